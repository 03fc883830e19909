#!/usr/bin/env python3
"""Adapters, on stand-ins that have what the other packages document; packages_test.py tries the
packages themselves. Usage: adapters_test.py folder-of-the-package"""

from support import ModuleTest, main

import sys
from types import SimpleNamespace as Thing

import morskin
import numpy as np
from morskin import adapters


def gemmi_atom(name, x, element="C", occ=1.0, altloc="\0"):
    return Thing(name=name, pos=Thing(x=x, y=0.0, z=0.0), element=Thing(name=element), occ=occ,
                 altloc=altloc, has_altloc=lambda: altloc != "\0")


class GemmiResidue(list):
    def __init__(self, atoms, name="ALA", seqid="1"):
        super().__init__(atoms)
        self.name, self.seqid = name, seqid


class GemmiModel(list):
    def subchains(self):
        return []


class BioResidue:
    """@param atoms  places, elements, and what else is known of them
    @param kind   "H_" and the name of what is HETATM"""

    def __init__(self, *atoms, name="ALA", kind=" ", chain="A"):
        self.level, self.resname, self.id, self.chain = "R", name, (kind, 1, " "), chain
        self.atoms = [Thing(coord=np.array([x, 0, 0], "f4"), element=element, name=element,
                            altloc=" ", occupancy=1.0) for x, element in atoms]

    def located(self, *places):
        """Gives the atoms names, letters and occupancies."""
        for atom, place in zip(self.atoms, places):
            atom.name, atom.altloc, atom.occupancy = place
        return self

    def is_disordered(self):
        return 0

    def get_parent(self):
        return self.chain

    def get_unpacked_list(self):
        return self.atoms


class Trajectory(list):
    """Frames of positions; going through them moves the atoms."""

    def __init__(self, group, frames):
        super().__init__(frames)
        self.group = group

    def __getitem__(self, frames):
        for number in range(len(self))[frames]:
            self.group.positions = list.__getitem__(self, number)
            yield Thing(frame=number, time=2.0 * number)


def group(frames, elements):
    found = Thing(elements=elements, positions=frames[0])
    found.atoms = found
    found.universe = Thing(trajectory=Trajectory(found, frames))
    return found


