#!/usr/bin/env python3
"""What `make install` puts where, and whether it works from there: programs are built against it,
and the commands of papers/install.md are run in it.
Usage: installed_test.py BUILD CONFIG CXX [FLAGS]"""

import gzip
import os
import re
import shutil
import subprocess
import sys
import unittest
from fnmatch import fnmatch
from pathlib import Path

from support.programs import output_of, temporary_folder

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "papers" / "course"))
from page import INSTALLED, Page  # noqa: E402  (from papers/course)
from run_commands import matches, run, trimmed  # noqa: E402

BUILD, CONFIG, CXX, FLAGS = [*sys.argv[1:], ""][:4]
PAGE = Page(ROOT / "papers" / "install.md")
# Debian's package and conda's of each library.
PACKAGES = {"libbz2.so.1.0": ("libbz2-1.0", "bzip2"),
            "liblzma.so.5": ("liblzma5", "liblzma"),
            "libnettle.so.8": ("libnettle8", "nettle"),
            "libpng16.so.16": ("libpng16-16", "libpng"),
            "libz.so.1": ("zlib1g", "zlib"),
            "libzstd.so.1": ("libzstd1", "zstd")}
BASE_SYSTEM = {"libc.so.6", "libm.so.6"}
# These two are in a release build.
OF_CXX = set() if CONFIG == "Release" else {"libgcc_s.so.1", "libstdc++.so.6"}


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = temporary_folder(cls)
        cls.stage = cls.folder / "stage"
        output_of("cmake", "--install", BUILD, "--prefix", "/opt/skins", "--config", CONFIG,
                  env={**os.environ, "DESTDIR": str(cls.stage)})
        cls.outside = [p for p in cls.stage.rglob("*") if p.is_file()
                       and not p.is_relative_to(cls.stage / "opt" / "skins")]
        cls.prefix = cls.folder / "moved"
        shutil.move(cls.stage / "opt" / "skins", cls.prefix)
        cls.files = sorted(p for p in cls.prefix.rglob("*") if not p.is_dir())
        cls.names = [str(p.relative_to(cls.prefix)) for p in cls.files]

    def setUp(self):
        self.environment = {**os.environ, "PREFIX": str(self.prefix), "CXX": CXX,
                            "CXXFLAGS": f"-O1 {FLAGS}",
                            "PATH": f"{self.prefix}/bin:{os.environ['PATH']}"}

    def test_files_lie_under_destdir_and_prefix_and_are_those_that_the_page_lists(self):
        self.assertEqual(self.outside, [])
        listed = re.findall(r"^PREFIX/(\S+)", PAGE.text, re.MULTILINE)
        for name in self.names:
            self.assertEqual(sum(fnmatch(name, pattern) for pattern in listed), 1, name)
        for pattern in listed:
            self.assertTrue(any(fnmatch(name, pattern) for name in self.names), pattern)

    def test_every_example_of_the_sources_is_installed_with_its_data_and_may_be_run_or_read(self):
        there = self.prefix / "share" / "doc" / "morskin" / "examples"
        tracked = [p.relative_to(ROOT / "examples") for p in (ROOT / "examples").rglob("*")
                   if p.is_file() and "__pycache__" not in p.parts]
        data = [Path("molecules", p.name) for p in (ROOT / "bench" / "molecules").iterdir()]
        self.assertEqual(sorted({*tracked, *data}),
                         sorted(p.relative_to(there) for p in there.rglob("*") if p.is_file()))
        for path in self.files:
            self.assertFalse(path.is_symlink(), path)
            self.assertTrue(path.stat().st_mode & 0o444 == 0o444, path)
        self.assertTrue(os.access(there / "shell" / "mesh_all.sh", os.X_OK))
        for target in re.findall(r"\]\(([^)#]+)", (there / "README.md").read_text()):
            self.assertTrue((there / target).exists(), f"{target} leads nowhere")

    def test_nothing_that_is_installed_names_the_folder_of_the_build_or_of_the_sources(self):
        if CONFIG != "Release":
            self.skipTest("assertions name their files")
        for path in self.files:
            for folder in (ROOT, Path(BUILD).resolve()):
                # Whole names: including morskin/morskin.h names no checkout in /morskin.
                named = rb"(-[IL]|(?<![\w.-]))" + re.escape(bytes(folder)) + rb"(?![\w.-])"
                self.assertIsNone(re.search(named, path.read_bytes()), path)

    def test_the_recipes_install_every_library_that_the_command_needs(self):
        if "-fsanitize" in FLAGS:
            self.skipTest("sanitizers have libraries of their own")
        needed = set(re.findall(r"NEEDED\s+(lib\S+)",
                                output_of("objdump", "-p", self.prefix / "bin/morskin")))
        self.assertEqual(needed - BASE_SYSTEM - OF_CXX, set(PACKAGES))
        packaging = ROOT / "packaging"
        conda = (packaging / "conda/meta.yaml").read_text()
        needs = re.search(r"\n  run:\n(( {4}- .*\n)+)", conda)[1]
        for of_debian, of_conda in PACKAGES.values():
            self.assertIn(f"    - {of_conda}\n", needs)
            for recipe in ("Containerfile", "apptainer.def"):
                last = (packaging / recipe).read_text().rpartition("apt-get install")[2]
                self.assertIn(of_debian, last.partition("\n")[0].split(), recipe)

    def test_the_page_says_where_the_debian_packages_land(self):
        makefile = (ROOT / "Makefile").read_text()
        folder = re.search(r"^deb: .*## make Debian packages in (\S+),", makefile, re.MULTILINE)[1]
        self.assertIn(f"mkdir -p {folder}/", makefile)
        self.assertIn(f"| `make deb` | two Debian packages in {folder}:", PAGE.text)

    def test_debian_s_copyright_names_each_molecule_whose_licence_is_not_cc0(self):
        sources = (ROOT / "bench/molecules/SOURCES.md").read_text()
        others = re.findall(r"^## Licence of `(.*)`$", sources, re.MULTILINE)
        self.assertGreater(len(others), 1)
        told = (ROOT / "packaging/debian/copyright").read_text()
        for name in others:
            holder = re.search(rf"^Files: bench/molecules/{name}\nCopyright: \S+ (.*)$", told,
                               re.MULTILINE)
            self.assertIn(holder[1], sources)

    def test_programs_and_shared_libraries_build_with_find_package_and_each_header_alone(self):
        build = self.folder / "uses"
        output_of("cmake", "-S", ROOT / "tests" / "installed", "-B", build,
                  f"-DCMAKE_PREFIX_PATH={self.prefix}", f"-DCMAKE_BUILD_TYPE={CONFIG}",
                  f"-DCMAKE_CXX_COMPILER={CXX}", f"-DCMAKE_CXX_FLAGS={FLAGS}")
        output_of("cmake", "--build", build)
        molecule, mesh = ROOT / "bench/molecules/two_balls.xyzr", self.folder / "two.ply"
        self.assertIn("certified, genus 0", output_of(build / "uses_morskin", molecule, mesh))
        output_of(self.prefix / "bin/morskin", "check", mesh, "--against", molecule, "--model",
                  "sas", "-C", "0.2")

    def test_the_example_in_cpp_that_is_short_of_memory_ends_with_a_line_and_code_2(self):
        if "-fsanitize" in FLAGS:
            self.skipTest("sanitizers end the program themselves")
        example = self.folder / "short"
        shutil.copytree(self.prefix / "share/doc/morskin/examples/cpp", example)
        output_of("make", "-s", "-C", example,
                  env={**self.environment, "PKG_CONFIG_PATH": f"{self.prefix}/lib/pkgconfig"})
        done = subprocess.run(["sh", "-c", 'ulimit -d 512; exec "$0" "$@"',
                               example / "mesh_a_molecule",
                               ROOT / "bench/molecules/1grm_model1.pdb", self.folder / "short.ply"],
                              capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stderr), (2, "mesh_a_molecule: std::bad_alloc\n"))

    def test_no_function_of_the_archive_has_the_name_of_one_that_a_program_may_have_too(self):
        symbols = output_of("nm", "-C", "--defined-only", self.prefix / "lib/libmorskin.a")
        self.assertIn("morskin::Skin::mesh", symbols)
        self.assertEqual(re.findall(r".* [TVWu] .*\b(?:Eigen|gemmi|tao|fast_float)::.*", symbols),
                         [])

    def test_the_package_finds_every_library_that_the_archive_needs_wherever_it_lies(self):
        package = self.prefix / "lib/cmake/morskin"
        needed = re.search(r'INTERFACE_LINK_LIBRARIES "(.*)"',
                           (package / "morskinTargets.cmake").read_text())[1].split(";")
        finds = re.findall(r"find_dependency\((\w+)\)",
                           (package / "morskinConfig.cmake").read_text())
        self.assertEqual([re.sub(r"\\\$<LINK_ONLY:(\w+)::\w+>", r"\1", name) for name in needed],
                         finds)

    def test_a_compiler_of_an_older_standard_is_told_first_that_the_library_is_of_a_newer(self):
        program = self.prefix / "share/doc/morskin/examples/cpp/mesh_a_molecule.cpp"
        done = subprocess.run([CXX, "-std=c++17", "-Wfatal-errors", "-fsyntax-only",
                               f"-I{self.prefix}/include", program], capture_output=True, text=True)
        self.assertRegex(done.stderr, r"error:.*compile with -std=c\+\+20")

    def test_mesh_all_gives_molecules_whose_names_begin_alike_meshes_of_their_own(self):
        molecules, box = ROOT / "bench/molecules", self.folder / "alike"
        box.mkdir()
        shutil.copy(molecules / "benzene.pdb", box / "a b.1.pdb")
        shutil.copy(molecules / "two_balls.xyzr", box / "a b.1.xyzr")
        (box / "a b.2.xyz.gz").write_bytes(gzip.compress((molecules / "caffeine.xyz").read_bytes()))
        script = self.prefix / "share/doc/morskin/examples/shell/mesh_all.sh"
        output_of(script, "out put", *sorted(box.iterdir()), cwd=box, env=self.environment)
        self.assertEqual({p.name for p in (box / "out put").iterdir()},
                         {f"a b.{name}.{ending}" for name in ("1.pdb", "1.xyzr", "2.xyz.gz")
                          for ending in ("ply", "json")})

    def test_the_page_shows_what_its_commands_print(self):
        box = self.folder / "box"
        box.mkdir()
        os.environ.update(self.environment)
        commands = [c for c in PAGE.commands() if c[1].startswith(INSTALLED)]
        self.assertGreater(len(commands), 8)
        for number, command, shown in commands:
            printed = run(command, box)
            self.assertTrue(matches(trimmed(shown), printed),
                            "\n".join([f"papers/install.md:{number}: {command}", *printed]))

    def test_all_that_tell_a_version_tell_the_same(self):
        version = re.search(r"project\(morskin VERSION (\S+)",
                            (ROOT / "CMakeLists.txt").read_text())[1]
        self.assertRegex(version, r"^(0|[1-9]\d*)\.(0|[1-9]\d*)\.(0|[1-9]\d*)$")
        date = re.search(r"MORSKIN_DATE (\S+)\)", (ROOT / "CMakeLists.txt").read_text())[1]
        self.assertEqual(output_of(self.prefix / "bin/morskin", "--version").split()[1], version)
        self.assertIn(f"\nVersion: {version}\n",
                      (self.prefix / "lib/pkgconfig/morskin.pc").read_text())
        pages = self.prefix / "share/man/man1"
        for page in pages.iterdir():
            self.assertIn(f' 1 {date} "morskin {version}"', page.read_text(), page)
        changes = (ROOT / "packaging/debian/changelog").read_text()
        self.assertTrue(changes.startswith(f"morskin ({version}) "))
        day = output_of("date", "--utc", "--date", re.search(r"^ -- .*>  (.*)$", changes,
                                                             re.MULTILINE)[1], "+%Y-%m-%d")
        self.assertEqual(day, date)
        self.assertIn(f'version = "{version}"', (ROOT / "packaging/conda/meta.yaml").read_text())
        citation = (ROOT / "CITATION.cff").read_text()
        self.assertIn(f'\nversion: {version}\ndate-released: "{date}"\n', citation)
        package = self.prefix / "lib/cmake/morskin/morskinConfigVersion.cmake"
        self.assertIn(f'set(PACKAGE_VERSION "{version}")', package.read_text())


