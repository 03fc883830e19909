#!/usr/bin/env python3
"""Many molecules by one command: rows, resuming after any end, shards, where the molecules are.
Usage: batch_test.py path/to/morskin"""

import gzip
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
            self.assertEqual((rows[name]["status"], rows[name]["triangles"]),
                             ("ok", report["triangles"]))
        triangles = sorted(row["triangles"] for row in rows.values())
        self.assertEqual([summary["triangles"][k] for k in ("least", "median", "most")],
                         [triangles[0], triangles[2], triangles[4]])
        self.assertEqual(summary["triangles"]["sum"], sum(triangles))

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
        self.assertIn("--radii", self.batch("in", "-o", "x", *COARSE, "--radii", "-", code=2))

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

    def test_wrong_arguments_give_2_and_make_nothing(self):
        self.chains(1)
        options = ("-C -1", "--density 0", "--format png", "--format .ply", "--format a.ply",
                   "--shard 0/2", "--shard 3/2", "--shard 1/2x", "--workers 0", "--timeout -1",
                   "--report x")
        for words in (("in",), ("-o", "out"), ("in", "-o", ""),
                      *(("in", "-o", "out", *option.split()) for option in options)):
            with self.subTest(words):
                self.assertNotIn("molecule.pdb", self.batch(*words, code=2))
        self.assertEqual(self.names(), ["in"])
        for words in (("no*.pdb",), ("in", "no*.pdb"), ("nothing",), ("in", "--only", "*.pdb")):
            self.batch(*words, "-o", "out", code=3)
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

    def test_a_disk_too_full_for_what_an_archive_holds_gives_7(self):
        self.input("big.xyzr", chain(0, 400))
        with tarfile.open(self.folder / "big.tar.gz", "w:gz") as archive:
            archive.add(self.folder / "big.xyzr", arcname="big.xyzr")
        def no_large_files():
            resource.setrlimit(resource.RLIMIT_FSIZE, (4000, 4000))
        complaint = self.batch("big.tar.gz", "-o", "out", *COARSE, code=7,
                               preexec_fn=no_large_files)
        self.assertIn("big.xyzr: cannot write: ", complaint)

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
        self.input("radii.txt", "C 2.7\n")
        self.assertIn("choose another folder", self.batch(*words, code=2))

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


