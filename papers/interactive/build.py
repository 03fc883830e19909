#!/usr/bin/env python3
"""Bundles the interactive parts of the course, each into one HTML file that needs nothing else.

    papers/interactive/build.py FOLDER [NAME ...]

A part is NAME.js here, with what it imports; parts with recorded data have it made by the program
(record.py). Takes esbuild, which Debian has.
"""

import argparse
import json
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
TITLES = {
    "skin2d": "The skin of discs",
    "sizes": "C, Q and the tangent disk",
}


def bundled(name):
    """The part's script as one text. A script inside a page ends at what looks like its end."""
    done = subprocess.run(["esbuild", HERE / f"{name}.js", "--bundle", "--minify", "--format=iife",
                           "--target=es2021", "--charset=utf8"],
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"papers/interactive/{name}.js: {done.stderr}")
    return done.stdout.replace("</script", "<\\/script").strip()


def data_of(name, command):
    """What a part shows of the real program, made by it."""
    return {}


def page(name, data):
    text = (HERE / "page.html").read_text(encoding="utf-8")
    style = (HERE / "style.css").read_text(encoding="utf-8").strip()
    as_json = json.dumps(data, separators=(",", ":")).replace("</", "<\\/")
    for mark, value in (("@TITLE@", TITLES[name]), ("@STYLE@", style), ("@DATA@", as_json),
                        ("@SCRIPT@", bundled(name))):
        text = text.replace(mark, value, 1)
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("names", nargs="*", help="by default all")
    parser.add_argument("--command", type=Path, default=ROOT / "build" / "morskin")
    parser.add_argument("--list", action="store_true", help="print the parts' names as JSON")
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    for name in arguments.names or TITLES:
        (arguments.folder / f"{name}.html").write_text(
            page(name, data_of(name, arguments.command)), encoding="utf-8")
    if arguments.list:
        print(json.dumps(list(TITLES)))


if __name__ == "__main__":
    main()
