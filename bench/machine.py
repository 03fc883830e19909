"""The environment of a measurement: machine, compiler, flags, load, version of the source."""

import datetime
import os
import platform
import re
import subprocess

from molecule_runs import ROOT


def output_of(*words):
    try:
        return subprocess.run(words, capture_output=True, text=True, check=False,
                              cwd=ROOT).stdout.strip()
    except OSError:
        return ""


def first_match(path, pattern):
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            found = re.search(pattern, file.read(), re.MULTILINE)
    except OSError:
        return ""
    return found[1].strip() if found else ""


def cached(name):
    """A variable of the release build's CMake cache."""
    return first_match(ROOT / "build" / "CMakeCache.txt", rf"^{name}:\w+=(.*)$")


def environment():
    """The current environment; unknown values are empty."""
    compiler, commit = cached("CMAKE_CXX_COMPILER"), output_of("git", "rev-parse", "HEAD")
    return {
        "date": datetime.datetime.now(datetime.timezone.utc).isoformat(timespec="seconds"),
        "commit": commit,
        "commit_is_exact": commit != "" and output_of("git", "status", "--porcelain",
                                                      "--untracked-files=no") == "",
        "cpu": first_match("/proc/cpuinfo", r"^model name\s*:\s*(.*)$"),
        "cores": os.cpu_count(),
        "memory": first_match("/proc/meminfo", r"^MemTotal:\s*(.*)$"),
        "kernel": platform.release(),
        "system": first_match("/etc/os-release", r'^PRETTY_NAME="(.*)"$'),
        "compiler": output_of(compiler, "--version").partition("\n")[0] if compiler else "",
        "build_type": cached("CMAKE_BUILD_TYPE"),
        "flags": " ".join([cached("CMAKE_CXX_FLAGS"), cached("CMAKE_CXX_FLAGS_RELEASE"),
                           "-std=c++20 -ffp-contract=off"]).strip(),
        "python": platform.python_version(),
        "load": list(os.getloadavg()) if hasattr(os, "getloadavg") else [],
    }
