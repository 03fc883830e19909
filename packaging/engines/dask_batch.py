#!/usr/bin/env python3
"""Meshes many molecules with Dask, a task for each shard. Words behind `--` are options of
`morskin batch`. The same line resumes, however it ended."""

import argparse
import subprocess
import sys

from dask.distributed import Client, LocalCluster, as_completed


def run_shard(number, shards, batch):
    """Runs on a Dask worker. The shard dies with it (setpriv is in util-linux), so that another
    worker can take it over."""
    subprocess.run(["setpriv", "--pdeathsig", "KILL", *batch, "--shard", f"{number}/{shards}",
                    "--workers", "1", "-q"], check=True)
    return number


def client_for(scheduler, processes):
    if scheduler:
        return Client(scheduler)
    return Client(LocalCluster(n_workers=processes, threads_per_worker=1, dashboard_address=None))


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     usage="%(prog)s LIST -o DIR [OPTIONS] [-- OPTIONS OF BATCH]")
    parser.add_argument("list", help="as `morskin batch` has it; seen by every Dask worker")
    parser.add_argument("-o", "--output", required=True, metavar="DIR", help="the same of it")
    parser.add_argument("--shards", type=int, default=16, metavar="N", help="default %(default)s")
    parser.add_argument("--scheduler", metavar="ADDRESS", help="default: a cluster of this machine")
    parser.add_argument("--processes", type=int, help="of this machine's cluster; default: cores")
    parser.add_argument("--morskin", default="morskin", help="the command")
    words = sys.argv[1:]
    dashes = words.index("--") if "--" in words else len(words)
    arguments = parser.parse_args(words[:dashes])
    batch = [arguments.morskin, "batch", arguments.list, "-o", arguments.output,
             *words[dashes + 1:]]
    with client_for(arguments.scheduler, arguments.processes) as client:
        # Not pure: a shard that was done before is asked again, and finds nothing left.
        shards = client.map(run_shard, range(1, arguments.shards + 1), shards=arguments.shards,
                            batch=batch, pure=False, retries=2)
        for count, _ in enumerate(as_completed(shards, raise_errors=True, with_results=True), 1):
            print(f"{count} of {arguments.shards} shards", file=sys.stderr)
    # Counts the rows; a row that were missing would be made here.
    sys.exit(subprocess.run(batch, check=False).returncode)


if __name__ == "__main__":
    main()
