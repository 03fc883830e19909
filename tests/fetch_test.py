#!/usr/bin/env python3
"""bench/fetch.py keeps entries that agree with bench/entries.tsv and nothing else, against a server
on this machine that lies, cuts transfers and is not there."""

import gzip
import os
import subprocess
import sys
import threading
import unittest
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

from support.programs import temporary_folder

ROOT = Path(__file__).resolve().parent.parent
MOLECULES = ROOT / "bench" / "molecules"
CRAMBIN = (MOLECULES / "1crn.pdb").read_bytes()
INHIBITOR = (MOLECULES / "5tmn_ligand.pdb").read_bytes()


class Archive(BaseHTTPRequestHandler):
    """Answers with what the server's `files` has; if `cut` is set, with so many bytes of it."""

    def do_GET(self):
        self.server.asked.append((self.path, self.headers["Range"]))
        data = self.server.files.get(self.path)
        if data is None:
            self.send_error(404)
            return
        start = int((self.headers["Range"] or "bytes=0-")[len("bytes="):-1])
        if start >= len(data):
            self.send_error(416)
            return
        self.send_response(206 if self.headers["Range"] else 200)
        self.send_header("Content-Length", str(len(data) - start))
        self.end_headers()
        self.wfile.write(data[start:][:self.server.cut])

    def log_message(self, *_):
        pass


