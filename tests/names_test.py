#!/usr/bin/env python3
"""Names that mean harm: of files, molecules, residues and atoms. They must reach neither the
terminal as commands nor a page as markup. Usage: names_test.py path/to/morskin"""

import base64
import json
import re
import shlex
import tarfile
import unittest
from html.parser import HTMLParser

from support.batch_case import COARSE, Batch, chain
from support.command import MOLECULES, CommandTest, main

ESCAPES = ["\x1b[31mred", "\x1b]0;title\x07", "a\tb", "\x9b2J", "\x7f", "back\x08space",
           "carriage\rreturn"]
MARKUP = ["</script><script>alert(1)</script>", "<!--<script>", "]]>", "\"'><img src=x>",
          "&lt;/script&gt;"]
# All control characters but the line's end, of ASCII and of Unicode.
CONTROL = re.compile("[\x00-\x09\x0b-\x1f\x7f\x80-\x9f]")


def mmcif(name, radius_comment="", x="0"):
    """A molecule of two atoms, whose atom, residue and chain have this name."""
    quote = ";" if "'" in name or '"' in name else "'"
    text = f"\n;{name}\n;\n" if quote == ";" else f"'{name}'"
    rows = "".join(f"C {text} {text} {text} {place} 0 0\n" for place in (x, "2"))
    return ("data_x\n" + radius_comment + "loop_\n_atom_site.type_symbol\n"
            "_atom_site.label_atom_id\n_atom_site.label_comp_id\n_atom_site.label_asym_id\n"
            "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n" + rows)


class Page(HTMLParser):
    """The scripts of a page, and all its tags."""

    def __init__(self, text):
        super().__init__()
        self.scripts, self.tags = [], []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, tuple(attrs)))
        if tag == "script":
            self.scripts.append("")

    def handle_data(self, data):
        if self.scripts and self.cdata_elem == "script":
            self.scripts[-1] += data


class Names(CommandTest):
    def said(self, *words, code=0):
        done = self.run_morskin(*words, code=code)
        return (done.stdout + done.stderr).decode(errors="replace")

    def assert_no_commands(self, said):
        self.assertIsNone(CONTROL.search(said), repr(said))

    def test_what_to_type_next_is_one_command_whatever_the_name(self):
        for name in ("plain.pdb", "a b.pdb", "it's.pdb", "$(ls);*.pdb", "-d.pdb"):
            self.input(name, (MOLECULES / "benzene.pdb").read_bytes())
            line = self.said(f"./{name}").splitlines()[-1]
            typed = line.split(" writes the mesh")[0].split(maxsplit=1)[1]
            self.assertEqual(shlex.split(typed),
                             ["morskin", f"./{name}", "-o", name[:-4] + ".ply"])

    def test_what_to_type_next_asks_for_what_info_was_asked_about(self):
        self.input("b.pdb", (MOLECULES / "benzene.pdb").read_bytes())
        self.input("a b.txt", "C 1.9\nH 1.1\n")
        options = ["--model", "sas", "-C", "0.4", "--radii", "a b.txt"]
        for words in (["b.pdb", *options], ["b.pdb", *options, "--threads", "1"]):
            line = self.said(*words).splitlines()[-1]
            typed = shlex.split(line.split(" writes the mesh")[0].split(maxsplit=1)[1])
            self.assertEqual(typed, ["morskin", *words, "-o", "b.ply"])

    def test_no_name_of_a_file_commands_the_terminal(self):
        for name in ESCAPES:
            with self.subTest(repr(name)):
                self.assert_no_commands(self.said("mesh", name + ".xyzr", "-o", "x.ply", code=3))
                molecule = self.input(name + ".xyzr", "0 0 0 1\n").name
                for words in (("info", molecule), ("info", molecule, "--json"),
                              ("mesh", molecule, "-o", name + ".ply"),
                              ("check", name + ".ply"), ("check", name + ".ply", "--json"),
                              ("view", name + ".ply", "-o", name + ".html")):
                    self.assert_no_commands(self.said(*words))
                for words, code in ((("mesh", molecule, "-o", name), 2),
                                    (("mesh", molecule, "-o", "no/" + name + ".ply"), 7),
                                    (("mesh", molecule, "-o", name + ".ply", "--method",
                                      "marching-cubes"), 5),
                                    (("mesh", molecule, "--model", name, "-o", "x.ply"), 2),
                                    (("mesh", molecule, "-o", "x.ply", "--timeout", "1e-6"), 6)):
                    self.assert_no_commands(self.said(*words, code=code))

    def test_no_name_of_an_atom_commands_the_terminal(self):
        for name in ESCAPES:
            with self.subTest(repr(name)):
                self.input("far.cif", mmcif(name, x="1e9"))
                self.assert_no_commands(self.said("mesh", "far.cif", "-o", "x.ply", code=4))
                raw = name.encode()
                self.input("far.pdb", b"ATOM      1 " + raw[:4].ljust(4) + b" " +
                           raw[:3].ljust(3) + b" A   1     1.0e9     0.000   0.000\n")
                self.assert_no_commands(self.said("mesh", "far.pdb", "-o", "x.ply", code=4))

    def test_json_keeps_the_name(self):
        name = "\x1b[31mred.xyzr"
        self.input(name, "0 0 0 1\n")
        self.assertEqual(json.loads(self.said("info", name, "--json"))["input"], name)

    def test_no_name_leaves_the_script_of_a_page(self):
        self.input("plain.cif", mmcif("CA"))
        self.run_morskin("view", "plain.cif", "-o", "plain.html", "-q")
        plain = Page((self.folder / "plain.html").read_text())
        for name in MARKUP:
            with self.subTest(name):
                molecule = self.input(name.replace("/", "\u2215") + ".cif", mmcif(name)).name
                self.run_morskin("view", molecule, "-o", "x.html", "-q")
                page = Page((self.folder / "x.html").read_text())
                self.assertEqual(page.tags, plain.tags)
                self.assertEqual(len(page.scripts), len(plain.scripts))
                about = next(json.loads(script) for script in page.scripts
                             if script.lstrip().startswith("{"))
                self.assertEqual(about["title"], molecule)


class Batches(Batch):
    def test_names_that_mean_harm_stay_in_the_folder(self):
        for folder in ("in", "bad"):
            (self.folder / folder).mkdir()
        names = ["-o.xyzr", "a b.xyzr", "$(touch x).xyzr", "'q\".xyzr", "new\nline.xyzr", "ö.xyzr"]
        for seed, name in enumerate(names):
            self.input(f"in/{name}", chain(seed))
        with tarfile.open(self.folder / "up.tar", "w") as archive:
            archive.add(self.folder / "in" / names[1], arcname="../../up.xyzr")
        self.assertEqual(self.batch("in", "-o", "out", *COARSE)["statuses"], {"ok": len(names)})
        self.assertEqual(sorted(self.rows()), sorted(names))
        self.batch("up.tar", "-o", "up", *COARSE)
        self.assertEqual(list(self.made("up")), ["up.xyzr.ply"])
        self.assertEqual(self.names(), ["bad", "in", "out", "up", "up.tar"])
        self.input("bad/no\natoms.pdb", "x\n")
        self.batch("bad", "-o", "rows", *COARSE)
        self.assertIn("no\natoms.pdb: has no ATOM", self.rows("rows")["no\natoms.pdb"]["reason"])
        self.input(b"in/\xff.xyzr".decode(errors="surrogateescape"), chain(9))
        self.assertIn("no UTF-8", self.batch("in", "-o", "out", *COARSE, code=2))


if __name__ == "__main__":
    main()
