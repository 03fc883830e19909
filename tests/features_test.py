#!/usr/bin/env python3
"""What `features` writes, read by NumPy without pickles.
Usage: features_test.py path/to/morskin"""

import json
import math

import meshio
import numpy

from support.command import MOLECULES, CommandTest, main

CHARGED = """ATOM      1  N   ARG A   1       0.000   0.000   0.000 -0.30  1.85
ATOM      2  CA  ARG A   1       1.500   0.000   0.000  0.21  2.00
ATOM      3  N   ILE B   2A      3.000   0.500   0.000 -0.47  1.85
HETATM    4  MG  MG  B   3       9.000   0.000   0.000  2.00  1.20
"""
# Kyte & Doolittle 1982, by one letter as in print.
SCALE = dict(zip("IVLFCMAGTSWYPHEQDNKR",
                 [4.5, 4.2, 3.8, 2.8, 2.5, 1.9, 1.8, -0.4, -0.7, -0.8, -0.9, -1.3, -1.6, -3.2,
                  -3.5, -3.5, -3.5, -3.5, -3.9, -4.5]))
LETTERS = dict(ILE="I", VAL="V", LEU="L", PHE="F", CYS="C", MET="M", ALA="A", GLY="G", THR="T",
               SER="S", TRP="W", TYR="Y", PRO="P", HIS="H", GLU="E", GLN="Q", ASP="D", ASN="N",
               LYS="K", ARG="R")


def laplacian(arrays):
    """The matrix in full."""
    matrix = numpy.zeros(arrays["laplacian_shape"])
    for row in range(len(matrix)):
        entries = slice(*arrays["laplacian_indptr"][row:row + 2])
        matrix[row, arrays["laplacian_indices"][entries]] = arrays["laplacian_data"][entries]
    return matrix


def triangle_areas(arrays):
    a, b, c = (arrays["vertices"][arrays["faces"][:, k]] for k in range(3))
    return numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1) / 2


