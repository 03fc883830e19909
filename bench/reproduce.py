#!/usr/bin/env python3
"""Reproduces section 5 of the paper: Table 1 and its comparison of methods, in one run.

Into the results folder go

  table1.csv        every run of every method on the three molecules, one row each
  table1.md         medians and spread beside the paper's own rows, ratios, what was asked
  scaling.csv       time against triangles over the corpus and over finer meshes of one molecule
  angles.csv        how many angles there are of each degree, by molecule and method
  agreement.csv     whether the methods agree on the topology of small sets of balls and molecules
  ablation.tsv      what each departure from the paper's Algorithm 1 is worth (bench/ablation.py)
  environment.json  machine, compiler, flags, load at start and end, by part
  inputs.sha256     the inputs, so that it can be seen what was measured

and bench/reproduce_plots.py draws scaling and angles from there. The methods take turns within each
repetition, so that noise hits all alike. What was out of time or left out for lack of it is "not
measured" in table1.md, and a method that is not built in is named there.

With --parts only some are run; the others' rows are taken from the folder, and table1.md says so.
--only and --largest choose among the molecules of the scaling, --models those of the agreement.
With --quick (QUICK=1) Table 1 comes first, every method once and without a limit of time, so that
the ratios to the sweep are measured whatever the machine is. Then each part has a share of the
time, with smaller molecules.
"""

import argparse
import hashlib
import math
import os
import tempfile
from pathlib import Path

import ablation
import reproduce_tables as tables
from machine import environment
from molecule_runs import (BUNDLED, MODELS, argument_parser, atom_count, end, molecule_files,
                           molecule_folder, positive, run_command, sized_files, time_limit)
from reproduce_part import METHODS, Notes, Part
from reproduce_tables import STAGES

PARTS = ["table1", "scaling", "agreement", "ablation"]
QUICK_SECONDS = {"table1": 20, "scaling": 60, "agreement": 40}  # of table1 after the first of each
NOT_SCALED = {"one-front-unsmoothed"}  # the sweep's time but for a few per cent

TABLE1 = {"5TMN": "5tmn_ligand.pdb", "9DNA": "9dna.pdb", "1GRM": "1grm_model1.pdb"}
TABLE1_COLUMNS = ["molecule", "method", "repetition", "triangles", "min_angle_deg",
                  "max_angle_deg", "worst_L", "worst_U", "seconds", "peak_memory_bytes",
                  "certified", *("seconds_" + s for s in STAGES), "cpu_seconds", "floor_ratio",
                  "homeomorphic", "euler_characteristic", "components", "genus", "violations_L",
                  "violations_U", "reason"]
SCALING_COLUMNS = ["molecule", "series", "atoms", "C", "method", "repetition", "triangles",
                   "seconds", "cpu_seconds", "peak_memory_bytes", "certified", "reason"]
AGREEMENT_COLUMNS = ["molecule", "model", "method", "certified", "euler_characteristic",
                     "components", "genus", "expected_euler_characteristic", "expected_components",
                     "expected_genus", "triangles", "min_angle_deg", "seconds", "reason"]
FINER = "5tmn_ligand.pdb"  # meshed with ever smaller C
SMALL_MOLECULES = ["benzene.pdb", "c60.xyz", "caffeine.xyz", "cube8.xyzr", "ring12.xyzr",
                   "shell_hollow.xyzr", "5tmn_ligand.pdb", "9dna.pdb", "1grm_model1.pdb",
                   "1crn.pdb", "1ubq.pdb"]


def arguments():
    parser = argument_parser(__doc__, timeout=1800, results="build/results", largest=8000)
    parser.add_argument("--repetitions", type=positive, default=5,
                        help="of every run (%(default)s)")
    parser.add_argument("--quick", action="store_true", default=os.environ.get("QUICK") == "1",
                        help="some five minutes; also with QUICK=1 in the environment")
    parser.add_argument("--finest", type=float, default=0.004, metavar="C",
                        help="of the series of finer and finer meshes (%(default)s)")
    parser.add_argument("--scaling-timeout", type=time_limit, default=30, metavar="SECONDS",
                        help="of a run of the scaling; a method that needs more is not tried on "
                             "larger inputs (%(default)s)")
    parser.add_argument("--parts", default=",".join(PARTS), help="default %(default)s")
    parser.add_argument("--methods", default=",".join(METHODS), help="default %(default)s")
    options = parser.parse_args()
    for asked, known in ((options.parts, PARTS), (options.methods, METHODS),
                         (options.models, MODELS)):
        for name in asked.split(","):
            if name not in known:
                parser.error(f"there is no '{name}', only {', '.join(known)}")
    if options.quick:
        options.timeout, options.largest = min(options.timeout, 20), min(options.largest, 700)
        options.finest = max(options.finest, 0.02)
        options.scaling_timeout = min(options.scaling_timeout, 5)
    return options


