#!/usr/bin/env python3
"""Meshes thousands of distinct chains and fragments of the corpus by one `morskin batch`, as for
machine learning: 2 vertices for each square Angstrom, voids left out, certified; once with the
model ses-like and once with vdw.

batch_inputs.txt has a recipe on each line: a file of the corpus and the residues of it to take, in
the file's order. --plan writes that list anew: each long chain whole, and windows of 1,200 to 4,000
heavy atoms, evenly over all files. --sample N draws N recipes, the same every time. Files are made
in build/batch, and what came of it goes to papers/results/batch.tsv. Processor seconds are what a
busy machine leaves unchanged.
"""

import gzip
import itertools
import json
import random
import shutil
import subprocess
import sys
import time

from molecule_runs import (MORSKIN, ROOT, Rows, argument_parser, cpu_seconds_of_children, end,
                           markdown, molecule_folder, named_files, run_program)

RECIPES = ROOT / "bench" / "batch_inputs.txt"
FILES = ["1aon.pdb.gz", "1bmf.pdb.gz", "1r03_24mer.pdb.gz", "2buk_capsid.pdb.gz", "1dps.pdb",
         "1kx5.pdb", "1af6.pdb", "1j4n_tetramer.pdb", "4hhb.pdb", "1k4c.pdb", "1ake.pdb",
         "1atp.pdb", "2por.pdb"]
COUNT = 4000
LONG_CHAIN = 1000  # heavy atoms
WINDOWS = [1200, 1600, 2000, 2200, 2400, 2800, 3200, 4000]  # heavy atoms, in turn
OPTIONS = ["--density", "2", "--voids", "drop"]
MODELS = ["ses-like", "vdw"]
COLUMNS = ["model", "inputs", "ok", "refused", "uncertified", "limit", "failed", "median_atoms",
           "median_density", "least_angle", "median_triangles", "median_cpu_seconds",
           "most_cpu_seconds", "cpu_seconds", "seconds", "workers", "median_mib", "most_mib"]
WIDTHS = [9, 6, 5, 7, 11, 5, 6, 12, 14, 11, 16, 18, 16, 11, 8, 7, 10, 0]


def arguments():
    parser = argument_parser(__doc__, timeout=600, results="papers/results/batch.tsv",
                             takes=["molecules", "models"])
    parser.set_defaults(models=",".join(MODELS))
    parser.add_argument("--plan", action="store_true", help="write the list of recipes, no more")
    parser.add_argument("--sample", type=int, default=COUNT, metavar="N", help="recipes to take")
    parser.add_argument("--workers", type=int, default=2, help="default %(default)s")
    options = parser.parse_args()
    if options.plan and options.only:
        parser.error("--plan writes the recipes of all files; leave --only out")
    return options


def residues_of(path):
    """Lines of each residue of a PDB file, in order: of its first model, heavy atoms of the first
    alternate location, no water."""
    opener = gzip.open if path.suffix == ".gz" else open
    lines = []
    with opener(path, "rt") as file:
        for line in file:
            if line.startswith("ENDMDL"):
                break
            element = line[76:78].strip() or line[12:14].strip(" 0123456789")[:1]
            if line.startswith(("ATOM", "HETATM")) and line[16] in " A" and line[17:20] != "HOH" \
                    and element not in ("H", "D"):
                lines.append(line)
    # Chains of copies may share their letters, so residues are told apart by where they begin.
    return [list(group) for _, group in itertools.groupby(lines, key=lambda line: line[17:27])]


def chains_of(residues):
    """(first, last) residue of each chain, from 0."""
    first = 0
    for _, group in itertools.groupby(residues, key=lambda residue: residue[0][21]):
        count = len(list(group))
        yield first, first + count - 1
        first += count


def plan(folder):
    """The recipes: name of a file, first and last residue from 1."""
    read = {path.name: residues_of(path) for path in named_files(folder, FILES)}
    recipes = {}  # as a set that keeps its order
    for name, residues in read.items():
        for first, last in chains_of(residues):
            if sum(map(len, residues[first:last + 1])) >= LONG_CHAIN:
                recipes[name, first + 1, last + 1] = None
    all_residues = sum(map(len, read.values()))
    for step in itertools.count():
        windows = windows_of(read, all_residues / (COUNT + step * 10))
        together = {**recipes, **dict.fromkeys(windows)}
        if len(together) >= COUNT:
            return list(together)[:COUNT]


def windows_of(read, stride):
    """Windows that begin a stride of residues apart; sizes in turn."""
    sizes = itertools.cycle(WINDOWS)
    for name, residues in read.items():
        place = 0.0
        while place < len(residues):
            first, size, atoms = int(place), next(sizes), 0
            for last in range(first, len(residues)):
                atoms += len(residues[last])
                if atoms >= size:
                    yield name, first + 1, last + 1
                    break
            place += stride


