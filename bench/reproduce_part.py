"""The methods of bench/reproduce.py, and one part of it: its rows, its file, its time."""

import csv
import math
import time

from molecule_runs import Replacement, brief, mesh
from reproduce_tables import LEFT_OUT

METHODS = {
    "sweep": ["--method", "sweep"],
    "one-front-unsmoothed": ["--method", "sweep", "--fronts", "1", "--angle-goal", "0"],
    "static": ["--method", "static"],
    "dynamic": ["--method", "dynamic"],
    "marching-cubes": ["--method", "marching-cubes"],
}
UNCERTIFIED_AS_A_RULE = {"marching-cubes"}


class Notes:
    """Remarks for table1.md."""

    def __init__(self):
        self.lines = []

    def add(self, text):
        if text not in self.lines:
            self.lines.append(text)
            print("note: " + text, flush=True)


class Part:
    """One part of the whole. Before `limit` a quick one knows no limit of time."""

    def __init__(self, name, columns, options, notes):
        self.name, self.options, self.notes = name, options, notes
        self.timeout = math.inf if options.quick else options.timeout
        self.deadline = math.inf
        self.left_out = 0
        self.may_run_out = options.quick  # whether a run out of time is no failure
        self.failures = []
        self.replacement = Replacement(options.results / f"{name}.csv", newline="")
        self.writer = csv.DictWriter(self.replacement.file, columns, restval="",
                                     extrasaction="ignore", lineterminator="\n")
        self.writer.writeheader()
        self.rows = []

    def limit(self, quick_seconds):
        """From now on no run takes longer than --timeout, and if quick all of them only so long."""
        self.timeout = self.options.timeout
        if self.options.quick:
            self.deadline = time.monotonic() + quick_seconds

    def is_late(self, seconds=0):
        """Whether a run that takes so long would end too late."""
        return time.monotonic() + seconds > self.deadline

    def leave_out(self, method, fixed, reason="no time was left (QUICK=1)"):
        """A row that says so, and has no values."""
        self.left_out += 1
        self.add({**fixed, "method": method, "certified": False, "reason": LEFT_OUT + reason})

    def add(self, row):
        self.writer.writerow(row)
        self.replacement.file.flush()
        self.rows.append(row)

    def run(self, path, model, method, fixed, *options, keep=None):
        """Meshes once; the row has the measured values beside the fixed ones."""
        timeout = max(1, min(self.timeout, self.deadline - time.monotonic()))
        done = mesh(path, model, timeout, *METHODS[method], *options, keep=keep)
        report = done.report
        row = {**report, **fixed, "method": method, "cpu_seconds": brief(done.cpu_seconds),
               "seconds": report.get("seconds", {}).get("total", brief(done.seconds)),
               "certified": report.get("certified", False)}
        row |= {"seconds_" + k: v for k, v in report.get("seconds", {}).items()}
        row["reason"] = report.get("reason") or done.complaint
        row["code"] = done.code
        self.add(row)
        if done.code not in (0, 5):
            self.notes.add(f"{self.name}: {method} on {fixed['molecule']}: {row['reason']}")
        is_excused = method in UNCERTIFIED_AS_A_RULE or (self.may_run_out and done.code == -1)
        if not row["certified"] and not is_excused:
            self.failures.append(f"{self.name}: {method} on {fixed['molecule']}: {row['reason']}")
        print(f"{self.name:10} {fixed['molecule']:24} {method:20} {row.get('triangles', '-'):>10} "
              f"{row['seconds']:>10} s  {'certified' if row['certified'] else row['reason'][:60]}",
              flush=True)
        return row

    def end(self):
        if self.left_out:
            self.notes.add(f"{self.name}: {self.left_out} runs were left out for lack of time")
        self.replacement.close(is_whole=True)
