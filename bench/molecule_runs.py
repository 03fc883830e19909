"""Common parts of the scripts of this folder: molecules, arguments, one run of the command."""

import argparse
import dataclasses
import functools
import json
import math
import os
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MORSKIN = ROOT / "build" / "morskin"
BUNDLED = ROOT / "bench" / "molecules"
ENDINGS = {".pdb", ".ent", ".cif", ".pqr", ".xyz", ".xyzr"}
MODELS = ["paper", "sas", "vdw"]
# The stages of a report's seconds, in their order, by what they are for.
STAGES = {"prepare": ["read", "triangulate", "mixed_complex", "dual_complex", "voids"],
          "mesh": ["critical_points", "sweep", "refine"], "angles": ["smooth"],
          "certify": ["certify"], "describe": ["describe"], "write": ["write"]}


class Parser(argparse.ArgumentParser):
    """No part of the molecules or models takes the place of a page's table, and a table that could
    not be written is found before the runs."""

    def parse_args(self, *words):
        options = super().parse_args(*words)
        parts = [name for name in ("only", "models", "largest")
                 if getattr(options, name, None) != self.get_default(name)]
        if parts and options.results.resolve().is_relative_to(ROOT / "papers"):
            self.error(f"--{parts[0]} makes a part of {options.results.name}, which a page shows: "
                       "say with --results where else to write")
        usual = self.get_default("results")
        if usual.suffix and options.results.is_dir():
            self.error(f"--results {options.results} is a folder: name a file, as {usual.name}")
        folder = options.results.absolute()
        if usual.suffix:
            folder = folder.parent
        there = next(path for path in (folder, *folder.parents) if os.path.exists(path))
        if not there.is_dir():
            self.error(f"--results: {there} is a file: name a folder")
        if not os.access(there, os.W_OK | os.X_OK):
            self.error(f"--results: {there} may not be written to: name another folder")
        return options


def argument_parser(text, *, timeout, results, takes=("molecules", "models", "largest"),
                    largest=None):
    """The arguments that scripts share; one may add its own.

    takes: which of these three; a script whose molecules or models are fixed takes none of it.
    """
    parser = Parser(description=text, formatter_class=argparse.RawDescriptionHelpFormatter)
    if "molecules" in takes:
        parser.add_argument("--molecules", type=Path, default=Path("../shared/molecules"),
                            help="folder to search (default %(default)s; bench/molecules where "
                                 "that is not there)")
    if "models" in takes:
        parser.add_argument("--models", default=",".join(MODELS), help="default %(default)s")
    if "largest" in takes:
        parser.add_argument("--largest", type=int, metavar="N", default=largest,
                            help="no molecule of more atoms" + (f" ({largest})" if largest else ""))
    parser.add_argument("--only", default="", metavar="PATTERN", help="part of the file's path")
    parser.add_argument("--timeout", type=time_limit, default=timeout,
                        help="seconds for one run (%(default)s)")
    parser.add_argument("--results", type=Path, default=ROOT / results,
                        help="where to write (default: " + results + ")")
    return parser


def positive(text):
    """A number of runs."""
    if int(text) < 1:
        raise argparse.ArgumentTypeError(f"{text} is not above 0")
    return int(text)


def time_limit(text):
    """Seconds."""
    if not float(text) > 0:
        raise argparse.ArgumentTypeError(f"{text} is not above 0")
    return float(text)


def molecule_folder(asked):
    """The folder asked for; where there is none, the bundled molecules, with a line saying so."""
    folder = asked if asked.is_absolute() else ROOT / asked
    if not folder.is_dir():
        print(f"{folder} is not there; using {BUNDLED}")
        folder = BUNDLED
    return folder.resolve()


def molecule_files(folder, only=""):
    def ending(path):
        return Path(path.stem).suffix if path.suffix == ".gz" else path.suffix

    return [p for p in sorted(folder.rglob("*")) if ending(p) in ENDINGS and only in str(p)]


def named_files(folder, names):
    """The first file of each name, or pattern, in the folder; ends the script if it lacks one."""
    found = [next(iter(sorted(folder.rglob(name))), None) for name in names]
    if None in found:
        missing = dict.fromkeys(name for name, path in zip(names, found) if not path)
        sys.exit(f"{folder} has no {', '.join(missing)}")
    return found


def run_program(words, **options):
    """subprocess.run(), which ends the script where the program is not built."""
    try:
        return subprocess.run(words, check=False, **options)
    except FileNotFoundError:
        how = "make command"
        if words[0] != MORSKIN:
            how += f", then cmake --build build --target {words[0].name}"
        sys.exit(f"{words[0]} is not there; run {how}")