def recipes_of(sample):
    lines = RECIPES.read_text(encoding="utf-8").splitlines()
    chosen = sorted(random.Random(1).sample(range(len(lines)), min(sample, len(lines))))
    return [lines[i].split() for i in chosen]


def make_inputs(recipes, folder, target):
    names = sorted({name for name, *_ in recipes})
    paths = dict(zip(names, named_files(folder, names)))
    shutil.rmtree(target, ignore_errors=True)
    target.mkdir(parents=True)
    for name, group in itertools.groupby(recipes, key=lambda recipe: recipe[0]):
        residues = residues_of(paths[name])
        for _, first, last in group:
            lines = itertools.chain(*residues[int(first) - 1:int(last)])
            path = target / f"{name.partition('.')[0]}_{first}-{last}.pdb"
            path.write_text("".join(lines) + "END\n", encoding="utf-8")


def row_of(model, options, target):
    made = target.parent / model
    shutil.rmtree(made, ignore_errors=True)
    start, before = time.monotonic(), cpu_seconds_of_children()
    done = run_program([MORSKIN, "batch", target, "-o", made, "--model", model, *OPTIONS,
                        "--workers", str(options.workers), "--timeout", str(options.timeout),
                        "--json"], stdout=subprocess.PIPE)
    done.check_returncode()
    summary = json.loads(done.stdout)
    row = {"model": model, "inputs": summary["inputs"], "workers": options.workers,
           "seconds": time.monotonic() - start,
           "cpu_seconds": cpu_seconds_of_children() - before}
    for status in ("ok", "refused", "uncertified", "limit", "failed"):
        row[status] = summary["statuses"].get(status, 0)
    for column, measure, which, unit in (
            ("median_atoms", "atoms", "median", 1), ("least_angle", "min_angle_deg", "least", 1),
            ("median_density", "vertices_per_square_angstrom", "median", 1),
            ("median_triangles", "triangles", "median", 1),
            ("median_cpu_seconds", "cpu_seconds", "median", 1),
            ("most_cpu_seconds", "cpu_seconds", "most", 1),
            ("median_mib", "peak_memory_bytes", "median", 2**20),
            ("most_mib", "peak_memory_bytes", "most", 2**20)):
        row[column] = summary.get(measure, {}).get(which, 0) / unit
    return row


def table(rows):
    """The rows of the page."""
    body = []
    for r in rows:
        of = {k: v if k == "model" else float(v) for k, v in r.items()}
        body.append([r["model"], r["inputs"], r["ok"], f"{of['median_atoms']:.0f}",
                     f"{of['median_density']:.2f}", f"{of['least_angle']:.2f}°",
                     f"{of['median_cpu_seconds']:.2f}", f"{of['most_cpu_seconds']:.1f}",
                     f"{of['cpu_seconds']:.0f}", f"{of['seconds']:.0f}", f"{of['most_mib']:.0f}"])
    return markdown(["model", "inputs", "certified", "heavy atoms, median",
                     "vertices per Å², median", "smallest angle", "processor s each, median",
                     "most", "processor s in all", "by the clock", "MiB a worker, most"], body)


def sentence(rows):
    """What the page says of the goal: ten minutes."""
    hours = {r["model"]: float(r["cpu_seconds"]) / int(r["inputs"]) * COUNT / 2 / 3600
             for r in rows}
    return (f"{COUNT:,} such molecules would take two cores "
            + " and ".join(f"{h:.2f} hours with {model}" for model, h in hours.items()))


def main():
    options = arguments()
    folder = molecule_folder(options.molecules)
    if options.plan:
        lines = [f"{name} {first} {last}\n" for name, first, last in plan(folder)]
        RECIPES.write_text("".join(lines), encoding="utf-8")
        return
    recipes = [r for r in recipes_of(options.sample) if options.only in r[0]]
    if not recipes:
        end([], recipes)
    inputs = ROOT / "build" / "batch" / "inputs"
    make_inputs(recipes, folder, inputs)
    with Rows(options.results, COLUMNS, WIDTHS, 1) as rows:
        for model in options.models.split(","):
            rows.add(row_of(model, options, inputs))
    as_text = [{k: str(v) for k, v in r.items()} for r in rows.rows]
    print(table(as_text), sentence(as_text), sep="\n")
    sys.exit(any(r["ok"] + r["refused"] < r["inputs"] for r in rows.rows))


if __name__ == "__main__":
    main()
