#!/usr/bin/env python3
"""pip installs the module from the checkout and from an sdist, each into a virtual environment of
its own with the system's packages. It compiles the library twice, so it is slow.
Usage: install_test.py folder-of-the-package [--sdist]: --sdist packs and configures only"""

import os
import shutil
import sys
import tarfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tests" / "support"))
from programs import output_of, temporary_folder  # noqa: E402  (from tests/support)

PROGRAM = """
import sys, morskin
mesh = morskin.read(sys.argv[1]).mesh(density=5)
assert mesh.certificate.certified and mesh.normals.shape == mesh.vertices.shape
print(morskin.__file__)
"""


class Install(unittest.TestCase):
    def setUp(self):
        self.folder = temporary_folder(self)

    def checkout(self):
        """A copy of the files that the repository has, for pip builds in the source folder."""
        names = output_of("git", "ls-files", "-z", "--cached", "--others", "--exclude-standard",
                          cwd=ROOT).split("\0")
        for name in filter(None, names):
            target = self.folder / "checkout" / name
            target.parent.mkdir(parents=True, exist_ok=True)
            if (ROOT / name).exists():
                shutil.copy(ROOT / name, target, follow_symlinks=False)
        return self.folder / "checkout"

    def sdist(self):
        source = self.checkout()
        output_of(sys.executable, "setup.py", "--quiet", "sdist", "--dist-dir", self.folder,
                  cwd=source)
        (archive,) = self.folder.glob("morskin-*.tar.gz")
        return archive

    def install(self, source):
        """Installs with pip and meshes with what is installed."""
        environment = self.folder / "environment"
        output_of(sys.executable, "-m", "venv", "--system-site-packages", environment)
        python = environment / "bin" / "python"
        # With the assertions of the library and of Eigen.
        output_of(python, "-m", "pip", "install", "--no-build-isolation", "--no-index", source,
                  cwd=self.folder, env={**os.environ, "CMAKE_ARGS": "-DCMAKE_BUILD_TYPE=Debug"})
        said = output_of(python, "-c", PROGRAM, ROOT / "bench" / "molecules" / "caffeine.xyz",
                         cwd=self.folder)
        self.assertTrue(said.startswith(str(environment)), said)
        found = output_of(python, "-m", "pip", "show", "--files", "morskin")
        for name in ("py.typed", "_morskin.pyi", "adapters.py"):
            self.assertIn(f"morskin/{name}", found)
        for name in ("mesh_test.py", "morse_test.py"):
            output_of(python, ROOT / "python" / "tests" / name, Path(said.strip()).parent.parent)
        output_of(python, "-m", "pip", "uninstall", "--yes", "morskin")

    def test_pip_installs_the_checkout(self):
        self.install(self.checkout())

    def test_pip_installs_the_sdist(self):
        self.install(self.sdist())


class Sdist(Install):
    test_pip_installs_the_checkout = test_pip_installs_the_sdist = None

    def test_the_sdist_has_all_that_cmake_asks_for_and_nothing_built(self):
        with tarfile.open(self.sdist()) as archive:
            archive.extractall(self.folder)
        (source,) = (path for path in self.folder.glob("morskin-*") if path.is_dir())
        for module in ("geometry", "skin", "morskin", "python"):
            here = {p.relative_to(ROOT) for p in (ROOT / module).rglob("*.[ch]*")
                    if p.suffix in (".h", ".cpp")}
            there = {p.relative_to(source) for p in (source / module).rglob("*.[ch]*")
                     if p.suffix in (".h", ".cpp")}
            self.assertEqual(here, there)
        self.assertEqual([p for p in source.rglob("*") if p.suffix in (".so", ".pyc", ".a")], [])
        output_of("cmake", "-S", source, "-B", self.folder / "build", "-DMORSKIN_BUILD_PYTHON=ON",
                  "-DMORSKIN_BUILD_COMMAND=OFF", "-DMORSKIN_BUILD_TESTS=OFF")


if __name__ == "__main__":
    tests = Sdist if "--sdist" in sys.argv else Install
    unittest.main(argv=[sys.argv[0]], defaultTest=tests.__name__)
