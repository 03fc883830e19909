#!/usr/bin/env python3
"""How the scripts of bench end where runs fail, and where there is nothing to run."""

import argparse
import contextlib
import io
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "bench"))
import ablation  # noqa: E402
import angles  # noqa: E402
import batch  # noqa: E402
import coarse  # noqa: E402
import complexes  # noqa: E402
import corpus  # noqa: E402
import counts  # noqa: E402
import curved_errors  # noqa: E402
import densities  # noqa: E402
import features  # noqa: E402
import implicit  # noqa: E402
import large  # noqa: E402
import methods  # noqa: E402
import molecule_runs  # noqa: E402
import morse_corpus  # noqa: E402
import operations  # noqa: E402
import prediction  # noqa: E402
import replay  # noqa: E402
import reproduce  # noqa: E402
import second_order  # noqa: E402
import ses_like  # noqa: E402
import subdomains  # noqa: E402
from molecule_runs import BUNDLED, STAGES, Run, argument_parser, read_rows  # noqa: E402

REPORT = {"fallbacks": [], "triangles": 10, "smoothing": {"left": 0, "inserted": 0},
          "violations_L": 0, "min_angle_deg": 31.0, "max_angle_deg": 100.0}
GOOD = Run(0, REPORT, "", 1, 1)
FALLEN = Run(0, REPORT | {"fallbacks": [{"to": "static"}]}, "", 1, 1)
BAD = Run(5, {}, "not certified", 1, 1)
SINGULAR = Run(4, {}, "singular", 1, 1)
EMPTY = Run(4, {}, "no ball has a positive weight", 1, 1)


SCRIPTS = (ablation, angles, batch, coarse, complexes, corpus, counts, curved_errors, densities,
           features, implicit, large, methods, morse_corpus, operations, prediction, replay,
           second_order, ses_like, subdomains)


def uses(script, option):
    return f"options.{option}" in Path(script.__file__).read_text(encoding="utf-8")


