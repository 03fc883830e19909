#!/usr/bin/env python3
"""papers/course/pictures.py, which tells stale pictures, and what build.py says of them. Takes
Debian's Pillow (cmake/pages_packages.txt)."""

import subprocess
import sys
import tempfile
from pathlib import Path

from PIL import Image, ImageDraw

from support.plain_tests import run_all

ROOT = Path(__file__).resolve().parent.parent
FIGURES = ROOT / "papers" / "figures"
sys.path.insert(0, str(ROOT / "papers" / "course"))
from build import stale_pictures  # noqa: E402


def told(kept, made):
    """Whether the kept one of two pictures is called stale. Lists of frames make a GIF."""
    with tempfile.TemporaryDirectory() as folder:
        paths = []
        for name, frames in (("kept", kept), ("made", made)):
            path = Path(folder) / f"{name}.{'gif' if len(frames) > 1 else 'png'}"
            frames[0].save(path, **({"save_all": True, "append_images": frames[1:]}
                                    if len(frames) > 1 else {}))
            paths.append(path)
        out = subprocess.run([sys.executable, ROOT / "papers" / "course" / "pictures.py", *paths],
                             text=True, stdout=subprocess.PIPE, check=True).stdout
        return out.split() == [str(paths[0])]


def figure():
    return Image.open(FIGURES / "figure-2.png").convert("RGB")


def with_line(picture):
    changed = picture.copy()
    ImageDraw.Draw(changed).line([(40, 40), (560, 540)], fill=(160, 20, 20), width=3)
    return changed


def test_a_picture_is_not_stale_beside_itself():
    assert not told([figure()], [figure()])


def test_a_line_more_or_another_size_is_told():
    assert told([figure()], [with_line(figure())])
    assert told([figure()], [figure().resize((600, 600))])


def test_a_level_here_and_there_is_not():
    rounded = figure().point(lambda value: value - (value % 5 == 0 and value > 0))
    assert not told([figure()], [rounded])


def test_one_frame_of_many_is_told():
    frames = [figure().rotate(k) for k in (0, 20, 40)]
    assert not told(frames, frames)
    assert told(frames, [frames[0], with_line(frames[1]), frames[2]])
    assert told(frames, frames[:2])


def test_a_stale_picture_is_named_once_in_a_folder_with_a_blank_too():
    with tempfile.TemporaryDirectory(prefix="a b") as folder:
        kept, made = Path(folder) / "kept.png", Path(folder) / "made.png"
        figure().save(kept)
        with_line(figure()).save(made)
        (said,) = stale_pictures([(kept, made)])
        assert said.partition(": kept otherwise")[0].endswith("/kept.png"), said


if __name__ == "__main__":
    sys.exit(run_all(globals()))