class Adapters(ModuleTest):
    def test_of_gemmi_s_atoms_the_likeliest_locations_are_taken_and_no_water(self):
        residue = GemmiResidue([gemmi_atom("N", 0.0, "N"),
                                gemmi_atom("CA", 1.5, occ=0.4, altloc="A"),
                                gemmi_atom("CA", 1.6, occ=0.6, altloc="B")])
        water = GemmiResidue([gemmi_atom("O", 9.0, "O")], name="HOH")
        model = GemmiModel([[residue, water]])
        for entity in (model, [model, GemmiModel()]):
            molecule = adapters.from_gemmi(entity)
            np.testing.assert_array_equal(molecule.positions[:, 0], [0.0, 1.6])
            np.testing.assert_array_equal(molecule.radii, [1.55, 1.7])
        self.assertEqual(len(adapters.from_gemmi(model, waters=True)), 3)

    def positions(self, *residues):
        found = adapters.from_gemmi(GemmiModel([list(residues)])).positions[:, 0].tolist()
        return found

    def test_gemmi_s_atoms_of_one_name_without_alternate_locations_are_all_kept(self):
        residue = GemmiResidue([gemmi_atom("H", float(x), "H") for x in range(6)])
        self.assertEqual(self.positions(residue), [0, 1, 2, 3, 4, 5])

    def test_of_gemmi_s_residues_at_one_site_the_likeliest_is_taken(self):
        proline = GemmiResidue([gemmi_atom("N", 0.0, "N"), gemmi_atom("CA", 1.0, altloc="A",
                                                                      occ=0.6)], name="PRO")
        serine = GemmiResidue([gemmi_atom("CA", 2.0, altloc="B", occ=0.4)], name="SER")
        other = GemmiResidue([gemmi_atom("CA", 3.0, altloc="B", occ=0.4)], name="SER", seqid="2")
        self.assertEqual(self.positions(proline, serine, other), [0, 1, 3])

    def test_of_gemmi_s_deuterium_and_hydrogen_at_one_site_one_is_taken_the_first_letter_s(self):
        residue = GemmiResidue([gemmi_atom("D", 0.0, "D", 0.5, "B"),
                                gemmi_atom("H", 1.0, "H", 0.5, "A")])
        self.assertEqual(self.positions(residue), [1])

    def test_of_a_biopython_structure_the_first_model_is_taken_and_no_water(self):
        protein, water = BioResidue((0, "C"), (1.5, "N")), BioResidue((9, "O"), name="HOH")
        chain = Thing(level="C", get_residues=lambda: iter([protein, water]))
        structure = Thing(level="S", get_models=lambda: iter([chain, None]))
        for entity in (structure, chain, protein):
            np.testing.assert_array_equal(adapters.from_biopython(entity).radii, [1.7, 1.55])
        self.assertEqual(len(adapters.from_biopython(structure, waters=True)), 3)

    def test_of_biopython_s_deuterium_and_hydrogen_at_one_site_one_is_taken(self):
        places = ("1DB", "A", 0.3), ("1HB", "B", 0.7), ("HD1", "A", 0.3)
        residue = BioResidue((0, "D"), (1, "H"), (2, "D")).located(*places)
        self.assertEqual(adapters.from_biopython(residue).positions[:, 0].tolist(), [1, 2])

    def test_of_biopython_s_locations_alike_the_first_letter_s_is_taken(self):
        for occupancy in (0.5, None):
            places = [("CA", letter, occupancy) for letter in "CAB"]
            residue = BioResidue((0, "C"), (1, "C"), (2, "C")).located(*places)
            self.assertEqual(adapters.from_biopython(residue).positions[:, 0].tolist(), [1])

    def test_biopython_s_locations_may_have_several_letters_or_none(self):
        for letters, kept in ((("AB", "AA"), [1]), (("", ""), [0, 1]), ((None, "A"), [1])):
            places = [("CA", letter, 0.4 if letter is None else 0.5) for letter in letters]
            residue = BioResidue((0, "C"), (1, "C")).located(*places)
            with self.subTest(letters=letters):
                self.assertEqual(adapters.from_biopython(residue).positions[:, 0].tolist(), kept)

    def test_of_biopython_s_residues_of_one_number_the_likeliest_is_taken_of_either_record(self):
        def positions(chain):
            cysteine = BioResidue((0, "C"), name="CYS").located(("CB", "A", 0.4))
            oxide = BioResidue((1, "C"), name="CSO", kind="H_CSO", chain=chain)
            model = Thing(level="M", get_residues=lambda: iter(
                [cysteine, oxide.located(("CB", "B", 0.6))]))
            return adapters.from_biopython(model).positions[:, 0].tolist()
        self.assertEqual(positions("A"), [1])
        self.assertEqual(positions("B"), [0, 1])

    def test_a_location_without_a_letter_is_one_of_those_with_and_copies_are_not(self):
        for letters, kept in (("A\0", [0]), ("\0A", [1]), ("AA", [0, 1]), ("BAAB", [1, 2])):
            residue = GemmiResidue([gemmi_atom("CA", float(x), altloc=letter,
                                               occ=0.4 if letter == "\0" else 0.6)
                                    for x, letter in enumerate(letters)])
            with self.subTest(letters=letters):
                self.assertEqual(self.positions(residue), kept)

    def test_what_read_takes_for_water_is_water(self):
        waters = "HOH DOD WAT H2O D2O SOL SPC TIP TP3 TP4 TP5 T3P TIP3 TIP4 TIP5".split()
        for name in [*waters, "OH2", "TIP6", "UNX"]:
            file = self.folder / "a.cif"
            file.write_text("data_a\nloop_\n" + "".join(f"_atom_site.{field}\n" for field in (
                "group_PDB", "type_symbol", "label_atom_id", "label_comp_id", "auth_asym_id",
                "auth_seq_id", "Cartn_x", "Cartn_y", "Cartn_z")) +
                f"ATOM C CA ALA A 1 0 0 0\nHETATM O O {name} A 2 9 0 0\n")
            both = [GemmiResidue([gemmi_atom("CA", 0.0)]),
                    GemmiResidue([gemmi_atom("O", 9.0, "O")], name=name, seqid="2")]
            chain = Thing(level="C", get_residues=lambda name=name: iter(
                [BioResidue((0, "C")), BioResidue((9, "O"), name=name)]))
            with self.subTest(name):
                kept = len(morskin.read(file))
                self.assertEqual(kept, 1 if name in waters else 2)
                self.assertEqual(len(adapters.from_gemmi(GemmiModel([both]))), kept)
                self.assertEqual(len(adapters.from_biopython(chain)), kept)
                self.assertEqual(len(adapters.from_gemmi(GemmiModel([both[1:]]))), 1)  # alone

    def test_a_structure_without_a_model_is_refused(self):
        for found in (lambda: adapters.from_gemmi([]), lambda: adapters.from_biopython(
                Thing(level="S", get_models=lambda: iter([])))):
            with self.assertRaisesRegex(morskin.RefusedInput, "no model"):
                found()

    def test_what_is_no_structure_or_model_is_a_type_error_that_names_what_is_taken(self):
        class Chain(GemmiModel):
            pass

        for wrong in (Chain([GemmiResidue([gemmi_atom("CA", 0.0)])]), gemmi_atom("CA", 0.0), None):
            with self.assertRaisesRegex(TypeError, "takes a gemmi.Structure or gemmi.Model, not "):
                adapters.from_gemmi(wrong)
        for wrong in (Thing(level="A"), None):
            with self.assertRaisesRegex(TypeError, "takes a Bio.PDB Structure, .*, not "):
                adapters.from_biopython(wrong)
        for take in (adapters.from_mdanalysis, adapters.over_time):
            with self.assertRaisesRegex(TypeError, "AtomGroup or Universe is taken, not float"):
                take(1.0)

    def test_an_element_without_a_radius_is_refused_with_its_atoms(self):
        with self.assertRaises(morskin.RefusedInput) as caught:
            adapters.from_mdanalysis(group([np.zeros((3, 3))], ["C", "Qq", "Qq"]))
        self.assertEqual(caught.exception.atoms, (1, 2))
        self.assertIn("Qq", str(caught.exception))

    def test_an_atom_of_the_unknown_element_is_refused_not_left_out(self):
        residue = GemmiResidue([gemmi_atom("CA", 0.0), gemmi_atom("X", 1.0, "X")])
        with self.assertRaises(morskin.RefusedInput) as caught:
            self.positions(residue)
        self.assertEqual(caught.exception.atoms, (1,))

    def test_radii_of_one_s_own_take_the_place_of_elements(self):
        atoms = Thing(atoms=Thing(positions=np.ones((2, 3), "f4")))
        found = adapters.from_mdanalysis(atoms, radii=[1, 2])
        self.assertEqual(found.radii.tolist(), [1, 2])
        self.assertEqual(found.positions.dtype, np.float64)
        for radii in ([1.0], [1, 2, 3], 1.0, [[1, 2]]):
            with self.assertRaisesRegex(ValueError, "one radius for each of the 2 atoms"):
                adapters.from_mdanalysis(atoms, radii=radii)

    def test_masked_radii_of_one_s_own_are_refused(self):
        atoms = Thing(atoms=Thing(positions=np.array([[0, 0, 0], [9, 0, 0]], "f4")))
        found = adapters.from_mdanalysis(atoms, radii=np.ma.masked_equal([1.0, 2.0], 2.0))
        with self.assertRaisesRegex(ValueError, "^radii must have no masked values"):
            found.skin()

    def test_a_trajectory_gives_a_row_for_each_frame_that_is_asked_for(self):
        frames = [np.array([[0, 0, 0], [d, 0, 0]], "f4") for d in (0.5, 1.5, 9, 1.5)]
        atoms = group(frames, ["C", "C"])
        rows = adapters.over_time(atoms, C=0.2)
        self.assertEqual(rows["frame"].tolist(), [0, 1, 2, 3])
        self.assertEqual(rows["time"].tolist(), [0, 2, 4, 6])
        self.assertEqual(rows["components"].tolist(), [1, 1, 2, 1])
        self.assertEqual(rows["area"][1], rows["area"][3])
        self.assertTrue((np.diff(rows["volume"][:3]) > 0).all())
        some = adapters.over_time(atoms, frames=slice(1, None, 2), C=0.2)
        np.testing.assert_array_equal(some, rows[1::2])
        with self.assertRaisesRegex(TypeError, "frames is a slice"):
            adapters.over_time(atoms, frames=0)
        wide = adapters.over_time(atoms, frames=slice(1), radii=[2, 2], model="sas", C=0.2)
        self.assertGreater(wide["area"][0], rows["area"][0])

    def test_no_package_is_imported_until_it_is_needed(self):
        said = self.python("import morskin, sys; print(sorted({m.partition('.')[0] for m in"
                           " sys.modules} & {'gemmi', 'Bio', 'MDAnalysis', 'meshio', 'vtkmodules',"
                           " 'scipy'}))")
        self.assertEqual(said, "[]\n")


