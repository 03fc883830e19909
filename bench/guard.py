#!/usr/bin/env python3
"""Fails if the command takes over 5 % more instructions or heap than bench/guard.json records.

Three fixed runs on bundled molecules, each on one thread, with the release build of build/:
- Instructions are counted by callgrind. The load of the machine does not change them; the vector
  instructions that the C library finds on it change them by 0.4 %.
- The heap's peak is massif's: what is allocated at most, to the byte. The resident memory that a
  report gives also has pages of the program's file. How many depends on how the kernel has read
  it: 6 % of a small run are between a program just linked and the same one read from disk.

A record made with other versions (compiler, libraries, valgrind, kind of memory pages) is compared
within 25 %: wide enough for what another compiler makes of the same source, and still narrow enough
to see work done twice. On another architecture nothing is compared. The output says which it was.
"""

import argparse
import dataclasses
import json
import os
import platform
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from machine import cached, first_match, output_of
from molecule_runs import BUNDLED, MORSKIN, ROOT

RECORD = ROOT / "bench" / "guard.json"
RUNS = [
    "9dna.pdb",
    "9dna.pdb --fronts 1 -C 0.3",
    "5tmn_ligand.pdb --method static",
]
FIGURES = ["instructions", "peak_heap_bytes"]
BOUND, WIDE_BOUND = 0.05, 0.25
MODEL = "paper"
TIMEOUT = 300  # seconds


def made_with():
    """What the figures depend on, apart from the source, by name."""
    eigen = Path(cached("Eigen3_DIR")) / "Eigen3ConfigVersion.cmake"
    return {
        "architecture": platform.machine(),
        "compiler": output_of(cached("CMAKE_CXX_COMPILER"), "--version").partition("\n")[0],
        "flags": f"{cached('CMAKE_CXX_FLAGS')} {cached('CMAKE_CXX_FLAGS_RELEASE')}".strip(),
        "eigen": first_match(eigen, r'^set\(PACKAGE_VERSION "(.*)"\)'),
        "c_library": os.confstr("CS_GNU_LIBC_VERSION") or "",
        "valgrind": output_of("valgrind", "--version"),
        "huge_pages": first_match("/sys/kernel/mm/transparent_hugepage/enabled", r"\[(\w+)\]"),
    }


def total_instructions(profile):
    """The total of a callgrind profile's text."""
    return int(re.search(r"^totals: (\d+)", profile, re.MULTILINE)[1])


def peak_heap_bytes(profile):
    """The largest heap of a massif profile's text."""
    return max(int(size) for size in re.findall(r"^mem_heap_B=(\d+)", profile, re.MULTILINE))


def profiled(run, tool, *tool_options):
    """The text that a tool of valgrind writes about a run."""
    file, *options = run.split()
    with tempfile.TemporaryDirectory() as folder:
        profile = Path(folder) / "profile.out"
        subprocess.run(["valgrind", "--quiet", f"--tool={tool}", *tool_options,
                        f"--{tool}-out-file={profile}", MORSKIN, "mesh", BUNDLED / file,
                        "--model", MODEL, "--threads", "1", *options, "-q",
                        "-o", Path(folder) / "mesh.ply"],
                       check=True, timeout=TIMEOUT)
        return profile.read_text("utf-8")


def measure(run):
    return {"instructions": total_instructions(profiled(run, "callgrind")),
            "peak_heap_bytes": peak_heap_bytes(profiled(run, "massif", "--peak-inaccuracy=0"))}


@dataclasses.dataclass
class Bound:
    """How much more than recorded is allowed."""
    share: float | None  # of what is recorded; None if the figures cannot be compared
    why: str = ""  # it is not the usual one


def bound_for(recorded_with, with_now):
    """The bound for figures made with one thing, then with another (both as of `made_with`)."""
    differing = [f"{name} was {recorded_with.get(name, 'not recorded')!r}, is {now!r}"
                 for name, now in with_now.items() if recorded_with.get(name) != now]
    if not differing:
        return Bound(BOUND)
    why = "the record was made with other versions: " + "; ".join(differing)
    if recorded_with.get("architecture") != with_now["architecture"]:
        return Bound(None, why + ". Nothing is compared: architectures count differently")
    return Bound(WIDE_BOUND, f"{why}. So {WIDE_BOUND:.0%} is allowed in place of {BOUND:.0%}")


@dataclasses.dataclass
class Finding:
    text: str
    fails: bool = False


def compare(recorded, measured, share):
    """A finding for each run and figure.

    recorded, measured: figures by name, by run. share: the part of what is recorded by which a
    figure may be above it.
    """
    for run, figures in measured.items():
        if run not in recorded:
            yield Finding(f"{run}: not recorded; run make guard-record", fails=True)
            continue
        for name, now in figures.items():
            before = recorded[run][name]
            text = f"{run}: {name} {before:,} recorded, {now:,} now, {now / before - 1:+.1%}"
            if now > before * (1 + share):
                yield Finding(f"{text}: above {share:+.0%}", fails=True)
            elif now < before * (1 - share):
                yield Finding(f"{text}: the record may be lowered, by make guard-record")
            else:
                yield Finding(text)


def check():
    """True if no figure is above its bound."""
    record = json.loads(RECORD.read_text("utf-8"))
    bound = bound_for(record["made_with"], made_with())
    if bound.why:
        print(bound.why)
    if bound.share is None:
        return True
    failures = 0
    for run in RUNS:
        for finding in compare(record["runs"], {run: measure(run)}, bound.share):
            print(("FAILED " if finding.fails else "") + finding.text, flush=True)
            failures += finding.fails
    print(f"{len(RUNS)} runs, {failures} figures above the record by more than {bound.share:.0%}")
    return failures == 0


def write_record():
    record = {"made_with": made_with(), "runs": {run: measure(run) for run in RUNS}}
    RECORD.write_text(json.dumps(record, indent=2) + "\n", "utf-8")
    print(f"{RECORD.relative_to(ROOT)} is written; commit it with the reason for the change")


def arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    action = parser.add_mutually_exclusive_group()
    action.add_argument("--check", action="store_true", help="compare with the record (default)")
    action.add_argument("--record", action="store_true", help="measure and write the record anew")
    return parser.parse_args()


def main():
    options = arguments()
    if not output_of("valgrind", "--version"):
        sys.exit("valgrind is not there; apt-get install valgrind")
    if cached("CMAKE_BUILD_TYPE") != "Release" or not MORSKIN.exists():
        sys.exit("build/ holds no release build of the command; run make command")
    if options.record:
        write_record()
    elif not check():
        sys.exit(1)


if __name__ == "__main__":
    main()