class Commit(unittest.TestCase):
    """cmake/commit.cmake on made-up trees."""

    def setUp(self):
        folder = temporary_folder(self)
        self.tree, self.file = folder / "tree", folder / "commit.cpp"
        self.tree.mkdir()

    def git(self, *words):
        return output_of("git", "-C", self.tree, "-c", "user.name=a", "-c", "user.email=a@b.c",
                         *words)

    def made(self, tree=None):
        output_of("cmake", "-D", f"SOURCE={tree or self.tree}", "-D", f"OUT={self.file}", "-P",
                  ROOT / "cmake" / "commit.cmake")
        return re.search(r'commit = "(.*)";', self.file.read_text())[1]

    def test_a_tree_without_git_and_a_folder_of_another_checkout_have_no_commit(self):
        self.assertEqual(self.made(), "unknown, built without git")
        self.git("init", "--quiet")
        self.assertEqual(self.made(), "unknown, built without git")  # nothing is committed yet
        self.git("commit", "--quiet", "--allow-empty", "-m", "first")
        (self.tree / "morskin").mkdir()
        self.assertEqual(self.made(self.tree / "morskin"), "unknown, built without git")

    def test_the_file_is_written_anew_for_another_commit_or_changes_and_only_then(self):
        self.git("init", "--quiet")
        (self.tree / "a").write_text("1")
        self.git("add", "a")
        self.git("commit", "--quiet", "-m", "first")
        first = self.made()
        self.assertEqual(first, self.git("rev-parse", "--short=12", "HEAD"))
        os.utime(self.file, (0, 0))
        self.made()
        self.assertEqual(self.file.stat().st_mtime, 0)
        (self.tree / "a").write_text("2")
        self.assertEqual(self.made(), f"{first} with changes")
        self.git("commit", "--quiet", "--all", "-m", "second")
        self.assertNotIn(first, self.made())


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]])