class Exports(ModuleTest):
    def test_meshio_gets_the_mesh_and_what_is_known_of_its_vertices(self):
        import meshio
        mesh = morskin.Skin([[0, 0, 0], [1.5, 0, 0]], [1.5, 1.2]).mesh(C=0.3)
        for ending in ("msh", "vtu"):
            mesh.to_meshio().write(self.folder / f"m.{ending}")
            read = meshio.read(self.folder / f"m.{ending}")
            np.testing.assert_array_equal(read.points, mesh.vertices)
            np.testing.assert_array_equal(read.cells_dict["triangle"], mesh.faces)
        for name in ("normals", "curvatures", "atoms", "length_scales", "components"):
            np.testing.assert_array_equal(read.point_data[name].squeeze(), getattr(mesh, name))

    def test_what_meshio_gets_may_be_written_to_and_the_mesh_stays_as_it_is(self):
        mesh = morskin.Skin([[0, 0, 0]], [1]).mesh(C=0.3)
        for told in (mesh.to_meshio(), mesh.to_meshio()):
            np.testing.assert_array_equal(told.points, mesh.vertices)
            told.points *= 10
            told.point_data["normals"] *= 10

    def test_meshio_writes_gmsh_s_files_without_the_pairs_of_curvatures(self):
        mesh = morskin.Skin([[0, 0, 0], [1.5, 0, 0]], [1.5, 1.2]).mesh(C=0.3)
        self.assertIn("curvatures", morskin.Mesh.to_meshio.__doc__.partition("Gmsh")[2])
        told = mesh.to_meshio()
        del told.point_data["curvatures"]
        told.write(self.folder / "gmsh.msh", file_format="gmsh", binary=False)
        for name in ("gmsh.msh", mesh.save(self.folder / "own.msh").name):
            vertices, faces = morskin.read_mesh(self.folder / name)
            np.testing.assert_array_equal(vertices, mesh.vertices)
            np.testing.assert_array_equal(faces, mesh.faces)

    def test_without_vtk_only_to_vtk_fails(self):
        mesh = morskin.Skin([[0, 0, 0]], [1]).mesh(C=0.3)
        hidden = dict.fromkeys([m for m in sys.modules if m.startswith("vtkmodules")] +
                               ["vtkmodules"])
        saved = {name: sys.modules.get(name) for name in hidden}
        sys.modules.update(hidden)
        try:
            with self.assertRaises(ImportError):
                mesh.to_vtk()
            self.assertEqual(len(mesh.to_meshio().points), len(mesh.vertices))
        finally:
            for name, module in saved.items():
                if module is None:
                    del sys.modules[name]
                else:
                    sys.modules[name] = module


if __name__ == "__main__":
    main()