class Sources(Batch):
    def test_all_ways_to_name_molecules_mean_the_same(self):
        names = self.chains(4)
        (self.folder / "in/below").mkdir()
        self.input("in/below/ring12.xyzr.gz", gzip.compress(self.ring.read_bytes()))
        self.input("in/about.json", "{}")
        self.batch("in", "-o", "out", *COARSE)
        expected = self.made()
        self.assertEqual(sorted(self.rows()), ["below/ring12.xyzr.gz", *names])
        listed = "".join(f"{p}\n" for p in ("in/below/ring12.xyzr.gz",
                                            *(f"in/{n}" for n in names)))
        self.input("list.txt", listed)
        for ending in ("", ".gz", ".xz"):
            with tarfile.open(self.folder / f"in.tar{ending}", "w:" + ending[1:]) as archive:
                archive.add(self.folder / "in", arcname=".")
        ways = [["list.txt"], ["-"], ["in/b*/*.gz", "in/*.xyzr"], ["in.tar"],
                ["in.tar.gz"], ["in.tar.xz"], listed.split()]
        for number, words in enumerate(ways):
            with self.subTest(words):
                self.batch(*words, "-o", f"out{number}", *COARSE,
                           input=listed.encode() if words == ["-"] else b"")
                self.assertEqual(self.made(f"out{number}"), expected)
        self.assertEqual(sorted(self.rows("out3")), sorted(self.rows()))
        self.batch("in.tar", "-o", "some", "--only", "*1.xyzr", *COARSE)
        self.assertEqual(list(self.rows("some")), ["chain01.xyzr"])

    def test_equal_names_from_two_folders_are_refused(self):
        self.chains(2)
        self.chains(1, "more")
        self.chains(1, "deep/a")
        self.chains(1, "deep/b")
        with tarfile.open(self.folder / "more.tar", "w") as archive:
            archive.add(self.folder / "more", arcname="more")
        for words in (("in", "more"), ("deep",), ("*/*.xyzr",), ("in", "more.tar")):
            complaint = self.batch(*words, "-o", "out", code=2)
            self.assertIn("would have the same name", complaint)
        self.assertFalse((self.folder / "out").exists())
        self.batch("in/chain00.xyzr", "-o", "out", *COARSE)
        complaint = self.batch("more/chain00.xyzr", "-o", "out", *COARSE, code=2)
        self.assertIn("has a row of in/chain00.xyzr", complaint)

    def test_one_file_under_two_names_is_called_the_same_file(self):
        self.chains(1)
        both = ("in/chain00.xyzr", "./in/chain00.xyzr")
        self.assertIn("are the same file", self.batch(*both, "-o", "out", code=2))

    def test_a_torn_archive_is_unreadable(self):
        self.chains(3)
        with tarfile.open(self.folder / "in.tar.gz", "w:gz") as archive:
            archive.add(self.folder / "in", arcname="in")
        whole = (self.folder / "in.tar.gz").read_bytes()
        self.input("torn.tar.gz", whole[:len(whole) // 2])
        self.assertIn("torn.tar.gz: ", self.batch("torn.tar.gz", "-o", "out", code=3))

    def test_a_wrong_bit_in_an_archive_is_found_before_anything_is_made(self):
        names = self.chains(3)
        for ending in ("gz", "bz2", "xz"):
            path = self.folder / f"in.tar.{ending}"
            with tarfile.open(path, f"w:{ending}") as archive:
                archive.add(self.folder / "in", arcname="in")
            whole = path.read_bytes()
            # Where a flip may still unpack to as many bytes; the last of gzip's is of the checksum.
            for at in (len(whole) // 3, len(whole) // 2, len(whole) - 6):
                wrong = bytearray(whole)
                wrong[at] ^= 4
                path.write_bytes(wrong)
                with self.subTest(ending, at=at):
                    self.assertIn(path.name, self.batch(path.name, "-o", "out", code=3))
            self.assertFalse((self.folder / "out").exists())
            path.write_bytes(whole)
            self.batch(path.name, "-o", ending, *COARSE)
            self.assertEqual(len(self.rows(ending)), len(names))

    def test_of_an_archive_links_are_refused_and_hidden_files_left_out(self):
        self.chains(1)
        self.input("in/._chain00.xyzr", "not a molecule")
        with tarfile.open(self.folder / "in.tar", "w") as archive:
            archive.add(self.folder / "in", arcname="in")
        self.batch("in.tar", "-o", "out", *COARSE)
        self.assertEqual(list(self.rows()), ["in/chain00.xyzr"])
        for make in (os.link, os.symlink):
            link = self.folder / "in/link.xyzr"
            make(self.folder / "in/chain00.xyzr", link)
            with tarfile.open(self.folder / "links.tar", "w") as archive:
                archive.add(self.folder / "in", arcname="in")
            complaint = self.batch("links.tar", "-o", "links", *COARSE, code=3)
            self.assertIn(" is a link", complaint)
            self.assertEqual(self.batch("in", "-o", make.__name__, *COARSE)["rows"], 2)
            link.unlink()

    def test_a_link_of_a_folder_that_leads_nowhere_gets_a_row(self):
        names = self.chains(1)
        (self.folder / "in/gone.xyzr").symlink_to("nowhere.xyzr")
        (self.folder / "in/gone.txt").symlink_to("nowhere.txt")
        (self.folder / "in/folder.xyzr").mkdir()
        self.batch("in", "-o", "out", *COARSE)
        self.assertEqual({name: row["status"] for name, row in self.rows().items()},
                         dict.fromkeys(names, "ok") | {"gone.xyzr": "unreadable"})

    def test_a_name_too_long_for_its_output_is_refused_before_anything_is_made(self):
        self.chains(1)
        for length, code in ((225, 0), (247, 2)):
            name = "x" * length + ".xyzr"
            self.input(f"in/{name}", chain(1))
            with self.subTest(length):
                done = self.batch("in", "-o", f"out{code}", *COARSE, code=code)
            self.assertEqual(f"{name}: with another ending the name is too long" in str(done),
                             code == 2)
        self.assertFalse((self.folder / "out2").exists())


if __name__ == "__main__":
    main()
