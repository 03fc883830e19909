#!/usr/bin/env python3
"""A batch goes on where it was, whatever ended it. Usage: batch_resume_test.py path/to/morskin"""

import json
import os
import random
import shutil
import signal
import subprocess
import time
from pathlib import Path

from support.batch_case import COARSE, Batch
from support.command import main, morskin


def is_alive(process):
    try:
        # Behind the program's name, in brackets, the state.
        state = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0]
    except OSError:
        return False
    return state != "Z"  # dead, but nobody has asked for its exit code


def molecule_of(worker):
    try:
        return Path(f"/proc/{worker}/cmdline").read_text().split("\0")[2]
    except (OSError, IndexError):
        return None


class Resume(Batch):
    def test_nothing_is_made_twice(self):
        self.chains(3)
        self.batch("in", "-o", "out", *COARSE)
        times = {p: p.stat().st_mtime_ns for p in (self.folder / "out").iterdir()}
        self.assertEqual(self.batch("in", "-o", "out", *COARSE)["made"], 0)
        self.assertEqual({p: p.stat().st_mtime_ns for p in (self.folder / "out").iterdir()}, times)

    def test_rows_are_read_of_regular_files_only(self):
        self.chains(1)
        (self.folder / "out").mkdir()
        os.mkfifo(self.folder / "out/rows-1-of-9.jsonl")
        (self.folder / "out/rows-2-of-9.jsonl").symlink_to("/dev/zero")
        self.batch("in", "-o", "out", *COARSE)
        (self.folder / "out/rows.jsonl").unlink()
        os.mkfifo(self.folder / "out/rows.jsonl")
        self.assertIn("no regular file", self.batch("in", "-o", "out", *COARSE, code=7))

    def test_a_copy_of_the_rows_beside_them_does_not_count(self):
        self.chains(2)
        self.batch("in", "-o", "out", *COARSE)
        (self.folder / "out/rows.jsonl").rename(self.folder / "out/rows-old.jsonl")
        self.assertEqual(self.batch("in", "-o", "out", *COARSE)["made"], 2)

    def test_a_torn_row_and_a_file_without_a_row_are_made_again(self):
        self.chains(3)
        self.batch("in", "-o", "out", *COARSE)
        rows, made = self.rows(), self.made()
        path = self.folder / "out/rows.jsonl"
        lines = path.read_bytes().splitlines(keepends=True)
        last = Path(json.loads(lines[-1])["input"]).name
        for torn in (lines[-1][:-1], lines[-1][:40], b"{", b"\0\0\0"):
            path.write_bytes(b"".join(lines[:-1]) + torn)
            stale = self.folder / "out" / (last + ".ply")
            stale.write_text("half a mesh")
            (stale.parent / (stale.name + ".unverified")).write_text("of another run")
            self.assertEqual(self.batch("in", "-o", "out", *COARSE)["made"], 1)
            self.assertEqual((self.rows(), self.made()), (rows, made))

    def test_a_torn_row_of_a_shard_is_cut_off_by_the_run_that_makes_the_rest(self):
        self.chains(4)
        self.batch("in", "-o", "out", *COARSE, "--shard", "1/2")
        path = self.folder / "out/rows-1-of-2.jsonl"
        path.write_bytes(path.read_bytes()[:-20])
        self.assertEqual(self.batch("in", "-o", "out", *COARSE)["made"], 3)
        self.assertEqual(len(self.rows()), 4)

    def test_a_line_that_is_no_row_is_named(self):
        self.chains(2)
        self.batch("in", "-o", "out", *COARSE)
        path = self.folder / "out/rows.jsonl"
        path.write_text('{"input": "x"}\n' + path.read_text())
        self.assertIn("out/rows.jsonl:1: is no row", self.batch("in", "-o", "out", *COARSE, code=3))

    def test_other_options_are_refused_and_other_limits_are_not(self):
        self.chains(2)
        self.batch("in", "-o", "out", *COARSE)
        for shard in ([], ["--shard", "1/2"]):
            complaint = self.batch("in", "-o", "out", "-C", "0.25", *shard, code=2)
            self.assertIn("-C0.3", complaint)
        self.assertEqual([p.name for p in (self.folder / "out").glob("*.jsonl")], ["rows.jsonl"])
        self.assertEqual(self.batch("in", "-o", "out", *COARSE, "--timeout", "60")["made"], 0)

    def test_rows_are_still_true_where_the_folders_were_moved(self):
        self.chains(2, "here/in")
        here, there = self.folder / "here", self.folder / "there"
        for source in ("in", "in/*.xyzr"):
            self.batch(here / source, "-o", here / "out", *COARSE)
            shutil.move(here, there)
            self.assertEqual(self.batch(there / source, "-o", there / "out", *COARSE)["made"], 0)
            shutil.move(there, here)

    def test_shards_together_make_the_whole(self):
        names = self.chains(7)
        self.batch("in", "-o", "whole", *COARSE)
        for number in (3, 1, 2):
            summary = self.batch("in", "-o", "out", *COARSE, "--shard", f"{number}/3")
            self.assertEqual(summary["rows"], len(names[number - 1::3]))
        self.assertEqual(sorted(p.name for p in (self.folder / "out").glob("*.jsonl")),
                         [f"rows-{i}-of-3.jsonl" for i in (1, 2, 3)])
        self.assertEqual((self.rows(), self.made()), (self.rows("whole"), self.made("whole")))
        summary = self.batch("in", "-o", "out", *COARSE)
        self.assertEqual((summary["rows"], summary["made"]), (7, 0))
        self.batch("in", "-o", "out", *COARSE, "--shard", "8/9")  # more shards than molecules

    def test_two_runs_do_not_write_the_same_rows(self):
        self.chains(6, balls=150)
        first = self.started("in", "-o", "out", "-C", "0.08")
        self.first_workers(first)
        first.send_signal(signal.SIGSTOP)  # however long the other takes
        complaint = self.batch("in", "-o", "out", "-C", "0.08", code=7)
        self.assertIn("another run writes it", complaint)
        first.kill()

    def rows_so_far(self):
        path = self.folder / "out/rows.jsonl"
        return path.read_text().count("\n") if path.exists() else 0

    def kill_at_random(self, victims, seed):
        """Kills what victims(run) gives, at random moments, but only after a row more, so that a
        busy machine gets on too; until a run ends by itself."""
        rng, kills = random.Random(seed), 0
        names = self.chains(10, balls=60)
        self.batch("in", "-o", "whole", "-C", "0.2")
        while True:
            run, before = self.started("in", "-o", "out", "-C", "0.2"), self.rows_so_far()
            while run.poll() is None:
                time.sleep(rng.uniform(0, 0.05))
                if self.rows_so_far() == before:
                    continue
                before = self.rows_so_far()
                time.sleep(rng.uniform(0, 0.1))
                for process in victims(run):
                    workers = self.workers_of(run)
                    try:
                        os.kill(process, signal.SIGKILL)
                        kills += 1
                    except ProcessLookupError:
                        continue
                    if process == run.pid:
                        run.wait()
                        self.assert_ended(workers)
            if run.returncode == 0 and kills > 1:
                break
            if run.returncode == 0:  # too quick to be killed twice: once more from the start
                shutil.rmtree(self.folder / "out")
                continue
            self.assertEqual(run.returncode, -signal.SIGKILL)
            self.rows()  # whole lines, none twice
        self.assertEqual(sorted(self.rows()), names)
        self.assertEqual((self.rows(), self.made()), (self.rows("whole"), self.made("whole")))

    def assert_ended(self, workers):
        end = time.monotonic() + 60
        while any(map(is_alive, workers)):
            self.assertLess(time.monotonic(), end, "workers outlive their parent")
            time.sleep(0.01)

    def test_killed_at_random_moments_the_union_is_complete_and_equal(self):
        self.kill_at_random(lambda run: [run.pid], seed=1)

    def test_killed_workers_are_started_again(self):
        killed = []

        def first_worker(run):
            workers = [w for w in self.workers_of(run) if killed.count(molecule_of(w)) < 2][:1]
            killed.extend(map(molecule_of, workers))
            return workers
        self.kill_at_random(first_worker, seed=2)

    def test_a_worker_that_is_always_killed_fails_after_three_attempts_and_leaves_no_file(self):
        self.chains(1, balls=400)
        (self.folder / "out").mkdir()
        for ending in ("ply", "ply.unverified"):
            self.input(f"out/chain00.xyzr.{ending}", "of an earlier run")
        run = self.started("in", "-o", "out", "-C", "0.05")
        killed = set()
        while run.poll() is None:
            for worker in self.workers_of(run):
                if worker not in killed:
                    os.kill(worker, signal.SIGKILL)
                    killed.add(worker)
            time.sleep(0.002)
        self.assertEqual((run.returncode, len(killed)), (0, 3))
        row = self.rows()["chain00.xyzr"]
        self.assertEqual(row["status"], "failed")
        self.assertIn("ended by signal 9, 3 times", row["reason"])
        self.assertEqual((row["outputs"], self.made()), ([], {}))

    def test_a_signal_ends_the_workers_and_leaves_nothing_unfinished(self):
        self.chains(4, balls=400)
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGXCPU,
                       signal.SIGUSR1, signal.SIGUSR2):
            run = self.started("in", "-o", "out", "-C", "0.03")
            workers = self.first_workers(run)
            run.send_signal(number)
            self.assertEqual(run.wait(), -number)
            self.assertFalse(any(map(is_alive, workers)))
            names = sorted(p.name for p in (self.folder / "out").iterdir())
            self.assertEqual(names, ["rows.jsonl"])

    def test_two_signals_in_turn_leave_nothing_unfinished_either(self):
        self.chains(4, balls=400)
        run = self.started("in", "-o", "out", "-C", "0.03")
        self.first_workers(run)
        for number in (signal.SIGSTOP, signal.SIGTERM, signal.SIGHUP, signal.SIGCONT):
            run.send_signal(number)
        self.assertIn(run.wait(), (-signal.SIGTERM, -signal.SIGHUP))
        self.assertEqual(os.listdir(self.folder / "out"), ["rows.jsonl"])

    def test_a_folder_that_is_removed_meanwhile_ends_the_run_in_words(self):
        self.chains(4, balls=400)
        run = subprocess.Popen([morskin(), "batch", "in", "-o", "out", "-C", "0.05", "-q"],
                               cwd=self.folder, stderr=subprocess.PIPE)
        self.first_workers(run)
        shutil.rmtree(self.folder / "out", ignore_errors=True)
        self.assertRegex(run.communicate()[1], rb"morskin: out\S*: \w+")
        self.assertEqual(run.returncode, 7)


if __name__ == "__main__":
    main()
