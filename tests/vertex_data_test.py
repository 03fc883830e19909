#!/usr/bin/env python3
"""What `mesh --vertex-data`, `--areas` and MSMS's two files hold, read by others' readers.
Usage: vertex_data_test.py path/to/morskin"""

import csv
import math
import struct
import subprocess

import meshio
import numpy

from support.command import MOLECULES, CommandTest, main

GROUPS = ["normal", "curvature", "directions", "scale", "atom", "shares", "component", "patch",
          "residue", "charge"]

# Record, name, residue, chain, number, insertion code, x, element: a minus, an insertion code, and
# what CSV has between quotation marks.
ATOMS = [("ATOM", "N", "ALA", "A", "-1", " ", 0, "N"),
         ("ATOM", "CA", "ALA", "A", "-1", " ", 1.5, "C"),
         ("ATOM", "N", "GLY", "A", "52", " ", 9, "N"),
         ("ATOM", "N", "GLY", "A", "52", "A", 18, "N"),
         ("ATOM", "CA", "GLY", "A", "52", "A", 19.5, "C"),
         ("HETATM", 'C"', "L,G", "B", "52", " ", 29, "C")]


def pdb_text():
    line = "{:6}    1  {:3} {} {}{:>4}{}   {:8.3f}   0.000   0.000  1.00  0.00          {:>2}\n"
    return "".join(line.format(*atom) for atom in ATOMS)


def cif_text():
    tags = ("group_PDB", "label_atom_id", "label_comp_id", "auth_asym_id", "auth_seq_id",
            "pdbx_PDB_ins_code", "Cartn_x", "type_symbol", "Cartn_y", "Cartn_z")
    row = "{} '{}' {} {} {} '{}' {} {} 0 0\n"
    return "data_a\nloop_\n" + "".join(f"_atom_site.{tag}\n" for tag in tags) + "".join(
        row.format(*atom).replace("' '", "?") for atom in ATOMS)


