#!/usr/bin/env python3
"""bench/corpus_totals.py adds up what bench/corpus.py wrote, by C and model."""

import contextlib
import io
import random
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "bench"))
import corpus  # noqa: E402
import corpus_totals  # noqa: E402
from molecule_runs import Rows, read_rows  # noqa: E402


def random_run(generator, c, model):
    row = dict.fromkeys(corpus.COLUMNS, 0)
    return row | {"file": "x", "model": model, "C": c, "atoms": generator.randrange(1, 99),
                  "triangles": generator.randrange(4, 999), "area": generator.uniform(1, 9),
                  "min_angle": generator.uniform(30, 40), "max_angle": generator.uniform(90, 120),
                  "seconds": generator.uniform(0, 2), "broken_L": generator.randrange(3),
                  "verdict": generator.choice(["certified"] * 5 + ["FAILED: no", "refused: no"])}


class Totals(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def totals_of(self, tables):
        """The exit code and the rows that the script writes for tables of such runs."""
        paths = []
        for number, runs in enumerate(tables):
            paths.append(self.folder / f"{number}.tsv")
            with contextlib.redirect_stdout(io.StringIO()), \
                    Rows(paths[-1], corpus.COLUMNS, corpus.WIDTHS, 2) as rows:
                for run in runs:
                    rows.add(run)
        words = ["corpus_totals.py", *map(str, paths), "--results", str(self.folder / "totals")]
        with mock.patch.object(sys, "argv", words), contextlib.redirect_stdout(io.StringIO()), \
                self.assertRaises(SystemExit) as ended:
            corpus_totals.main()
        return ended.exception.code, read_rows(self.folder / "totals")

    def test_every_run_but_the_refused_is_in_one_row_and_a_failure_fails(self):
        for seed in range(50):
            generator = random.Random(seed)
            tables = [[random_run(generator, c, model) for model in ("sas", "vdw")
                       for _ in range(12)] for c in (0.08, 0.2)]
            runs = [r for table in tables for r in table if not r["verdict"].startswith("refused")]
            good = [r for r in runs if r["verdict"] == "certified"]
            code, rows = self.totals_of(tables)
            self.assertEqual(code, int(len(good) < len(runs)))
            self.assertEqual([(r["C"], r["model"]) for r in rows],
                             [("0.08", "sas"), ("0.08", "vdw"), ("0.2", "sas"), ("0.2", "vdw")])
            self.assertEqual(sum(int(r["molecules"]) for r in rows), len(runs))
            for column, of_runs in (("certified", [1] * len(good)),
                                    ("triangles", [r["triangles"] for r in good]),
                                    ("broken_L", [r["broken_L"] for r in good])):
                self.assertEqual(sum(int(r[column]) for r in rows), sum(of_runs), column)
            seconds = sum(float(r["microseconds"]) * int(r["triangles"]) for r in rows)
            self.assertAlmostEqual(seconds, 1e6 * sum(r["seconds"] for r in good))
            self.assertEqual(min(float(r["min_angle"]) for r in rows),
                             min(r["min_angle"] for r in good))

    def test_where_none_is_certified_the_counts_are_there_all_the_same(self):
        run = random_run(random.Random(0), 0.3, "vdw") | {"verdict": "FAILED: no"}
        code, (row,) = self.totals_of([[run]])
        self.assertEqual((code, row["molecules"], row["certified"]), (1, "1", "0"))

    def test_a_table_that_is_not_there_is_named(self):
        words = ["corpus_totals.py", str(self.folder / "none.tsv")]
        with mock.patch.object(sys, "argv", words), self.assertRaises(SystemExit) as ended:
            corpus_totals.main()
        self.assertIn("none.tsv: no such file", ended.exception.code)


if __name__ == "__main__":
    unittest.main()
