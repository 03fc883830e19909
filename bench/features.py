#!/usr/bin/env python3
"""How near to two vertices per square Angstrom `features` comes, and how long it takes on one core.

One line for each molecule, also in papers/results/features.tsv: atoms, vertices, vertices per
square Angstrom, the least processor and wall seconds of several runs of the whole command, and the
shares of the stages in a run with a report. A run is good when it is certified.
"""

import json
import resource
import subprocess
import tempfile
import time
from pathlib import Path

from molecule_runs import (MORSKIN, STAGES, Rows, argument_parser, end, markdown,
                           molecule_folder, named_files, run_program)

MOLECULES = ["atp.pdb", "amprenavir.pdb", "heme.pdb", "1grm_model1.pdb", "9dna_duplex.pdb",
             "1l2y.cif", "1crn.pdb", "1bna.pdb", "1ubq.pdb", "1rna.cif", "1ejg.pdb", "2koc.pdb",
             "5pti.pdb", "1stp.cif", "1aki.pdb", "1hpv.pdb", "2buk.pdb", "1brs.pdb", "1ehz.pdb",
             "1j4n.pdb", "1a63.pqr", "2por.pdb", "1atp.pdb", "1ake.pdb"]
GOAL = 2  # vertices per square Angstrom
REPEATS = 3
COLUMNS = ["molecule", "atoms", "vertices", "density", "cpu_seconds", "seconds", *STAGES,
           "verdict"]
WIDTHS = [12, 6, 8, 8, 11, 8, 8, 6, 6, 8, 8, 6, 10]


def arguments():
    parser = argument_parser(__doc__, timeout=600, results="papers/results/features.tsv",
                             takes=["molecules"])
    return parser.parse_args()


def timed(path, output, timeout):
    """Processor and wall seconds of one run, which prints and tells nothing."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    run_program([MORSKIN, "features", path, "-o", output, "-q", "--threads", "1"],
                timeout=timeout).check_returncode()
    wall, after = time.monotonic() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, wall


def reported(path, output, timeout):
    report = output.with_name("r.json")
    run_program([MORSKIN, "features", path, "-o", output, "-q", "--threads", "1", "--report",
                 report], timeout=timeout).check_returncode()
    return json.loads(report.read_text(encoding="utf-8"))


def row_of(path, timeout):
    failed = dict.fromkeys(COLUMNS, "") | {"molecule": path.name}
    try:
        with tempfile.TemporaryDirectory() as folder:
            output = Path(folder) / "x.npz"
            best = [min(times) for times in zip(*(timed(path, output, timeout)
                                                  for _ in range(REPEATS)))]
            report = reported(path, output, timeout)
    except subprocess.CalledProcessError as error:
        return failed | {"verdict": f"FAILED: exit code {error.returncode}"}
    except subprocess.TimeoutExpired:
        return failed | {"verdict": f"FAILED: still running after {timeout:g} s"}
    seconds = report["seconds"]
    stages = {name: sum(seconds[s] for s in parts) for name, parts in STAGES.items()}
    whole = sum(stages.values())
    return {"molecule": path.name, "atoms": report["atoms_used"], "vertices": report["vertices"],
            "density": report["quality"]["vertices_per_square_angstrom"],
            "cpu_seconds": best[0], "seconds": best[1],
            **{name: part / whole for name, part in stages.items()},
            "verdict": "certified"}


def table(rows):
    return markdown(
        ["molecule", "atoms", "vertices", "per Å²", "processor seconds", *STAGES],
        ([r["molecule"], f"{int(r['atoms']):,}", f"{int(r['vertices']):,}",
          f"{float(r['density']):.2f}", f"{float(r['cpu_seconds']):.2f}",
          *(f"{100 * float(r[stage]):.0f} %" for stage in STAGES)] for r in rows))


def sentence(rows):
    """What the page says of all."""
    densities, atoms = ([float(r[k]) for r in rows] for k in ("density", "atoms"))
    kinase = next(r for r in rows if r["molecule"] == "1atp.pdb")
    return (f"on {len(rows)} molecules of {min(atoms):,.0f} to {max(atoms):,.0f} atoms, "
            f"{min(densities):.2f} to {max(densities):.2f} were made where {GOAL} were asked for. "
            f"1ATP, {int(kinase['atoms']):,} atoms, takes {float(kinase['cpu_seconds']):.2f} s of "
            "one core")


def main():
    options = arguments()
    folder = molecule_folder(options.molecules)
    paths = named_files(folder, [name for name in MOLECULES if options.only in name])
    with Rows(Path(options.results), COLUMNS, WIDTHS, 1) as rows:
        for path in paths:
            rows.add(row_of(path, options.timeout))
    as_text = [{k: str(v) for k, v in r.items()} for r in rows.rows
               if r["verdict"] == "certified"]
    print(table(as_text))
    if len(as_text) == len(MOLECULES):
        print(sentence(as_text))
    end([r["verdict"] for r in rows.rows if r["verdict"] != "certified"], rows.rows)


if __name__ == "__main__":
    main()
