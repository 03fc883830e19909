#!/usr/bin/env python3
"""Faults while the command works: it is killed, the disk is full, others write the same file.

    faults_test.py path/to/morskin [--slow]    --slow: fifty signals of each kind, not four
"""

import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from contextlib import contextmanager
from pathlib import Path

from support.command import MOLECULES, CommandTest, main, morskin

SLOW = "--slow" in sys.argv
ROUNDS = 50 if SLOW else 4


@contextmanager
def small_disk():
    """A folder in which there is room for 64 KiB."""
    with tempfile.TemporaryDirectory() as folder:
        words = ["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", folder]
        if os.geteuid() != 0 or subprocess.run(words, stderr=subprocess.DEVNULL,
                                               check=False).returncode != 0:
            raise unittest.SkipTest("may not mount; hostile_test.py tries ulimit -f")
        try:
            yield Path(folder)
        finally:
            subprocess.run(["umount", folder], check=True)


class Faults(CommandTest):
    def setUp(self):
        super().setUp()
        self.random = random.Random(2004)
        self.old = b"an older file\n"

    def start(self, *words):
        return subprocess.Popen([morskin(), *map(str, words)], cwd=self.folder,
                                stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                stderr=subprocess.DEVNULL)

    def mesh_bytes(self, molecule, name="whole.ply"):
        """What a run leaves that nothing disturbs, and the seconds it takes."""
        start = time.monotonic()
        self.run_morskin("mesh", molecule, "-o", name, "-q")
        seconds = time.monotonic() - start
        content = (self.folder / name).read_bytes()
        (self.folder / name).unlink()
        return content, seconds

    def in_place_of_the_system(self, text):
        """The environment in which these functions in C are called in place of the system's."""
        self.input("in_place.c", """
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>
""" + text)
        words = ["cc", "-w", "-shared", "-fPIC", "-o", "in_place.so", "in_place.c", "-ldl"]
        subprocess.run(words, cwd=self.folder, check=True)
        return {**os.environ, "LD_PRELOAD": str(self.folder / "in_place.so")}

    def signals(self, number):
        """The files beside the output after each run that a signal ended at a random moment."""
        new, seconds = self.mesh_bytes(self.ring)
        output = self.input("out.ply", self.old)
        left = []
        for _ in range(ROUNDS):
            process = self.start("mesh", self.ring, "-o", "out.ply", "-q")
            time.sleep(self.random.uniform(0, 1.2 * seconds))
            process.send_signal(number)
            code = process.wait(60)
            self.assertIn(code, (0, -number))
            content = output.read_bytes()
            self.assertIn(content, (self.old, new))
            if code == 0:
                self.assertEqual(content, new)
            left += [name for name in self.names() if name != "out.ply"]
            output.write_bytes(self.old)
        return left

    def test_a_signal_at_any_moment_leaves_the_old_file_or_the_new_and_no_other(self):
        for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGXCPU,
                       signal.SIGUSR1, signal.SIGUSR2):
            with self.subTest(number):
                self.assertEqual(self.signals(number), [])

    def test_a_kill_at_any_moment_leaves_the_old_file_or_the_new(self):
        for name in self.signals(signal.SIGKILL):
            self.assertRegex(name, r"^out\.ply\.part")

    def test_a_full_disk_gives_7_and_keeps_the_older_file(self):
        self.run_morskin("mesh", self.ring, "-o", "ring.ply", "-q")
        self.input("big.xyzr", "".join(f"{i} 0 0 1\n" for i in range(9000)))
        mesh = self.folder / "ring.ply"
        with small_disk() as disk:
            for ending, words in (("ply", ("mesh", self.ring)), ("html", ("view", mesh)),
                                  ("png", ("render", mesh)),
                                  ("json", ("morse", self.ring, "--model", "paper")),
                                  ("xyzr", ("balls", "big.xyzr"))):
                with self.subTest(words[0]):
                    output = disk / f"out.{ending}"
                    output.write_bytes(self.old)
                    done = self.run_morskin(*words, "-o", output, code=7)
                    self.assertIn(b"cannot write: No space left on device", done.stderr)
                    self.assertEqual(output.read_bytes(), self.old)
                    self.assertEqual([p.name for p in disk.iterdir()], [output.name])
                    output.unlink()

    def test_closed_standard_streams_get_into_no_file(self):
        expected, _ = self.mesh_bytes(self.ring)
        for closed in ((0,), (1,), (2,), (0, 1, 2)):
            with self.subTest(closed):
                done = subprocess.run(
                    [morskin(), "mesh", "ring.xyzr", "-o", "out.ply", "--progress", "always"],
                    cwd=self.folder, timeout=120, check=False,
                    stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                    preexec_fn=lambda: [os.close(n) for n in closed])  # pylint: disable=W0640
                self.assertEqual(done.returncode, 7 if 1 in closed else 0)
                self.assertEqual((self.folder / "out.ply").read_bytes(), expected)
                self.assertEqual(self.names(), ["out.ply"])
        for words in (("info", "ring.xyzr"), ("check", "out.ply"), ("mesh", "--help")):
            done = subprocess.run([morskin(), *words], cwd=self.folder, timeout=120, check=False,
                                  stderr=subprocess.PIPE, preexec_fn=lambda: os.close(1))
            self.assertEqual(done.returncode, 7, words)
            self.assertIn(b"standard output: cannot write", done.stderr)

    def test_a_mesh_that_cannot_be_read_back_gives_5_and_leaves_no_file_but_the_older(self):
        # Whoever opens a temporary file to read finds its first hundred bytes only.
        cut = self.in_place_of_the_system("""
int open(const char* path, int flags, ...) {
  int (*next)(const char*, int, int) = (int (*)(const char*, int, int))dlsym(RTLD_NEXT, "open");
  if ((flags & O_ACCMODE) == O_RDONLY && strstr(path, ".part")) truncate(path, 100);
  return next(path, flags, 0600);
}
int open64(const char* path, int flags, ...) { return open(path, flags, 0600); }
""")
        self.input("out.ply", self.old)
        before = self.names()
        done = self.run_morskin("mesh", self.ring, "-o", "out.ply", "--json", code=5, env=cut)
        self.assertIn(b"not certified: out.ply", done.stderr)
        self.assertIn(b"see the report", done.stderr)
        report = json.loads(done.stdout)
        self.assertEqual((report["certified"], report["outputs"]), (False, []))
        self.assertEqual((self.folder / "out.ply").read_bytes(), self.old)
        self.assertEqual(self.names(), before)

    def test_a_full_disk_that_only_the_close_tells_of_gives_7_and_keeps_the_older_file(self):
        full = self.in_place_of_the_system("""
int close(int number) {
  int (*next)(int) = (int (*)(int))dlsym(RTLD_NEXT, "close");
  char link[40], path[4096] = "";
  snprintf(link, sizeof link, "/proc/self/fd/%d", number);
  readlink(link, path, sizeof path - 1);
  next(number);
  if (!strstr(path, ".ply.part")) return 0;
  errno = ENOSPC;
  return -1;
}
""")
        self.input("out.ply", self.old)
        before = self.names()
        for name in ("out.ply", "new.ply"):
            done = self.run_morskin("mesh", self.ring, "-o", name, code=7, env=full)
            self.assertIn(f"{name}: cannot write: No space left on device".encode(), done.stderr)
            self.assertEqual(self.names(), before)
        self.assertEqual((self.folder / "out.ply").read_bytes(), self.old)

    def test_permissions_that_cannot_be_kept_give_7_and_keep_the_older_file(self):
        strict = self.in_place_of_the_system(
            "int fchmod(int number, unsigned mode) { errno = EPERM; return -1; }")
        self.input("out.ply", self.old)
        before = self.names()
        done = self.run_morskin("mesh", self.ring, "-o", "out.ply", code=7, env=strict)
        self.assertIn(b"out.ply: cannot write: Operation not permitted", done.stderr)
        self.assertEqual(self.names(), before)
        self.assertEqual((self.folder / "out.ply").read_bytes(), self.old)
        self.run_morskin("mesh", self.ring, "-o", "new.ply", env=strict)  # which has none to keep

    def test_a_batch_says_that_the_system_grants_no_more_processes(self):
        alone = self.in_place_of_the_system("int fork(void) { errno = EAGAIN; return -1; }")
        done = self.run_morskin("batch", self.ring, "-o", "out", code=6, env=alone)
        self.assertIn(b"no worker could be started: Resource temporarily", done.stderr)

    def test_of_two_writers_of_one_file_one_wins(self):
        other = self.input("other.xyzr", (MOLECULES / "two_balls.xyzr").read_bytes())
        whole = [self.mesh_bytes(molecule)[0] for molecule in (self.ring, other)]
        for _ in range(ROUNDS):
            both = [self.start("mesh", molecule, "-o", "out.ply", "-q")
                    for molecule in (self.ring, other)]
            self.assertEqual([process.wait(60) for process in both], [0, 0])
            self.assertIn((self.folder / "out.ply").read_bytes(), whole)
            self.assertEqual(self.names(), ["other.xyzr", "out.ply"])

    def test_two_outputs_of_which_one_links_to_the_other_are_refused_made_or_not(self):
        for link, option in (("link.off", "-o"), ("link.json", "--report")):
            (self.folder / link).symlink_to("middle")
            (self.folder / "middle").symlink_to("a.ply")
            done = self.run_morskin("mesh", self.ring, "-o", "a.ply", option, link, code=2)
            self.assertIn(f"{link} is named twice".encode(), done.stderr)
            self.assertEqual(self.names(), sorted((link, "middle")))
            for name in self.names():
                (self.folder / name).unlink()

    def test_an_uncertified_mesh_behind_a_link_replaces_neither_the_input_nor_a_report(self):
        (self.folder / "link.ply").symlink_to("a.ply")
        words = ("-o", "link.ply", "--method", "marching-cubes")
        for _ in ("a file to be made", "one that is there"):
            done = self.run_morskin("mesh", self.ring, *words, "--report", "a.ply.unverified",
                                    code=2)
            self.assertIn(b"goes when it is not certified", done.stderr)
            self.input("a.ply.unverified", self.ring.read_bytes())
            done = self.run_morskin("mesh", "a.ply.unverified", *words, code=2)
            self.assertIn(b"a.ply.unverified would replace the input", done.stderr)
            (self.folder / "a.ply.unverified").unlink()
            self.input("a.ply", self.old)

    def test_an_input_that_changes_while_it_is_read_is_one_of_the_two_or_refused(self):
        texts = [(MOLECULES / name).read_bytes() for name in ("ring12.xyzr", "two_balls.xyzr")]
        whole = []
        for text in texts:
            whole.append(self.mesh_bytes(self.input("changing.xyzr", text))[0])
        changing = self.folder / "changing.xyzr"
        is_over = threading.Event()

        def replace():
            for i in range(10 ** 9):
                if is_over.is_set():
                    return
                spare = self.folder / "spare"
                spare.write_bytes(texts[i % 2])
                spare.rename(changing)

        def overwrite():
            for i in range(10 ** 9):
                if is_over.is_set():
                    return
                changing.write_bytes(texts[i % 2])  # empty in between, and cut short

        for change, codes in ((replace, (0,)), (overwrite, (0, 3, 4))):
            is_over.clear()
            thread = threading.Thread(target=change)
            thread.start()
            try:
                for _ in range(ROUNDS):
                    process = self.start("mesh", changing, "-o", "out.ply", "-q")
                    self.assertIn(process.wait(60), codes)
                    output = self.folder / "out.ply"
                    if change is replace:
                        self.assertIn(output.read_bytes(), whole)
                    output.unlink(missing_ok=True)
            finally:
                is_over.set()
                thread.join()

    def test_a_folder_of_molecules_that_may_not_be_read_is_named(self):
        closed = self.folder / "in/closed"
        closed.mkdir(parents=True)
        program, options = morskin(), {}
        if os.geteuid() == 0:  # who may read all
            program = shutil.copy(program, self.folder)
            self.folder.chmod(0o755)
            options = {"user": 65534, "group": 65534, "extra_groups": []}
        closed.chmod(0)
        self.addCleanup(closed.chmod, 0o755)
        (self.folder / "in/open").mkdir()
        self.input("in/open/one.xyzr", "0 0 0 1")
        complaints = [("in", b"in/closed: Permission denied"),
                      ("in/*/*.xyzr", b"in/*/*.xyzr: a folder that may fit cannot be read")]
        for word, complaint in complaints:
            done = subprocess.run([program, "batch", word, "-o", "out"], cwd=self.folder,
                                  capture_output=True, check=False, **options)
            self.assertEqual(done.returncode, 3)
            self.assertIn(b"morskin: " + complaint, done.stderr)


if __name__ == "__main__":
    sys.argv = [word for word in sys.argv if word != "--slow"]
    main()
