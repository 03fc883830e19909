#!/usr/bin/env python3
"""Manual pages and completions, which are made from the options, against the command's own help
and in a real shell. Usage: manual_test.py path/to/morskin path/to/morskin_manual bash|zsh"""

import filecmp
import re
import subprocess
import sys
import unittest

from support.programs import temporary_folder
from support.shell import Shell

MORSKIN, MANUAL, SHELL = sys.argv[1:4]


def help_of(*words):
    return subprocess.run([MORSKIN, *words], check=True, capture_output=True, text=True).stdout


def commands():
    listed = help_of("--help").partition("Subcommands:")[2].partition("\n\n")[0]
    return re.findall(r"^  (\w+)  ", listed, re.MULTILINE)


def options_of(command):
    """All that its help lists, one name each."""
    return set(re.findall(r"^  (-[^\s,]+)", help_of(command, "--help-all"), re.MULTILINE))


class ManualTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = temporary_folder(cls)
        cls.manual = cls.folder / "manual"
        subprocess.run([MANUAL, cls.manual], check=True)


class Pages(ManualTest):
    def test_there_is_a_page_of_the_program_and_of_each_command_that_its_help_lists(self):
        self.assertGreater(len(commands()), 7)
        self.assertEqual({p.name for p in self.manual.glob("*.1")},
                         {"morskin.1", *(f"morskin-{c}.1" for c in commands())})
        page = (self.manual / "morskin.1").read_text()
        for command in commands():
            self.assertIn(f".BR morskin\\-{command} (1)", page)

    def test_every_option_of_the_help_is_on_its_page_and_no_other_is(self):
        for command in commands():
            page = (self.manual / f"morskin-{command}.1").read_text()
            heads = re.findall(r"^\.TP\n\\fB(\S+?)\\fR", page, re.MULTILINE)
            self.assertEqual({head.replace("\\", "") for head in heads}, options_of(command))

    def test_no_dash_may_become_a_hyphen_that_cannot_be_typed(self):
        for page in self.manual.glob("*.1"):
            text = page.read_text().partition(".SH NAME")[2]
            self.assertIn("\\-\\-help\\-all", text, page)
            self.assertNotRegex(text, r"(?<!\\)-", page)

    def test_what_is_said_of_an_option_ends_with_a_full_stop(self):
        for page in self.manual.glob("*.1"):
            options = page.read_text().partition(".SH OPTIONS\n")[2].partition(".SH ")[0]
            for entry in options.split(".TP\n")[1:]:
                said = re.split(r"\n(?:Default: |Required\.|\.SS )", entry.partition("\n")[2])[0]
                self.assertTrue(said.rstrip().endswith("."), f"{page.name}: {said}")

    def test_mandoc_finds_nothing_to_say_about_any_page(self):
        for page in self.manual.glob("*.1"):
            done = subprocess.run(["mandoc", "-T", "lint", page], capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stdout), (0, ""))

    def test_man_has_no_warning_of_any_page(self):
        for page in self.manual.glob("*.1"):
            done = subprocess.run(["man", "--warnings", "-E", "UTF-8", "-Tutf8", "-l", page],
                                  stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
            self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_text_that_looks_like_a_request_of_roff_is_text(self):
        shown = subprocess.run(["mandoc", "-T", "ascii", self.manual / "morskin-mesh.1"],
                               check=True, capture_output=True, text=True).stdout
        shown = " ".join(re.sub(".\b", "", shown).split())
        for words in ("by its ending: .ply .off .obj", "Write .vert and .face in columns",
                      "asin(1/Q^2)", "short for --function height:x,y,z"):
            self.assertIn(words, shown)

    def test_the_same_files_are_made_every_time(self):
        again = self.folder / "again"
        subprocess.run([MANUAL, again], check=True)
        names = sorted(p.name for p in self.manual.iterdir())
        self.assertEqual(filecmp.cmpfiles(self.manual, again, names, shallow=False)[0], names)


class Completion(ManualTest):
    def setUp(self):
        folder = temporary_folder(self)
        for name in ("my molecule.pdb", "other.xyz", "7", "12:30.pdb", "r=1 C=2.pdb"):
            (folder / name).touch()
        (folder / "models").mkdir()
        self.shell = Shell(SHELL, folder, self.manual)
        self.addCleanup(self.shell.close)

    def expect(self, line, *words):
        self.assertEqual(self.shell.completed(line), [*words], line)

    def test_commands_and_files_stand_first(self):
        for command in commands():
            self.expect(f"morskin {command}", command)
        self.expect("morskin me", "mesh")
        self.expect("morskin oth", "other.xyz")
        self.expect("morskin --vers", "--version")

    def test_each_option_of_each_command_is_completed_as_it_stands(self):
        for command in commands():
            for option in sorted(options_of(command)):
                self.expect(f"morskin {command} {option}", command, option)
            self.expect(f"morskin {command} --hel", command, "--help")

    def test_an_option_is_completed_as_far_as_it_is_the_only_one(self):
        self.expect("morskin mesh other.xyz --vox", "mesh", "other.xyz", "--vox")
        self.expect("morskin mesh other.xyz --voi", "mesh", "other.xyz", "--voids")
        self.expect("morskin mesh --model-", "mesh", "--model-number")
        self.expect("morskin mesh --help-", "mesh", "--help-all")
        self.expect("morskin mesh --snapshot-d", "mesh", "--snapshot-dir")
        self.expect("morskin balls --angle-g", "balls", "--angle-g")  # mesh's

    def test_a_file_without_a_command_takes_the_options_of_mesh(self):
        self.expect("morskin other.xyz --voi", "other.xyz", "--voids")
        self.expect("morskin other.xyz --method st", "other.xyz", "--method", "static")
        self.expect("morskin other.xyz -o my", "other.xyz", "-o", "my molecule.pdb")

    def test_values_that_are_words_are_completed_for_the_option_before_them(self):
        self.expect("morskin mesh other.xyz --method st", "mesh", "other.xyz", "--method",
                    "static")
        self.expect("morskin mesh --method=st", "mesh", "--method=static")
        self.expect("morskin info --model ses", "info", "--model", "ses-like")
        self.expect("morskin render --by ang", "render", "--by", "angle")

    def test_files_are_completed_where_one_is_due_and_not_where_a_number_is(self):
        self.expect("morskin mesh my", "mesh", "my molecule.pdb")
        self.expect("morskin mesh other.xyz -o my", "mesh", "other.xyz", "-o", "my molecule.pdb")
        self.expect("morskin check x.ply --against ot", "check", "x.ply", "--against",
                    "other.xyz")
        self.expect("morskin mesh --snapshot-dir mod", "mesh", "--snapshot-dir", "models/")
        self.expect("morskin mesh -C oth", "mesh", "-C", "oth")

    def test_names_with_a_colon_or_an_equals_sign_are_completed_however_they_are_begun(self):
        for begun in ("12", "12:", "12:3", r"12\:3", "'12:3"):
            self.expect(f"morskin mesh {begun}", "mesh", "12:30.pdb")
            self.expect(f"morskin {begun}", "12:30.pdb")
        for begun in ("r", "r=", "r=1", r"r\=1\ C"):
            self.expect(f"morskin mesh other.xyz -o {begun}", "mesh", "other.xyz", "-o",
                        "r=1 C=2.pdb")
        self.expect("morskin check x.ply --against=12:", "check", "x.ply", "--against=12:30.pdb")
        self.expect("morskin mesh 12:30.pdb --voi", "mesh", "12:30.pdb", "--voids")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
