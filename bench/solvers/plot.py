#!/usr/bin/env python3
"""Draws papers/results/solvers.svg and .png: the error of the energy against vertices.

Takes matplotlib: on Debian the package python3-matplotlib, whose Python is /usr/bin/python3.
"""

import argparse
from pathlib import Path

import molecule
from measure import BENCH, is_marching_cubes, model_of
from molecule_runs import read_rows

LOOKS = {"density": "o-", "C": "s", "voids kept": "^", "marching cubes": "x:"}
COLOURS = {"vdw": "#1f4e79", "ses-like": "#b45f06", "Born": "#1f4e79", "Kirkwood": "#b45f06"}


def kind_of(options, has_voids):
    if is_marching_cubes(options):
        return "marching cubes"
    if has_voids and "--voids drop" not in options:
        return "voids kept"
    return "density" if "--density" in options else "C"


def draw(axes, points):
    """@param points  series (name and kind), vertices and error"""
    for name, kind in dict.fromkeys((p[0], p[1]) for p in points):
        xy = sorted(p[2:] for p in points if p[:2] == (name, kind))
        axes.plot(*zip(*xy), LOOKS[kind], color=COLOURS[name], markersize=5, linewidth=1,
                  label=f"{name}, {kind}")
    axes.set(xscale="log", yscale="log", xlabel="vertices")
    axes.legend(fontsize=7)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path, nargs="?",
                        default=BENCH.parent / "papers" / "results")
    folder = parser.parse_args().folder
    from reproduce_plots import plt, save  # here, for --help without matplotlib

    balls, proteins = (read_rows(folder / f"solvers-{name}.tsv") for name in ("balls", "molecule"))
    figure, (left, right) = plt.subplots(1, 2, figsize=(7.2, 3.6), sharey=True)
    draw(left, [(name, kind_of(r["options"], False), int(r["vertices"]),
                 abs(float(r[f"{name.lower()}_error"])))
                for r in balls for name in ("Born", "Kirkwood")])
    limits = {model: molecule.limit(proteins, model) for model in ("vdw", "ses-like")}
    draw(right, [(model_of(r["options"]), kind_of(r["options"], True), int(r["vertices"]),
                  abs(float(r["energy"]) / limits[model_of(r["options"])] - 1))
                 for r in proteins])
    left.set(ylabel="error of the energy", title="charges in a ball of 2 Å")
    right.set(title="1L2Y")
    save(figure, folder, "solvers")


if __name__ == "__main__":
    main()