class Ends(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.table = Path(folder.name) / "table.tsv"

    def code_of(self, script, *words):
        """The exit code of a script's main, and what it says."""
        taken = ["--molecules", str(BUNDLED)] if uses(script, "molecules") else []
        words = [script.__name__, *taken, "--results", str(self.table), *words]
        said = io.StringIO()
        with (mock.patch.object(sys, "argv", words), contextlib.redirect_stdout(said),
              self.assertRaises(SystemExit) as ended):
            script.main()
        return ended.exception.code, said.getvalue()

    def angles(self, *runs):
        """angles.py where the models of caffeine come to these runs."""
        with mock.patch.object(angles, "mesh", side_effect=runs):
            code, _ = self.code_of(angles, "--only", "caffeine", "--sizes", "0.08", "--goals", "30")
        return code, read_rows(self.table)[0]

    def test_angles_fail_where_a_run_is_not_certified_or_fell_back_and_all_are_named(self):
        self.assertEqual(self.angles(GOOD, GOOD)[0], 0)
        for runs in ((GOOD, BAD), (FALLEN, GOOD), (BAD, FALLEN)):
            code, row = self.angles(*runs)
            named = [f"caffeine.xyz, {model}: " in row["verdict"] for model in ("paper", "vdw")]
            self.assertEqual((code, named), (1, [r is not GOOD for r in runs]), row)

    def test_a_singular_piece_is_refused_and_not_one_that_coarse_meshes_miss(self):
        for run, verdict in ((SINGULAR, "refused"), (EMPTY, "FAILED: " + EMPTY.complaint)):
            self.assertEqual(coarse.verdict_of(run), verdict)
        with mock.patch.object(coarse, "mesh", side_effect=[SINGULAR, BAD]):
            _, said = self.code_of(coarse, "--only", "caffeine", "--sizes", "0.2", "--models",
                                   "vdw", "--pieces", "2")
        self.assertIn("0 after a fallback, 1 refused as singular, 1 not", said)

    def test_angles_of_no_run_are_none(self):
        for runs, ends in (((BAD, BAD), 1), ((SINGULAR, SINGULAR), 0), ((SINGULAR, EMPTY), 1)):
            code, row = self.angles(*runs)
            self.assertEqual((code, row["runs"], row["min_angle"]), (ends, "0", "-"))

    def test_features_tell_of_a_run_that_fails_beside_those_that_do_not(self):
        ended = subprocess.CalledProcessError(5, ["morskin"])
        seconds = {stage: 1.0 for stages in STAGES.values() for stage in stages}
        report = {"seconds": seconds, "atoms_used": 1, "vertices": 4, "certified": True,
                  "quality": {"vertices_per_square_angstrom": 2.0}}
        with (mock.patch.object(features, "MOLECULES", ["caffeine.xyz", "benzene.pdb"]),
              mock.patch.object(features, "timed", side_effect=[ended, (1, 1), (1, 1), (1, 1)]),
              mock.patch.object(features, "reported", return_value=report)):
            code, said = self.code_of(features)
        failed, good = read_rows(self.table)
        self.assertEqual((code, failed["verdict"], good["verdict"]),
                         (1, "FAILED: exit code 5", "certified"))
        self.assertIn("| benzene.pdb | 1 |", said)

    def test_tables_are_made_of_the_runs_that_do_not_fail(self):
        name, model, words = subdomains.SURFACES[0]
        failed = subdomains.row_of(Path(name), model, words, 1, BAD)
        self.assertIn("| FAILED |", subdomains.table([failed]))
        row = dict.fromkeys(ses_like.COLUMNS, "1") | {"offset": "0.1", "verdict": "certified"}
        failed = dict.fromkeys(ses_like.COLUMNS, "") | {"offset": "0.1", "verdict": "FAILED: so"}
        self.assertEqual(ses_like.table([row, failed]), ses_like.table([row]))
        ses_like.table([failed])
        failed = second_order.row_of(Path("caffeine.xyz"), 0.2, BAD, 1)
        self.assertIn("| FAILED |", second_order.table([failed]))

    def test_a_method_that_is_not_certified_makes_no_other_one_wrong(self):
        shape = {"certified": True, "method": "static", "euler_characteristic": 2, "components": 1,
                 "genus": 0, "fallbacks": []}
        torn = shape | {"certified": False, "reason": "torn", "components": 9}
        for other, verdict in ((shape, "certified"),
                               (shape | {"genus": 1}, "FAILED: genus is 1, static has 0")):
            runs = [Run(0, report, "", 1, 1) for report in (torn, shape, other)]
            with mock.patch.object(molecule_runs, "mesh", side_effect=runs):
                self.code_of(methods, "--only", "c60", "--models", "vdw", "--methods", "a,b,c")
            verdicts = [r["verdict"] for r in read_rows(self.table)]
            self.assertEqual(verdicts, ["FAILED: torn", "certified", verdict])

    def test_a_density_that_is_missed_is_good_where_the_mesh_is_finer_only(self):
        for made, missed, verdict in ((2, {}, "made"),
                                      (3, {"missed_size": "so"}, "coarser is not possible"),
                                      (1, {"missed_size": "not 2"}, "FAILED: not 2")):
            report = {"certified": True, "quality": {"vertices_per_square_angstrom": made}} | missed
            found = densities.verdict_of(Run(0, report, "", 1, 1), report, 2)
            self.assertEqual(found, verdict)

    def test_without_a_molecule_nothing_was_run_and_an_earlier_table_stays(self):
        self.table.write_text("earlier", encoding="utf-8")
        for script in SCRIPTS:
            with self.subTest(script.__name__):
                code, said = self.code_of(script, "--only", "no such molecule")
                self.assertEqual((code, said.splitlines()[-1]), (1, "nothing was run"))
                self.assertEqual(self.table.read_text(encoding="utf-8"), "earlier")

    def test_molecules_models_and_sizes_that_a_script_does_not_ask_about_are_wrong_arguments(self):
        for script in SCRIPTS:
            for option, value in (("molecules", "x"), ("models", "vdw"), ("largest", "9")):
                said = io.StringIO()
                words = [f"--{option}", value, "--only", "no such molecule"]
                with self.subTest(script.__name__, option=option), \
                        contextlib.redirect_stderr(said):
                    code, _ = self.code_of(script, *words)
                    self.assertEqual((code, "unrecognized" in said.getvalue()),
                                     (1, False) if uses(script, option) else (2, True))

    def test_where_a_program_is_not_built_one_line_says_so(self):
        none = self.table.parent / "none"
        for script, owner, name in ((ablation, ablation, "PROGRAM"),
                                    (angles, molecule_runs, "MORSKIN"),
                                    (curved_errors, curved_errors, "PROGRAM")):
            with self.subTest(script.__name__), mock.patch.object(owner, name, none):
                code, _ = self.code_of(script, "--only", "caffeine")
                self.assertRegex(code, f"^{none} is not there; run make command")
        for script in (coarse, features, ses_like):
            with (self.subTest(script.__name__), mock.patch.object(script, "MORSKIN", none),
                  mock.patch.object(molecule_runs, "MORSKIN", none),
                  mock.patch.dict(sys.modules, ses_comparison=mock.MagicMock())):  # needs numpy
                molecule_runs.atom_count.cache_clear()
                code, _ = self.code_of(script, "--only", "1crn")
                self.assertRegex(code, f"^{none} is not there; run make command")
        options = argparse.Namespace(workers=1, timeout=1)
        with mock.patch.object(batch, "MORSKIN", none), self.assertRaises(SystemExit) as ended:
            batch.row_of("vdw", options, none)
        self.assertRegex(ended.exception.code, f"^{none} is not there; run make command")

    def test_a_program_that_fails_or_is_out_of_time_is_named_with_what_it_says(self):
        program = self.table.parent / "program"
        for text, timeout, said in (("echo nothing >&2; exit 3", 60, "exit code 3: nothing"),
                                    ("exec sleep 60", 0.1, "still running after 0.1 s")):
            program.write_text(f"#!/bin/sh\n{text}\n", encoding="utf-8")
            program.chmod(0o755)
            with mock.patch.object(curved_errors, "PROGRAM", program):
                code, _ = self.code_of(curved_errors, "--only", "ball", "--timeout", str(timeout))
            self.assertEqual(code, f"ball with C = 0.35: {said}")
            self.assertFalse(self.table.exists())

    def test_copies_of_what_cannot_be_read_end_as_the_command_does(self):
        out = self.table.with_name("copies.xyzr")
        tile = [sys.executable, ROOT / "bench" / "tile.py", "nowhere.pdb", "-o", out]
        for command, code, said in ((molecule_runs.MORSKIN, 3, "morskin: "),
                                    ("/nowhere", 2, "usage: ")):
            done = subprocess.run([*tile[:2], command, *tile[2:]], capture_output=True, text=True,
                                  check=False)
            self.assertEqual((done.returncode, out.exists()), (code, False), done.stderr)
            self.assertTrue(done.stderr.startswith(said), done.stderr)

    def test_where_all_runs_fail_the_table_says_so(self):
        for script, only, count in ((subdomains, "1grm", 8), (second_order, "benzene", 1)):
            with (self.subTest(script.__name__), mock.patch.object(script, "mesh",
                                                                   return_value=BAD)):
                code, said = self.code_of(script, "--only", only)
                self.assertEqual(code, 1)
                self.assertIn("FAILED |", said)
                verdicts = [r["verdict"] for r in read_rows(self.table)]
                self.assertEqual(verdicts, ["FAILED: not certified"] * count)

    def test_a_second_order_run_that_fails_leaves_the_others_in_the_table(self):
        report = {"certified": True, "triangles": 10, "area": 1.9,
                  "second_order": {"area": 2.0, "least_jacobian": 0.5}}
        runs = [Run(0, report, "", 1, 1)] * len(second_order.SIZES) + [BAD]
        with mock.patch.object(second_order, "mesh", side_effect=runs):
            code, said = self.code_of(second_order, "--only", "benzene")
        self.assertEqual((code, said.count("FAILED |")), (1, 1))
        self.assertEqual(len(read_rows(self.table)), len(second_order.SIZES))

    def test_a_part_of_the_molecules_or_models_replaces_no_table_of_a_page(self):
        parser = argument_parser("", timeout=1, results="papers/results/features.tsv", largest=400)
        parser.parse_args(["--largest", "400"])
        for part in (["--only", "1grm"], ["--models", "vdw"], ["--largest", "50"]):
            parser.parse_args([*part, "--results", str(self.table)])
            said = io.StringIO()
            with contextlib.redirect_stderr(said), self.assertRaises(SystemExit) as ended:
                parser.parse_args(part)
            self.assertEqual(ended.exception.code, 2)
            self.assertIn(f"{part[0]} makes a part of features.tsv", said.getvalue())

    def test_no_repetition_is_a_wrong_argument(self):
        for script in (ablation, large, replay, reproduce):
            for count in ("0", "-1", "x"):
                with self.subTest(script.__name__), contextlib.redirect_stderr(io.StringIO()):
                    self.assertEqual(self.code_of(script, "--repetitions", count), (2, ""))

    def test_no_time_is_a_wrong_argument(self):
        for script, option in ((angles, "--timeout"), (reproduce, "--scaling-timeout")):
            for limit in ("0", "-1", "nan", "x"):
                with self.subTest(option, limit=limit), contextlib.redirect_stderr(io.StringIO()):
                    self.assertEqual(self.code_of(script, option, limit), (2, ""))

    def test_a_plan_of_some_files_is_a_wrong_argument_and_leaves_the_recipes(self):
        said = io.StringIO()
        with (mock.patch.object(batch, "RECIPES", self.table), contextlib.redirect_stderr(said),
              mock.patch.object(batch, "plan", return_value=[])):
            self.assertEqual(self.code_of(batch, "--plan", "--only", "1aon"), (2, ""))
        self.assertIn("leave --only out", said.getvalue())
        self.assertFalse(self.table.exists())

    def test_a_folder_for_the_table_is_a_wrong_argument_before_anything_is_run(self):
        said = io.StringIO()
        for script in (angles, prediction):
            with contextlib.redirect_stderr(said):
                code, out = self.code_of(script, "--results", str(self.table.parent))
            self.assertEqual((code, out), (2, ""))
        self.assertIn("is a folder: name a file, as prediction.tsv", said.getvalue())

    def test_a_file_for_the_folder_of_results_is_a_wrong_argument(self):
        self.table.write_text("earlier", encoding="utf-8")
        for script, name in ((reproduce, ""), (angles, "table.tsv"), (prediction, "new/table.md")):
            said = io.StringIO()
            with contextlib.redirect_stderr(said):
                code = self.code_of(script, "--results", str(self.table / name))
            self.assertEqual(code, (2, ""))
            self.assertIn(f"{self.table} is a file: name a folder", said.getvalue())

    def test_a_folder_of_results_that_may_not_be_written_to_is_a_wrong_argument(self):
        for script, name in ((reproduce, ""), (angles, "table.tsv"), (prediction, "new/table.md")):
            said = io.StringIO()
            with contextlib.redirect_stderr(said), mock.patch("os.access", return_value=False):
                code = self.code_of(script, "--results", str(self.table.parent / name))
            self.assertEqual(code, (2, ""))
            self.assertIn(f"{self.table.parent} may not be written to", said.getvalue())

    def test_without_the_corpus_its_molecules_are_named_and_an_earlier_table_stays(self):
        self.table.write_text("earlier", encoding="utf-8")
        for script in (batch, densities, features, large, replay, ses_like, subdomains):
            with self.subTest(script.__name__):
                code, _ = self.code_of(script)
                self.assertRegex(code, r"molecules has no [\w.*]+(, [\w.*]+)*$")
                self.assertEqual(self.table.read_text(encoding="utf-8"), "earlier")


if __name__ == "__main__":
    unittest.main()
