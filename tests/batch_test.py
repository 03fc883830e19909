#!/usr/bin/env python3
"""Many molecules by one command: their rows, and how it ends.
Usage: batch_test.py path/to/morskin"""

import json
import os
import resource
import subprocess
import tarfile
from pathlib import Path

from support.batch_case import COARSE, Batch, chain
from support.command import main, morskin


class Rows(Batch):
    def test_what_is_made_is_what_mesh_makes(self):
        names = self.chains(5)
        summary = self.batch("in", "-o", "out", *COARSE, "--format", "ply,vert")
        self.assertEqual((summary["inputs"], summary["rows"], summary["made"]), (5, 5, 5))
        self.assertEqual(summary["statuses"], {"ok": 5})
        rows, made = self.rows(), self.made()
        self.assertEqual(len(made), 15)
        for name in names:
            report = self.mesh_json(f"in/{name}", "-o", "one.ply", "-o", "one.vert", *COARSE)
            outputs = [f"{name}.ply", f"{name}.vert", f"{name}.face"]
            self.assertEqual(rows[name]["outputs"], outputs)
            for output in outputs:
                one = (self.folder / ("one" + Path(output).suffix)).read_bytes()
                self.assertEqual(made[output], one)
            told = {key: report[key] for key in ("vertices", "triangles", "area", "min_angle_deg",
                                                 "components", "genus")}
            told |= {"status": "ok", "atoms": report["atoms_used"],
                     "input_sha256": report["provenance"]["input-sha256"],
                     "vertices_per_square_angstrom":
                         report["quality"]["vertices_per_square_angstrom"]}
            self.assertEqual({key: rows[name][key] for key in told}, told)
        triangles = sorted(row["triangles"] for row in rows.values())
        self.assertEqual([summary["triangles"][k] for k in (
            "least", "5%", "25%", "median", "75%", "95%", "most")],
            [triangles[k] for k in (0, 0, 1, 2, 3, 4, 4)])
        self.assertEqual(summary["triangles"]["sum"], sum(triangles))

    def test_the_summary_rounds_no_number_of_the_rows(self):
        self.chains(3)
        memory = self.batch("in", "-o", "out", *COARSE)["peak_memory_bytes"]
        lines = (self.folder / "out/rows.jsonl").read_text().splitlines()
        values = sorted(json.loads(line)["peak_memory_bytes"] for line in lines)
        self.assertEqual([memory[k] for k in ("least", "median", "most")], values)
        self.assertEqual(memory["sum"], sum(values))

    def test_a_shard_without_molecules_has_a_line_of_counts_and_no_table(self):
        self.chains(1)
        done = self.run_morskin("batch", "in", "-o", "out", "--shard", "2/3")
        self.assertEqual(done.stdout, b"0 molecules, 0 rows, 0 made now in 0 s\n")

    def test_curved_triangles_are_those_of_mesh(self):
        name, = self.chains(1)
        self.batch("in", "-o", "out", *COARSE, "--format", "vtu,msh", "--order", "2")
        self.mesh_json(f"in/{name}", "-o", "one.vtu", "-o", "one.msh", *COARSE, "--order", "2")
        for ending in ("vtu", "msh"):
            self.assertEqual(self.made()[f"{name}.{ending}"],
                             (self.folder / f"one.{ending}").read_bytes())
        self.batch("in", "-o", "x", *COARSE, "--order", "2", code=2)  # of PLY

    def test_both_files_of_msms_may_be_named_and_are_there(self):
        self.chains(1)
        for k, endings in enumerate(("vert", "face,vert", "ply,vert,off,face")):
            self.batch("in", "-o", f"out{k}", *COARSE, "--format", endings)
            [row] = self.rows(f"out{k}").values()
            for name in row["outputs"]:
                self.assertGreater((self.folder / f"out{k}" / name).stat().st_size, 0)
            self.assertEqual(sorted(name.split(".")[-1] for name in row["outputs"]),
                             sorted({"vert", "face", *endings.split(",")}))

    def test_radii_cannot_come_from_a_standard_input_that_workers_lack(self):
        self.chains(1)
        table = self.input("radii.txt", "C 1.7\n")
        for name in ("-", "/dev/stdin"):
            with open(table, "rb") as stream:
                complaint = self.batch("in", "-o", "x", *COARSE, "--radii", name, code=2,
                                       stdin=stream)
            self.assertIn("--radii", complaint)

    def test_radii_cannot_come_from_a_pipe_that_the_first_reader_empties(self):
        self.chains(1)
        os.mkfifo(self.folder / "pipe")
        self.assertIn("--radii", self.batch("in", "-o", "x", *COARSE, "--radii", "pipe", code=2))
        self.assertFalse((self.folder / "x").exists())

    def test_with_features_it_makes_what_features_makes_with_the_same_options(self):
        names = self.chains(3)
        options = ("--density", "3", "--model", "vdw", "--max-memory", "2G", "--timeout", "100")
        summary = self.batch("in", "-o", "out", "--features", *options)
        self.assertEqual(summary["statuses"], {"ok": 3})
        made, rows = self.made(), self.rows()
        for name in names:
            self.run_morskin("features", f"in/{name}", "-o", "one.npz", "-q", *options)
            self.assertEqual(made[f"{name}.npz"], (self.folder / "one.npz").read_bytes())
            self.assertGreater(rows[name]["triangles"], 100)
        self.assertEqual(self.batch("in", "-o", "out", "--features", *options)["made"], 0)
        for option in ("--vertex-data all", "--decimals 3", "--order 2", "--grid 1", "--grow 0..1"):
            words = option.split()
            self.assertIn(words[0], self.batch("in", "-o", "x", "--features", *words, code=2))
        complaint = self.batch("in", "-o", "x", "--features", "--format", "npz,vtu", code=2)
        self.assertIn("--format", complaint)
        self.assertFalse((self.folder / "x").exists())

    def test_each_end_of_a_worker_is_a_status_with_its_reason(self):
        self.input("good.xyzr", chain(1))
        self.input("torn.pdb", "ATOM  nonsense\n")
        self.input("touching.xyzr", "0 0 0 2\n6 6 0 4\n")
        self.input("weights.xyzw", "0 0 0 2\n")
        self.input("list.txt", "good.xyzr\n\n# not this one\nmissing.pdb\ntorn.pdb\n"
                               "touching.xyzr\nweights.xyzw\ngood.xyzr\n")
        summary = self.batch("list.txt", "-o", "out", "--model", "vdw", *COARSE)
        self.assertEqual(summary["statuses"],
                         {"failed": 1, "ok": 1, "refused": 1, "unreadable": 2})
        rows = self.rows()
        for name, status, reason in (
                ("missing.pdb", "unreadable", "missing.pdb: cannot be opened"),
                ("torn.pdb", "unreadable", "torn.pdb:1: "),
                ("touching.xyzr", "refused", "touching.xyzr: the skin is singular at"),
                ("weights.xyzw", "failed", "gives weights; leave out --model")):
            with self.subTest(name):
                self.assertEqual((rows[name]["status"], rows[name]["outputs"]), (status, []))
                self.assertIn(reason, rows[name]["reason"])
        self.assertNotIn("reason", rows["good.xyzr"])
        self.assertEqual(list(self.made()), ["good.xyzr.ply"])

    def test_a_mesh_that_is_not_certified_keeps_its_ending(self):
        self.chains(2)
        self.batch("in", "-o", "out", "--method", "marching-cubes", "--grid", "0.5")
        self.assertEqual({row["status"] for row in self.rows().values()}, {"uncertified"})
        self.assertEqual(list(self.made()),
                         ["chain00.xyzr.ply.unverified", "chain01.xyzr.ply.unverified"])

    def test_limits_are_of_each_molecule(self):
        self.chains(2)
        for word, value in (("--timeout", "1e-6"), ("--max-memory", "1K")):
            # A few hundred triangles would fit into what reading the options has given back.
            self.batch("in", "-o", word, word, value, "-C", "0.1")
            rows = self.rows(word).values()
            self.assertEqual([(r["status"], r["outputs"]) for r in rows], 2 * [("limit", [])])
            self.assertTrue(all(word in r["reason"] for r in rows), rows)

    def test_a_molecule_that_takes_more_processor_time_than_the_system_grants_is_tried_once(self):
        self.chains(1, balls=400)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.batch("in", "-o", "out", "-C", "0.01", preexec_fn=lambda:
                   resource.setrlimit(resource.RLIMIT_CPU, (1, resource.RLIM_INFINITY)))
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        self.assertLess(after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, 2)
        row = self.rows()["chain00.xyzr"]
        self.assertEqual((row["status"], row["outputs"], self.made()), ("limit", [], {}))
        self.assertIn("processor time", row["reason"])

    def test_wrong_arguments_give_2_and_make_nothing(self):
        self.chains(1)
        options = ("-C -1", "--density 0", "--format png", "--format .ply", "--format a.ply",
                   "--shard 0/2", "--shard 3/2", "--shard 1/2x", "--workers 0", "--timeout -1",
                   "--report x")
        for words in (("in",), ("-o", "out"), ("in", "-o", ""),
                      *(("in", "-o", "out", *option.split()) for option in options)):
            with self.subTest(words):
                self.assertNotIn("molecule.pdb", self.batch(*words, code=2))
        no_utf8 = os.fsdecode(b"\xff")
        self.assertIn("no UTF-8", self.batch("in", "-o", "out", "--chain", no_utf8, code=2))
        for word in ("in/*", "in/" + sorted(os.listdir(self.folder / "in"))[0]):
            self.assertIn("--only is of folders and archives",
                          self.batch(word, "-o", "out", "--only", "*.cif", code=2))
        self.assertEqual(self.names(), ["in"])
        for words in (("no*.pdb",), ("in", "no*.pdb"), ("nothing",)):
            self.batch(*words, "-o", "out", code=3)
        self.assertIn("no molecules in in that fit --only *.pdb;",
                      self.batch("in", "-o", "out", "--only", "*.pdb", code=3))
        self.assertEqual(self.names(), ["in"])

    def test_a_full_disk_ends_the_batch_without_a_row(self):
        self.chains(2)
        def no_large_files():
            resource.setrlimit(resource.RLIMIT_FSIZE, (4000, 4000))
        complaint = self.batch("in", "-o", "out", *COARSE, code=7, preexec_fn=no_large_files)
        self.assertIn("cannot write: File too large", complaint)
        self.assertEqual((self.rows(), self.made()), ({}, {}))
        self.batch("in", "-o", "out", *COARSE)
        self.assertEqual(len(self.rows()), 2)

    def test_a_row_that_has_no_room_is_called_too_large_where_files_may_not_grow(self):
        self.input("list", "".join(f"{k}.pdb\n" for k in range(20)))
        def no_large_files():
            resource.setrlimit(resource.RLIMIT_FSIZE, (1000, 1000))
        complaint = self.batch("list", "-o", "out", code=7, preexec_fn=no_large_files)
        self.assertIn("out/rows.jsonl: cannot write: File too large; ", complaint)
        made = len(self.rows())  # the others whole
        self.assertEqual(self.batch("list", "-o", "out")["made"], 20 - made)

    def test_a_disk_too_full_for_what_an_archive_holds_gives_7(self):
        self.input("big.xyzr", chain(0, 400) + "# end\n" * 30000)
        with tarfile.open(self.folder / "big.tar.gz", "w:gz") as archive:
            archive.add(self.folder / "big.xyzr", arcname="big.xyzr")
        for most in (4000, 1 << 16):  # the second is where a block that is unpacked ends
            def no_large_files():
                resource.setrlimit(resource.RLIMIT_FSIZE, (most, most))  # pylint: disable=W0640
            complaint = self.batch("big.tar.gz", "-o", "out", *COARSE, code=7,
                                   preexec_fn=no_large_files)
            self.assertIn("big.xyzr: cannot write: File too large; ", complaint)
            self.assertEqual(os.listdir(self.folder / "out"), ["rows.jsonl"])

    def test_children_of_others_that_end_meanwhile_are_none_of_its_workers(self):
        self.input("one.xyzr", chain(0, 100))
        words = [morskin(), "batch", "one.xyzr", "-o", "out", "-C", "0.1"]
        done = subprocess.run(["sh", "-c", 'sleep 0.05 & exec "$@"', "sh", *words],
                              cwd=self.folder, capture_output=True, check=False)
        self.assertEqual((done.returncode, [row["status"] for row in self.rows().values()]),
                         (0, ["ok"]))

    def test_a_table_of_radii_counts_by_what_it_says(self):
        self.input("one.xyz", "1\n\nC 0 0 0\n")
        self.input("radii.txt", "C 1.7\n")
        words = ("one.xyz", "-o", "out", *COARSE, "--radii", "radii.txt")
        self.batch(*words)
        self.assertEqual(self.batch(*words)["made"], 0)
        self.input("other.txt", "C 1.7\n")
        for name in ("./radii.txt", "other.txt"):
            self.assertEqual(self.batch(*words[:-1], name)["made"], 0)
        self.input("radii.txt", "C 2.7\n")
        self.assertIn("choose another folder", self.batch(*words, code=2))

    def test_a_file_that_is_called_like_a_table_of_radii_does_not_count(self):
        self.input("one.xyz", "1\n\nC 0 0 0\n")
        for name in ("bondi", "C=1.7"):
            words = ("one.xyz", "-o", f"out {name}", *COARSE, "--radii", name)
            self.batch(*words)
            self.input(name, "C 2.7\n")
            self.assertEqual(self.batch(*words)["made"], 0)

    def test_progress_tells_how_long_it_will_take(self):
        self.chains(3)
        done = self.run_morskin("batch", "in", "-o", "out", *COARSE, "--progress", "always")
        self.assertRegex(done.stderr.decode(), r"\r2 of 3, \d+ s left *\r3 of 3, 0 s left")
        self.assertRegex(done.stdout.decode(), r"^3 molecules, 3 rows, 3 made now in .* s: 3 ok\n")

    def test_no_text_is_left_on_the_line_of_progress_in_the_end_however_long_it_was(self):
        self.batch("ring.xyzr", "-o", "out", *COARSE)
        row = self.rows()["ring.xyzr"]
        names = [f"{k}.pdb" for k in range(100_000)]
        self.input("list", "\n".join(names))
        rows = (json.dumps({**row, "input": name}) + "\n" for name in names[1:])
        self.input("out/rows.jsonl", "".join(rows))
        done = self.run_morskin("batch", "list", "-o", "out", *COARSE, "--progress", "always")
        texts = done.stderr.decode().split("\r")
        self.assertIn("100,000 of 100,000, 0 s left", [text.rstrip() for text in texts])
        for text in (line := "", *texts):  # a terminal keeps what is not written over
            line = text + line[len(text):]
        self.assertEqual(line.strip(), "")


if __name__ == "__main__":
    main()
