#!/usr/bin/env python3
"""Gets the corpus's entries from the Protein Data Bank, and checks that they are those measured.

bench/entries.tsv has the file name of each entry in the corpus and two SHA-256: of the file's text
and of its coordinates alone, since the archive renews headers and names of atoms now and then. A
file with other coordinates is not kept. Files that are there and right are not fetched again, and
a transfer that was cut goes on where it ended.

The paper's first molecule, 7TMN, was not to be had for the measurements, so no hash of it is known;
its inhibitor goes into a file of its own, with the command that makes the paper's row.

    bench/fetch.py                        # all of them into build/corpus (make fetch)
    bench/fetch.py 1AKE 7TMN --into x
    make reproduce MOLECULES=build/corpus

Not fetched are copies of units, parts of entries and what no entry has: those of bench/molecules
are in the repository.
"""

import argparse
import gzip
import hashlib
import http.client
import re
import sys
import urllib.error
import urllib.request
import zlib
from pathlib import Path

from molecule_runs import ROOT, molecule_files, read_rows
from reproduce_tables import PAPER

TABLE = ROOT / "bench" / "entries.tsv"
COLUMNS = ["file", "sha256", "coordinates_sha256"]
UNKNOWN = "-"
PAPERS_OWN = "7tmn.pdb"
SECONDS = 60  # without a byte


class Failure(Exception):
    """Why an entry is not there, for the user."""


class NoNetwork(Failure):
    pass


def entry_of(name):
    return name.partition(".")[0].upper()


def coordinates(text):
    """The coordinates of all atoms of PDB or mmCIF text as they are written, a line for each."""
    if not text.startswith("data_"):
        atoms = (line for line in text.splitlines() if line.startswith(("ATOM  ", "HETATM")))
        return [" ".join([line[30:38], line[38:46], line[46:54]]) for line in atoms]
    columns = re.findall(r"^_atom_site\.(\S+)", text, re.MULTILINE)
    where = [columns.index(name) for name in ("Cartn_x", "Cartn_y", "Cartn_z") if name in columns]
    rows = (line.split() for line in text.splitlines() if line.startswith(("ATOM ", "HETATM ")))
    return [" ".join(row[i] for i in where) for row in rows
            if len(where) == 3 and len(row) > max(where)]


def hashes(data):
    """Of the text and of its coordinates; without coordinates it is no molecule."""
    lines = coordinates(data.decode("utf-8", errors="replace"))
    if not lines:
        raise Failure("has no atoms; is it an entry of the archive?")
    words = "\n".join(" ".join(line.split()) for line in lines)
    return hashlib.sha256(data).hexdigest(), hashlib.sha256(words.encode()).hexdigest()


def verdict(data, row):
    """How what came agrees with the table. Raises Failure if it does not."""
    text, atoms = hashes(data)
    if row["sha256"] == UNKNOWN:
        return f"no hash of it is known; it has SHA-256 {text}"
    if text == row["sha256"]:
        return "as measured"
    if atoms == row["coordinates_sha256"]:
        return "other text than measured, the same coordinates"
    raise Failure(f"other coordinates than measured: SHA-256 {atoms}, not "
                  f"{row['coordinates_sha256']}; not kept")


def uncompressed(data):
    try:
        return gzip.decompress(data) if data.startswith(b"\x1f\x8b") else data
    except (OSError, EOFError, zlib.error) as error:
        raise Failure(f"broken gzip: {error}; not kept") from error


def transfer(url, part):
    """Writes the file at the address; goes on with what there is of it."""
    start = part.stat().st_size if part.exists() else 0
    try:
        request = urllib.request.Request(url, headers={"Range": f"bytes={start}-"} if start else {})
        with urllib.request.urlopen(request, timeout=SECONDS) as answer:
            goes_on = answer.status == http.HTTPStatus.PARTIAL_CONTENT
            with open(part, "ab" if goes_on else "wb") as file:
                while block := answer.read1(1 << 16):
                    file.write(block)
            if answer.length:  # bytes that were announced and did not come
                raise Failure(f"cut off, {answer.length} bytes are missing; run this again")
    except urllib.error.HTTPError as error:
        if error.code != http.HTTPStatus.REQUESTED_RANGE_NOT_SATISFIABLE:  # there is no more of it
            raise Failure(f"{url}: {error.code} {error.reason}") from error
    except (ValueError, http.client.InvalidURL) as error:
        raise NoNetwork(f"{url} is no address: {error}") from error
    except urllib.error.URLError as error:
        raise NoNetwork(f"no network, or {url} is not there: {error.reason}") from error
    except (OSError, http.client.HTTPException) as error:
        raise Failure(f"cut off ({error or type(error).__name__}); run this again") from error