class VertexData(CommandTest):
    def meshed(self, *words, molecule=MOLECULES / "1crn.pdb"):
        return self.mesh_json(molecule, "-C", "0.2", *words)

    def ply(self, name):
        """Columns of the vertices and of the faces, by name, read by the header alone."""
        data = (self.folder / name).read_bytes()
        end = data.index(b"end_header\n") + 11
        sizes = {"double": ("d", 8), "int": ("i", 4)}
        counts, formats, names = {}, {"vertex": "<", "face": "<B3i"}, {"vertex": [], "face": ["n"]}
        names["face"] += ["a", "b", "c"]
        for line in data[:end].decode().splitlines():
            words = line.split()
            if words[0] == "element":
                element = words[1]
                counts[element] = int(words[2])
            elif words[0] == "property" and words[1] != "list":
                formats[element] += sizes[words[1]][0]
                names[element].append(words[2])
        columns = {}
        for element in ("vertex", "face"):
            size = struct.calcsize(formats[element]) * counts[element]
            rows = list(struct.iter_unpack(formats[element], data[end:end + size]))
            columns[element] = dict(zip(names[element], map(numpy.array, zip(*rows))))
            end += size
        self.assertEqual(end, len(data))
        return columns["vertex"], columns["face"]

    def test_all_that_can_be_told_agrees_with_itself_and_with_the_report(self):
        report = self.meshed("-o", "m.ply", "--vertex-data", "all")
        vertex, face = self.ply("m.ply")
        unit = numpy.array([vertex[c] for c in ("nx", "ny", "nz")])
        self.assertLess(abs(numpy.linalg.norm(unit, axis=0) - 1).max(), 1e-12)
        k1, k2 = vertex["k1"], vertex["k2"]
        self.assertTrue((k1 >= k2).all())
        numpy.testing.assert_allclose(vertex["mean_curvature"], (k1 + k2) / 2)
        numpy.testing.assert_allclose(vertex["gaussian_curvature"], k1 * k2)
        numpy.testing.assert_allclose(numpy.maximum(abs(k1), abs(k2)) * vertex["length_scale"], 1)
        shares = numpy.array([vertex[f"share{i}"] for i in (1, 2, 3, 4)])
        numpy.testing.assert_allclose(shares.sum(axis=0), 1)
        atoms = numpy.array([vertex[f"atom{i}"] for i in (1, 2, 3, 4)])
        self.assertTrue(((atoms >= 0) | (shares == 0)).all())
        self.assertEqual(len(set(vertex["component"])), report["components"])
        self.assertEqual(set(vertex["residue"]), set(range(46)))  # crambin's
        self.assertTrue(set(face["patch"]) <= {0, 1, 2, 3})
        for corner in "abc":
            self.assertTrue((face["component"] == vertex["component"][face[corner]]).all())

    def test_shape_index_is_what_surface_learning_makes_of_mean_and_gaussian_curvature(self):
        self.meshed("-o", "m.ply", "--vertex-data", "curvature")
        vertex, _ = self.ply("m.ply")
        H, K = vertex["mean_curvature"], vertex["gaussian_curvature"]
        root = numpy.sqrt(numpy.maximum(H * H - K, 0))
        is_clear = root > 1e-6
        self.assertGreater(is_clear.mean(), 0.5)
        theirs = 2 / math.pi * numpy.arctan(H[is_clear] / root[is_clear])
        numpy.testing.assert_allclose(vertex["shape_index"][is_clear], theirs, atol=1e-6)

    def test_the_mesh_is_the_same_with_and_without_what_is_told(self):
        self.meshed("-o", "plain.ply", "-o", "plain.off")
        self.meshed("-o", "told.ply", "-o", "told.vtu", "-o", "told.off", "--vertex-data", "all")
        plain, told = meshio.read(self.folder / "plain.ply"), self.ply("told.ply")[0]
        for axis, name in enumerate("xyz"):
            self.assertTrue((plain.points[:, axis] == told[name]).all())
        self.assertEqual((self.folder / "plain.off").read_bytes(),
                         (self.folder / "told.off").read_bytes())
        self.assertEqual(self.check("told.ply", "--against", MOLECULES / "1crn.pdb", "-C", "0.2")
                         ["certified"], True)

    def test_meshio_reads_vtu_and_ply_with_all_that_is_told(self):
        self.meshed("-o", "m.ply", "-o", "m.vtu", "--vertex-data", "all")
        vertex, face = self.ply("m.ply")
        vtu = meshio.read(self.folder / "m.vtu")
        self.assertTrue((vtu.points[:, 0] == vertex["x"]).all())
        numpy.testing.assert_array_equal(vtu.point_data["normal"][:, 2], vertex["nz"])
        numpy.testing.assert_array_equal(vtu.point_data["curvature"][:, 0], vertex["k1"])
        numpy.testing.assert_array_equal(vtu.point_data["residue"].ravel(), vertex["residue"])
        numpy.testing.assert_array_equal(vtu.cell_data["patch"][0].ravel(), face["patch"])
        # Of PLY meshio reads no numbers of triangles.
        self.meshed("-o", "m.ply", "--vertex-data", "curvature,atom")
        ply = meshio.read(self.folder / "m.ply")
        numpy.testing.assert_array_equal(ply.point_data["k2"], vertex["k2"])
        numpy.testing.assert_array_equal(ply.point_data["atom"], vertex["atom"])

    def test_patches_and_directions_agree_with_the_atoms_and_the_normals_of_the_vertices(self):
        self.meshed("-o", "m.npz", "-o", "m.vert", "--vertex-data", "all")
        a = numpy.load(self.folder / "m.npz")
        atoms = sum(a[f"atom{i}"] >= 0 for i in (1, 2, 3, 4))
        kinds = numpy.array([0, 3, 1, 2, 2])  # MSMS's, by the number of atoms that make a patch
        for name, column, made_by in (("m.vert", 8, atoms), ("m.face", 3, a["face_patch"] + 1)):
            told = numpy.loadtxt(self.folder / name, skiprows=3, usecols=column, dtype=int)
            numpy.testing.assert_array_equal(told, kinds[made_by])
        of_corners = atoms[a["faces"]]
        is_inside = of_corners.min(axis=1) == of_corners.max(axis=1)
        agree = a["face_patch"][is_inside] + 1 == of_corners[is_inside, 0]
        self.assertGreater(agree.mean(), 0.95)  # the middle may lie in another cell
        first, second = (numpy.array([a[f"{k}{axis}"] for axis in "xyz"]).T for k in ("k1", "k2"))
        numpy.testing.assert_allclose(numpy.cross(first, second), a["normals"], atol=1e-12)
        # Along an edge the normal turns as curvatures and directions say, nearly.
        start, end = a["faces"][:, 0], a["faces"][:, 1]
        edge, turn = (a[of][end] - a[of][start] for of in ("vertices", "normals"))
        told = sum((k * (edge * d).sum(axis=1))[:, None] * d
                   for k, d in ((a["k1"][start], first[start]), (a["k2"][start], second[start])))
        self.assertGreater((turn * told).sum(), 0.8 * math.sqrt((turn**2).sum() * (told**2).sum()))

    def test_residues_and_chains_are_those_of_the_nearest_atom(self):
        self.input("a.pdb", pdb_text())
        self.meshed("-o", "m.npz", "--vertex-data", "atom,residue", molecule="a.pdb")
        told = numpy.load(self.folder / "m.npz")
        self.assertEqual(set(told["atom"]), set(range(6)))
        numpy.testing.assert_array_equal(told["residue"],
                                         numpy.array([0, 0, 1, 2, 2, 3])[told["atom"]])
        numpy.testing.assert_array_equal(told["chain"],
                                         numpy.array([0, 0, 0, 0, 0, 1])[told["atom"]])

    def test_a_word_that_is_no_group_is_refused_with_those_that_are(self):
        said = self.run_morskin("mesh", self.ring, "-o", "m.ply", "--vertex-data", "normals",
                                code=2).stderr.decode()
        for group in GROUPS:
            self.assertIn(group, said)
        self.assertEqual(self.names(), [])

    def test_all_is_every_group_that_a_complaint_names_charge_where_there_are_any(self):
        every = ",".join(set(GROUPS) - {"charge"})
        for name, words in (("all.ply", "all"), ("every.ply", every)):
            self.meshed("-o", name, "--vertex-data", words)
        self.assertEqual(*([sorted(columns) for columns in self.ply(name)]
                           for name in ("all.ply", "every.ply")))

    def test_what_no_output_can_hold_is_refused_and_a_group_named_twice_is_told_once(self):
        said = self.run_morskin("mesh", self.ring, "-o", "m.off", "-o", "m.vert", "--vertex-data",
                                "normal", code=2).stderr
        self.assertIn(b".ply, .vtu", said)
        for groups in ("all,charge", "normal,all"):
            said = self.run_morskin("mesh", self.ring, "-o", "m.ply", "--vertex-data", groups,
                                    code=2).stderr
            self.assertIn(b"--vertex-data all has every group; leave out the others", said)
        self.run_morskin("mesh", self.ring, "-o", "m.ply", "--vertex-data", "atom,scale,atom", "-q")
        header = (self.folder / "m.ply").read_bytes()[:2000]
        self.assertEqual(header.count(b" atom\n"), 1)

    def test_files_of_a_mesh_that_is_not_certified_say_so_in_all_their_names(self):
        self.run_morskin("mesh", self.ring, "-o", "m.vert", "--areas", "a.csv", "-q", "--method",
                         "marching-cubes", code=5)
        self.assertEqual(self.names(), ["a.csv.unverified", "m.face.unverified",
                                        "m.vert.unverified"])
        for words in (("check", "m.vert.unverified"), ("m.face.unverified",),
                      ("view", "m.vert.unverified", "-o", "m.html")):
            self.assertRegex(self.run_morskin(*words).stdout, rb"mesh +\S+ triangles", words)

    def test_either_of_the_two_names_of_msms_writes_both_files_and_check_reads_them(self):
        for name in ("m.vert", "m.face"):
            with self.subTest(name):
                self.meshed("-o", name)
                self.assertEqual(self.names(), ["m.face", "m.vert"])
                found = self.check("m.vert", "--against", MOLECULES / "1crn.pdb", "-C", "0.2")
                self.assertTrue(found["certified"])
                for path in ("m.face", "m.vert"):
                    (self.folder / path).unlink()

    def test_msms_s_two_files_are_read_back_however_their_names_are_written(self):
        report = self.meshed("-o", "m.vert", "-o", "./m.face")
        self.assertEqual(report["certified_file"], "m.vert")
        self.assertEqual(self.names(), ["m.face", "m.vert"])

    def test_vertices_beside_a_pipe_of_triangles_are_certified_from_memory(self):
        (self.folder / "m.face").symlink_to("/dev/null")
        report = self.meshed("-o", "m.vert")
        self.assertIn("in memory", report["certified_file"])
        self.assertTrue(report["certified"])

    def test_the_rows_of_a_vert_file_are_those_of_the_ply_file(self):
        self.meshed("-o", "m.vert", "-o", "m.ply", "--vertex-data", "normal,atom")
        vertex, face = self.ply("m.ply")
        rows = numpy.loadtxt(self.folder / "m.vert", skiprows=3)
        for column, name in enumerate(["x", "y", "z", "nx", "ny", "nz"]):
            numpy.testing.assert_array_equal(rows[:, column], vertex[name])
        numpy.testing.assert_array_equal(rows[:, 7], vertex["atom"] + 1)
        corners = numpy.loadtxt(self.folder / "m.face", skiprows=3, dtype=int)
        for column, name in enumerate("abc"):
            numpy.testing.assert_array_equal(corners[:, column], face[name] + 1)
        for name, rows in (("m.vert", rows), ("m.face", corners)):
            counts = (self.folder / name).read_text().splitlines()[2].split()
            self.assertEqual(int(counts[0]), len(rows))

    def test_areas_of_atoms_and_of_residues_add_up_to_the_report_s(self):
        report = self.meshed("-o", "m.ply", "--areas", "areas.csv")
        with open(self.folder / "areas.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        sums = {what: math.fsum(float(r["area"]) for r in rows if r["of"] == what)
                for what in ("atom", "residue", "total")}
        self.assertEqual(sum(r["of"] == "residue" for r in rows), 46)
        self.assertEqual(sum(r["of"] == "atom" for r in rows), report["atoms_used"])
        self.assertAlmostEqual(sums["atom"], sums["total"], places=8)
        self.assertAlmostEqual(sums["residue"], sums["total"], places=8)
        self.assertAlmostEqual(sums["total"] / report["area"], 1, places=5)
        self.assertEqual(rows[0]["residue"], "THR")

    def test_rows_of_areas_name_the_file_s_atoms_and_add_those_of_one_residue(self):
        for file, text, first_line in (("a.pdb", pdb_text(), 1), ("a.cif", cif_text(), 13)):
            self.input(file, text)
            self.meshed("-o", "m.ply", "--areas", "areas.csv", molecule=file)
            with open(self.folder / "areas.csv", newline="") as table:
                header, *rows = csv.reader(table)
            self.assertEqual(header, "of atom line chain residue_number residue name element radius"
                                     " area".split())
            areas = [float(row.pop()) for row in rows]
            expected, sums = [], {}
            for i, (_, name, residue, chain, number, code, _, element) in enumerate(ATOMS):
                radius = {"C": "1.7", "N": "1.55"}[element]
                place = (chain, number + code.strip(), residue)
                expected.append(["atom", str(i + 1), str(first_line + i), *place, name, element,
                                 radius])
                sums[place] = sums.get(place, 0) + areas[i]
                if i in (2, 5):  # alone
                    ball = 4 * math.pi * float(radius)**2
                    self.assertAlmostEqual(areas[i] / ball, 1, delta=0.05)
            expected += [["residue", "", "", *place, "", "", ""] for place in sums]
            self.assertEqual(rows, [*expected, ["total", *[""] * 8]])
            for found, area in zip(areas[len(ATOMS):], sums.values()):
                self.assertAlmostEqual(found, area, places=9)

    def test_standard_output_gets_what_is_told_too(self):
        told = self.run_morskin("mesh", self.ring, "-o", "-", "--vertex-data", "normal", "-q")
        self.assertIn(b"property double nx\n", told.stdout[:2000])

    def test_tetgen_fills_the_off_file_with_tetrahedra(self):
        self.meshed("-o", "m.off", "--voids", "drop")
        done = subprocess.run(["tetgen", "-pQ", "m.off"], cwd=self.folder, capture_output=True)
        self.assertEqual(done.returncode, 0, done.stdout[-500:])
        tetrahedra = (self.folder / "m.1.ele").read_text().splitlines()[0]
        self.assertGreater(int(tetrahedra.split()[0]), 1000)


if __name__ == "__main__":
    main()
