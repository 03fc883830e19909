#!/usr/bin/env python3
"""Tells which pictures are kept otherwise than their commands draw them now.

    papers/course/pictures.py KEPT MADE [KEPT MADE ...]

Prints the kept ones that look otherwise: by the bounds of tests/figures_test.cpp, since other
compilers and libraries round otherwise. Takes Pillow: on Debian the package python3-pil, whose
Python is /usr/bin/python3.
"""

import sys

from PIL import Image, ImageChops, ImageSequence, ImageStat

MEAN, LEVEL, SHARE = 1.0, 24, 0.004  # levels of 255; share of the bytes that differ by more


def looks_alike(one, other):
    """Whether two frames of one size do."""
    difference = ImageChops.difference(one.convert("RGB"), other.convert("RGB"))
    stat = ImageStat.Stat(difference)
    seen = sum(sum(difference.getchannel(band).histogram()[LEVEL + 1:]) for band in "RGB")
    return sum(stat.mean) / 3 < MEAN and seen < SHARE * 3 * one.width * one.height


def same_picture(kept, made):
    with Image.open(kept) as one, Image.open(made) as other:
        if one.size != other.size:
            return False
        ours, theirs = ([frame.copy() for frame in ImageSequence.Iterator(picture)]
                        for picture in (one, other))
        return len(ours) == len(theirs) and all(map(looks_alike, ours, theirs))


if __name__ == "__main__":
    names = sys.argv[1:]
    for kept_name, made_name in zip(names[::2], names[1::2]):
        if not same_picture(kept_name, made_name):
            print(kept_name)
