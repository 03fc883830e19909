#!/usr/bin/env python3
"""What angles are reached? Meshes molecules for several C and goals of --angle-goal.

One line for each C and goal: runs, triangles, how many stayed below the goal, insertions that the
last 30 degrees took, edges that break [L], and the smallest and largest angle of all. Fails where a
run is not certified or fell back; singular skins are left out. The lines also go to
papers/results/angle_goals.tsv.
"""

from pathlib import Path

from molecule_runs import Rows, argument_parser, end, mesh, molecule_folder, sized_files

COLUMNS = ["C", "goal", "runs", "triangles", "left", "inserted", "violations_L", "min_angle",
           "max_angle", "verdict"]
WIDTHS = [5, 5, 5, 10, 6, 8, 12, 9, 9, 0]


def arguments():
    parser = argument_parser(__doc__, timeout=300, results="papers/results/angle_goals.tsv",
                             largest=400)
    parser.set_defaults(models="paper,vdw", molecules=Path("bench/molecules"))
    parser.add_argument("--sizes", default="0.05,0.08,0.12,0.16,0.2,0.25,0.3,0.35,0.4",
                        help="C, default %(default)s")
    parser.add_argument("--goals", default="30,35,40", help="degrees, default %(default)s")
    return parser.parse_args()


def row(size, goal, paths, options):
    """The runs of all molecules and models with one C and one goal together."""
    reports, failures = [], []
    for path in paths:
        for model in options.models.split(","):
            run = mesh(path, model, options.timeout, "-C", size, "--angle-goal", goal)
            if run.code == 0 and not run.report["fallbacks"]:
                reports.append(run.report)
            elif not (run.code == 4 and "singular" in run.complaint):  # these are no concern here
                failures.append(f"{path.name}, {model}: {run.complaint or 'fell back'}")
    return {"C": size, "goal": goal, "runs": len(reports),
            "triangles": sum(r["triangles"] for r in reports),
            "left": sum(r["smoothing"]["left"] for r in reports),
            "inserted": sum(r["smoothing"]["inserted"] for r in reports),
            "violations_L": sum(r["violations_L"] for r in reports),
            "min_angle": min((r["min_angle_deg"] for r in reports), default="-"),
            "max_angle": max((r["max_angle_deg"] for r in reports), default="-"),
            "verdict": "FAILED: " + "; ".join(failures) if failures else
            "certified" if reports else "refused"}


def main():
    options = arguments()
    files, unreadable = sized_files(molecule_folder(options.molecules), options.only,
                                    options.largest)
    paths = [path for _, path in files]
    with Rows(options.results, COLUMNS, WIDTHS, 2) as rows:
        for size in options.sizes.split(",") if paths else []:
            for goal in options.goals.split(","):
                rows.add(row(size, goal, paths, options))
    failed = [r for r in rows.rows if r["verdict"].startswith("FAILED")]
    end(failed, rows.rows, unreadable)


if __name__ == "__main__":
    main()
