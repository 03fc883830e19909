"""Builds the extension with CMake, for pip. It takes Debian's packages (cmake/packages.txt);
the environment variable CMAKE_ARGS is given on to CMake."""

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent


class CMakeBuild(build_ext):
    def build_extension(self, ext):
        folder = Path(self.build_temp).resolve()
        subprocess.run(["cmake", "-S", ROOT, "-B", folder, f"-DMORSKIN_PYTHON={sys.executable}",
                        "-DMORSKIN_BUILD_PYTHON=ON", "-DMORSKIN_BUILD_COMMAND=OFF",
                        "-DMORSKIN_BUILD_TESTS=OFF",
                        *shlex.split(os.environ.get("CMAKE_ARGS", ""))], check=True)
        subprocess.run(["cmake", "--build", folder, "--target", "morskin_python",
                        "--parallel", str(self.parallel or os.cpu_count())], check=True)
        target = Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        (built,) = (folder / "python" / "morskin").glob("_morskin.*.so")
        shutil.copy(built, target)


setup(
    version=re.search(r"\bVERSION (\d+\.\d+\.\d+)\b", (ROOT / "CMakeLists.txt").read_text())[1],
    ext_modules=[Extension("morskin._morskin", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
    options={"build": {"build_base": "build/setuptools"}},  # build/ itself is CMake's
)
