#!/usr/bin/env python3
"""Draws scaling.csv and angles.csv of a results folder, each as SVG and PNG.

Takes matplotlib: on Debian the package python3-matplotlib, whose Python is /usr/bin/python3.
"""

import argparse
from pathlib import Path

from reproduce_tables import PAPER, fit, read_rows

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend comes first)

COLOURS = {"sweep": "#1f4e79", "one-front-unsmoothed": "#6fa8dc", "static": "#b45f06",
           "dynamic": "#990000", "marching-cubes": "#7f7f7f"}
MARKERS = {"corpus": "o", "finer": "s"}
# The same data give the same bytes.
matplotlib.rcParams.update({"svg.hashsalt": "morskin", "font.size": 9, "axes.grid": True,
                            "grid.alpha": 0.3, "figure.constrained_layout.use": True})


def save(figure, folder, name):
    for ending, metadata in (("svg", {"Date": None}), ("png", {"Software": None})):
        figure.savefig(folder / f"{name}.{ending}", dpi=130, metadata=metadata)
    plt.close(figure)


def draw_scaling(rows, folder):
    figure, axes = plt.subplots(figsize=(7.2, 5))
    for method in [m for m in COLOURS if any(r["method"] == m for r in rows)]:
        for series, marker in MARKERS.items():
            found, points = fit(rows, "seconds", series=series, method=method)
            _, every = fit(rows, "seconds", least=0, series=series, method=method)
            if not every:
                continue
            label = f"{method}, {series}"
            if found:
                label += f": exponent {found[0]:.2f}"
                ends = [points[0][0], points[-1][0]]
                axes.plot(ends, [found[2] * n ** found[0] for n in ends], color=COLOURS[method],
                          linewidth=0.9, linestyle="-" if series == "corpus" else "--")
            axes.plot(*zip(*every), marker, color=COLOURS[method], markersize=4, label=label,
                      fillstyle="full" if series == "corpus" else "none")
    paper = sorted((n, s, d) for _, n, _, s, d in PAPER.values())
    triangles = [p[0] for p in paper]
    axes.plot(triangles, [p[1] for p in paper], "^k", markersize=5, label="paper, sweep (2004)")
    axes.plot(triangles, [p[2] for p in paper], "vk", markersize=5, label="paper, dynamic (2004)",
              fillstyle="none")
    axes.set(xscale="log", yscale="log", xlabel="triangles",
             ylabel="seconds, file to certified file (median)",
             title="Time against triangles; corpus: one molecule each, C = 0.08;\n"
                   "finer: the inhibitor of 5TMN with smaller and smaller C")
    axes.legend(fontsize=7)
    save(figure, folder, "scaling")


def draw_angles(rows, folder):
    molecules = list(dict.fromkeys(r["molecule"] for r in rows))
    figure, panels = plt.subplots(len(molecules), 1, figsize=(7.2, 2.3 * len(molecules)),
                                  sharex=True, squeeze=False)
    for axes, molecule in zip(panels[:, 0], molecules):
        for method, colour in COLOURS.items():
            counts = [int(r["count"]) for r in rows
                      if r["molecule"] == molecule and r["method"] == method]
            if counts:
                shares = [100 * c / sum(counts) for c in counts]
                axes.step(range(180), shares, where="post", color=colour, linewidth=1, label=method)
        axes.set(ylabel="% of angles a degree", title=molecule, xlim=(0, 180))
        axes.axvline(21.55, color="black", linewidth=0.8, linestyle=":")
    panels[0, 0].legend(fontsize=7)
    panels[-1, 0].set(xlabel="angle, degrees (dotted: the bound, 21.55)")
    save(figure, folder, "angles")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path, help="the results folder")
    folder = parser.parse_args().folder
    scaling, angles = read_rows(folder / "scaling.csv"), read_rows(folder / "angles.csv")
    if scaling:
        draw_scaling(scaling, folder)
    if angles:
        draw_angles(angles, folder)


if __name__ == "__main__":
    main()
