#!/usr/bin/env python3
"""Builds the pages of papers/ as a site that can be read offline, and checks all that they say.

- Sphinx makes the site, with plug-ins of our own (papers/course/plugins): names become links to
  their lines, excerpts are taken from the sources between marks (`// [excerpt: name]` ...
  `// [/excerpt]`), formulas are set, interactive parts are framed.
- Every command on a page is run, in a folder of the page's own; what it prints must be what the
  page shows. Pictures that a command makes take the place of the kept ones.
- A link that leads nowhere, a name, test or excerpt that is not there, or an output that differs
  ends the build with exit code 1.
- The site is a folder, and the same in one archive.
- The course for students is the same without the solutions; it is searched for what gives them
  away.

    make papers
    make student-course
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import time
import zipfile
from pathlib import Path

from lesson import lesson_complaints
from page import PAPERS, Page, complaints, page_files
from run_commands import check_pages
from sources import ROOT
from student import leaks_of_site

SYSTEM_PYTHON = "/usr/bin/python3"  # Debian installs Sphinx for its own
ENTRY = '<!doctype html><meta http-equiv="refresh" content="0; url=README.html">\n'


def built(out, boxes, command, tags):
    """Complaints of Sphinx, which makes the site. The interactive parts are made before it."""
    shutil.rmtree(out, ignore_errors=True)
    parts = boxes / "interactive"
    subprocess.run([sys.executable, PAPERS / "interactive" / "build.py", parts,
                    "--command", command], check=True)
    done = subprocess.run(
        [SYSTEM_PYTHON, "-m", "sphinx", "-q", "-E", "-W", "--keep-going", "-b", "html",
         "-d", boxes / "doctrees", "-c", PAPERS / "course", "-D", f"made_pictures={boxes}",
         "-D", f"interactive_parts={parts}", *(f"-t{tag}" for tag in tags), PAPERS, out],
        text=True, stderr=subprocess.PIPE, check=False,
        env={**os.environ, "PYTHONHASHSEED": "0", "PYTHONDONTWRITEBYTECODE": "1"})
    if done.returncode:
        return done.stderr.splitlines() or [f"Sphinx ended with exit code {done.returncode}"]
    (out / "index.html").write_text(ENTRY, encoding="utf-8")
    for left in (".buildinfo", "objects.inv"):
        (out / left).unlink(missing_ok=True)
    return []


def archive(folder):
    """Writes FOLDER.zip: the same bytes whenever the site is the same."""
    target = folder.with_name(f"{folder.name}.zip")
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as zipped:
        for file in sorted(path for path in folder.rglob("*") if path.is_file()):
            name = Path(folder.name) / file.relative_to(folder)
            entry = zipfile.ZipInfo(name.as_posix())  # of 1980, as every entry
            entry.external_attr = 0o644 << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            zipped.writestr(entry, file.read_bytes())
    return target


def pages_in(folder):
    return [file for file in sorted(folder.rglob("*.html")) if file.parent.name != "interactive"]


def dead_links(folder):
    """Links of the built pages that lead nowhere."""
    texts = {file: file.read_text(encoding="utf-8") for file in pages_in(folder)}
    ids = {file: set(re.findall(r'\bid="([^"]+)"', text)) for file, text in texts.items()}
    found = []
    for file, text in texts.items():
        for address in re.findall(r'\b(?:href|src)="([^"]+)"', text):
            if re.match(r"[a-z]+:", address):
                continue
            path, _, anchor = address.partition("#")
            target = (file.parent / path.partition("?")[0]).resolve() if path else file
            if not target.exists():
                found.append(f"{file.relative_to(folder)}: dead link {address}")
            elif anchor and target in ids and anchor not in ids[target]:
                found.append(f"{file.relative_to(folder)}: no such place: {address}")
    return found


def online_parts(folder):
    """Things that a built page would fetch."""
    fetched = re.compile(r'\bsrc="(https?:[^"]+)"|<link[^>]*href="(https?:[^"]+)"')
    return [f"{file.name}: fetches {match[1] or match[2]}" for file in pages_in(folder)
            for match in fetched.finditer(file.read_text(encoding="utf-8"))]


def made_pictures(boxes, pages):
    """(kept, made) of each picture that the pages' commands have made."""
    return [(PAPERS / "figures" / made.name, made) for page in pages
            for made in sorted((boxes / page.stem / "papers" / "figures").glob("*.*"))]


def stale_pictures(pictures):
    """Complaints about pictures that look otherwise than their commands draw them now."""
    files = [str(file) for kept, made in pictures if kept.exists() for file in (kept, made)]
    stale = subprocess.run([SYSTEM_PYTHON, PAPERS / "course" / "pictures.py", *files], text=True,
                           stdout=subprocess.PIPE, check=True).stdout.splitlines()
    stale += [str(kept) for kept, _ in pictures if not kept.exists()]
    return [f"{os.path.relpath(kept, ROOT)}: kept otherwise than its command draws it now; "
            "make figures" for kept in sorted(set(stale))]


def keep_pictures(pages, boxes, arguments):
    pages = [page for page in pages
             if any("papers/figures/" in command for _, command, _ in page.commands())]
    _, failures = check_pages(pages, boxes, arguments.command.resolve(), arguments.jobs)
    for kept, made in made_pictures(boxes, pages):
        if not kept.exists() or kept.read_bytes() != made.read_bytes():
            shutil.copyfile(made, kept)
            print(f"drawn anew: {os.path.relpath(kept, ROOT)}")
    for failure in failures:
        print(failure)
    return 1 if failures else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--out", type=Path, help="build/course, or build/student-course")
    parser.add_argument("--student", action="store_true", help="leave out the solutions")
    parser.add_argument("--command", type=Path, default=ROOT / "build" / "morskin")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--no-run", action="store_true", help="leave the commands alone")
    parser.add_argument("--keep-pictures", action="store_true",
                        help="run the commands of the pages with pictures, and keep what they draw")
    parser.add_argument("pages", nargs="*", type=Path,
                        help="check only these, and build no site")
    arguments = parser.parse_args()

    name = "student-course" if arguments.student else "course"
    out = (arguments.out or ROOT / "build" / name).resolve()
    boxes = out.with_name(f"{out.name}-work")
    pages = [Page(path.resolve()) for path in arguments.pages or page_files()]
    if arguments.keep_pictures:
        return keep_pictures(pages, boxes, arguments)
    failures = [c for page in pages for c in complaints(page) + lesson_complaints(page)]
    start, commands = time.monotonic(), 0
    if not arguments.no_run:
        commands, found = check_pages(pages, boxes, arguments.command.resolve(), arguments.jobs)
        failures += found
        failures += stale_pictures(made_pictures(boxes, pages))
    seconds = time.monotonic() - start
    if not failures and not arguments.pages:
        tags = ["student"] if arguments.student else []
        complaints_of_sphinx = built(out, boxes, arguments.command.resolve(), tags)
        failures += complaints_of_sphinx or dead_links(out) + online_parts(out)
        failures += leaks_of_site(out) if arguments.student else []
    for failure in failures:
        print(failure)
    print(f"{len(pages)} pages, {commands} commands run in {seconds:.0f} s, "
          f"{len(failures)} failures")
    if not failures and not arguments.pages:
        print(f"The course is in {os.path.relpath(out)}/index.html, "
              f"all of it in {os.path.relpath(archive(out))}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
