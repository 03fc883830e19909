#!/usr/bin/env python3
"""The workflows of packaging/engines, on the engines themselves: what they make is what one batch
makes, whatever is killed on the way. Needs cmake/engines_packages.txt and, for Slurm, root.
Usage: engines_test.py path/to/morskin"""

import getpass
import json
import os
import shlex
import signal
import socket
import subprocess
import sys
import time
import unittest
from pathlib import Path

from support.batch_case import Batch
from support.command import main, morskin

ENGINES = Path(__file__).resolve().parent.parent / "packaging" / "engines"
OPTIONS = ["-C", "0.1"]
SHARDS = 4

SLURM = """ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/none
CredType=cred/none
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def free_ports(count):
    sockets = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [s.getsockname()[1] for s in sockets]
    for s in sockets:
        s.close()
    return ports


def descendants(process):
    """Processes that run `morskin batch` below this one."""
    found, waiting = [], [process]
    while waiting:
        at = waiting.pop()
        for task in Path(f"/proc/{at}/task").glob("*/children"):
            try:
                waiting += map(int, task.read_text().split())
            except OSError:
                continue
        try:
            words = Path(f"/proc/{at}/cmdline").read_text().split("\0")
        except OSError:
            continue
        if words[1:2] == ["batch"]:
            found.append(at)
    return found


def parent_of(process):
    return int(Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[1])


class Engines(Batch):
    def setUp(self):
        super().setUp()
        self.chains(12, balls=150)
        self.batch("in", "-o", "whole", *OPTIONS)

    def assert_whole(self):
        self.assertEqual(self.rows(), self.rows("whole"))
        made = {k: v for k, v in self.made().items() if k not in ("summary.json", "shards")}
        self.assertEqual(made, self.made("whole"))
        self.assertEqual(len(list((self.folder / "out").glob("rows-*.jsonl"))), SHARDS)

    def made(self, folder="out"):
        return {p.name: p.read_bytes() for p in (self.folder / folder).iterdir()
                if p.is_file() and p.suffix != ".jsonl"}

    def wait_for(self, fact, seconds=120):
        end = time.monotonic() + seconds
        while not (found := fact()):
            self.assertLess(time.monotonic(), end, "waited for too long")
            time.sleep(0.02)
        return found

    def rows_so_far(self):
        return sum(p.read_text().count("\n") for p in self.folder.glob("out/rows-*.jsonl"))


class Snakemake(Engines):
    def words(self, command, output, inputs="in"):
        return ["snakemake", "--snakefile", ENGINES / "Snakefile", "--cores", "2",
                "--rerun-incomplete", "--config", f"list={inputs}", f"out={output}",
                f"shards={SHARDS}",
                f"morskin={command}", "options=" + shlex.join(OPTIONS)]

    def test_the_paths_of_snakemake_may_hold_blanks(self):
        command = self.folder / "the command"
        command.symlink_to(morskin())
        subprocess.run(self.words(command, "my out"), cwd=self.folder, check=True,
                       capture_output=True, timeout=600)
        self.assertEqual(self.rows("my out"), self.rows("whole"))

    def test_braces_are_letters_to_snakemake_but_in_the_output_where_they_are_refused(self):
        command = self.folder / "{the} command"
        command.symlink_to(morskin())
        (self.folder / "in{1}").symlink_to("in")
        subprocess.run(self.words(command, "braced", "in{1}"), cwd=self.folder, check=True,
                       capture_output=True, timeout=600)
        self.assertTrue((self.folder / "braced/summary.json").exists())
        refused = subprocess.run(self.words(command, "out{1}"), cwd=self.folder, check=False,
                                 capture_output=True, text=True, timeout=600)
        self.assertNotEqual(refused.returncode, 0)
        self.assertIn("out=out{1}: Snakemake takes what is in braces", refused.stderr)

    def test_molecules_that_are_added_to_the_list_are_made(self):
        names = [f"in/chain{i:02}.xyzr\n" for i in range(12)]
        words = self.words(morskin(), "out", self.input("list.txt", "".join(names[:8])))
        for count in (8, 12):
            self.input("list.txt", "".join(names[:count]))
            subprocess.run(words, cwd=self.folder, check=True, capture_output=True, timeout=600)
            self.assertEqual(len(self.rows()), count)

    def test_snakemake_goes_on_after_it_was_killed(self):
        words = self.words(morskin(), "out")
        first = subprocess.Popen(words, cwd=self.folder, stderr=subprocess.DEVNULL,
                                 start_new_session=True)
        self.addCleanup(first.wait)
        self.wait_for(lambda: self.rows_so_far() > 1)
        os.killpg(first.pid, signal.SIGKILL)
        first.wait()
        self.assertFalse((self.folder / "out/summary.json").exists())
        subprocess.run([*words[:3], "--unlock", *words[5:]], cwd=self.folder, check=True,
                       capture_output=True)
        subprocess.run(words, cwd=self.folder, check=True, capture_output=True, timeout=600)
        self.assert_whole()
        summary = json.loads((self.folder / "out/summary.json").read_text())
        self.assertEqual((summary["rows"], summary["made"]), (12, 0))


class Dask(Engines):
    def test_dask_goes_on_after_its_workers_were_killed(self):
        run = subprocess.Popen([sys.executable, ENGINES / "dask_batch.py", "in", "-o", "out",
                                "--shards", str(SHARDS), "--processes", "2", "--morskin",
                                morskin(), "--", *OPTIONS], cwd=self.folder,
                               stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        self.addCleanup(run.kill)
        victim = self.wait_for(lambda: descendants(run.pid))[0]
        os.kill(parent_of(victim), signal.SIGKILL)  # the Dask worker: its nanny starts another
        said = run.communicate(timeout=600)[0]
        self.assertEqual(run.returncode, 0)
        self.assertRegex(said, r"^12 molecules, 12 rows, 0 made now in .* 12 ok\n")
        self.assert_whole()


class Slurm(Engines):
    """A cluster of this machine alone."""

    def start_slurm(self):
        folder = self.folder / "slurm"
        for name in ("state", "spool"):
            (folder / name).mkdir(parents=True)
        text = SLURM.format(host=socket.gethostname().split(".")[0], user=getpass.getuser(),
                            folder=folder, ports=free_ports(2))
        (folder / "slurm.conf").write_text(text)
        self.environment = {**os.environ, "SLURM_CONF": str(folder / "slurm.conf"),
                            "MORSKIN": morskin()}
        for program in ("slurmctld", "slurmd"):
            daemon = subprocess.Popen([f"/usr/sbin/{program}", "-D"], env=self.environment,
                                      stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            self.addCleanup(daemon.wait)
            self.addCleanup(daemon.terminate)
        self.wait_for(lambda: "idle" in self.slurm("sinfo", "-h", "-o", "%T"))

    def slurm(self, *words):
        done = subprocess.run(list(map(str, words)), cwd=self.folder, env=self.environment,
                              capture_output=True, text=True, check=False, timeout=60)
        return done.stdout

    def submit(self):
        return self.slurm("sbatch", "--parsable", f"--array=1-{SHARDS}", "--output=slurm/%A_%a.log",
                          ENGINES / "batch.slurm", "in", "out", *OPTIONS).strip()

    def test_a_job_array_goes_on_after_tasks_were_killed_and_the_job_cancelled(self):
        self.start_slurm()
        job = self.submit()
        self.assertRegex(job, r"^\d+$")
        self.wait_for(lambda: self.rows_so_far() > 1)
        self.slurm("scancel", "--signal=KILL", "--full", f"{job}_1")
        self.slurm("scancel", job)
        self.wait_for(lambda: not self.slurm("squeue", "-h"))
        self.assertLess(self.rows_so_far(), 12)
        self.submit()
        self.wait_for(lambda: not self.slurm("squeue", "-h"), seconds=600)
        self.assert_whole()


if __name__ == "__main__":
    main()
