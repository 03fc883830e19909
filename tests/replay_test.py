"""The trace of a run holds its tasks, and the replay schedules them as the program does."""

import gzip
import itertools
import json
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "bench"))
import replay  # noqa: E402
from molecule_runs import BUNDLED, MORSKIN  # noqa: E402

SEEDS = range(200)


def trace_of(*words):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "trace.json"
        subprocess.run([MORSKIN, "mesh", *words, "-o", pathlib.Path(folder) / "x.ply", "-q",
                        "--trace-tasks", file], check=True)
        return json.loads(file.read_text())


def random_tree(generator, depth):
    return {box: generator.random() for box in range(2 ** (depth + 1) - 1)}


def random_tasks(seed):
    generator = random.Random(seed)
    return [generator.random() for _ in range(generator.randrange(40))]


class Schedules(unittest.TestCase):
    def test_one_worker_takes_the_sum_of_the_tasks(self):
        for seed in SEEDS:
            tasks = random_tasks(seed)
            self.assertAlmostEqual(replay.makespan(tasks, 1), sum(tasks))
            boxes = random_tree(random.Random(seed), seed % 6)
            self.assertAlmostEqual(replay.tree_makespan(boxes, 1), sum(boxes.values()))

    def test_no_schedule_beats_the_critical_path_or_an_even_share(self):
        for seed, workers in itertools.product(SEEDS, (1, 2, 3, 8, 64)):
            tasks = random_tasks(seed)
            least = max([sum(tasks) / workers, *tasks])
            taken = replay.makespan(tasks, workers)
            self.assertGreaterEqual(taken, least - 1e-12)
            self.assertLessEqual(taken, 2 * least + 1e-12)  # Graham's bound
            boxes = random_tree(random.Random(seed), seed % 6)
            share, path = sum(boxes.values()) / workers, replay.tree_path(boxes)
            taken = replay.tree_makespan(boxes, workers)
            self.assertGreaterEqual(taken, max(share, path) - 1e-12)
            self.assertLessEqual(taken, share + path + 1e-12)

    def test_with_a_worker_for_each_leaf_the_longest_path_is_all(self):
        for seed in SEEDS:
            depth = seed % 6
            boxes = random_tree(random.Random(seed), depth)
            self.assertAlmostEqual(replay.tree_makespan(boxes, 2 ** depth),
                                   replay.tree_path(boxes))

    def test_three_boxes_on_two_workers_by_hand(self):
        self.assertEqual(replay.tree_makespan({0: 1, 1: 2, 2: 5}, 2), 6)
        self.assertEqual(replay.tree_makespan({0: 1, 1: 2, 2: 5}, 1), 8)


class Traces(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.one = trace_of(BUNDLED / "caffeine.xyz", "-C", "0.02", "--threads", "1")
        cls.two = trace_of(BUNDLED / "caffeine.xyz", "-C", "0.02", "--threads", "2")

    def test_one_thread_is_number_0_alone_and_two_are_more(self):
        self.assertEqual({e["tid"] for e in self.one["traceEvents"]}, {0})
        self.assertLess({0}, {e["tid"] for e in self.two["traceEvents"]})

    def test_the_tasks_are_the_same_for_any_number_of_threads(self):
        def counts(trace):
            tasks = [(e["cat"], e["args"]["number"]) for e in trace["traceEvents"]]
            return sorted(tasks)
        self.assertEqual(counts(self.one), counts(self.two))

    def test_spans_of_a_thread_lie_in_each_other_or_apart(self):
        for trace, thread in itertools.product((self.one, self.two), range(64)):
            open_ends = []
            spans = [(e["ts"], e["ts"] + e["dur"]) for e in trace["traceEvents"]
                     if e["tid"] == thread]
            for begin, end in sorted(spans, key=lambda s: (s[0], -s[1])):
                while open_ends and begin >= open_ends[-1]:
                    open_ends.pop()
                if open_ends:
                    self.assertLessEqual(end, open_ends[-1] + 1e-3)
                open_ends.append(end)

    def test_every_box_of_the_dissection_is_swept_once(self):
        boxes = sorted(e["args"]["number"] for e in self.one["traceEvents"] if e["cat"] == "box")
        self.assertEqual(boxes, list(range(len(boxes))))
        self.assertGreater(len(boxes), 1)

    def test_what_is_not_in_tasks_is_serial_and_nothing_is_counted_twice(self):
        total = max(e["ts"] + e["dur"] for e in self.one["traceEvents"]) * 1e-6
        run = replay.Replay(self.one, total)
        self.assertGreater(run.serial, 0)
        self.assertAlmostEqual(run.seconds(1), total)
        self.assertLess(run.seconds(2), total)
        self.assertGreaterEqual(run.seconds(64), run.critical_path() - 1e-9)

    def test_reading_unpacking_and_writing_are_spans_of_their_own(self):
        with tempfile.TemporaryDirectory() as folder:
            packed = pathlib.Path(folder) / "caffeine.xyz.gz"
            packed.write_bytes(gzip.compress((BUNDLED / "caffeine.xyz").read_bytes()))
            trace = trace_of(packed, "-C", "0.08", "--threads", "1")
        total = max(e["ts"] + e["dur"] for e in trace["traceEvents"]) * 1e-6
        spans = [e["name"] for e in trace["traceEvents"] if e["name"] in replay.FILES]
        self.assertEqual(set(spans), replay.FILES)
        self.assertEqual(spans.count("gunzip"), 1)
        run = replay.Replay(trace, total)
        self.assertGreater(run.files, 0)
        self.assertLess(run.files, run.serial)


if __name__ == "__main__":
    unittest.main()
