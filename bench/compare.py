#!/usr/bin/env python3
"""Is this build slower than that of another commit? Times the two in turns.

The sources of BASE are unpacked into build/compare/ and built there as its own release preset says;
a second call with the same BASE builds nothing. Then both commands mesh each input in turns, the
order changing every time, so that what else the machine does falls on both. Medians and their
ratio, this build over BASE, are printed, with triangles, the smallest angle, and whether the files
are the same byte by byte. Exit code 1 if user time or memory is above the bound for any input.

Wall time is shown only. On a busy machine nine runs of one and the same program gave ratios from
0.97 to 1.02 in user time, and from 0.85 to 1.03 in wall time.
"""

import argparse
import dataclasses
import hashlib
import json
import math
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from machine import output_of
from molecule_runs import BUNDLED, MORSKIN, ROOT, molecule_files

BUILDS = ROOT / "build" / "compare"


def unpacked(commit):
    """The folder of the sources of a commit, unpacked if they are not yet there."""
    name = output_of("git", "rev-parse", "--quiet", "--verify", commit + "^{commit}")
    if not name:
        sys.exit(f"no such commit: {commit}")
    folder = BUILDS / name[:12]
    if not folder.exists():
        part, archive = folder.with_suffix(".part"), folder.with_suffix(".tar")
        shutil.rmtree(part, ignore_errors=True)
        part.mkdir(parents=True)
        subprocess.run(["git", "archive", f"--output={archive}", name], cwd=ROOT, check=True)
        subprocess.run(["tar", "--extract", f"--file={archive}", "-C", part], check=True)
        archive.unlink()
        part.rename(folder)
    return folder


def built(folder, jobs):
    """The command of the sources in a folder, built in release."""
    for words in (["--preset", "release"],
                  ["--build", "build", "--parallel", str(jobs), "--target", "morskin_command"]):
        done = subprocess.run(["cmake", *words], cwd=folder, capture_output=True, text=True,
                              check=False)
        if done.returncode != 0:
            sys.exit(f"{folder}: cmake {' '.join(words)} failed\n{done.stdout}{done.stderr}")
    return folder / "build" / "morskin"


@dataclasses.dataclass
class Sample:
    """What one run took and made."""
    user_seconds: float
    wall_seconds: float
    peak_memory_bytes: int
    triangles: int
    min_angle_deg: float
    digest: str  # of the mesh file


def sample(program, molecule, options):
    with tempfile.TemporaryDirectory() as folder:
        mesh, report = Path(folder) / "mesh.ply", Path(folder) / "report.json"
        start = time.monotonic()
        process = subprocess.Popen([program, "mesh", molecule, "-o", mesh, "--report", report,
                                    "-q", *options])
        _, status, usage = os.wait4(process.pid, 0)
        wall_seconds = time.monotonic() - start
        process.returncode = os.waitstatus_to_exitcode(status)
        if process.returncode != 0:
            sys.exit(f"{program} mesh {molecule}: exit code {process.returncode}")
        figures = json.loads(report.read_text("utf-8"))
        return Sample(user_seconds=usage.ru_utime, wall_seconds=wall_seconds,
                      peak_memory_bytes=figures["peak_memory_bytes"],
                      triangles=figures["triangles"], min_angle_deg=figures["min_angle_deg"],
                      digest=hashlib.sha256(mesh.read_bytes()).hexdigest())


def samples_in_turns(programs, molecule, options, runs):
    """Samples by program. A first run of each, which reads the files, is left out."""
    samples = [[] for _ in programs]
    for turn in range(runs + 1):
        order = list(enumerate(programs))
        for i, program in order if turn % 2 == 0 else reversed(order):
            taken = sample(program, molecule, options)
            if turn > 0:
                samples[i].append(taken)
    return samples


ROWS = [  # label, name in Sample, unit, digits
    ("user time, s", "user_seconds", 1, 3),
    ("wall time, s", "wall_seconds", 1, 3),
    ("peak memory, MiB", "peak_memory_bytes", 2**20, 1),
    ("triangles", "triangles", 1, 0),
    ("smallest angle, deg", "min_angle_deg", 1, 3),
]
BOUNDED = {"user_seconds", "peak_memory_bytes"}


def compare(base, here, bound):
    """Lines of a table, and the labels of what is above the bound."""
    lines, above = [], []
    for label, name, unit, digits in ROWS:
        before, now = (statistics.median(getattr(s, name) for s in samples) / unit
                       for samples in (base, here))
        # Of a run too short for the clock, all of its time may count as the system's.
        ratio = now / before if before > 0 else math.nan
        is_above = name in BOUNDED and ratio > bound
        if is_above:
            above.append(label.partition(",")[0])
        lines.append(f"  {label:20} {before:>14,.{digits}f} {now:>14,.{digits}f} {ratio:8.3f}"
                     + (f"  above {bound:g}" if is_above else ""))
    are_same = {s.digest for s in base} == {s.digest for s in here}
    lines.append("  the files are the same" if are_same else "  the files differ")
    return lines, above


def default_molecules(folder):
    """Gramicidin, and ubiquitin if the folder has it, else crambin."""
    folder = folder if folder.is_absolute() else ROOT / folder
    return [BUNDLED / "1grm_model1.pdb",
            *(molecule_files(folder, "1ubq") or [BUNDLED / "1crn.pdb"])[:1]]


def arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter,
        epilog="Make hands over the other options as COMPARE:\n  make bench-compare BASE=HEAD~3 "
               "COMPARE='--runs 21 --mesh=\"-C 0.3 --fronts 1\"'")
    parser.add_argument("base", metavar="BASE", help="commit to compare with, by any of its names")
    parser.add_argument("--inputs", type=Path, nargs="+", metavar="FILE",
                        help="molecules (default gramicidin, and 1UBQ, else the bundled crambin)")
    parser.add_argument("--molecules", type=Path, default=Path("../shared/molecules"),
                        help="folder to look for 1UBQ in (default %(default)s)")
    parser.add_argument("--runs", type=int, default=9, metavar="N",
                        help="runs of each command on each input (default %(default)s)")
    parser.add_argument("--bound", type=float, default=1.05, metavar="RATIO",
                        help="fail above it; inf never fails (default %(default)s)")
    parser.add_argument("--mesh", default="--model paper", metavar="OPTIONS",
                        help="for both commands, as in --mesh='--model vdw --threads 1'; "
                             "default %(default)s")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="to build BASE with")
    options = parser.parse_args()
    if options.runs < 1:
        parser.error("--runs must be at least 1")
    return options


def main():
    options = arguments()
    if not MORSKIN.exists():
        sys.exit("build/ holds no command; run make command")
    source = unpacked(options.base)
    print(f"building {options.base} in {source.relative_to(ROOT)}", flush=True)
    programs = [built(source, options.jobs), MORSKIN]
    failures = 0
    for molecule in options.inputs or default_molecules(options.molecules):
        base, here = samples_in_turns(programs, molecule, options.mesh.split(), options.runs)
        lines, above = compare(base, here, options.bound)
        print(f"\n{molecule.name:22} {source.name:>14} {'here':>14} {'ratio':>8}", *lines, sep="\n",
              flush=True)
        failures += len(above)
    print(f"\n{failures} medians above {options.bound:g} times those of {options.base}")
    sys.exit(failures > 0)


if __name__ == "__main__":
    main()
