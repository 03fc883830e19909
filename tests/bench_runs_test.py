#!/usr/bin/env python3
"""The scripts of bench run to their end and leave a table: on caffeine, or, where their molecules
are fixed, on the smallest of them. Wants build/morskin."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BENCH = ROOT / "bench"
sys.path.insert(0, str(BENCH))
import reproduce_tables  # noqa: E402
from molecule_runs import STAGES, read_rows, run_command  # noqa: E402

CAFFEINE = ["--only", "caffeine"]
# By script the words of each run; it takes a second or two.
RUNS = {
    "angles.py": [[*CAFFEINE, "--sizes", "0.08", "--goals", "30"]],
    "coarse.py": [[*CAFFEINE, "--pieces", "1", "--sizes", "0.2"]],
    "complexes.py": [["--only", "5tmn"]],
    "corpus.py": [[*CAFFEINE, "--check"]],
    "counts.py": [["--only", "5tmn"]],
    "features.py": [["--only", "1grm"]],
    "large.py": [["--only", "1grm", "--repetitions", "1"]],
    "methods.py": [CAFFEINE],
    "morse_corpus.py": [CAFFEINE],
    "operations.py": [["--only", "c60"]],
    "prediction.py": [[*CAFFEINE, "--largest", "100"], ["--functions", *CAFFEINE]],
    "replay.py": [["--only", "1grm", "--repetitions", "1"]],
    "second_order.py": [CAFFEINE],
}
# Why the others are not run here.
OTHERS = {
    "ablation.py": "needs a program of its own; tests/ablation_test.cpp, tests/reproduce_test.py",
    "batch.py": "its chains are of the corpus",
    "compare.py": "builds; tests/compare_test.py",
    "corpus_totals.py": "takes tables of corpus.py; tests/corpus_totals_test.py",
    "curved_errors.py": "needs a program of its own",
    "densities.py": "its molecules are of the corpus, or large",
    "fetch.py": "needs a server; tests/fetch_test.py",
    "guard.py": "needs valgrind; tests/guard_test.py",
    "implicit.py": "several seconds",
    "reproduce.py": "several seconds; tests/reproduce_test.py",
    "reproduce_plots.py": "needs matplotlib",
    "ses_like.py": "its chains are of the corpus",
    "subdomains.py": "its molecules are of the corpus",
    "tile.py": "makes no table; corpus.py runs it",
}


def run(script, *words):
    """The script on the bundled molecules; counts.py and operations.py know no others."""
    knows_its_own = script in ("counts.py", "operations.py")
    molecules = [] if knows_its_own else ["--molecules", BENCH / "molecules"]
    return subprocess.run([sys.executable, BENCH / script, *molecules, *words],
                          capture_output=True, text=True, check=False)


class Scripts(unittest.TestCase):
    def test_each_ends_well_and_leaves_its_table(self):
        for script, words in ((s, w) for s, several in RUNS.items() for w in several):
            with self.subTest(script, words=words), tempfile.TemporaryDirectory() as folder:
                table = Path(folder) / "table"
                done = run(script, *words, "--results", table)
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                self.assertGreater(len(table.read_text("utf-8").splitlines()), 1)

    def test_the_stages_are_those_of_a_report_and_the_shares_of_features_make_up_the_whole(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            words = ["mesh", BENCH / "molecules" / "caffeine.xyz", "-o", folder / "x.ply"]
            seconds = run_command([*words, "--json"], 60).report["seconds"]
            self.assertEqual([*reproduce_tables.STAGES, "total"], list(seconds))
            run("features.py", "--only", "1grm", "--results", folder / "table")
            (row,) = read_rows(folder / "table")
        self.assertTrue(set(STAGES) <= set(row), row)
        self.assertAlmostEqual(sum(float(row[stage]) for stage in STAGES), 1)

    def test_every_script_is_run_here_or_has_a_reason(self):
        scripts = {s.name for s in BENCH.glob("*.py") if '"__main__"' in s.read_text("utf-8")}
        self.assertEqual(scripts, {*RUNS, *OTHERS})


if __name__ == "__main__":
    unittest.main()
