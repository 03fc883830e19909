#!/usr/bin/env python3
"""Every script of bench starts and explains itself: what it imports is there, in the repository or
in Python's own library. The plots also need matplotlib, which `make reproduce` installs; where it
is not, what is missing must be matplotlib and nothing else."""

import subprocess
import sys
from pathlib import Path

BENCH = Path(__file__).resolve().parent.parent / "bench"


def complaint(script):
    """Why the script does not start; nothing if it does."""
    done = subprocess.run([sys.executable, script, "--help"], capture_output=True, text=True,
                          check=False)
    if done.returncode == 0 and "usage:" in done.stdout:
        return None
    last = (done.stderr.strip().splitlines() or [f"exit {done.returncode}, no usage"])[-1]
    if script.name == "reproduce_plots.py" and last.endswith("No module named 'matplotlib'"):
        print(f"{script.name}: matplotlib is not installed here, imports before it are")
        return None
    return last


def main():
    scripts = sorted(s for folder in (BENCH, BENCH / "solvers") for s in folder.glob("*.py")
                     if '"__main__"' in s.read_text("utf-8"))
    complaints = {s.name: c for s in scripts if (c := complaint(s))}
    for name, text in complaints.items():
        print(f"bench/{name} does not start: {text}")
    print(f"{len(scripts)} scripts, {len(complaints)} do not start")
    sys.exit(bool(complaints) or not scripts)


if __name__ == "__main__":
    main()
