#!/usr/bin/env python3
"""Ctrl-C, threads, forks and memory. Usage: runs_test.py folder-of-the-package"""

from support import BALLS, COARSE, MOLECULES, ModuleTest, main

import multiprocessing
import os
import signal
import threading
import time
from pathlib import Path
from unittest import mock

import morskin
import numpy as np

LONG = {"C": 0.01, "threads": 1}  # takes seconds


def area_of(radius):
    """In a worker of a pool."""
    return morskin.Skin([[0, 0, 0]], [radius]).mesh(**COARSE).certificate.area


class Interruption(ModuleTest):
    def setUp(self):
        super().setUp()
        self.skin = morskin.read(MOLECULES / "1crn.pdb").skin()

    def test_ctrl_c_ends_a_run_soon_and_the_next_run_is_whole(self):
        said = self.python("""
import os, signal, sys, threading, time
import morskin
skin = morskin.read(sys.argv[1]).skin()
threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
start = time.monotonic()
try:
    skin.mesh(C=0.01, threads=2)
except KeyboardInterrupt:
    print("stopped", time.monotonic() - start < 10)
print(skin.mesh(C=0.3).certificate.certified)
""", str(MOLECULES / "1crn.pdb"))
        self.assertEqual(said, "stopped True\nTrue\n")

    def test_what_the_progress_function_raises_ends_the_run_and_comes_out(self):
        class Enough(Exception):
            pass
        stages = []

        def progress(stage, share):
            stages.append(stage)
            self.assertTrue(share is None or 0 <= share <= 1)
            if len(stages) == 20:
                raise Enough
        start = time.monotonic()
        with self.assertRaises(Enough):
            self.skin.mesh(progress=progress, **LONG)
        self.assertLess(time.monotonic() - start, 10)
        self.assertEqual(len(stages), 20)

    def test_what_ends_a_run_comes_out_even_where_the_run_had_failed_by_itself(self):
        class Enough(Exception):
            pass

        def reports(call, last):
            """How many are made when the last of them raises; `call` fails without that."""
            count = 0

            def progress(*_):
                nonlocal count
                count += 1
                if count == last:
                    raise Enough
            with self.assertRaises(Enough if last else morskin.Error):
                call(progress)
            return count
        for call in (lambda progress: morskin.Skin([[0, 0, 0], [2, 2, 0]], [1, 1], threads=1,
                                                   progress=progress),  # touches itself
                     lambda progress: morskin.Skin(*BALLS).mesh(
                         C=0.9, Q=1.9, angle_goal_deg=0, threads=1, progress=progress)):
            all_reports = reports(call, None)
            self.assertGreater(all_reports, 1)
            for last in range(1, all_reports + 1):
                with self.subTest(last=last, of=all_reports):
                    self.assertEqual(reports(call, last), last)

    def test_a_check_may_be_ended_between_its_steps(self):
        mesh, reports = self.skin.mesh(**COARSE), []

        def progress(stage, share):
            reports.append(stage)
            if len(reports) == 3:
                raise TimeoutError
        with self.assertRaises(TimeoutError):
            morskin.check(mesh.vertices, mesh.faces, self.skin, C=0.3, progress=progress)
        self.assertEqual(reports, ["certify"] * 3)

    def test_what_the_handler_of_any_signal_raises_ends_the_run(self):
        def enough(*_):
            raise TimeoutError
        old = signal.signal(signal.SIGALRM, enough)
        self.addCleanup(signal.signal, signal.SIGALRM, old)
        signal.setitimer(signal.ITIMER_REAL, 0.2)
        with self.assertRaises(TimeoutError):
            self.skin.mesh(**LONG)

    def test_the_progress_function_may_mesh_too(self):
        mesh = morskin.Skin(*BALLS).mesh(
            progress=lambda *_: morskin.Skin(*BALLS).mesh(**COARSE), **COARSE)
        self.assertTrue(mesh.certificate.certified)

    def test_progress_tells_the_stages(self):
        stages = set()
        morskin.Skin(*BALLS, progress=lambda stage, share: stages.add(stage)).mesh(
            C=0.2, threads=2, progress=lambda stage, share: stages.add(stage))
        self.assertLessEqual({"triangulate", "sweep", "certify"}, stages)

    def test_a_molecule_s_skin_is_prepared_on_as_many_threads_and_tells_its_stages_too(self):
        molecule, stages = morskin.Molecule(*map(np.array, BALLS)), set()
        with mock.patch("morskin.molecule.Skin", wraps=morskin.Skin) as skin:
            molecule.mesh(C=0.3, threads=1, progress=lambda stage, share: stages.add(stage))
        self.assertEqual(skin.call_args.kwargs["threads"], 1)
        self.assertLessEqual({"dual complex", "certify"}, stages)

    def test_the_lock_is_released_while_a_run_is_on(self):
        ticks, is_over = [], threading.Event()

        def tick():
            while not is_over.wait(0.005):
                ticks.append(time.monotonic())
        other = threading.Thread(target=tick)
        other.start()
        start = time.monotonic()
        self.skin.mesh(C=0.05, threads=1)
        end = time.monotonic()
        is_over.set()
        other.join()
        self.assertGreater(end - start, 0.2)
        self.assertGreater(len([t for t in ticks if start < t < end]), (end - start) / 0.05)

    def test_threads_of_python_share_a_skin_and_a_mesh(self):
        meshes, points = [], []

        def work():
            meshes.append(self.skin.mesh(C=0.3, threads=1))
            points.append(meshes[0].normals.copy())
        threads = [threading.Thread(target=work) for _ in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for mesh in meshes:
            np.testing.assert_array_equal(mesh.vertices, meshes[0].vertices)
        for found in points:
            np.testing.assert_array_equal(found, points[0])


def atoms_of(molecule):
    """In a worker of a pool."""
    return len(molecule.skin("sas").critical_points()) and len(molecule)


class Exit(ModuleTest):
    BUSY = """
import os, sys, threading, time
import morskin
skin = morskin.read(sys.argv[1]).skin()
threading.Thread(target=lambda: skin.mesh(C=0.01), daemon=True).start()
time.sleep(0.3)
"""

    def test_python_ends_while_a_daemon_makes_a_mesh(self):
        crambin = str(MOLECULES / "1crn.pdb")
        self.assertEqual(self.python(self.BUSY + "print('over')", crambin, timeout=30), "over\n")

    # Each is called again and again, whatever it raises: a worker's loop.
    CALLS = ("skin.mesh(C=0.3)", "morskin.read(sys.argv[1])", "skin.critical_points()",
             "skin.mesh(C=0.3).normals", "skin.mesh(C=0.3).save(sys.argv[2])",
             "morskin.read_mesh(sys.argv[3])")
    LOOP = """
import sys, threading, time
import morskin
skin = morskin.Skin([[0, 0, 0], [1.5, 0, 0]], [1.2, 1.0])
skin.mesh(C=0.3).save(sys.argv[3])
def work():
    while True:
        try:
            {}
        except BaseException:
            pass
threading.Thread(target=work, daemon=True).start()
time.sleep(0.2)
print("over")
"""

    def test_python_ends_while_a_daemon_loops_over_any_call(self):
        for call in self.CALLS:
            with self.subTest(call):
                said = self.python(self.LOOP.format(call), str(MOLECULES / "1crn.pdb"),
                                   str(self.folder / "a.ply"), str(self.folder / "b.ply"),
                                   timeout=30)
                self.assertEqual(said, "over\n")

    def test_python_ends_while_a_daemon_reads_a_pipe_that_nobody_writes_to(self):
        os.mkfifo(self.folder / "pipe")
        self.assertEqual(self.python("""
import sys, threading, time
import morskin
threading.Thread(target=morskin.read, args=[sys.argv[1]], daemon=True).start()
time.sleep(0.2)
print("over")
""", str(self.folder / "pipe"), timeout=30), "over\n")

    def test_a_function_of_the_end_may_mesh(self):
        self.assertEqual(self.python("""
import atexit
import morskin
def last():
    print(morskin.Skin([[0, 0, 0]], [1]).mesh(C=0.3).certificate.certified)
atexit.register(last)
""", timeout=30), "True\n")

    def test_a_fork_of_a_busy_python_ends_too(self):
        said = self.python(self.BUSY + """
if os.fork():
    print(os.wait()[1])
else:
    morskin.Skin([[0, 0, 0]], [1]).mesh(C=0.3)
    sys.exit()
""", str(MOLECULES / "1crn.pdb"), timeout=30)
        self.assertEqual(said, "0\n")


class Forks(ModuleTest):
    def test_a_molecule_goes_to_the_workers_of_a_pool(self):
        molecule = morskin.read(MOLECULES / "benzene.pdb")
        with multiprocessing.get_context("fork").Pool(1) as pool:
            self.assertEqual(pool.map_async(atoms_of, [molecule]).get(timeout=60), [12])

    def test_a_pool_works_after_a_mesh_in_the_parent(self):
        radii = [1 + k / 10 for k in range(8)]
        morskin.Skin(*BALLS).mesh(C=0.2, threads=2)
        for method in ("fork", "spawn", "forkserver"):
            with multiprocessing.get_context(method).Pool(2) as pool:
                found = pool.map_async(area_of, radii).get(timeout=60)
            self.assertEqual(found, [area_of(radius) for radius in radii])

    def test_a_pool_works_that_is_forked_while_a_mesh_is_made(self):
        mesh = []
        busy = threading.Thread(
            target=lambda: mesh.append(morskin.Skin(*BALLS).mesh(C=0.02, threads=1)))
        busy.start()
        with multiprocessing.get_context("fork").Pool(2) as pool:
            found = pool.map_async(area_of, [1.0, 1.5]).get(timeout=60)
        busy.join()
        self.assertEqual(found, [area_of(1.0), area_of(1.5)])
        self.assertTrue(mesh[0].certificate.certified)


class Memory(ModuleTest):
    CALLS = 10_000

    @staticmethod
    def resident():
        """Bytes."""
        for line in Path("/proc/self/status").read_text().splitlines():
            if line.startswith("VmRSS:"):
                return int(line.split()[1]) * 1024
        raise RuntimeError("no VmRSS")

    def growth(self, call):
        """Of the resident memory over CALLS calls, after a tenth as many, bytes."""
        for _ in range(self.CALLS // 10):
            call()
        before = self.resident()
        for _ in range(self.CALLS):
            call()
        return self.resident() - before

    def test_10_000_meshes_leave_no_memory_behind(self):
        def call():
            mesh = morskin.Skin([[0, 0, 0]], [1.0]).mesh(C=0.4, threads=1)
            return mesh.vertices, mesh.faces, mesh.normals, mesh.atom_ids, mesh.certificate.area
        self.assertLess(self.growth(call), 4 * 2**20)

    def test_10_000_failures_and_critical_points_leave_no_memory_behind(self):
        skin = morskin.Skin(*BALLS)

        def call():
            for bad in (lambda: skin.mesh(C=-1), lambda: morskin.Skin([[0, 0, 0]], [-1]),
                        lambda: morskin.check([[0, 0, 0]], [[0, 0, 9]], skin)):
                with self.assertRaises(ValueError):
                    bad()
            return skin.critical_points().positions
        self.assertLess(self.growth(call), 4 * 2**20)


if __name__ == "__main__":
    main()
