#!/usr/bin/env python3
"""The packages run where nothing else is: the static binary in an empty folder as root of the file
system, the Debian packages in a fresh Debian. It needs to be root, and the network.
Usage: packages_test.py BUILD, the folder that `make static deb` has filled"""

import subprocess
import sys
import unittest
from pathlib import Path

from support.programs import output_of, temporary_folder

ROOT = Path(__file__).resolve().parent.parent
BUILD = Path(sys.argv[1]).resolve()
CAFFEINE = ROOT / "bench" / "molecules" / "caffeine.xyz"

# What a user would type who has just installed it.
IN_DEBIAN = """
apt-get install --yes --no-install-recommends /packages/*.deb > /dev/null
morskin --version
dpkg --listfiles morskin | grep --quiet /usr/share/man/man1/morskin-mesh.1.gz
dpkg --listfiles morskin | grep --quiet /usr/share/zsh/vendor-completions/_morskin
dpkg --listfiles morskin | grep --quiet /usr/share/morskin/engines/Snakefile
morskin mesh /usr/share/doc/morskin/examples/molecules/caffeine.xyz -o caffeine.ply | tail --lines 1
apt-get install --yes --no-install-recommends g++ make pkg-config > /dev/null
make -s -C /usr/share/doc/morskin/examples/cpp
cd /usr/share/doc/morskin/examples
cpp/mesh_a_molecule molecules/cube8.xyzr /cube.ply
dpkg --purge morskin libmorskin-dev > /dev/null
test ! -e /usr/bin/morskin
"""


class Packages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        output_of("make", "static", "deb", cwd=ROOT)

    def setUp(self):
        self.folder = temporary_folder(self)

    def test_the_static_binary_runs_where_there_is_nothing_and_writes_the_same_bytes(self):
        self.assertIn("not a dynamic executable", subprocess.run(
            ["ldd", BUILD / "static" / "morskin"], capture_output=True, text=True).stderr)
        for file in (BUILD / "static" / "morskin", CAFFEINE):
            output_of("cp", file, self.folder)
        for name in ("c.ply", "c.npz", "c.png"):
            words = ["render", "/c.ply"] if name == "c.png" else ["mesh", "/caffeine.xyz", "-q"]
            output_of("chroot", self.folder, "/morskin", *words, "-o", f"/{name}")
        words = ["mesh", "caffeine.xyz", "-q", "-o", "shared.ply", "-o", "shared.npz"]
        output_of(BUILD / "morskin", *words, cwd=self.folder)
        for ending in ("ply", "npz"):
            self.assertEqual((self.folder / f"c.{ending}").read_bytes(),
                             (self.folder / f"shared.{ending}").read_bytes())

    def test_the_same_debian_packages_are_made_every_time(self):
        packages = sorted((BUILD / "deb").glob("*.deb"))
        self.assertEqual(len(packages), 2)
        first = [package.read_bytes() for package in packages]
        output_of("make", "deb", cwd=ROOT)
        self.assertTrue(first == [package.read_bytes() for package in packages])

    def test_the_debian_packages_install_run_and_go_again(self):
        said = output_of(
            "mmdebstrap", "--variant=apt", "--quiet", '--customize-hook=mkdir "$1/packages"',
            *(f"--customize-hook=copy-in {package} /packages"
              for package in sorted((BUILD / "deb").glob("*.deb"))),
            '--customize-hook=chroot "$1" sh -euc "$IN_DEBIAN"', "bookworm", "/dev/null",
            env={"IN_DEBIAN": IN_DEBIAN, "PATH": "/usr/sbin:/usr/bin:/sbin:/bin"})
        self.assertIn("certified: homeomorphic", said)
        self.assertIn("triangles, certified, genus 0", said)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
