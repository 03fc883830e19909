#!/usr/bin/env python3
"""What the second checker, certify/verify/, reads, and that it takes nothing else for it; and that
it ends where a process of its own does.
Usage: verify_files_test.py path/to/morskin (not run)"""

import io
import json
import os
import subprocess
import sys
import unittest
from pathlib import Path
from unittest import mock

import numpy as np

from support.command import main
from support.programs import temporary_folder

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "certify" / "verify"))
import files  # noqa: E402
import verify  # noqa: E402

POINTS = [(0., 0, 0), (1, 0, 0), (0, 1, 0), (0.1, 0, 1)]
FACES = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
HEADER = """ply
format binary_little_endian 1.0
comment of anybody's
element vertex 4
property {real} x
property {real} y
property {real} z
property uchar more
element face 4
property list uchar int vertex_indices
property int more
end_header
"""


def off(faces, points=POINTS, word="OFF"):
    rows = [word, f"{len(points)} {len(faces)} 0 # and a remark"]
    return "\n".join(rows + [" ".join(map(repr, row)) for row in [*points, *faces]])


def ply(real="double", faces=FACES, size=3, header=HEADER):
    kind = {"double": "<f8", "float": "<f4"}[real]
    points = np.array([(*p, 7) for p in POINTS], [*((axis, kind) for axis in "xyz"), ("m", "u1")])
    rows = np.array([(size, f, -1) for f in faces], [("s", "u1"), ("f", "<i4", 3), ("m", "<i4")])
    return header.format(real=real).encode() + points.tobytes() + rows.tobytes()


def killed(_):
    """As the system ends a process that takes too much memory."""
    os._exit(137)


