#!/usr/bin/env python3
"""What would more processors bring? Replays the tasks of a run in one thread on 1 to 64 workers.

Meshes each surface with --threads 1 --trace-tasks and schedules the tasks again as the program
does: a free worker takes the next task of a loop, and whoever ends the second half of a box goes on
with the box. What is in no task counts as serial, from the start of the program to its end. A run
with --threads 2 beside it shows how good the prediction is.

The columns: seconds of the replay and its speed-up; the speed-up from unpacked bytes in memory to
bytes in memory, without reading, unpacking and writing; the one if all that the kernel did, the
clearing of pages above all, went on one worker at a time; and the worst case for processors that
can move no more than 10 GB a second each while this one moves `copies`, GB a second: as if the
tasks did nothing but move memory.
"""

import heapq
import itertools
import json
import resource
import statistics
import tempfile
import time
from pathlib import Path

from molecule_runs import (Rows, argument_parser, end, markdown, mesh, molecule_folder,
                           named_files, positive, read_rows)

SURFACES = [("1grm_model1.pdb", "paper"), ("1ubq.pdb", "paper"), ("1kx5.pdb", "sas"),
            ("1aon.pdb.gz", "sas"), ("1f2n_capsid.cif.gz", "sas")]
WORKERS = [1, 2, 4, 8, 16, 32, 64]
COLUMNS = ["molecule", "model", "workers", "seconds", "speed_up", "in_memory",
           "with_serial_kernel", "at_10_GB_s", "measured", "verdict"]
WIDTHS = [18, 6, 8, 9, 9, 10, 18, 11, 9, 10]
FILES = {"read", "gunzip", "write"}  # stages with the system's and zlib's work alone
SLOW_MEMORY = 10e9  # bytes a second


class Span:
    """A span of the trace, with the spans that lie in it."""

    def __init__(self, event):
        self.kind, self.name = event["cat"], event["name"]
        self.number = event["args"]["number"]
        self.begin, self.seconds = event["ts"] * 1e-6, event["dur"] * 1e-6
        self.inside = []

    @property
    def end(self):
        return self.begin + self.seconds

    def walk(self):
        yield self
        for span in self.inside:
            yield from span.walk()


def forest(trace):
    """The outermost spans of a trace of one thread."""
    spans = sorted((Span(e) for e in trace["traceEvents"]), key=lambda s: (s.begin, -s.seconds))
    root = Span({"cat": "run", "name": "run", "ts": 0, "dur": 1e15, "args": {"number": 0}})
    path = [root]
    for span in spans:
        while span.begin >= path[-1].end:
            path.pop()
        path[-1].inside.append(span)
        path.append(span)
    return root.inside


def outermost_loops(spans):
    """(stage, loop): loops inside of tasks are part of the task."""
    for span in spans:
        if span.kind == "loop":
            yield span
        else:
            yield from outermost_loops(span.inside)


def makespan(seconds, workers):
    """Of tasks that are taken in their order, each by the first worker that is free."""
    free = [0.0] * workers
    for task in seconds:
        heapq.heapreplace(free, free[0] + task)
    return max(free)


