"""What tests of programs share: a folder to run them in, and what they print."""

import subprocess
import tempfile
from pathlib import Path


def temporary_folder(test):
    """A folder that goes when the test has ended, or all tests of the class that is given."""
    folder = tempfile.TemporaryDirectory()
    add_cleanup = test.addClassCleanup if isinstance(test, type) else test.addCleanup
    add_cleanup(folder.cleanup)
    return Path(folder.name)


def output_of(*words, **options):
    """What a program prints, errors too. Fails if it does not end well."""
    done = subprocess.run([*map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, **options)
    if done.returncode != 0:
        raise AssertionError(f"{words}\n{done.stdout[-5000:]}")
    return done.stdout.strip()
