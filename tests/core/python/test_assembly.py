"""Sets of bearing rows: adore.Assembly."""

import tempfile
import unittest
from pathlib import Path

import numpy as np

import adore


class Sets(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)
        deck = adore.new("ball-18")
        deck.rpm2 = 1000
        self.set = adore.new_assembly(self.folder / "set", "DB", deck, preload={"force": "500 N"}, load={"x": "200 N"})

    def tearDown(self):
        self.temporary.cleanup()

    def test_statics_share_the_load(self):
        solution = self.set.statics()
        self.assertAlmostEqual(solution.summary["preload_unmounted_N"], 500.0, places=4)
        rows = solution.columns("rows")
        self.assertAlmostEqual(float(np.sum(rows["load x [N]"])), 200.0, places=3)
        self.assertEqual(solution.stiffness.shape, (5, 5))
        self.assertEqual(len(solution.rows), 2)
        self.assertLess(solution.summary["life_iso16281_hours"], solution.rows[0]["life_iso16281_hours"])
        self.assertIn("axial force", solution.tables)
        self.assertEqual(self.set.arrangement, "DB")

    def test_files(self):
        run = self.set.run(self.folder / "results")
        self.assertEqual(run.status, "done")
        self.assertTrue((run.folder / "row-2" / "PRINT.txt").exists())
        self.assertAlmostEqual(run.summary["preload_unmounted_N"], 500.0, places=4)
        with self.assertRaises(adore.ResultsExistError):
            self.set.run(self.folder / "results")

    def test_errors(self):
        with self.assertRaises(adore.InputError):
            adore.Assembly(self.folder)
        with self.assertRaisesRegex(adore.InputError, "several rows on one shaft"):
            self.set.statics(sets={"mode": 0})
        with self.assertRaisesRegex(adore.InputError, "same orientation"):
            adore.new_assembly(self.folder / "tandem", "DT", adore.new("ball-18"), preload={"force": "1 N"})
        self.assertTrue(all(one.severity != "error" for one in self.set.check()))


if __name__ == "__main__":
    unittest.main()