def tree_makespan(boxes, workers):
    """Of the boxes of a dissection, by number: the leaves in their order; whoever ends the second
    half of a box goes on with it."""
    leaves = iter(range(len(boxes) // 2, len(boxes)))
    half_done, last, order = set(), 0.0, itertools.count()
    running = [(0.0, next(order), None) for _ in range(workers)]
    while running:
        now, _, done = heapq.heappop(running)
        last = max(last, now)
        box = None
        if done:  # not the whole: 0 has no box around it
            around = (done - 1) // 2
            if around in half_done:
                box = around
            half_done.add(around)
        if box is None:
            box = next(leaves, None)
        if box is not None:
            heapq.heappush(running, (now + boxes[box], next(order), box))
    return last


def tree_path(boxes):
    """The longest chain of boxes, each around the one before."""
    longest = dict(boxes)
    for box in sorted(boxes, reverse=True):
        if box:
            longest[(box - 1) // 2] = max(longest[(box - 1) // 2],
                                          boxes[(box - 1) // 2] + longest[box])
    return longest[0]


class Replay:
    """The loops of one run, and all the rest of its time."""

    def __init__(self, trace, total):
        self.loops = []  # lists of seconds, or dictionaries of them by box
        spans = forest(trace)
        self.serial = total
        for loop in outermost_loops(spans):
            boxes = {s.number: s.seconds for s in loop.walk() if s.kind == "box"}
            tasks = boxes or [s.seconds for s in loop.inside]
            self.loops.append(tasks)
            self.serial -= sum(boxes.values()) if boxes else sum(tasks)
        self.total = total
        self.files = sum(s.seconds for top in spans for s in top.walk()
                         if s.kind == "stage" and s.name in FILES)
        self.serial_by_stage = {}
        for stage in (s for s in spans if s.kind == "stage"):
            inside = sum(s.seconds for loop in outermost_loops([stage]) for s in loop.inside)
            name = stage.name
            self.serial_by_stage[name] = (self.serial_by_stage.get(name, 0)
                                          + stage.seconds - inside)

    def seconds(self, workers):
        return self.serial + sum(
            tree_makespan(tasks, workers) if isinstance(tasks, dict) else makespan(tasks, workers)
            for tasks in self.loops)

    def critical_path(self):
        return self.serial + sum(
            tree_path(tasks) if isinstance(tasks, dict) else max(tasks, default=0)
            for tasks in self.loops)


def bytes_per_second():
    """How much one processor of this machine copies, read and written."""
    size = 1 << 28
    source, target = bytearray(b"\1") * size, bytearray(b"\2") * size
    times = []
    for _ in range(5):
        start = time.perf_counter()
        target[:] = source
        times.append(time.perf_counter() - start)
    return 2 * size / min(times)


def kernel_seconds_of_children():
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_stime


def traced_run(path, model, timeout):
    """(run, replay, seconds in the kernel)"""
    with tempfile.TemporaryDirectory() as temporary:
        file = Path(temporary) / "trace.json"
        before = kernel_seconds_of_children()
        run = mesh(path, model, timeout, "--threads", "1", "--trace-tasks", file)
        kernel = kernel_seconds_of_children() - before
        return run, Replay(json.loads(file.read_text()), run.seconds) if file.exists() else None, \
            kernel


def rows_of(path, model, options, copied):
    runs = [traced_run(path, model, options.timeout) for _ in range(options.repetitions)]
    two = [mesh(path, model, options.timeout, "--threads", "2")
           for _ in range(options.repetitions)]
    row = {"molecule": path.name, "model": model}
    bad = [r for r in [run for run, _, _ in runs] + two if not r.report.get("certified")]
    if bad:
        yield dict.fromkeys(COLUMNS, "") | row | {"verdict": f"FAILED: {bad[0].complaint}"}
        return
    run, replay, kernel = sorted(runs, key=lambda r: r[0].seconds)[len(runs) // 2]
    measured = {1: run.seconds, 2: statistics.median(r.seconds for r in two)}
    slower = max(1, copied / SLOW_MEMORY)
    for workers in WORKERS:
        seconds = replay.seconds(workers)
        share = kernel / replay.total
        worst = replay.serial + (seconds - replay.serial) * slower
        whole = replay.serial + (replay.total - replay.serial) * slower
        yield row | {"workers": workers, "seconds": seconds,
                     "speed_up": replay.total / seconds,
                     "in_memory": (replay.total - replay.files) / (seconds - replay.files),
                     "with_serial_kernel": replay.total / (kernel + (1 - share) * seconds),
                     "at_10_GB_s": whole / worst, "measured": measured.get(workers, ""),
                     "verdict": "certified"}
    print(f"  serial {replay.serial:.3g} s of {replay.total:.3g}, critical path "
          f"{replay.critical_path():.3g}; serial by stage: "
          + ", ".join(f"{name} {s:.3g}" for name, s in
                      sorted(replay.serial_by_stage.items(), key=lambda x: -x[1]) if s > 0.005))


def table(rows):
    """The rows of the page: by molecule, the speed-up of each number of workers."""
    body = []
    for name, model in SURFACES:
        of_it = [r for r in rows if (r["molecule"], r["model"]) == (name, model)]
        label = f"{name.split('.')[0].split('_')[0].upper()}, {model}"
        measured = float(of_it[0]["measured"]) / float(of_it[1]["measured"])
        for what, column in (("", "speed_up"), (", in memory", "in_memory"),
                             (", the kernel serial", "with_serial_kernel")):
            body.append([label + what, *(f"{float(r[column]):.2f}" for r in of_it),
                         f"{measured:.2f}"])
    return markdown(["", *map(str, WORKERS), "two threads, measured"], body)


def sentence(rows):
    """On the page: how far the replay on two workers is from what two threads took."""
    of_two = [r for r in rows if int(r["workers"]) == 2]
    worst = max(abs(float(r["measured"]) / float(r["seconds"]) - 1) for r in of_two)
    return f"The times predicted for two are within {100 * worst:.0f} % of those measured."


def draw(rows, path):
    """Takes matplotlib, as reproduce_plots.py does."""
    import reproduce_plots as plots
    figure, axes = plots.plt.subplots(figsize=(6.4, 4.2))
    for name, model in SURFACES:
        of_it = [r for r in rows if (r["molecule"], r["model"]) == (name, model)]
        workers = [int(r["workers"]) for r in of_it]
        line, = axes.plot(workers, [float(r["speed_up"]) for r in of_it], "o-", markersize=4,
                          label=f"{name.split('.')[0].split('_')[0].upper()}, {model}")
        axes.plot(workers, [float(r["with_serial_kernel"]) for r in of_it], "--",
                  color=line.get_color(), linewidth=0.9)
        axes.plot(2, float(of_it[0]["measured"]) / float(of_it[1]["measured"]), "x",
                  color=line.get_color())
    axes.plot(WORKERS[:4], WORKERS[:4], color="#7f7f7f", linewidth=0.8, label="ideal")
    axes.set(xscale="log", xticks=WORKERS, xticklabels=WORKERS, xlabel="workers",
             ylabel="speed-up", title="Tasks of one thread, replayed; dashed: the kernel serial; "
                                      "crosses: measured")
    axes.legend(fontsize=7)
    plots.save(figure, path.parent, path.stem)


def main():
    parser = argument_parser(__doc__, timeout=600, results="papers/results/replay.tsv",
                             takes=["molecules"])
    parser.add_argument("--plot", action="store_true",
                        help="only draw the results, as SVG and PNG (python3-matplotlib)")
    parser.add_argument("--repetitions", type=positive, default=5, help="default %(default)s")
    options = parser.parse_args()
    if options.plot:
        return draw(read_rows(options.results), options.results)
    folder = molecule_folder(options.molecules)
    surfaces = [s for s in SURFACES if options.only in s[0]]
    paths = named_files(folder, [name for name, _ in surfaces])
    copied = bytes_per_second()
    print(f"copies: {copied * 1e-9:.1f} GB a second")
    with Rows(options.results, COLUMNS, WIDTHS, 2) as rows:
        for path, (_, model) in zip(paths, surfaces):
            for row in rows_of(path, model, options, copied):
                rows.add(row)
    end([r["verdict"] for r in rows.rows if r["verdict"].startswith("FAILED")], rows.rows)


if __name__ == "__main__":
    main()
