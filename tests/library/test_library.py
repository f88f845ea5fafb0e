"""The library as programs get it: installed headers that compile separately, and the example built against the installed tree."""

import os
import re
import shutil
import subprocess
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

BUILD = Path(os.environ["ADORE_BUILD_FOLDER"])
SOURCE = Path(os.environ["ADORE_SOURCE_FOLDER"])
COMPILER = os.environ.get("CXX", "c++")


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = Path(tempfile.mkdtemp(prefix="adore-library-"))
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.prefix = cls.folder / "prefix"
        subprocess.run(["cmake", "--install", BUILD, "--prefix", cls.prefix, "--component", "library"], check=True,
                       stdout=subprocess.DEVNULL)  # fmt: skip
        cls.include = cls.prefix / "include" / "adore"
        cls.headers = sorted(str(h.relative_to(cls.include)) for h in cls.include.rglob("*.h*"))

    def test_the_interface_is_runs_and_studies_with_what_they_take_and_return(self):
        rooms = {h.split("/")[0] for h in self.headers}
        self.assertEqual(rooms, {"base", "bearing", "calculators", "deck", "results", "runs", "studies", "user"})
        # A header more or less is a change of the interface, in resources/docs/library.md and the changelog.
        self.assertEqual(len(self.headers), 46)

    def test_every_installed_header_compiles_alone(self):
        def compile_one(header):
            source = self.folder / (header.replace("/", "_") + ".cpp")
            source.write_text(f"#include <adore/{header}>\n#include <adore/{header}>\n")
            return header, subprocess.run(
                [COMPILER, "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Wpedantic", "-Werror",
                 "-I", self.prefix / "include", "-isystem", self.include, source], capture_output=True, text=True,
            )  # fmt: skip

        with ThreadPoolExecutor(2) as pool:
            for header, done in pool.map(compile_one, self.headers):
                self.assertEqual(done.returncode, 0, f"{header}\n{done.stderr}")

    def test_installed_headers_include_installed_headers_and_json_only(self):
        standard = re.compile(r"^[a-z_]+$|^stdint\.h$|^sys/types\.h$")  # sys/types.h: uid_t
        for header in self.headers:
            for quote, name in re.findall(r'#include ([<"])([^>"]+)[>"]', (self.include / header).read_text()):
                if quote == '"':
                    self.assertIn(name, self.headers, header)
                else:
                    self.assertTrue(standard.match(name) or name.startswith("nlohmann/"), f"{header}: {name}")

    def test_the_library_shows_its_own_names_only_and_names_its_version(self):
        library = next((self.prefix / "lib").rglob("libadorecore.so"))
        names = subprocess.run(["nm", "-DC", "--defined-only", library], check=True, capture_output=True, text=True).stdout
        foreign = [line for line in names.splitlines() if "adore::" not in line]
        self.assertEqual(foreign, [])
        self.assertIn("adore::runs::run(", names)
        soname = subprocess.run(["objdump", "-p", library], check=True, capture_output=True, text=True).stdout
        version = re.search(r"project\(adore VERSION (\d+)\.(\d+)", (SOURCE / "CMakeLists.txt").read_text())
        # Before 1.0 the minor version plays the part of the major one.
        self.assertIn(f"libadorecore.so.{version.group(1)}.{version.group(2)}\n", soname)

    def test_the_example_builds_and_runs_against_the_installed_tree(self):
        build = self.folder / "build"
        for words in (["-S", SOURCE / "resources" / "examples" / "cpp-library", "-B", build, f"-DCMAKE_PREFIX_PATH={self.prefix}"],
                      ["--build", build]):  # fmt: skip
            done = subprocess.run(["cmake", *words], capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        done = subprocess.run([build / "bearing_speeds", self.folder / "run"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        stiffness = [float(x) for x in re.findall(r"axial stiffness ([\d.e+]+)", done.stdout)]
        # Centrifugal forces open the contact angles of the inner race: the faster, the softer along the axis.
        self.assertEqual(len(stiffness), 3)
        self.assertEqual(stiffness, sorted(stiffness, reverse=True))
        self.assertRegex(done.stdout, r"largest contact load \d{2,4}\.")
        self.assertIn("100 %", done.stderr)
        self.assertTrue((self.folder / "run" / "PRINT.txt").exists())

    def test_another_minor_version_is_refused(self):
        folder = self.folder / "other"
        folder.mkdir()
        (folder / "CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.25)\nproject(other LANGUAGES CXX)\nfind_package(Adore 0.99 REQUIRED)\n"
        )
        done = subprocess.run(["cmake", "-S", folder, "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={self.prefix}"],
                              capture_output=True, text=True)  # fmt: skip
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("0.99", done.stderr)


if __name__ == "__main__":
    unittest.main()
