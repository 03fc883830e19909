#!/usr/bin/env python3
"""Runs the steps of a container file in chroots, in place of a container engine.

    try_containerfile.py BASE.tar FOLDER [--file packaging/Containerfile] [--context .]

BASE.tar is what every FROM of an image starts with, as mmdebstrap makes it (--variant=minbase).
Each stage gets a folder in FOLDER, which stays; what is printed is each step, how long it took, and
at the end what the program of the last stage says to --version. Needs to be root. It knows FROM,
RUN, COPY, WORKDIR and ENTRYPOINT as the file here has them, and fails on anything else. Not copied
are what git ignores, as .containerignore has it for engines.
"""

import argparse
import json
import re
import shlex
import shutil
import subprocess
import sys
import time
from pathlib import Path

# What engines mount; a namespace of its own, so that all is unmounted whatever happens.
IN_CHROOT = """
mount --make-rprivate /
mount -t proc proc "$1/proc"
mount --rbind /dev "$1/dev"
mount --rbind /sys "$1/sys"
cp /etc/resolv.conf "$1/etc/resolv.conf"
exec chroot "$1" sh -c 'cd "$1" && exec sh -c "$2"' sh "$2" "$3"
"""
ENVIRONMENT = {"PATH": "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin",
               "HOME": "/root", "DEBIAN_FRONTEND": "noninteractive"}


def instructions(text):
    """(keyword, rest) of each line; a backslash at its end joins it with the next."""
    text = re.sub(r"\\\n", " ", re.sub(r"^\s*#.*\n", "", text, flags=re.MULTILINE))
    for line in filter(None, map(str.strip, text.splitlines())):
        keyword, _, rest = line.partition(" ")
        yield keyword, rest.strip()


class Stage:
    def __init__(self, root, base):
        self.root, self.folder, self.entry = root, "/", None
        root.mkdir(parents=True)
        subprocess.run(["tar", "--extract", "--file", base, "--directory", root], check=True)

    def inside(self, path):
        path = Path("/", self.folder, path)
        return self.root / path.relative_to("/")

    def run(self, command):
        subprocess.run(["unshare", "--mount", "--pid", "--fork", "--kill-child",
                        "sh", "-eu", "-c", IN_CHROOT, "sh",
                        self.root, self.folder, command], env=ENVIRONMENT, check=True)


def copy_context(context, target):
    """The checkout with its history, without what git ignores."""
    listed = subprocess.run(["git", "-C", context, "ls-files", "-z", "--cached", "--others",
                             "--exclude-standard"], check=True, stdout=subprocess.PIPE).stdout
    for name in filter(None, listed.decode().split("\0")):
        if (context / name).is_symlink() or (context / name).is_file():
            (target / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(context / name, target / name, follow_symlinks=False)
    shutil.copytree(context / ".git", target / ".git")


def copy(stage, words, stages, context):
    source = next((stages[w.removeprefix("--from=")] for w in words if w.startswith("--from=")),
                  None)
    origin, target = [w for w in words if not w.startswith("--")]
    if source:
        shutil.copytree(source.inside(origin), stage.inside(target), symlinks=True,
                        dirs_exist_ok=True)
    elif origin == ".":
        copy_context(context, stage.inside(target))
    else:
        raise SystemExit(f"COPY {origin}: only the whole context or from a stage")


def build(text, base, folder, context):
    stages = {}
    for keyword, rest in instructions(text):
        print(f"== {keyword} {rest}", flush=True)
        start = time.monotonic()
        if keyword == "FROM":
            _, _, name = rest.partition(" AS ")
            name = name or f"stage{len(stages)}"
            stage = stages[name] = Stage(folder / name, base)
        elif keyword == "RUN":
            stage.run(rest)
        elif keyword == "COPY":
            copy(stage, shlex.split(rest), stages, context)
        elif keyword == "WORKDIR":
            stage.folder = rest
            stage.inside("").mkdir(parents=True, exist_ok=True)
        elif keyword == "ENTRYPOINT":
            stage.entry = json.loads(rest)
        else:
            raise SystemExit(f"{keyword}: not known to this script")
        print(f"== done in {time.monotonic() - start:.0f} s", flush=True)
    return stage


def main():
    arguments = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    arguments.add_argument("base", type=Path)
    arguments.add_argument("folder", type=Path)
    arguments.add_argument("--file", type=Path, default=Path("packaging/Containerfile"))
    arguments.add_argument("--context", type=Path, default=Path("."))
    given = arguments.parse_args()
    try:
        last = build(given.file.read_text("utf-8"), given.base, given.folder.resolve(),
                     given.context.resolve())
        last.run(shlex.join([*last.entry, "--version"]))
    except subprocess.CalledProcessError as error:
        sys.exit(f"failed with exit code {error.returncode}")


if __name__ == "__main__":
    main()
