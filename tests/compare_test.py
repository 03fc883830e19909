#!/usr/bin/env python3
"""The comparison of two builds (bench/compare.py), on made-up samples; nothing is timed."""

import contextlib
import dataclasses
import io
import sys
import unittest
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "bench"))
import compare  # noqa: E402  (from bench)

SAMPLE = compare.Sample(user_seconds=1.0, wall_seconds=0.6, peak_memory_bytes=100 * 2**20,
                        triangles=325_348, min_angle_deg=30.0, digest="same")


def samples(**changes):
    return [dataclasses.replace(SAMPLE, **changes)] * 3


class Tables(unittest.TestCase):
    def test_a_median_above_the_bound_is_named_and_marked_in_its_row(self):
        for field, label in (("user_seconds", "user time"), ("peak_memory_bytes", "peak memory")):
            slower = samples(**{field: 1.06 * getattr(SAMPLE, field)})
            lines, above = compare.compare(samples(), slower, 1.05)
            self.assertEqual(above, [label])
            (row,) = [line for line in lines if "above 1.05" in line]
            self.assertIn(label, row)
            self.assertIn("1.060", row)

    def test_a_faster_build_is_not_above_the_bound(self):
        _, above = compare.compare(samples(), samples(user_seconds=0.5), 1.05)
        self.assertEqual(above, [])

    def test_the_bound_is_the_one_asked_for(self):
        slower = samples(user_seconds=1.06)
        self.assertEqual(compare.compare(samples(), slower, 1.1)[1], [])
        self.assertEqual(compare.compare(samples(), slower, 1.01)[1], ["user time"])
        self.assertEqual(compare.compare(samples(), slower, float("inf"))[1], [])

    def test_where_the_base_took_no_user_time_that_was_measured_nothing_is_above_the_bound(self):
        base = samples(user_seconds=0.0)
        for here in (samples(user_seconds=0.0), samples(user_seconds=0.01)):
            lines, above = compare.compare(base, here, 1.05)
            self.assertEqual(above, [])
            self.assertIn("nan", lines[0])

    def test_one_slow_run_among_three_changes_no_median(self):
        _, above = compare.compare(samples(), samples()[:2] + samples(user_seconds=9.0)[:1], 1.05)
        self.assertEqual(above, [])

    def test_more_wall_time_is_shown_and_does_not_fail(self):
        lines, above = compare.compare(samples(), samples(wall_seconds=1.2), 1.05)
        self.assertIn("2.000", "\n".join(lines))
        self.assertEqual(above, [])

    def test_more_triangles_and_other_angles_are_shown_and_do_not_fail(self):
        lines, above = compare.compare(samples(), samples(triangles=400_000, min_angle_deg=21.6), 1)
        text = "\n".join(lines)
        self.assertIn("325,348", text)
        self.assertIn("400,000", text)
        self.assertIn("21.600", text)
        self.assertEqual(above, [])

    def test_the_table_says_whether_the_files_are_the_same(self):
        self.assertIn("the files are the same", compare.compare(samples(), samples(), 1.05)[0][-1])
        self.assertIn("the files differ",
                      compare.compare(samples(), samples(digest="other"), 1.05)[0][-1])


class Turns(unittest.TestCase):
    def test_the_builds_take_turns_the_order_changes_and_the_first_runs_are_left_out(self):
        calls = []
        with mock.patch.object(compare, "sample", lambda program, *_: calls.append(program) or
                               (program, len(calls))):
            taken = compare.samples_in_turns(["base", "here"], "ring.xyzr", [], 2)
        self.assertEqual(calls, ["base", "here", "here", "base", "base", "here"])
        self.assertEqual(taken, [[("base", 4), ("base", 5)], [("here", 3), ("here", 6)]])

    def test_a_commit_that_is_not_there_ends_the_script_by_name(self):
        with self.assertRaisesRegex(SystemExit, "no such commit: no-such-name"):
            compare.unpacked("no-such-name")

    def test_without_ubiquitin_the_bundled_crambin_is_taken(self):
        self.assertEqual([p.name for p in compare.default_molecules(ROOT / "cmake")],
                         ["1grm_model1.pdb", "1crn.pdb"])

    def test_no_runs_at_all_are_refused(self):
        with mock.patch.object(sys, "argv", ["compare.py", "HEAD", "--runs", "0"]), \
                contextlib.redirect_stderr(io.StringIO()), self.assertRaises(SystemExit) as ended:
            compare.arguments()
        self.assertEqual(ended.exception.code, 2)


if __name__ == "__main__":
    unittest.main()
