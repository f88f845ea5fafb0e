"""Builds the module with the project's own CMake: pip install --no-build-isolation ./core/python.

ADORE_BUILD_FOLDER names an existing CMake build folder of the source tree, e.g. build/release. Without it the build folder is build/python,
with additional arguments from CMAKE_ARGS.
"""

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

SOURCE = Path(__file__).resolve().parents[2]


class CMakeModule(build_ext):
    def build_extension(self, ext):
        given = os.environ.get("ADORE_BUILD_FOLDER")
        folder = SOURCE / given if given else SOURCE / "build" / "python"
        if not given:
            subprocess.run(
                ["cmake", "-S", SOURCE, "-B", folder, "-DCMAKE_BUILD_TYPE=Release", "-DADORE_WITH_QT=OFF",
                 "-DADORE_BUILD_TESTS=OFF", f"-DPython_EXECUTABLE={sys.executable}"]
                + (["-G", "Ninja"] if shutil.which("ninja") else []) + shlex.split(os.environ.get("CMAKE_ARGS", "")),
                check=True, stdout=subprocess.DEVNULL,
            )  # fmt: skip
        subprocess.run(["cmake", "--build", folder, "--target", "adore_python", "--parallel", str(os.cpu_count() or 1)], check=True)
        built = list((folder / "python" / "adore").glob("_core.*.so"))
        target = Path(self.get_ext_fullpath(ext.name))
        module = next((b for b in built if b.name == target.name), None)
        if module is None:
            names = ", ".join(b.name for b in built) or "none"
            sys.exit(f"the build in {folder} made no {target.name} (there is: {names}); it was configured for another Python")
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(module, target)


version = re.search(r"project\(adore VERSION ([\d.]+)", (SOURCE / "CMakeLists.txt").read_text()).group(1)
setup(version=version, ext_modules=[Extension("adore._core", [])], cmdclass={"build_ext": CMakeModule})
