"""Batches of small molecules, all different."""

import json
import random
import subprocess
import time
from pathlib import Path

from support.command import CommandTest, morskin

COARSE = ("-C", "0.3")
TIMES = ("seconds", "cpu_seconds", "peak_memory_bytes")


def chain(seed, balls=12):
    """A molecule of its own for each seed."""
    rng, x, lines = random.Random(seed), 0.0, []
    for _ in range(balls):
        lines.append(f"{x:.4f} {rng.uniform(-1, 1):.4f} {rng.uniform(-1, 1):.4f} "
                     f"{rng.uniform(1.2, 2):.4f}\n")
        x += rng.uniform(0.8, 1.6)
    return "".join(lines)


class Batch(CommandTest):
    def chains(self, count, folder="in", balls=12):
        (self.folder / folder).mkdir(parents=True)
        names = [f"chain{i:02}.xyzr" for i in range(count)]
        for seed, name in enumerate(names):
            self.input(f"{folder}/{name}", chain(seed, balls))
        return names

    def batch(self, *words, code=0, **options):
        done = self.run_morskin("batch", *words, "--json", code=code, **options)
        return json.loads(done.stdout) if code == 0 else done.stderr.decode()

    def started(self, *words):
        child = subprocess.Popen([morskin(), "batch", *words, "-q"], cwd=self.folder,
                                 stderr=subprocess.DEVNULL)
        self.addCleanup(child.wait)
        self.addCleanup(child.kill)
        return child

    def rows(self, folder="out"):
        """Rows by input, without what differs from run to run."""
        rows = {}
        for path in sorted((self.folder / folder).glob("*.jsonl")):
            for line in path.read_text().splitlines():
                row = json.loads(line)
                self.assertNotIn(row["input"], rows, "two rows of one molecule")
                rows[row["input"]] = {k: v for k, v in row.items() if k not in TIMES}
        return rows

    def made(self, folder="out"):
        """Bytes of all files but the rows, by name."""
        return {p.name: p.read_bytes() for p in sorted((self.folder / folder).iterdir())
                if p.suffix != ".jsonl"}

    def first_workers(self, run):
        """The workers of a run that has started, as soon as there are any."""
        while not (workers := self.workers_of(run)):
            self.assertIsNone(run.poll(), "the run ended without a worker")
            time.sleep(0.005)
        return workers

    def workers_of(self, process):
        try:
            text = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text()
        except OSError:
            return []
        return [int(word) for word in text.split()]