def fetch(row, base, folder):
    """Gets one entry unless it is there and right; returns how it agrees with the table."""
    target = folder / row["file"]
    if target.exists():
        try:
            return verdict(uncompressed(target.read_bytes()), row) + ", was there"
        except Failure:
            pass  # stays until a right one has come
    part = folder / (row["file"] + ".part")
    compressed = row["file"].removesuffix(".gz") + ".gz"
    transfer(base + entry_of(row["file"]) + compressed[compressed.index("."):], part)
    try:
        data = uncompressed(part.read_bytes())
        agreement = verdict(data, row)
    except Failure:
        part.unlink()
        raise
    if not target.name.endswith(".gz"):
        part.write_bytes(data)
    part.rename(target)
    return agreement


def write_inhibitor(entry):
    """The HETATM residues of an entry but water and ions, in a file beside it; its path."""
    residues = {}
    for line in entry.read_text(encoding="utf-8", errors="replace").splitlines():
        if line.startswith("HETATM") and line[17:20].strip() not in ("HOH", "DOD"):
            residues.setdefault(line[17:27], []).append(line)
    lines = [line for atoms in residues.values() if len(atoms) > 1 for line in atoms]
    if not lines:
        raise Failure("has no HETATM residue of more than one atom: no inhibitor")
    path = entry.with_name(entry.stem + "_ligand.pdb")
    path.write_text("\n".join([*lines, "END", ""]), encoding="utf-8")
    return path


def record(folder):
    """Writes the table from the files of a folder that are named after an entry."""
    files = {p.name: p for p in molecule_files(folder)
             if re.fullmatch(r"\d\w{3}\.(pdb|cif)(\.gz)?", p.name)}
    rows = [[name, *hashes(uncompressed(path.read_bytes()))]
            for name, path in sorted(files.items())]
    rows.append([PAPERS_OWN, UNKNOWN, UNKNOWN])
    TABLE.write_text("".join("\t".join(row) + "\n" for row in [COLUMNS, *rows]), encoding="utf-8")


def arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("entries", nargs="*", metavar="ID", help="default: all of the table")
    parser.add_argument("--into", type=Path, default=ROOT / "build" / "corpus", metavar="FOLDER",
                        help="default build/corpus")
    parser.add_argument("--from", dest="base", default="https://files.rcsb.org/download/",
                        metavar="URL", help="default %(default)s")
    parser.add_argument("--record", type=Path, metavar="FOLDER",
                        help="fetch nothing; write the table from the files of this folder")
    return parser.parse_args()


def main():
    options = arguments()
    if options.record:
        record(options.record)
        return 0
    wanted = {entry.upper() for entry in options.entries}
    rows = [r for r in read_rows(TABLE) if not wanted or entry_of(r["file"]) in wanted]
    if unknown := wanted - {entry_of(r["file"]) for r in rows}:
        sys.exit(f"{', '.join(sorted(unknown))}: not in {TABLE}")
    options.into.mkdir(parents=True, exist_ok=True)
    failures = 0
    for row in rows:
        try:
            print(f"{row['file']}: {fetch(row, options.base, options.into)}", flush=True)
            if row["file"] == PAPERS_OWN:
                ligand = write_inhibitor(options.into / PAPERS_OWN)
                name, triangles, angle, *_ = PAPER["5TMN"]
                print(f"The row {name} of Table 1, {triangles:,} triangles and {angle} degrees:\n"
                      f"    build/morskin mesh {ligand} --model paper -o {ligand.stem}.ply")
        except Failure as failure:
            print(f"{row['file']}: {failure}", file=sys.stderr, flush=True)
            failures += 1
            if isinstance(failure, NoNetwork):
                break
    return min(failures, 1)


if __name__ == "__main__":
    sys.exit(main())