def methods_there_are(options, notes):
    """The methods that were asked for and that this build has; reports the others."""
    there = []
    for method, words in METHODS.items():
        if method not in options.methods.split(","):
            notes.add(f"the method {method} was not asked for")
            continue
        with tempfile.TemporaryDirectory() as temporary:
            done = run_command(["mesh", BUNDLED / "two_balls.xyzr", "-o",
                                Path(temporary) / "mesh.ply", "--json", *words], 60)
        if done.code == 2:
            notes.add(f"the method {method} is left out: {done.complaint}")
        else:
            there.append(method)
    return there


def turns(methods, repetition):
    """The methods, another one first in each repetition."""
    first = repetition % max(1, len(methods))
    return methods[first:] + methods[:first]


def table1(options, methods, notes, meshes):
    """The first repetition knows no limit if it is quick."""
    part = Part("table1", TABLE1_COLUMNS, options, notes)
    hopeless, seconds = set(), {}
    for repetition in range(1, options.repetitions + 1):
        if repetition == 2:
            print("\n" + tables.ratios_text(part.rows, methods), flush=True)
            part.limit(QUICK_SECONDS["table1"])
        for molecule, file in TABLE1.items():
            for method in turns(methods, repetition):
                if (molecule, method) in hopeless:
                    continue
                fixed = {"molecule": molecule, "repetition": repetition}
                if part.is_late(seconds.get((molecule, method), 0)):
                    part.leave_out(method, fixed)
                    continue
                keep = meshes / f"{molecule}.{method}.ply" if repetition == 1 else None
                row = part.run(BUNDLED / file, "paper", method, fixed, keep=keep)
                seconds[molecule, method] = float(row["seconds"])
                if row["code"] not in (0, 5):
                    hopeless.add((molecule, method))
    tables.write_angles(options.results / "angles.csv", meshes, list(TABLE1), methods)
    part.end()
    return part


def evenly_spaced(files, least, most, count):
    """About `count` of the files, their atoms evenly spaced on a logarithmic scale."""
    chosen = []
    for i in range(count if files else 0):
        wanted = least * (most / least) ** (i / (count - 1))
        nearest = min(files, key=lambda f: abs(math.log(f[0] / wanted)))
        if nearest not in chosen:
            chosen.append(nearest)
    return chosen


def scaling(options, methods, notes, folder):
    """Small things first within a repetition; a method out of time is not tried on larger ones."""
    files, unreadable = sized_files(folder, options.only)
    part = Part("scaling", SCALING_COLUMNS, options, notes)
    part.limit(QUICK_SECONDS["scaling"])
    part.timeout, part.may_run_out = min(part.timeout, options.scaling_timeout), True
    methods = [m for m in methods if m not in NOT_SCALED]
    for path in unreadable:
        notes.add(f"scaling: {path.name} cannot be read")
    fitting = [f for f in files if 10 <= f[0] <= options.largest]
    if not fitting:
        notes.add("scaling: there is no molecule of the size asked for")
    chosen = evenly_spaced(fitting, 10, options.largest, 8 if options.quick else 12)
    cases = [(p, {"molecule": p.name, "series": "corpus", "atoms": atoms, "C": 0.08})
             for atoms, p in chosen]
    for C in (0.1, 0.08, 0.056, 0.04, 0.028, 0.02, 0.014, 0.01, 0.007, 0.005, 0.004):
        if C >= options.finest:
            cases.append((BUNDLED / FINER, {"molecule": FINER, "series": "finer", "atoms": 32,
                                            "C": C}))
    limit = {}  # by series and method, where the first run was out of time
    for repetition in range(1, options.repetitions + 1):
        for index, (path, fixed) in enumerate(cases):
            for method in turns(methods, repetition):
                if index >= limit.get((fixed["series"], method), math.inf):
                    continue
                fixed = {**fixed, "repetition": repetition}
                if part.is_late():
                    part.leave_out(method, fixed)
                    continue
                row = part.run(path, "paper", method, fixed, "-C", str(fixed["C"]))
                if row["code"] == -1:  # other failures tell nothing of larger ones
                    limit[fixed["series"], method] = index
    part.end()
    return part