@functools.cache
def atom_count(path):
    """The atoms that a mesh would be made of; infinitely many if `balls` does not say."""
    done = run_program([MORSKIN, "balls", path, "-o", "-", "-q"], capture_output=True)
    return done.stdout.count(b"\n") if done.returncode == 0 else math.inf


def sized_files(folder, only="", largest=None):
    """Pairs of atoms and file, small molecules first, none of more than `largest` atoms; and the
    files that cannot be read."""
    files = sorted((atom_count(p), p) for p in molecule_files(folder, only))
    return ([(atoms, p) for atoms, p in files if atoms < math.inf and atoms <= (largest or atoms)],
            [p for atoms, p in files if atoms == math.inf])


@dataclasses.dataclass
class Run:
    """What came of one run: exit code (-1 out of time), report (empty if there is none), words."""
    code: int
    report: dict
    complaint: str
    seconds: float  # by the wall clock, the program's start and end included
    cpu_seconds: float  # of all its threads; right only while no other run is under way


def cpu_seconds_of_children():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def run_command(words, timeout):
    """Runs morskin with these words; what it prints on standard output is JSON.

    timeout: seconds, or math.inf.
    """
    start, before = time.monotonic(), cpu_seconds_of_children()
    try:
        done = run_program([MORSKIN, *words], capture_output=True, text=True,
                           timeout=None if timeout == math.inf else timeout)
        code, output, complaint = done.returncode, done.stdout, done.stderr
    except subprocess.TimeoutExpired:
        code, output, complaint = -1, "", f"still running after {timeout:g} s"
    return Run(code, json.loads(output) if output else {},
               " ".join(complaint.split()).removeprefix("morskin: "),
               time.monotonic() - start, cpu_seconds_of_children() - before)


def mesh(path, model, timeout, *options, keep=None):
    """One run of `mesh`; the mesh itself, certified or not, goes to `keep` if that is given."""
    with tempfile.TemporaryDirectory() as temporary:
        output = Path(temporary) / "mesh.ply"
        done = run_command(["mesh", path, "--model", model, "--json", "--progress", "never",
                            "-o", output, *options], timeout)
        unverified = output.with_name(output.name + ".unverified")
        made = output if output.exists() else unverified
        if keep and made.exists():
            shutil.move(made, keep)
    return done


def brief(value, digits=4):
    return f"{value:.{digits}g}" if isinstance(value, float) else str(value)


class Replacement:
    """A file to write that takes an earlier one's place when it is whole, and has .part behind its
    name until then: a run that is cut leaves the earlier file as it is."""

    def __init__(self, path, newline=None):
        path.parent.mkdir(parents=True, exist_ok=True)
        self.path, self.part = path, path.with_name(path.name + ".part")
        self.file = open(self.part, "w", encoding="utf-8", newline=newline)

    def close(self, is_whole):
        self.file.close()
        if is_whole:
            self.part.replace(self.path)


class Rows:
    """Rows of results, each printed at once; a file of tabs, replaced when all are there."""

    def __init__(self, path, columns, widths, left):
        """widths: by column, for the eye; the first `left` columns stand to the left."""
        self.columns, self.widths, self.left, self.rows = columns, widths, left, []
        self.replacement = Replacement(path)
        self.file = self.replacement.file
        self.file.write("\t".join(columns) + "\n")
        self.show(columns)

    def __enter__(self):
        return self

    def __exit__(self, error, *_):
        # SystemExit is an error, too: it may tell that an input is missing.
        self.replacement.close(is_whole=error is None and self.rows)

    def show(self, values):
        cells = [brief(v) for v in values]
        text = [c[:w].ljust(w) if i < self.left else c.rjust(w)
                for i, (c, w) in enumerate(zip(cells, self.widths))]
        print(" ".join(text[:-1]), "", cells[-1], flush=True)

    def add(self, row):
        values = [row[c] for c in self.columns]
        self.file.write("\t".join(map(str, values)) + "\n")
        self.file.flush()
        self.show(values)
        self.rows.append(row)


def read_rows(path):
    """The rows of such a file, all values as text."""
    lines = path.read_text(encoding="utf-8").splitlines()
    return [dict(zip(lines[0].split("\t"), line.split("\t"))) for line in lines[1:]]


def markdown(head, rows):
    """A table of cells, each a text or what str makes one."""
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    lines += ["| " + " | ".join(map(str, cells)) + " |" for cells in rows]
    return "\n".join(lines) + "\n"


def end(failures, runs, unreadable=()):
    """Ends the script: well if there were runs, no failures and no unreadable files."""
    for path in unreadable:
        print(f"  {path}: FAILED: morskin balls cannot read it")
    if not runs:
        print("nothing was run")
    sys.exit(1 if failures or unreadable or not runs else 0)