class VerifyFiles(unittest.TestCase):
    def setUp(self):
        self.path = temporary_folder(self) / "file"

    def read(self, content, reader, *more):
        self.path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return reader(self.path, *more)

    def refused(self, contents, reader, *more):
        for content in contents:
            with self.subTest(content), self.assertRaises((ValueError, KeyError, TypeError)):
                self.read(content, reader, *more)

    def test_balls_are_four_numbers_on_a_line_none_too_large(self):
        found = self.read("# x y z w\n0 1 2 -3\n-1e30 0 0 1\n", files.read_balls)
        self.assertEqual(found.tolist(), [[0, 1, 2, -3], [-1e30, 0, 0, 1]])
        self.assertEqual(self.read("0 0 0 1", files.read_balls).shape, (1, 4))
        self.refused(["0 0 1", "0 0 0 1 1", "0 0 0 1\n0 0 1", "0 0 0 nan", "inf 0 0 1", "0 0 0 x",
                      "0 0 0 2e30", "0 0 0 1\n0 -2e30 0 1"], files.read_balls)

    def test_meshes_are_triangles_of_vertices_that_are_there_in_off_or_ply(self):
        for content in (off([(3, *f) for f in FACES]), ply(), ply("float")):
            points, faces = self.read(content, files.read_mesh)
            np.testing.assert_allclose(points, POINTS, atol=1e-7)
            self.assertEqual(faces.tolist(), [list(f) for f in FACES])
        for at, wrong in ((1, -1), (3, 4), (2, 2**31 - 1)):
            row = [3, *FACES[2]]
            row[at] = wrong
            faces = [tuple(row) if f is FACES[2] else (3, *f) for f in FACES]
            self.refused([off(faces), ply(faces=[f[1:] for f in faces])], files.read_mesh)
        fours = [(4, *f) for f in FACES]
        self.refused([off(fours), ply(size=4), ply(size=2), off([(3, *f) for f in FACES], word="N"),
                      off([(3, *f, 0) for f in FACES]), off([(3, 0, 1)]), ply()[:-1], "", "OFF",
                      ply() + ply(),
                      ply(header=HEADER.replace("little", "big")),
                      ply(header=HEADER.replace("list uchar int", "list uchar uint"))],
                     files.read_mesh)

    def test_no_number_of_an_off_file_is_one_that_python_alone_reads(self):
        rows = off([(3, *f) for f in FACES])
        for number in ("0.0", "0.1", "4 4 0", "3 0 2 1"):
            self.refused([rows.replace(number, number[:-1] + "0_" + number[-1], 1),
                          rows.replace(number, "0_" + number, 1)], files.read_mesh)

    def test_an_off_file_of_fewer_than_no_vertices_is_none(self):
        # Cut so many numbers before the end, both parts would have the right lengths.
        points = [*POINTS, (1., 1, 1), (1., 1, 2), (1., 2, 1), (2., 1, 1)]
        rows = off([(3, *f) for f in FACES * 3], points)
        self.assertEqual(len(self.read(rows, files.read_mesh)[1]), 12)
        self.refused([rows.replace("8 12 0", "-16 12 0")], files.read_mesh)

    def test_a_certificate_is_of_this_mesh_and_names_only_what_is_there(self):
        right = {"format": "morskin-certificate-1", "balls": 5, "vertices": 4, "triangles": 4,
                 "simplices": [[0, 1, 2, 4]], "vertex_atoms": [[4], [0, 1], [2, 1, 0], [3]],
                 "component_vertices": [3, 0], "dropped_voids": 0}
        found = self.read(json.dumps(right), files.read_certificate, 5, 4, 4)
        self.assertEqual(found["vertex_atoms"].tolist(),
                         [[4] * 4, [0, 1] * 2, [2, 1, 0, 2], [3] * 4])
        wrong = [{key: right[key] + 1} for key in ("balls", "vertices", "triangles")]
        wrong += [{"format": "morskin-certificate-2"}]
        wrong += [{"simplices": [[0, 1, 2, i]]} for i in (-1, 5)]
        wrong += [{"vertex_atoms": [[4], [0], [2], [i]]} for i in (-1, 5)]
        wrong += [{"vertex_atoms": [[4], [0], [2], [3, i]]} for i in (-1, 5)]
        wrong += [{"vertex_atoms": atoms} for atoms in ([[4]] * 3, [[4]] * 5, [[4]] * 3 + [[]])]
        wrong += [{"component_vertices": [v]} for v in (-1, 4)] + [{"dropped_voids": "some"}]
        self.refused([json.dumps(right | change) for change in wrong], files.read_certificate,
                     5, 4, 4)

    def test_an_empty_mesh_is_not_proved_and_its_certificate_not_unreadable(self):
        names = [str(self.path.with_name(name)) for name in ("a.xyzw", "a.off", "a.json")]
        witness = {"format": "morskin-certificate-1", "balls": 1, "vertices": 0, "triangles": 0,
                   "simplices": [[0]], "vertex_atoms": [], "component_vertices": [],
                   "dropped_voids": 0}
        for name, text in zip(names, ("0 0 0 2\n", "OFF\n0 0 0\n", json.dumps(witness))):
            Path(name).write_text(text, encoding="utf-8")
        report = verify.verify(names)
        self.assertTrue(report["reason"].startswith("manifold: "), report["reason"])

    def test_a_list_of_names_that_is_no_text_or_names_itself_is_a_wrong_argument(self):
        for content in (b"balls\xff\nmesh\ncertificate\n", f"@{self.path}\n".encode()):
            self.path.write_bytes(content)
            with self.subTest(content), mock.patch.multiple(
                    sys, argv=["verify.py", f"@{self.path}"], stdout=io.StringIO(),
                    stderr=io.StringIO()):
                try:
                    code = verify.main()  # from Python 3.12 on any bytes are a file's name
                except SystemExit as ended:
                    code = ended.code
            self.assertEqual(code, 2)

    def test_without_numpy_it_says_so_and_gives_no_verdict(self):
        folder = self.path.parent
        (folder / "numpy.py").write_text("raise ImportError('no numpy')\n", encoding="utf-8")
        done = subprocess.run([sys.executable, verify.__file__, "b", "m", "c"], check=False,
                              capture_output=True, env={**os.environ, "PYTHONPATH": str(folder)})
        self.assertEqual((done.returncode, done.stdout), (2, b""))
        self.assertEqual(done.stderr, b"verify.py: no numpy; install numpy (python3-numpy)\n")

    def test_a_verdict_that_cannot_be_printed_is_none(self):
        with open("/dev/full", "wb") as full:
            done = subprocess.run([sys.executable, verify.__file__, "b", "m", "c"], check=False,
                                  stdout=full, stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr, b"verify.py: [Errno 28] No space left on device\n")

    def test_a_process_that_the_system_ends_leaves_a_verdict_on_each_mesh(self):
        with mock.patch.object(verify, "verify", killed):
            reports = list(verify.verify_all([("b", "m1", "c"), ("b", "m2", "c")]))
        self.assertEqual([r["mesh"] for r in reports], ["m1", "m2"])
        for report in reports:
            self.assertFalse(report["homeomorphic"] or report["on_skin"])
            self.assertRegex(report["reason"], "^not proved: a process was ended")

    def test_a_process_that_ends_while_meshes_are_still_handed_out_leaves_a_verdict_on_each(self):
        names = [f"m{i}" for i in range(3000)]
        with mock.patch.object(verify, "verify", killed):
            reports = list(verify.verify_all([("b", name, "c") for name in names]))
        self.assertEqual([r["mesh"] for r in reports], names)
        self.assertFalse([r for r in reports if not r["reason"].startswith("not proved: a proc")])


if __name__ == "__main__":
    main()
