#!/usr/bin/env python3
"""Adapters and exports with the packages themselves, and the types with mypy; slow, and in need of
cmake/python_packages.txt. Usage: packages_test.py folder-of-the-package"""

from support import MOLECULES, ModuleTest, main

import subprocess
import sys
import warnings
from pathlib import Path

import Bio.PDB
import gemmi
import MDAnalysis
import morskin
import numpy as np
from morskin import adapters

CRAMBIN = str(MOLECULES / "1crn.pdb")
EXAMPLE = '''
import morskin
import numpy as np
mesh: morskin.Mesh = morskin.Skin([[0, 0, 0]], np.ones(1), model="sas").mesh(density=5)
area: float = mesh.certificate.area
heights: "np.ndarray[tuple[int], np.dtype[np.float64]]" = mesh.skin.critical_points().values
'''


class Packages(ModuleTest):
    def test_gemmi_biopython_and_mdanalysis_give_the_atoms_that_read_does(self):
        molecule = morskin.read(CRAMBIN)
        structure = Bio.PDB.PDBParser(QUIET=True).get_structure("1crn", CRAMBIN)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            universe = MDAnalysis.Universe(CRAMBIN)
        for found in (adapters.from_gemmi(gemmi.read_structure(CRAMBIN)),
                      adapters.from_gemmi(gemmi.read_structure(CRAMBIN)[0]),
                      adapters.from_biopython(structure),
                      adapters.from_biopython(next(structure.get_chains())),
                      adapters.from_mdanalysis(universe)):
            np.testing.assert_array_equal(found.radii, molecule.radii)
            np.testing.assert_allclose(found.positions, molecule.positions, atol=1e-5)

    def test_waters_and_alternate_locations_are_read_alike(self):
        text = "".join(
            f"{kind:6}{i:5} {name:4}{alternate}{residue} A{number:4}    {x:8.3f}   0.000   0.000"
            f"{occupancy:6.2f}  0.00          {element:>2}\n"
            for i, (kind, name, alternate, residue, number, x, occupancy, element) in enumerate([
                ("ATOM", " N", " ", "ALA", 1, 0, 1, "N"),
                ("ATOM", " CA", "A", "ALA", 1, 1.4, 0.3, "C"),
                ("ATOM", " CA", "B", "ALA", 1, 1.5, 0.7, "C"),
                ("ATOM", " CB", "A", "SER", 2, 4, 0.7, "C"),
                ("ATOM", " SG", "B", "CYS", 2, 5, 0.3, "S"),
                ("HETATM", " O", " ", "HOH", 3, 9, 1, "O"),
                ("HETATM", " O", " ", "DOD", 4, 12, 1, "O"),
                ("HETATM", " O", " ", "SOL", 5, 15, 1, "O"),
                ("ATOM", " D", "B", "GLY", 6, 18, 0.5, "D"),
                ("ATOM", " H", "A", "GLY", 6, 19, 0.5, "H"),
                ("ATOM", " CA", "B", "GLY", 6, 20, 0.5, "C"),
                ("ATOM", " CA", "A", "GLY", 6, 21, 0.5, "C"),
                ("ATOM", " CB", "A", "CYS", 7, 24, 0.4, "C"),
                ("HETATM", " CB", "B", "CSO", 7, 25, 0.6, "C")], start=1))
        file = self.folder / "a.pdb"
        file.write_text(text + "END\n")
        molecule = morskin.read(file)
        self.assertEqual(molecule.positions[:, 0].tolist(), [0, 1.5, 4, 19, 21, 25])
        structure = Bio.PDB.PDBParser(QUIET=True).get_structure("a", str(file))
        for found in (adapters.from_gemmi(gemmi.read_structure(str(file))),
                      adapters.from_biopython(structure)):
            np.testing.assert_allclose(found.positions, molecule.positions, atol=1e-6)

    def test_areas_and_volumes_along_an_mdanalysis_trajectory(self):
        frames = np.array([[[0, 0, 0], [d, 0, 0], [0, 9, 0]] for d in (0.5, 1.0, 1.5)])
        universe = MDAnalysis.Universe.empty(3, trajectory=True)
        universe.add_TopologyAttr("elements", ["C", "N", "O"])
        universe.load_new(frames, dt=2.0)
        rows = adapters.over_time(universe.select_atoms("element C N"), C=0.2)
        self.assertEqual(rows["frame"].tolist(), [0, 1, 2])
        self.assertEqual(rows["time"].tolist(), [0, 2, 4])
        self.assertTrue((np.diff(rows["area"]) > 0).all())
        self.assertEqual(rows["components"].tolist(), [1, 1, 1])
        whole = adapters.over_time(universe, frames=slice(0, None, 2), C=0.2)
        self.assertEqual(whole["components"].tolist(), [2, 2])

    def test_vtk_gets_the_mesh_and_what_is_known_of_its_vertices(self):
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkFiltersCore import vtkMassProperties
        mesh = morskin.read(MOLECULES / "caffeine.xyz").mesh(C=0.2)
        data = mesh.to_vtk()
        np.testing.assert_array_equal(vtk_to_numpy(data.GetPoints().GetData()), mesh.vertices)
        np.testing.assert_array_equal(vtk_to_numpy(data.GetPointData().GetNormals()), mesh.normals)
        np.testing.assert_array_equal(vtk_to_numpy(data.GetPointData().GetArray("atoms")),
                                      mesh.atoms)
        properties = vtkMassProperties()
        properties.SetInputData(data)
        self.assertAlmostEqual(properties.GetSurfaceArea() / mesh.certificate.area, 1, places=6)
        self.assertAlmostEqual(properties.GetVolume() / mesh.certificate.volume, 1, places=6)

    def test_the_package_and_its_use_have_types_that_agree(self):
        (self.folder / "use.py").write_text(EXAMPLE)
        (self.folder / "misuse.py").write_text(EXAMPLE.replace("density", "densty"))
        package = Path(morskin.__file__).parent
        mypy = [sys.executable, "-m", "mypy", "--strict", "--ignore-missing-imports",
                "--cache-dir", self.folder / "cache"]
        for files, code in (([package], 0), (["use.py"], 0), (["misuse.py"], 1)):
            done = subprocess.run([*mypy, *files], cwd=self.folder, capture_output=True, text=True,
                                  env={"MYPYPATH": str(package.parent), "PATH": "/usr/bin"})
            self.assertEqual(done.returncode, code, done.stdout + done.stderr)


if __name__ == "__main__":
    main()
