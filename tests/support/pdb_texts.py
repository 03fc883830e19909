"""A PDB file with something for every option that chooses atoms."""

# Chains A and B; a ligand, water, hydrogen, two places of one atom.
ATOMS = """\
ATOM      1  N   ALA A   1       0.000   0.000   0.000  1.00  0.00           N
ATOM      2  H   ALA A   1       1.000   0.100   0.000  1.00  0.00           H
ATOM      3  OG ASER A   2       2.500   0.000   0.200  0.40  0.00           O
ATOM      4  OG BSER A   2       2.500   0.600   0.200  0.60  0.00           O
ATOM      5  CA  GLY B   1       9.000   0.000   0.000  1.00  0.00           C
HETATM    6  S   SO4 B   9      10.500   0.000   0.300  1.00  0.00           S
HETATM    7  O   HOH B  10      14.000   0.000   0.000  1.00  0.00           O
"""
# Model 4 has chain A only.
MODELS = "MODEL        1\n" + ATOMS + "ENDMDL\nMODEL        4\n" + ATOMS[:ATOMS.index(
    "ATOM      5")] + "ENDMDL\n"
# Chain A and a copy of it that is turned about the z axis and 20 Angstrom above.
ASSEMBLY = """\
REMARK 350 BIOMOLECULE: 1
REMARK 350 APPLY THE FOLLOWING TO CHAINS: A
REMARK 350   BIOMT1   1  1.000000  0.000000  0.000000        0.00000
REMARK 350   BIOMT2   1  0.000000  1.000000  0.000000        0.00000
REMARK 350   BIOMT3   1  0.000000  0.000000  1.000000        0.00000
REMARK 350   BIOMT1   2 -1.000000  0.000000  0.000000        0.00000
REMARK 350   BIOMT2   2  0.000000 -1.000000  0.000000        0.00000
REMARK 350   BIOMT3   2  0.000000  0.000000  1.000000       20.00000
"""
