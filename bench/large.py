#!/usr/bin/env python3
"""How much memory and time does a triangle of a large molecule take, against one of gramicidin?

Sweeps each surface in two threads, one line each, also in papers/results/large.tsv: peak memory
and its share of the budget, 1.5 kB an atom and 150 bytes a triangle; microseconds a triangle by
the clock and of processor time, each the median of several runs, gramicidin's and capsids' in
turns, but one run of a capsid with a larger C. A run is good when it is certified.
"""

import statistics
import subprocess
import tempfile
from pathlib import Path

from molecule_runs import (MORSKIN, ROOT, Rows, argument_parser, end, markdown, mesh,
                           molecule_folder, named_files, positive)

SMALL = "1grm_model1.pdb"
# By model and C, molecules from the smallest to the largest; "2x2x1": so many copies, side by side.
SURFACES = [("sas", 0.08, [SMALL, "2buk_capsid.pdb.gz", "1f2n_capsid.cif.gz"]),
            ("vdw", 0.2, [SMALL, "2buk_capsid.pdb.gz"]),
            ("paper", 0.23, [SMALL, "2buk_capsid.pdb.gz"]),
            ("vdw", 0.3, [SMALL, "1f2n_capsid.cif.gz"]),
            ("paper", 0.34, [SMALL, "1f2n_capsid.cif.gz"]),
            ("sas", 0.3, [SMALL, "2buk_capsid.pdb.gz", "1f2n_capsid.cif.gz 2x2x1"])]
QUICK_C = 0.08  # of runs that are repeated
COLUMNS = ["molecule", "model", "C", "atoms", "triangles", "peak_mib", "of_budget",
           "seconds", "cpu_seconds", "min_angle", "verdict"]
WIDTHS = [24, 5, 5, 8, 9, 8, 9, 8, 11, 9, 10]


def budget(atoms, triangles):
    """In bytes."""
    return 1500 * atoms + 150 * triangles


def input_of(name, found, folder):
    """The file, or so many copies of its molecule in the folder."""
    file, *copies = name.split()
    if not copies:
        return found[file]
    tiled = Path(folder) / "copies.xyzr"
    subprocess.run([ROOT / "bench" / "tile.py", MORSKIN, found[file], "-n", copies[0], "-o", tiled],
                   check=True, capture_output=True)
    return tiled


def runs_of(model, c, paths, options):
    """By molecule, the runs with one model and C, taken in turns."""
    runs = {name: [] for name in paths}
    for turn in range(options.repetitions):
        for name, path in paths.items():
            if turn == 0 or c == QUICK_C or name == SMALL:
                runs[name].append(mesh(path, model, options.timeout, "-C", str(c),
                                       "--method", "sweep", "--threads", "2"))
    return runs


def row_of(name, model, c, runs):
    row = dict.fromkeys(COLUMNS, "") | {"molecule": name, "model": model, "C": c}
    for run in runs:
        if run.code != 0 or not run.report.get("certified"):
            return row | {"verdict": f"FAILED: {run.complaint}"}
    report = runs[0].report
    peak = statistics.median(run.report["peak_memory_bytes"] for run in runs)
    atoms, triangles = report["atoms_used"], report["triangles"]
    return row | {"atoms": atoms, "triangles": triangles, "peak_mib": peak / 2**20,
                  "of_budget": peak / budget(atoms, triangles),
                  "seconds": statistics.median(run.seconds for run in runs),
                  "cpu_seconds": statistics.median(run.cpu_seconds for run in runs),
                  "min_angle": report["min_angle_deg"], "verdict": "certified"}


def a_triangle(row, column):
    """Microseconds."""
    return float(row[column]) / int(row["triangles"]) * 1e6


def over_small(rows, row, column):
    """The time a triangle over gramicidin's with the same model and C."""
    small = next(r for r in rows if (r["molecule"], r["model"], r["C"])
                 == (SMALL, row["model"], row["C"]))
    return a_triangle(row, column) / a_triangle(small, column)


def label(name):
    entry = name.split(".")[0].split("_")[0].upper()
    return f"four of {entry}" if name.endswith("2x2x1") else entry


def table(rows):
    """4.3: memory and time of each run."""
    return markdown(
        ["molecule, model", "$C$", "atoms", "triangles", "peak memory", "of the budget",
         "µs a triangle, by the clock", "processor time", "over gramicidin's, clock",
         "processor time"],
        ([f"{label(r['molecule'])}, {r['model']}", r["C"], f"{int(r['atoms']):,}",
          f"{int(r['triangles']):,}", f"{float(r['peak_mib']):,.0f} MiB",
          f"{float(r['of_budget']):.2f}", f"{a_triangle(r, 'seconds'):.2f}",
          f"{a_triangle(r, 'cpu_seconds'):.2f}",
          *(["", ""] if r["molecule"] == SMALL else
            [f"{over_small(rows, r, column):.2f}" for column in ("seconds", "cpu_seconds")])]
         for r in rows))


def sentence(rows):
    """4.3: how far the budget is kept, and how flat time is."""
    large = [r for r in rows if r["molecule"] != SMALL]
    within = [r for r in large if float(r["of_budget"]) <= 1]
    clock, cpu = ([over_small(rows, r, column) for r in large]
                  for column in ("seconds", "cpu_seconds"))
    return (f"Of {len(large)} runs {len(within)} keep the budget. A triangle takes "
            f"{min(clock):.2f} to {max(clock):.2f} times what gramicidin's takes by the clock, "
            f"{min(cpu):.2f} to {max(cpu):.2f} times its processor time.")


def readme_sentence(rows):
    """README: the largest molecule's runs, and by how much the budget is exceeded at most."""
    large = [r for r in rows if r["molecule"] != SMALL]
    within = sum(float(r["of_budget"]) <= 1 for r in large)
    most = max(float(r["of_budget"]) for r in large)
    runs = "; ".join(
        f"{label(r['molecule'])}, {int(r['atoms']):,} atoms, model `{r['model']}`, C = {r['C']}: "
        f"{int(r['triangles']) / 1e6:.1f} million triangles, {float(r['peak_mib']) / 1024:.1f} "
        f"GiB, {float(r['seconds']):.0f} seconds" for r in large if "1f2n" in r["molecule"])
    return (f"Of {len(large)} runs on capsids {within} keep within 1.5 kB an atom and 150 bytes a "
            f"triangle; none takes more than {most:.2f} times that. In two threads, all certified: "
            f"{runs}.")


def main():
    parser = argument_parser(__doc__, timeout=1800, results="papers/results/large.tsv",
                             takes=["molecules"])
    parser.add_argument("--repetitions", type=positive, default=5,
                        help="of quick runs (%(default)s)")
    options = parser.parse_args()
    folder = molecule_folder(options.molecules)
    surfaces = [(model, c, [n for n in names if options.only in n]) for model, c, names in SURFACES]
    files = sorted({name.split()[0] for _, _, names in surfaces for name in names})
    found = dict(zip(files, named_files(folder, files)))
    with tempfile.TemporaryDirectory() as temporary, \
            Rows(options.results, COLUMNS, WIDTHS, 2) as rows:
        for model, c, names in surfaces:
            paths = {name: input_of(name, found, temporary) for name in names}
            for name, runs in runs_of(model, c, paths, options).items():
                rows.add(row_of(name, model, c, runs))
    end([r["verdict"] for r in rows.rows if r["verdict"] != "certified"], rows.rows)


if __name__ == "__main__":
    main()
