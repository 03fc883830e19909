#!/usr/bin/env python3
"""Several models of one file from outside. Usage: models_command_test.py path/to/morskin"""

import json
import os
import signal
import subprocess
import time

from support.command import CommandTest, main, morskin

ATOM = "ATOM  {n:5d}  C   ALA A   1    {x:8.3f}   0.000   0.000  1.00  0.00           C\n"


def pdb(models):
    """@param models  number: abscissae of its atoms"""
    return "".join(f"MODEL     {number:4d}\n" + "".join(
        ATOM.format(n=i, x=x) for i, x in enumerate(places, 1)) + "ENDMDL\n"
                   for number, places in models.items())


def cif(models):
    rows = "".join(f"C {x} 0 0 {number}\n" for number, places in models.items() for x in places)
    return ("data_nmr\nloop_\n_atom_site.type_symbol\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
            "_atom_site.Cartn_z\n_atom_site.pdbx_PDB_model_num\n" + rows)


MODELS = {1: [0, 1.5], 2: [0, 1.6], 4: [0, 1.4, 3.0], 5: [0, 1.3]}


class Models(CommandTest):
    def setUp(self):
        super().setUp()
        self.input("nmr.pdb", pdb(MODELS))
        # An atom of an unknown element in model 2.
        self.input("bad.pdb", pdb(MODELS).replace(
            ATOM.format(n=2, x=1.6), ATOM.format(n=2, x=1.6).replace(" C\n", "XX\n").replace(
                "  C   ALA", "  XX  ALA")))

    def mesh(self, *words, file="nmr.pdb", code=0):
        return self.run_morskin("mesh", file, "-C", "0.3", *words, code=code)

    def made(self):
        return [name for name in self.names() if not name.endswith((".pdb", ".cif", ".xyz"))]

    def test_each_model_gets_files_and_a_report_of_its_own(self):
        for words, numbers in (("all", (1, 2, 4, 5)), ("1,4-5", (1, 4, 5)), ("5,1-2", (5, 1, 2)),
                               ("2-2", (2,)), ("1,1-2,2", (1, 2))):
            with self.subTest(words):
                done = self.mesh("--model-number", words, "-o", "m.ply", "-o", "m.off",
                                 "--report", "r.json", "--areas", "a.csv",
                                 "--trace-tasks", "t.json")
                self.assertEqual(self.made(), sorted(
                    name.format(n) for n in numbers
                    for name in ("a-{}.csv", "m-{}.off", "m-{}.ply", "r-{}.json", "t-{}.json")))
                lines = done.stdout.decode().splitlines()
                self.assertEqual([line for line in lines if "->" in line],
                                 [f"nmr.pdb -> m-{n}.ply, m-{n}.off" for n in numbers])
                for n in numbers:
                    report = json.loads((self.folder / f"r-{n}.json").read_text())
                    self.assertEqual(report["selection"], {"model_number": n})
                    self.assertEqual(report["atoms_used"], len(MODELS[n]))
                for name in self.made():
                    (self.folder / name).unlink()

    def test_a_model_among_several_is_meshed_as_it_is_alone(self):
        self.input("nmr.cif", cif(MODELS))
        self.mesh("--model-number", "all", "-o", "all.ply", "-q")
        for n in MODELS:
            for file in ("nmr.pdb", "nmr.cif"):
                self.mesh("--model-number", str(n), "-o", "one.ply", "-q", file=file)
                self.assertEqual(self.without_origin("one.ply"),
                                 self.without_origin(f"all-{n}.ply"))
            checked = self.check(f"all-{n}.ply", "--against", "nmr.pdb")
            self.assertTrue(checked["certified"])
            self.assertEqual(checked["selection"], {"model_number": n})

    def test_frames_of_xyz_are_models_by_their_places(self):
        self.input("path.xyz", "2\none\nC 0 0 0\nO 1.2 0 0\n2\ntwo\nC 0 0 0\nO 1.3 0 0\n")
        self.mesh("--model-number", "all", "-o", "m.ply", "-q", file="path.xyz")
        self.assertEqual(self.made(), ["m-1.ply", "m-2.ply"])

    def test_reports_as_json_follow_one_another(self):
        text = self.mesh("--model-number", "1-2", "-o", "m.ply", "--json").stdout.decode()
        decoder, numbers = json.JSONDecoder(), []
        while text.strip():
            report, end = decoder.raw_decode(text.strip())
            numbers.append(report["selection"]["model_number"])
            text = text.strip()[end:]
        self.assertEqual(numbers, [1, 2])

    def test_a_model_that_fails_stops_no_other_unless_that_is_asked(self):
        done = self.mesh("--model-number", "all", "-o", "m.ply", "-q", file="bad.pdb", code=4)
        self.assertEqual(self.made(), ["m-1.ply", "m-4.ply", "m-5.ply"])
        self.assertIn(b"bad.pdb: model 2: exit code 4", done.stderr)
        for name in self.made():
            (self.folder / name).unlink()
        self.mesh("--model-number", "all", "--fail-fast", "-o", "m.ply", "-q", file="bad.pdb",
                  code=4)
        self.assertEqual(self.made(), ["m-1.ply"])

    def test_the_exit_code_is_the_worst(self):
        (self.folder / "m-1.ply").mkdir()
        done = self.mesh("--model-number", "1-2", "-o", "m.ply", "-q", file="bad.pdb", code=7)
        self.assertIn(b"model 1: exit code 7", done.stderr)
        self.assertIn(b"model 2: exit code 4", done.stderr)

    def test_a_limit_that_one_model_reaches_is_no_other_s(self):
        self.input("uneven.pdb", pdb({1: [1.5 * k for k in range(900)], 2: [0, 1.5]}))
        done = self.run_morskin("mesh", "uneven.pdb", "-C", "0.02", "--model-number", "all", "-o",
                                "m.ply", "-q", "--timeout", "3", code=6)
        self.assertIn(b"model 1: exit code 6", done.stderr)
        self.assertEqual(self.made(), ["m-2.ply"])

    def test_models_that_the_file_lacks_are_refused_before_any_is_meshed(self):
        for words, missing in (("1-5", 3), ("7,1", 7), ("0-1", 0), ("1-9223372036854775807", 3)):
            said = self.mesh("--model-number", words, "-o", "m.ply", code=4).stderr.decode()
            self.assertIn(f"has no model {missing}; choose from 1, 2, 4, 5", said)
            self.assertEqual(self.made(), [])

    def test_what_no_set_of_models_is_and_what_cannot_be_numbered_is_wrong_usage(self):
        for words in ("", "1,", ",1", "3-1", "1-", "-1", "a", "1;2", "1 2", "All", "1-2-3",
                      "1,99999999999999999999"):
            with self.subTest(words):
                self.mesh(f"--model-number={words}", "-o", "m.ply", code=2)
        for words in ("-1", "1,2-"):
            said = self.mesh(f"--model-number={words}", "-o", "m.ply", code=2).stderr.decode()
            self.assertIn(f'not "{words.split(",")[-1]}"', said)
        several = ("--model-number", "all")
        self.mesh(*several, "-o", "-", code=2)
        self.mesh(*several, "-o", "m.ply", "--report", "-", code=2)
        self.mesh(*several, "-o", "m.ply", "--snapshots", "2", code=2)
        os.mkfifo(self.folder / "pipe")  # empty for all runs but the first
        for file, more in (("-", ()), ("pipe", ()), ("nmr.pdb", ("--radii", "pipe"))):
            self.mesh(*several, *more, "-o", "m.ply", file=file, code=2)
        self.mesh("-o", "m.ply", "--fail-fast", code=2)
        for command in (("info", "nmr.pdb"), ("balls", "nmr.pdb", "-o", "b.xyzr"),
                        ("morse", "nmr.pdb", "-o", "b.json"), ("view", "nmr.pdb", "-o", "b.html")):
            said = self.run_morskin(*command, *several, code=2).stderr
            self.assertIn(b"only mesh takes several models", said)

    def in_second_model(self):
        """A process that meshes the second of eight models."""
        self.input("long.pdb", pdb({n: [1.5 * k for k in range(400)] for n in range(1, 9)}))
        process = subprocess.Popen(
            [morskin(), "mesh", "long.pdb", "-C", "0.05", "--model-number", "all", "-o", "m.ply",
             "-q"], cwd=self.folder, start_new_session=True, stderr=subprocess.DEVNULL)
        self.addCleanup(process.kill)
        end = time.monotonic() + 60
        while not any(name.startswith("m-2.ply.part") for name in self.names()):
            self.assertLess(time.monotonic(), end)
            time.sleep(0.005)
        return process

    def test_a_signal_to_the_command_alone_ends_all_and_leaves_no_half_file(self):
        for number in (signal.SIGTERM, signal.SIGXCPU, signal.SIGUSR1, signal.SIGUSR2):
            process = self.in_second_model()
            process.send_signal(number)
            self.assertEqual(process.wait(60), -number)
            self.assertEqual(self.names(), ["bad.pdb", "long.pdb", "m-1.ply", "nmr.pdb"])

    def test_an_interrupt_ends_all_and_leaves_no_half_file(self):
        process = self.in_second_model()
        os.killpg(process.pid, signal.SIGINT)
        self.assertEqual(process.wait(60), -signal.SIGINT)
        self.assertEqual(self.made(), ["m-1.ply"])
        self.assertTrue(self.check("m-1.ply", "--against", "long.pdb")["certified"])


if __name__ == "__main__":
    main()