class Features(CommandTest):
    def features(self, molecule, *words):
        self.run_morskin("features", molecule, "-o", "m.npz", "-q", *words)
        with numpy.load(self.folder / "m.npz", allow_pickle=False) as archive:
            return dict(archive)

    def test_methods_without_a_density_have_no_features(self):
        for method in ("dynamic", "marching-cubes"):
            done = self.run_morskin("features", MOLECULES / "benzene.pdb", "-o", "f.npz",
                                    "--method", method, code=2)
            self.assertIn(method, done.stderr.decode())
        for option in ("--grid", "--grow"):
            self.assertNotIn(option, self.run_morskin("features", "--help").stdout.decode())

    def test_names_types_and_shapes_are_those_of_the_page(self):
        a = self.features(MOLECULES / "1crn.pdb")
        n, m, atoms = len(a["vertices"]), len(a["faces"]), len(a["atom_radius"])
        self.assertEqual(atoms, 327)
        by_vertex = ["k1", "k2", "mean_curvature", "gaussian_curvature", "shape_index",
                     "curvedness", "hphob", "mass"]
        expected = {"vertices": ("<f8", (n, 3)), "faces": ("<u4", (m, 3)),
                    "normals": ("<f8", (n, 3)), "atom": ("<i4", (n,)),
                    **{name: ("<f8", (n,)) for name in by_vertex},
                    "atom_position": ("<f8", (atoms, 3)), "atom_radius": ("<f8", (atoms,)),
                    "atom_hphob": ("<f8", (atoms,)), "atom_name": ("<U3", (atoms,)),
                    "atom_element": ("<U1", (atoms,)), "atom_residue": ("<U3", (atoms,)),
                    "atom_residue_number": ("<U2", (atoms,)), "atom_chain": ("<U1", (atoms,)),
                    "laplacian_data": ("<f8", (n + 3 * m,)),
                    "laplacian_indices": ("<i4", (n + 3 * m,)),
                    "laplacian_indptr": ("<i4", (n + 1,)), "laplacian_shape": ("<i8", (2,))}
        for name, (kind, shape) in expected.items():
            with self.subTest(name):
                self.assertEqual((a[name].dtype.str, a[name].shape), (kind, shape))
        page = (MOLECULES.parent.parent / "papers" / "features.md").read_text(encoding="utf-8")
        for name in expected:
            self.assertIn(name, page)
        others = {"metadata", "C", "Q", "size"}  # the model has no probe
        self.assertEqual(set(a) - set(expected), others)

    def test_atoms_are_those_of_the_file_and_every_index_is_one_of_them(self):
        a = self.features(MOLECULES / "1crn.pdb")
        rows = [line for line in (MOLECULES / "1crn.pdb").read_text().splitlines()
                if line.startswith("ATOM")]
        self.assertEqual([row[12:16].strip() for row in rows], list(a["atom_name"]))
        self.assertEqual([row[17:20].strip() for row in rows], list(a["atom_residue"]))
        self.assertEqual([row[21] for row in rows], list(a["atom_chain"]))
        self.assertEqual([row[22:26].strip() for row in rows], list(a["atom_residue_number"]))
        places = [[float(row[k:k + 8]) for k in (30, 38, 46)] for row in rows]
        numpy.testing.assert_array_equal(a["atom_position"], places)
        self.assertTrue(((a["atom"] >= 0) & (a["atom"] < len(rows))).all())
        # The nearest by power distance, with the weights of the model ses-like.
        weights = 2 * (a["atom_radius"] + 0.25) ** 2
        for v in range(0, len(a["vertices"]), 50):
            squares = ((a["atom_position"] - a["vertices"][v]) ** 2).sum(axis=1)
            powers = squares - weights
            self.assertAlmostEqual(powers[a["atom"][v]], powers.min(), places=9)

    def test_hydropathy_is_that_of_kyte_and_doolittle_of_the_nearest_atom_s_residue(self):
        a = self.features(MOLECULES / "1crn.pdb")
        of_atom = [SCALE[LETTERS[residue]] for residue in a["atom_residue"]]
        numpy.testing.assert_array_equal(a["atom_hphob"], of_atom)
        numpy.testing.assert_array_equal(a["hphob"], a["atom_hphob"][a["atom"]])

    def test_every_amino_acid_has_its_value_and_other_residues_0(self):
        names = [*LETTERS, "HEM", "DA", "NALA", "CPHE", "NHEM"]  # NALA begins a chain in Amber
        rows = [f"ATOM  {k + 1:5}  C   {name:4}A{k + 1:4}    {5 * k:8.3f}   0.000   0.000"
                "  1.00  0.00           C" for k, name in enumerate(names)]
        a = self.features(self.input("all.pdb", "\n".join(rows) + "\n"), "--voids", "keep")
        numpy.testing.assert_array_equal(
            a["atom_hphob"],
            [SCALE[LETTERS[n[-3:]]] if n[-3:] in LETTERS else 0 for n in names])

    def test_charges_are_there_if_the_file_gives_them_and_only_then(self):
        a = self.features(self.input("m.pqr", CHARGED))
        numpy.testing.assert_array_equal(a["atom_charge"], [-0.30, 0.21, -0.47, 2.00])
        alone = a["vertices"][:, 0] > 8  # nearer, the mixed cell of both begins
        self.assertEqual(set(a["partial_charge"][alone]), {2.0})
        self.assertEqual(list(a["atom_chain"]), ["A", "A", "B", "B"])
        numpy.testing.assert_array_equal(a["atom_hphob"], [-4.5, -4.5, 4.5, 0])
        a = self.features(MOLECULES / "caffeine.xyz")
        self.assertNotIn("partial_charge", a)
        self.assertNotIn("atom_charge", a)
        self.assertEqual(set(a["atom_name"]), {""})

    def test_shape_index_is_what_masif_makes_of_mean_and_gaussian_curvature(self):
        a = self.features(MOLECULES / "1crn.pdb")
        H, K = a["mean_curvature"], a["gaussian_curvature"]
        root = numpy.sqrt(numpy.maximum(H * H - K, 0))
        clear = root > 1e-6
        self.assertGreater(clear.mean(), 0.5)
        theirs = 2 / math.pi * numpy.arctan(H[clear] / root[clear])
        numpy.testing.assert_allclose(a["shape_index"][clear], theirs, atol=1e-6)
        self.assertTrue((abs(a["shape_index"]) <= 1).all())

    def test_the_laplacian_is_symmetric_its_rows_add_up_to_nothing_and_masses_to_the_area(self):
        a = self.features(MOLECULES / "benzene.pdb")
        L = laplacian(a)
        numpy.testing.assert_array_equal(L, L.T)
        self.assertLess(abs(L.sum(axis=1)).max(), 1e-12)
        self.assertAlmostEqual(a["mass"].sum(), triangle_areas(a).sum(), places=9)
        self.assertGreater(numpy.linalg.eigvalsh(L)[0], -1e-10)

    def test_on_a_ball_the_first_eigenvalues_are_nearly_l_l_plus_1_over_r_squared(self):
        a = self.features(self.input("ball.xyzr", "0 0 0 4.75\n"), "--density", "4")
        R = 5  # with the 0.25 of ses-like
        numpy.testing.assert_allclose(numpy.linalg.norm(a["vertices"], axis=1), R)
        root = 1 / numpy.sqrt(a["mass"])
        values = numpy.linalg.eigvalsh(root[:, None] * laplacian(a) * root)
        expected = [l * (l + 1) / R ** 2 for l in range(4) for _ in range(2 * l + 1)]
        self.assertLess(abs(values[0]), 1e-9)
        numpy.testing.assert_allclose(values[1:16], expected[1:], rtol=0.03)

    def test_the_density_is_about_what_is_asked_for(self):
        for words, density in (([], 2), (["--density", 1], 1), (["--density", 4], 4),
                               (["--density", 2, "-C", 0.3], 2),
                               (["--density", 2, "--method", "sweep"], 2)):
            a = self.features(MOLECULES / "1crn.pdb", *words)
            made = len(a["vertices"]) / triangle_areas(a).sum()
            self.assertLess(abs(made / density - 1), 0.1, (words, made))

    def test_the_mesh_is_the_one_that_mesh_makes_of_the_same_options(self):
        for name in ("benzene.pdb", "shell_hollow.xyzr"):  # the shell has a void
            with self.subTest(name):
                a = self.features(MOLECULES / name)
                self.run_morskin("mesh", MOLECULES / name, "-o", "m.off", "-q", "--model",
                                 "ses-like", "--voids", "drop", "--density", "2")
                vertices, faces = self.read_off("m.off")
                numpy.testing.assert_array_equal(a["vertices"], vertices)
                numpy.testing.assert_array_equal(a["faces"], faces)
                self.run_morskin("features", MOLECULES / name, "-o", "m.ply", "-q")
                found = self.check("m.ply", "--against", MOLECULES / name)
                self.assertTrue(found["certified"])

    def test_ply_holds_what_is_by_vertex_and_the_same_numbers(self):
        a = self.features(MOLECULES / "1crn.pdb", "-o", "m.ply")
        ply = meshio.read(self.folder / "m.ply")
        numpy.testing.assert_array_equal(ply.points, a["vertices"])
        numpy.testing.assert_array_equal(ply.cells_dict["triangle"], a["faces"])
        a |= dict(zip(("nx", "ny", "nz"), a["normals"].T))
        self.assertEqual(set(ply.point_data), {
            name for name, array in a.items()
            if array.shape == (len(ply.points),) and not name.startswith("laplacian")})
        for name, column in ply.point_data.items():
            with self.subTest(name):
                self.assertEqual(column.dtype, a[name].dtype)
                numpy.testing.assert_array_equal(column, a[name])

    def test_it_says_in_one_line_what_it_wrote_or_nothing(self):
        said = self.run_morskin("features", self.ring, "-o", "m.npz").stdout.decode()
        self.assertRegex(said, r"^m\.npz: [\d,]+ vertices, .* certified\n$")
        self.assertEqual(self.run_morskin("features", self.ring, "-o", "m.npz", "-q").stdout, b"")

    def test_the_line_stays_out_of_a_report_or_mesh_on_standard_output(self):
        words = ("features", MOLECULES / "benzene.pdb", "-o", "m.npz")
        done = self.run_morskin(*words, "--report", "-")
        self.assertTrue(json.loads(done.stdout)["certified"])
        self.assertRegex(done.stderr, b"^m.npz: .*, certified\n$")
        done = self.run_morskin(*words, "-o", "m.ply", "-q")
        self.assertEqual(self.run_morskin(*words, "-o", "-").stdout,
                         (self.folder / "m.ply").read_bytes())

    def test_other_endings_and_bad_densities_are_refused_and_nothing_is_left(self):
        for words in (["-o", "m.npz", "--density", "0"], ["-o", "m.npz", "-o", "m.npz"],
                      ["-o", ""]):
            self.run_morskin("features", self.ring, *words, code=2)
        for name in ("m.off", "m.vtu", "m", "m.doc", "m.vert"):
            done = self.run_morskin("features", self.ring, "-o", name, code=2)
            self.assertIn(name.encode() + b": the ending must be .npz or .ply", done.stderr)
        self.assertEqual(self.names(), [])

    def test_help_tells_the_defaults_and_what_is_not_there(self):
        said = self.run_morskin("features", "--help").stdout.decode()
        for words in ("ses-like", "drop", "[2]", "Kyte", "hbond", "charge"):
            self.assertIn(words, said)

    def test_the_bytes_are_the_same_for_any_number_of_threads(self):
        made = set()
        for threads in (1, 2):
            self.run_morskin("features", MOLECULES / "1crn.pdb", "-o", "m.npz", "-q", "--threads",
                             threads)
            made.add((self.folder / "m.npz").read_bytes())
        self.assertEqual(len(made), 1)


if __name__ == "__main__":
    main()
