#!/usr/bin/env python3
"""Builds the pages of papers/ as HTML that can be read offline, and checks all that they say.

- Names become links to their lines, excerpts are taken from the sources between marks
  (`// [excerpt: name]` ... `// [/excerpt]`), formulas become MathML, pictures are embedded.
- Every command on a page is run, in a folder of the page's own; what it prints must be what the
  page shows. Pictures that a command makes take the place of the kept ones.
- A link that leads nowhere, a name, test or excerpt that is not there, or an output that differs
  ends the build with exit code 1.

    make papers
"""

import argparse
import re
import sys
import time
from pathlib import Path

from lesson import lesson_complaints
from page import PAPERS, Page, complaints, page_files
from render import Listings, rendered
from run_commands import check_pages
from sources import ROOT


def dead_links(folder):
    """Links of the built pages that lead nowhere."""
    ids, found = {}, []
    files = sorted(folder.glob("*.html"))
    for file in [*files, *sorted((folder / "src").rglob("*.html"))]:
        ids[file.resolve()] = set(re.findall(r'\bid="([^"]+)"', file.read_text(encoding="utf-8")))
    for file in files:
        text = file.read_text(encoding="utf-8")
        for address in re.findall(r'\b(?:href|src)="([^"]+)"', text):
            if address.startswith("data:"):
                continue
            if re.match(r"[a-z]+:", address):
                continue
            path, _, anchor = address.partition("#")
            target = (file.parent / path).resolve() if path else file.resolve()
            if not target.exists():
                found.append(f"{file.name}: dead link {address}")
            elif target.parent.name == "interactive":
                continue  # after # is a state, no place
            elif anchor and anchor not in ids.get(target, set()):
                found.append(f"{file.name}: no such place: {address}")
    return found


def changed_pictures(boxes):
    """Pictures made by commands that are not those kept in papers/figures."""
    return sorted({made.name for made in boxes.glob("*/papers/figures/*.*")
                   if not (PAPERS / "figures" / made.name).exists()
                   or made.read_bytes() != (PAPERS / "figures" / made.name).read_bytes()})


def online_parts(folder):
    """Things that a built page would fetch."""
    return [f"{file.name}: fetches {address}" for file in sorted(folder.glob("*.html"))
            for address in re.findall(r'\bsrc="(https?:[^"]+)"', file.read_text(encoding="utf-8"))]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, default=ROOT / "build" / "papers")
    parser.add_argument("--command", type=Path, default=ROOT / "build" / "morskin")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--no-run", action="store_true", help="leave the commands alone")
    parser.add_argument("pages", nargs="*", type=Path, help="by default all")
    arguments = parser.parse_args()

    every = [Page(path) for path in page_files()]
    stems = {page.stem for page in every}
    chosen = [Page(path.resolve()) for path in arguments.pages] or every
    failures = [c for page in chosen for c in complaints(page) + lesson_complaints(page)]
    start, commands = time.monotonic(), 0
    boxes = arguments.out / "run"
    if not arguments.no_run:
        commands, found = check_pages(chosen, boxes, arguments.command.resolve(), arguments.jobs)
        failures += found
    seconds = time.monotonic() - start
    arguments.out.mkdir(parents=True, exist_ok=True)
    listings = Listings(arguments.out / "src")
    if not failures:
        for page in chosen:
            folder = page.path.parent.relative_to(PAPERS.parent)
            resources = [boxes / page.stem / folder, PAPERS.parent / folder]
            text = rendered(page, stems, listings, resources, failures)
            (arguments.out / f"{page.stem}.html").write_text(text, encoding="utf-8")
        if not arguments.pages:
            failures += dead_links(arguments.out) + online_parts(arguments.out)
    for failure in failures:
        print(failure)
    for name in changed_pictures(boxes):
        print(f"note: papers/figures/{name} is kept otherwise than its command draws it now")
    print(f"{len(chosen)} pages, {commands} commands run in {seconds:.0f} s, "
          f"{len(listings.written)} listings, {len(failures)} failures")
    if not failures:
        print(f"The course is in {(arguments.out / 'README.html').relative_to(Path.cwd())}"
              if arguments.out.is_relative_to(Path.cwd()) else arguments.out)
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