def made_up_balls(model, folder):
    """One ball; two with a neck, almost touching and apart. Files of radii that go through the
    model, so the distance is chosen for the weight that comes of it."""
    r = 1.5
    weight = {"paper": math.sqrt(2) * (r + 1.4), "sas": 2 * (r + 1.4) ** 2, "vdw": 2 * r * r}[model]
    shares = {"one": None, "two-neck": 0.9, "two-almost-touching": 1.01, "two-apart": 1.2}
    for name, share in shares.items():
        path = folder / f"{name}-{model}.xyzr"
        lines = [f"0 0 0 {r}"]
        if share:
            lines.append(f"{share * 2 * math.sqrt(weight):.6f} 0.1 0.05 {r}")
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
        yield name, path


def agreement(options, methods, notes, folder, temporary):
    """Small things first."""
    part = Part("agreement", AGREEMENT_COLUMNS, options, notes)
    part.limit(QUICK_SECONDS["agreement"])
    files = {p.name: p for p in molecule_files(BUNDLED) + molecule_files(folder)}
    for name in SMALL_MOLECULES:
        if name not in files:
            notes.add(f"agreement: {name} is not in {folder}")
    molecules = [(name, files[name]) for name in SMALL_MOLECULES if name in files]
    cases = [(name, path, model) for model in options.models.split(",")
             for name, path in [*made_up_balls(model, temporary), *molecules]]
    late = set()
    for name, path, model in sorted(cases, key=lambda case: atom_count(case[1])):
        for method in methods:
            fixed = {"molecule": name, "model": model}
            if (name, method) in late:
                part.leave_out(method, fixed, "it was out of time in another model")
            elif part.is_late():
                part.leave_out(method, fixed)
            elif part.run(path, model, method, fixed)["code"] == -1:
                late.add((name, method))
    part.end()
    return part


def ablated(options):
    rows = ablation.measure(options.results / "ablation.tsv",
                            min(options.timeout, ablation.TIMEOUT), options.repetitions,
                            is_quick=options.quick)
    return argparse.Namespace(rows=rows, failures=ablation.failures(rows))


def hashes(folder):
    for path in sorted({*molecule_files(BUNDLED), *molecule_files(folder)}):
        digest = hashlib.sha256(path.read_bytes()).hexdigest()
        base = folder if path.is_relative_to(folder) else BUNDLED
        yield f"{digest}  {path.relative_to(base)}\n"


def main():
    options = arguments()
    options.results.mkdir(parents=True, exist_ok=True)
    notes = Notes()
    folder = molecule_folder(options.molecules)
    if folder == BUNDLED.resolve():
        notes.add(f"{options.molecules} is not there: the corpus is bench/molecules only")
    if options.quick:
        notes.add("QUICK=1: smaller molecules, less time; the figures are rougher")
    methods = methods_there_are(options, notes)
    if not methods:
        end([], [])
    inputs = "".join(hashes(folder))
    with tempfile.TemporaryDirectory() as name:
        temporary = Path(name)
        measures = {"table1": lambda: table1(options, methods, notes, temporary),
                    "scaling": lambda: scaling(options, methods, notes, folder),
                    "agreement": lambda: agreement(options, methods, notes, folder, temporary),
                    "ablation": lambda: ablated(options)}
        parts = {}
        for part in (p for p in PARTS if p in options.parts.split(",")):
            started = environment()
            parts[part] = measures[part]()
            # At once, or a run that is cut leaves rows with the environment of earlier ones.
            known = tables.write_environment(options.results / "environment.json", started,
                                             environment(), options, part)
            (options.results / "inputs.sha256").write_text(inputs, encoding="utf-8")
    rows = {name: part.rows for name, part in parts.items()}
    for name in PARTS:
        if name not in rows and (earlier := tables.earlier_rows(options.results, name)):
            rows[name] = earlier
            at = {"date": "unknown", "cpu": "an unknown machine"} | known.get(name, {})
            notes.add(f"{name}: the rows of an earlier run, of {at['date'][:10]} on {at['cpu']}")
    text = tables.table1_text(rows, methods, notes.lines,
                              known.get("table1", known[next(iter(parts))]))
    (options.results / "table1.md").write_text(text, encoding="utf-8")
    print("\n" + text + f"\nAll of this is in {options.results}.\n")
    failures = [f for part in parts.values() for f in part.failures]
    for failure in failures:
        print("NOT CERTIFIED: " + failure)
    end(failures, any(rows.values()))


if __name__ == "__main__":
    main()