class Fetch(unittest.TestCase):
    def setUp(self):
        self.server = ThreadingHTTPServer(("127.0.0.1", 0), Archive)
        self.server.asked, self.server.cut = [], None
        self.server.files = {"/1CRN.pdb.gz": gzip.compress(CRAMBIN)}
        threading.Thread(target=self.server.serve_forever, daemon=True).start()
        self.url = f"http://127.0.0.1:{self.server.server_port}/"
        self.into = temporary_folder(self)

    def tearDown(self):
        self.server.shutdown()
        self.server.server_close()

    def fetch(self, *words):
        done = subprocess.run([sys.executable, ROOT / "bench" / "fetch.py", "--into", self.into,
                               "--from", self.url, *words], capture_output=True, text=True,
                              check=False, env={**os.environ, "no_proxy": "*"})
        self.assertNotIn("Traceback", done.stderr)
        return done

    def there(self):
        return sorted(p.name for p in self.into.iterdir())

    def test_an_entry_that_agrees_is_kept_and_not_fetched_again(self):
        done = self.fetch("1crn")
        self.assertIn("1crn.pdb: as measured\n", done.stdout)
        self.assertIn("404", done.stderr)  # of the mmCIF file, after which the PDB file came
        self.assertEqual(done.returncode, 1)
        self.assertEqual((self.into / "1crn.pdb").read_bytes(), CRAMBIN)
        asked = len(self.server.asked)
        self.assertIn("as measured, was there", self.fetch("1crn").stdout)
        self.assertNotIn("/1CRN.pdb.gz", [path for path, _ in self.server.asked[asked:]])

    def test_a_file_that_is_there_and_wrong_gives_way_to_the_right_one_only(self):
        target, wrong = self.into / "1crn.pdb", CRAMBIN.replace(b" 17.047", b" 17.048")
        target.write_bytes(wrong)
        self.server.files["/1CRN.pdb.gz"] = gzip.compress(wrong)
        self.assertIn("other coordinates than measured", self.fetch("1CRN").stderr)
        self.assertEqual(target.read_bytes(), wrong)
        self.server.files["/1CRN.pdb.gz"] = gzip.compress(CRAMBIN)
        self.assertIn("1crn.pdb: as measured\n", self.fetch("1CRN").stdout)
        self.assertEqual(target.read_bytes(), CRAMBIN)
        self.assertEqual(self.there(), ["1crn.pdb"])

    def test_other_coordinates_are_not_kept_and_another_header_is(self):
        self.server.files["/1CRN.pdb.gz"] = gzip.compress(CRAMBIN.replace(b" 17.047", b" 17.048"))
        done = self.fetch("1CRN")
        self.assertIn("1crn.pdb: other coordinates than measured", done.stderr)
        self.assertEqual((done.returncode, self.there()), (1, []))
        self.server.files["/1CRN.pdb.gz"] = gzip.compress(b"REMARK 999 renewed\n" + CRAMBIN)
        self.assertIn("other text than measured, the same", self.fetch("1CRN").stdout)
        self.assertEqual(self.there(), ["1crn.pdb"])

    def test_a_page_in_place_of_an_entry_is_not_kept(self):
        self.server.files["/1CRN.pdb.gz"] = b"<html>sign in</html>"
        self.assertIn("has no atoms", self.fetch("1CRN").stderr)
        self.assertEqual(self.there(), [])

    def test_an_mmcif_file_without_atoms_is_not_kept(self):
        heads = "".join(f"_atom_site.Cartn_{axis}\n" for axis in "xyz")
        for text in ("data_1CRN\n#\n", f"data_1CRN\nloop_\n{heads}#\n",
                     f"data_1CRN\nloop_\n_atom_site.group_PDB\n{heads}ATOM 1.0 2.0\n"):
            self.server.files["/1CRN.cif.gz"] = gzip.compress(text.encode())
            self.assertIn("1crn.cif: has no atoms", self.fetch("1CRN").stderr)
            self.assertEqual(self.there(), ["1crn.pdb"])

    def test_a_broken_gzip_is_not_kept_and_the_next_entry_is_fetched(self):
        whole = gzip.compress(CRAMBIN)
        for broken in (whole[:10] + b"\xff" * 90, whole[:-8] + b"\0" * 8, whole[:5000]):
            self.server.files["/1CRN.pdb.gz"] = self.server.files["/1AKE.pdb.gz"] = broken
            done = self.fetch("1CRN", "1AKE")
            self.assertEqual((done.stderr.count("broken gzip"), self.there()), (2, []))

    def test_a_transfer_that_was_cut_goes_on_where_it_ended(self):
        self.server.cut = 5000
        done = self.fetch("1CRN")
        self.assertIn("cut off", done.stderr)
        self.assertEqual((done.returncode, self.there()), (1, ["1crn.pdb.part"]))
        self.server.cut = None
        self.assertIn("1crn.pdb: as measured\n", self.fetch("1CRN").stdout)
        self.assertIn(("/1CRN.pdb.gz", "bytes=5000-"), self.server.asked)
        self.assertEqual(self.there(), ["1crn.pdb"])

    def test_a_transfer_that_was_cut_before_its_name_was_given_ends_well(self):
        (self.into / "1crn.pdb.part").write_bytes(self.server.files["/1CRN.pdb.gz"])
        self.assertIn("1crn.pdb: as measured\n", self.fetch("1CRN").stdout)

    def test_without_a_network_one_line_says_so(self):
        self.url = "http://127.0.0.1:9/"  # the port where nothing listens
        done = self.fetch()
        self.assertEqual((done.returncode, len(done.stderr.splitlines()), self.there()), (1, 1, []))
        self.assertIn("no network", done.stderr)

    def test_what_is_no_address_is_named_once(self):
        for self.url in ("nowhere/", "http://127.0.0.1:port/"):
            done = self.fetch()
            self.assertEqual((done.returncode, len(done.stderr.splitlines())), (1, 1), done.stderr)
            self.assertIn(f"{self.url}1AF6.pdb.gz is no address", done.stderr)

    def test_the_papers_own_molecule_comes_with_its_inhibitor_and_its_row(self):
        place = "       1.000   2.000   3.000  1.00 10.00"
        others = "".join(f"{head}{place}\n" for head in (
            "ATOM      1  N   ILE E   1", "HETATM  900  O   HOH E 401",
            "HETATM  901 ZN    ZN E 322")).encode()
        self.server.files["/7TMN.pdb.gz"] = gzip.compress(others + INHIBITOR)
        done = self.fetch("7TMN")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("no hash of it is known", done.stdout)
        self.assertIn("24,336 triangles and 27.02 degrees", done.stdout)

        def atoms(data):
            return [line for line in data.splitlines() if line.startswith(b"HETATM")]
        self.assertEqual(atoms((self.into / "7tmn_ligand.pdb").read_bytes()), atoms(INHIBITOR))

    def test_an_entry_that_the_corpus_has_not_is_refused(self):
        self.assertIn("9XYZ: not in", self.fetch("9XYZ").stderr)


if __name__ == "__main__":
    unittest.main()
