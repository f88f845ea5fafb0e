"""The Python blocks of the README and of the tour, each page from top to bottom in a fresh folder."""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(os.environ.get("ADORE_SOURCE_FOLDER", Path(__file__).resolve().parents[3]))


def blocks(page):
    text = (SOURCE / page).read_text(encoding="utf-8")
    return re.findall(r"^```python\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)


class Tour(unittest.TestCase):
    def run_page(self, page, least):
        code = blocks(page)
        self.assertGreaterEqual(len(code), least)
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, "-W", "error", "-c", "\n".join(code)], cwd=folder, capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            return done.stdout, sorted(str(p.relative_to(folder)) for p in Path(folder).rglob("*.png"))

    def test_the_blocks_of_the_readme_run(self):
        told, pictures = self.run_page("README.md", 1)
        self.assertIn("largest contact load", told)
        self.assertTrue(pictures)

    def test_the_blocks_of_the_tour_run(self):
        told, pictures = self.run_page("resources/docs/python-tour.md", 9)
        self.assertIn("did you mean", told)
        self.assertIn("100%", told)
        self.assertIn("pictures/cage.png", pictures)


if __name__ == "__main__":
    unittest.main()
