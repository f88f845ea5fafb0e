"""The README's way: pip install --no-build-isolation ./core/python in a fresh environment."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path


class Pip(unittest.TestCase):
    def test_pip_installs_a_package_that_works_in_a_fresh_environment(self):
        source = Path(os.environ["ADORE_SOURCE_FOLDER"])
        clean = {k: v for k, v in os.environ.items() if k not in ("PYTHONPATH", "PYTHONHOME")}
        with tempfile.TemporaryDirectory() as folder:
            place = Path(folder) / "env"
            subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", place], check=True, env=clean)
            python = place / "bin" / "python"
            # ADORE_BUILD_FOLDER: what this build has compiled is not compiled again. No index: nothing is downloaded.
            done = subprocess.run(
                [python, "-m", "pip", "install", "--no-build-isolation", "--no-index", source / "core" / "python"],
                env=clean, capture_output=True, text=True,
            )  # fmt: skip
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            script = (
                "import adore; assert 'env' in adore.__file__, adore.__file__\n"
                "deck = adore.new('ball'); run = deck.run(until='0.01rev', progress=False)\n"
                "print(adore.__version__, run['contact.load'].shape[1:], len(run.table('SOL1').columns) > 5)"
            )
            told = subprocess.run([python, "-c", script], env=clean, cwd=folder, capture_output=True, text=True)
            self.assertEqual(told.stderr, "")
            self.assertEqual(told.stdout.split(" ", 1)[1].strip(), "(12, 2) True")
            names = {p.name for p in (place / "lib").rglob("adore/*")}
            self.assertTrue({"py.typed", "_core.pyi", "calc.pyi", "variables.pyi"} <= names, names)


if __name__ == "__main__":
    unittest.main()
