"""The wheel of tricontact: what CMake compiles, beside the package in Python.

TRICONTACT_BUILD names a finished build folder to take the compiled modules from; without it one
is configured below build/ and compiled, which takes a quarter of an hour.
"""

import os
import re
import subprocess
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

SOURCES = Path(__file__).resolve().parent


def version():
    text = (SOURCES / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"^project\(Tricontact VERSION (\S+)", text, re.MULTILINE).group(1)


class ByCMake(build_ext):
    """Installs the component `python` of the build into the wheel."""

    def build_extension(self, ext):
        given = os.environ.get("TRICONTACT_BUILD")
        build = Path(given) if given else Path(self.build_temp).resolve() / "cmake"
        if not given:
            options = ["-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DTRICONTACT_WITH_PYTHON=ON",
                       "-DTRICONTACT_WITH_TESTS=OFF", *os.environ.get("CMAKE_ARGS", "").split()]
            subprocess.run(["cmake", "-S", SOURCES, "-B", build, *options], check=True)
            subprocess.run(["cmake", "--build", build, "--target", "tricontact_python", "tricontact"], check=True)
        package = Path(self.get_ext_fullpath(ext.name)).resolve().parent
        subprocess.run(["cmake", "--install", build, "--component", "wheel", "--prefix", package,
                        "--strip"], check=True)


setup(
    version=version(),
    ext_modules=[Extension("tricontact._core", [])],
    cmdclass={"build_ext": ByCMake},
)
