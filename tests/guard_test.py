#!/usr/bin/env python3
"""The guard for speed and memory (bench/guard.py), on made-up records; nothing is measured."""

import json
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "bench"))
import guard  # noqa: E402  (from bench)

MADE_WITH = {"architecture": "x86_64", "compiler": "g++ 12", "c_library": "glibc 2.36"}
RECORDED = {"caffeine.xyz": {"instructions": 1_000_000, "peak_heap_bytes": 200_000}}


def findings(share=guard.BOUND, **figures):
    return list(guard.compare(RECORDED, {"caffeine.xyz": figures}, share))


class Figures(unittest.TestCase):
    def test_a_figure_above_the_bound_fails_and_names_run_recorded_now_and_share(self):
        (found,) = findings(instructions=1_060_000)
        self.assertTrue(found.fails)
        for words in ("caffeine.xyz", "instructions", "1,000,000 recorded", "1,060,000 now",
                      "+6.0%", "above +5%"):
            self.assertIn(words, found.text)

    def test_more_memory_fails_while_the_instructions_are_as_recorded(self):
        found = findings(instructions=1_000_000, peak_heap_bytes=211_000)
        self.assertEqual([f.fails for f in found], [False, True])
        self.assertIn("peak_heap_bytes", found[1].text)

    def test_a_figure_at_the_bound_passes_without_a_remark(self):
        for now in (1_050_000, 1_000_000, 950_000):
            (found,) = findings(instructions=now)
            self.assertFalse(found.fails)
            self.assertTrue(found.text.endswith("%"), found.text)

    def test_a_figure_below_the_bound_passes_and_says_that_the_record_may_be_lowered(self):
        (found,) = findings(instructions=940_000)
        self.assertFalse(found.fails)
        self.assertIn("-6.0%: the record may be lowered", found.text)

    def test_a_run_that_is_not_recorded_fails(self):
        (found,) = guard.compare({}, {"caffeine.xyz": {"instructions": 1}}, guard.BOUND)
        self.assertTrue(found.fails)
        self.assertIn("caffeine.xyz: not recorded", found.text)

    def test_the_wide_bound_lets_pass_what_the_usual_one_does_not_but_not_work_done_twice(self):
        (found,) = findings(guard.WIDE_BOUND, instructions=1_200_000)
        self.assertFalse(found.fails)
        (found,) = findings(guard.WIDE_BOUND, instructions=2_000_000)
        self.assertTrue(found.fails)
        self.assertIn("above +25%", found.text)


class Profiles(unittest.TestCase):
    def test_the_total_is_of_the_line_that_says_so(self):
        self.assertEqual(guard.total_instructions("summary: 7\ntotals: 12\n"), 12)

    def test_the_peak_is_of_the_largest_snapshot_not_of_the_last(self):
        snapshots = "".join(f"snapshot={i}\nmem_heap_B={size}\nmem_heap_extra_B=9000\n"
                            for i, size in enumerate([0, 5000, 300]))
        self.assertEqual(guard.peak_heap_bytes(snapshots), 5000)


class Bounds(unittest.TestCase):
    def test_a_record_made_with_the_same_versions_has_the_usual_bound_and_no_remark(self):
        self.assertEqual(guard.bound_for(MADE_WITH, dict(MADE_WITH)), guard.Bound(0.05))

    def test_a_record_made_with_another_compiler_has_the_wide_bound_and_says_so(self):
        bound = guard.bound_for(MADE_WITH, MADE_WITH | {"compiler": "g++ 14"})
        self.assertEqual(bound.share, 0.25)
        self.assertIn("compiler was 'g++ 12', is 'g++ 14'", bound.why)
        self.assertIn("25% is allowed in place of 5%", bound.why)
        self.assertNotIn("glibc", bound.why)

    def test_a_version_that_was_not_recorded_counts_as_another(self):
        bound = guard.bound_for(MADE_WITH, MADE_WITH | {"valgrind": "valgrind-3.19.0"})
        self.assertEqual(bound.share, 0.25)
        self.assertIn("valgrind was 'not recorded'", bound.why)

    def test_on_another_architecture_nothing_is_compared_and_the_output_says_so(self):
        bound = guard.bound_for(MADE_WITH, MADE_WITH | {"architecture": "aarch64"})
        self.assertIsNone(bound.share)
        self.assertIn("Nothing is compared", bound.why)


class Record(unittest.TestCase):
    def test_the_record_holds_every_run_every_figure_and_every_version_that_is_compared(self):
        record = json.loads(guard.RECORD.read_text("utf-8"))
        self.assertEqual(list(record["runs"]), guard.RUNS)
        for figures in record["runs"].values():
            self.assertEqual(list(figures), guard.FIGURES)
        self.assertEqual(list(record["made_with"]), list(guard.made_with()))

    def test_every_run_is_of_a_bundled_molecule(self):
        for run in guard.RUNS:
            self.assertTrue((guard.BUNDLED / run.split()[0]).is_file(), run)

    def test_the_total_of_a_profile_is_read(self):
        profile = "version: 1\nevents: Ir\nfn=(1) main\n0 7\ntotals: 1141074812\n"
        self.assertEqual(guard.total_instructions(profile), 1_141_074_812)


if __name__ == "__main__":
    unittest.main()
