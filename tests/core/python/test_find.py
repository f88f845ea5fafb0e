"""Inverse calculations: adore.find()."""

import unittest

import numpy as np

import adore

SPHERE = {"Rx": 0.05, "Ry": 0.05, "E": 2e10, "nu": 0.3}


class Find(unittest.TestCase):
    def test_one_solution_is_that_of_the_equilibrium(self):
        deck = adore.new("ball")
        found = adore.find(deck, "appLoadX", (1000, 5000), "largest_contact_load_N=500")
        self.assertEqual(found.answer, "one")
        deck.appLoadX = found.value
        self.assertAlmostEqual(deck.statics().summary["largest_contact_load_N"], 500.0, places=4)
        x, y = found.curve
        self.assertGreaterEqual(len(x), 41)
        self.assertTrue(np.all(np.diff(x) > 0.0))
        self.assertIn("appLoadX = ", repr(found))

    def test_none_and_many_have_no_value(self):
        deck = adore.new("ball")
        none = adore.find(deck, "appLoadX", (1000, 2000), "largest_contact_load_N=1e7")
        self.assertEqual(none.answer, "none")
        self.assertEqual(none.best[0], 2000.0)
        self.assertEqual(none.solutions, [])
        with self.assertRaises(adore.InputError):
            none.value
        everywhere = adore.find(deck, "appLoadX", (1000, 2000), "largest_contact_load_N>=1")
        with self.assertRaises(adore.InputError):
            everywhere.value

    def test_calculators_and_questions(self):
        inputs = {"body1": SPHERE, "body2": SPHERE, "load": 1, "stress_poisson": 0.3}
        found = adore.find("hertz", "load", (1e3, 1e7), "delta=4e-3", inputs=inputs)
        self.assertAlmostEqual(found.value, 586080.586, places=2)
        same = adore.find("hertz", between=(1e3, 1e7), question="contact-load-for-approach=4e-3", inputs=inputs)
        self.assertAlmostEqual(same.value, found.value, places=2)
        self.assertIn("quiet-load", adore.find_questions())
        self.assertEqual(adore.find_targets()["largest_pressure_Pa"][0], "Pa")

    def test_wrong_requests_are_errors(self):
        deck = adore.new("ball")
        for request in ({"unknown": "appLoadX"}, {"unknown": "appLoadX", "target": "nothing=1"}, {"unknown": "apLoadX", "target": "load_x_N=1"},
                        {"question": "quiet-load", "target": "load_x_N=1"}):  # fmt: skip
            with self.subTest(request), self.assertRaises(adore.InputError):
                adore.find(deck, between=(1, 2), **request)


if __name__ == "__main__":
    unittest.main()
