#!/usr/bin/env python3
"""Where the molecules of a batch are: lists, folders, archives, patterns.
Usage: batch_sources_test.py path/to/morskin"""

import gzip
import os
import resource
import subprocess
import tarfile

from support.batch_case import COARSE, Batch, chain
from support.command import main, morskin


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
        (self.folder / "in/bare").symlink_to("nowhere")
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

    def test_a_name_that_an_archive_has_twice_and_an_archive_given_twice_are_called_so(self):
        self.chains(1)
        with tarfile.open(self.folder / "in.tar", "w") as archive:
            archive.add(self.folder / "in/chain00.xyzr", arcname="a.xyzr")
        twice = "a.xyzr in in.tar is there twice"
        self.assertIn(twice, self.batch("in.tar", "in.tar", "-o", "out", code=2))
        with tarfile.open(self.folder / "in.tar", "a") as archive:
            archive.add(self.folder / "in/chain00.xyzr", arcname="a.xyzr")
        self.assertIn(twice, self.batch("in.tar", "-o", "out", code=2))

    def test_a_torn_archive_is_unreadable(self):
        self.chains(3)
        with tarfile.open(self.folder / "in.tar.gz", "w:gz") as archive:
            archive.add(self.folder / "in", arcname="in")
        whole = (self.folder / "in.tar.gz").read_bytes()
        self.input("torn.tar.gz", whole[:len(whole) // 2])
        self.assertIn("torn.tar.gz: ", self.batch("torn.tar.gz", "-o", "out", code=3))

    def test_an_archive_that_cannot_be_opened_for_want_of_descriptors_is_told_so(self):
        self.chains(1)
        with tarfile.open(self.folder / "in.tar", "w") as archive:
            archive.add(self.folder / "in", arcname="in")
        run = subprocess.Popen([morskin(), "batch", "-", "in.tar", "-o", "out"], cwd=self.folder,
                               stdin=subprocess.PIPE, stderr=subprocess.PIPE)
        run.stdin.write(b"# more than a pipe holds, so that it has been read from\n" * 10000)
        resource.prlimit(run.pid, resource.RLIMIT_NOFILE, (3, 3))
        complaint = run.communicate(b"in/chain00.xyzr\n", timeout=60)[1].decode()
        self.assertEqual(run.returncode, 3)
        self.assertEqual(complaint, "morskin: in.tar: cannot be opened: Too many open files; "
                                    "allow more open files (ulimit -n)\n")

    def test_archives_behind_each_other_in_one_file_are_all_read(self):
        self.chains(2)
        self.input("two.xyzr", chain(7))
        for name, held in (("a.tar", "in"), ("b.tar", "two.xyzr")):
            with tarfile.open(self.folder / name, "w") as archive:
                archive.add(self.folder / held, arcname=held)
        a, b = ((self.folder / name).read_bytes() for name in ("a.tar", "b.tar"))
        for ending, pack in (("tar", bytes), ("tar.gz", gzip.compress)):
            with self.subTest(ending):
                self.input(f"ab.{ending}", pack(a + b))
                self.batch(f"ab.{ending}", "-o", ending, *COARSE)
                self.assertEqual(sorted(self.rows(ending)),
                                 ["in/chain00.xyzr", "in/chain01.xyzr", "two.xyzr"])
                for wrong in (a + b[:512], a + b"x" * 512, a + b"x"):
                    self.input(f"wrong.{ending}", pack(wrong))
                    self.batch(f"wrong.{ending}", "-o", "wrong", *COARSE, code=3)

    def test_an_archive_cut_between_two_files_is_unreadable(self):
        names = self.chains(3)
        with tarfile.open(self.folder / "in.tar", "w") as archive:
            archive.add(self.folder / "in", arcname="in")
        whole = (self.folder / "in.tar").read_bytes()
        with tarfile.open(self.folder / "in.tar") as archive:
            last = archive.getmembers()[-1]
        end = last.offset_data + (last.size + 511) // 512 * 512
        for place in (last.offset, end):
            for ending, pack in (("tar", bytes), ("tar.gz", gzip.compress)):
                self.input(f"cut.{ending}", pack(whole[:place]))
                with self.subTest(place, ending=ending):
                    complaint = self.batch(f"cut.{ending}", "-o", "out", code=3)
                    self.assertIn(f"cut.{ending}: has no end", complaint)
        self.assertFalse((self.folder / "out").exists())
        self.input("short.tar", whole[:end + 512])  # of two blocks of zeros one will do
        self.assertEqual(self.batch("short.tar", "-o", "out", *COARSE)["rows"], len(names))

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

    def test_what_an_archive_holds_too_long_for_any_reader_is_not_unpacked(self):
        names = self.chains(1)
        with open(self.folder / "in/long.pdb", "wb") as file:
            file.truncate(3 << 30)
        subprocess.run(["tar", "--sparse", "-cf", "in.tar", "in"], cwd=self.folder, check=True)
        self.batch("in.tar", "-o", "out", *COARSE)
        rows = self.rows()
        self.assertEqual(rows[f"in/{names[0]}"]["status"], "ok")
        self.assertEqual(rows["in/long.pdb"]["status"], "unreadable")
        self.assertIn("long.pdb: holds more than 2147483648 bytes", rows["in/long.pdb"]["reason"])

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
        for ring in ("ring.xyzr", "ring.txt"):
            (self.folder / "in" / ring).symlink_to(ring)
        (self.folder / "in/folder.xyzr").mkdir()
        self.batch("in", "-o", "out", *COARSE)
        self.assertEqual({name: row["status"] for name, row in self.rows().items()},
                         dict.fromkeys(names, "ok") |
                         dict.fromkeys(("gone.xyzr", "ring.xyzr"), "unreadable"))

    def test_of_a_folder_and_a_pattern_only_files_are_taken(self):
        names = self.chains(1)
        os.mkfifo(self.folder / "in/pipe.xyzr")  # which would hold its worker for ever
        (self.folder / "in/folder.xyzr").mkdir()
        (self.folder / "in/gone.xyzr").symlink_to("nowhere.xyzr")
        for number, words in enumerate(("in", "in/*.xyzr")):
            self.batch(words, "-o", f"out{number}", "--timeout", "20", *COARSE)
            self.assertEqual(sorted(self.rows(f"out{number}")), [*names, "gone.xyzr"])

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
