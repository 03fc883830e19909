"""Runs the commands of pages and compares what they print with what the page shows."""

import os
import re
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor

from page import LESSONS, PAPERS, RUNNABLE
from sources import ROOT

TIMEOUT = 1800  # seconds for one command: a busy machine is slow, and that is no failure


def sandbox_for(page, folder, binary):
    """A folder that looks like the project's root, in which a page's commands may write."""
    folder = folder / page.stem
    shutil.rmtree(folder, ignore_errors=True)
    for name in ("figures", "lessons"):
        (folder / "papers" / name).mkdir(parents=True)
    (folder / "papers" / "course").symlink_to(PAPERS / "course")
    for file in LESSONS.glob("*.py"):
        (folder / "papers" / "lessons" / file.name).symlink_to(file)
    (folder / "build" / "papers").mkdir(parents=True)
    (folder / "build" / "morskin").symlink_to(binary)
    (folder / "build" / "papers" / "steps").symlink_to(binary.parent / "papers" / "steps")
    (folder / "build" / "python").symlink_to(binary.parent / "python")
    for name in ("bench", "tests", "app", "examples", "front", "refine", "morse", "skin",
                 "geometry", "certify"):
        (folder / name).symlink_to(ROOT / name)
    return folder


def matches(shown, printed):
    """Whether printed lines are the shown ones. `...` alone stands for any lines, in a line for
    any text."""
    if not shown:
        return not printed
    if shown[0].strip() == "...":
        return any(matches(shown[1:], printed[k:]) for k in range(len(printed) + 1))
    pattern = ".*".join(re.escape(part) for part in shown[0].rstrip().split("..."))
    return bool(printed) and re.fullmatch(pattern, printed[0].rstrip()) is not None \
        and matches(shown[1:], printed[1:])


def trimmed(lines):
    lines = [line.rstrip() for line in lines]
    while lines and not lines[-1]:
        lines.pop()
    return lines


def run(command, folder):
    """What a command prints, as lines; a last line `[exit N]` where it fails."""
    environment = {**os.environ, "LC_ALL": "C.UTF-8", "COLUMNS": "100"}
    try:
        done = subprocess.run(["bash", "-o", "pipefail", "-c", command], cwd=folder,
                              env=environment, text=True, timeout=TIMEOUT,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT)
    except subprocess.TimeoutExpired:
        return [f"[no end within {TIMEOUT} s]"]
    lines = trimmed(done.stdout.splitlines())
    return lines + [f"[exit {done.returncode}]"] if done.returncode else lines


def check_page(page, folder, binary):
    """(number of commands run, failures) of a page."""
    box = sandbox_for(page, folder, binary)
    count, failures = 0, []
    for number, command, shown in page.commands():
        if not command.startswith(RUNNABLE):
            continue
        printed = run(command, box)
        count += 1
        where = f"{page.path.relative_to(ROOT)}:{number}: {command}"
        if shown is None:
            if printed and printed[-1].startswith("["):
                failures.append("\n".join([where, *printed]))
        elif not matches(trimmed(shown), printed):
            failures.append("\n".join([f"{where}\n-- the page shows", *shown, "-- it prints",
                                       *printed]))
    return count, failures


def check_pages(pages, folder, binary, jobs=2):
    with ThreadPoolExecutor(jobs) as pool:
        results = list(pool.map(lambda page: check_page(page, folder, binary), pages))
    return sum(count for count, _ in results), [f for _, found in results for f in found]
