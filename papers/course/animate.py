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


def drawn(meshes, options, *words):
    """The meshes under one camera, as the command draws them, one below the other."""
    with tempfile.TemporaryDirectory() as folder:
        picture = Path(folder) / "picture.png"
        subprocess.run([options.command, "render", *meshes, "-o", picture, "--view", options.view,
                        "--size", options.size, "--columns", "1", *words], check=True,
                       stdout=subprocess.DEVNULL)
        return Image.open(picture).convert("RGB")


def frames(states, mesh, options):
    last = drawn([mesh], options, "--by", "angle")
    # The mesh is drawn with the states as well, since all share what the camera frames.
    strip = drawn([*states, mesh], options, "--edges", "never")
    stride = (strip.height - last.height) // len(states)
    return [strip.crop((0, k * stride, last.width, k * stride + last.height))
            for k in range(len(states))] + [last]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("snapshots", type=Path, help="folder with snapshot-1.ply and so on")
    parser.add_argument("mesh", type=Path, help="the finished mesh")
    parser.add_argument("-o", "--output", type=Path, required=True)
    parser.add_argument("--view", default="0.2,0.5,1")
    parser.add_argument("--size", default="320", help="of a frame, W or WxH")
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
