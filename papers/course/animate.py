#!/usr/bin/env python3
"""Draws the snapshots of a sweep, and the finished mesh by its angles, as one moving picture.

    build/morskin mesh INPUT -o mesh.ply --snapshots N --snapshot-dir FOLDER
    papers/course/animate.py FOLDER mesh.ply -o sweep.gif

Takes Pillow: on Debian the package python3-pil, whose Python is /usr/bin/python3.
"""

import argparse
import subprocess
import tempfile
from pathlib import Path

from PIL import Image

FRAME_MS, LAST_MS = 250, 2500
COLOURS = 128  # of the picture's palette
GAP = 16  # between the panels of a sheet, pixels; the legend stands below the last


def drawn(meshes, options, *words):
    """The meshes under one camera, as the command draws them, one below the other."""
    with tempfile.TemporaryDirectory() as folder:
        picture = Path(folder) / "picture.png"
        subprocess.run([options.command, "render", *meshes, "-o", picture, "--view", options.view,
                        "--size", "x".join(map(str, options.size)), "--columns", "1", *words],
                       check=True,
                       stdout=subprocess.DEVNULL)
        return Image.open(picture).convert("RGB")


def frames(states, mesh, options):
    """One for each state, then the mesh by its angles; all with their legends, of one size."""
    last = drawn([mesh], options, "--by", "angle")
    # The mesh is drawn with the states as well, since all share what the camera frames.
    sheet = drawn([*states, mesh], options, "--edges", "never")
    width, height = options.size
    panels_end = (len(states) + 1) * (height + GAP) - GAP
    size = (width, max(last.height, height + sheet.height - panels_end))

    def frame(panel, legend):
        picture = Image.new("RGB", size, "white")
        picture.paste(panel, (0, 0))
        picture.paste(legend, (0, height))
        return picture

    legend = sheet.crop((0, panels_end, width, sheet.height))
    tops = [k * (height + GAP) for k in range(len(states))]
    return [frame(sheet.crop((0, top, width, top + height)), legend) for top in tops] \
        + [frame(last, last.crop((0, height, width, last.height)))]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("snapshots", type=Path, help="folder with snapshot-1.ply and so on")
    parser.add_argument("mesh", type=Path, help="the finished mesh")
    parser.add_argument("-o", "--output", type=Path, required=True)
    parser.add_argument("--view", default="0.2,0.5,1")
    parser.add_argument("--size", type=int, nargs=2, default=(320, 320),
                        metavar=("WIDTH", "HEIGHT"), help="of a frame, pixels, less its legend")
    parser.add_argument("--command", type=Path, default=Path("build/morskin"))
    options = parser.parse_args()

    states = sorted(options.snapshots.glob("snapshot-*.ply"),
                    key=lambda path: int(path.stem.rpartition("-")[2]))
    if not states:
        parser.error(f"{options.snapshots} has no snapshots")
    pictures = frames(states, options.mesh, options)
    # One palette for all frames, so that nothing flickers.
    middle, last = pictures[len(pictures) // 2], pictures[-1]
    both = Image.new("RGB", (2 * last.width, last.height))
    both.paste(middle, (0, 0))
    both.paste(last, (last.width, 0))
    palette = both.quantize(COLOURS)
    first, *others = [p.quantize(palette=palette, dither=Image.Dither.NONE) for p in pictures]
    first.save(options.output, save_all=True, append_images=others, loop=0,
               duration=[FRAME_MS] * len(states) + [LAST_MS])


if __name__ == "__main__":
    main()
