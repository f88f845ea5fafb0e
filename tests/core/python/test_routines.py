"""Routines of the user in Python: the same trajectories, the cost, and what goes wrong."""

import tempfile
import time
import unittest
from pathlib import Path

import numpy as np

import adore


def traction(table=False):
    """The hypothetical curve of the example, as a function of the user."""
    routines = adore.Routines("tanh 1")

    if table:

        @routines.traction("element_race", table=True, slip_scale=0.2)
        def law(slip):
            return 0.06 * np.tanh(slip / 0.2)

    else:

        @routines.traction("element_race", slip_scale=0.2)
        def law(slip, contact):
            return 0.06 * np.tanh(slip / 0.2)

    return routines


def formula(folder):
    """The same law through the solver's own formulas."""
    file = Path(folder) / "law.json"
    file.write_text('{"version": "tanh 1", "adrx7": {"element_race": {"formula": "0.06*tanh(u/0.2)", "slip_scale": "0.2"}}}')
    return file


def deck():
    out = adore.new("ball")
    out.kTrac = -1
    return out


class Traction(unittest.TestCase):
    def test_function_table_and_formula_give_the_same_trajectory(self):
        with tempfile.TemporaryDirectory() as folder:
            runs = [deck().run(until="0.1rev", progress=False, user=user) for user in (formula(folder), traction(), traction(True))]
        theirs, direct, tabulated = (r["contact.heat"] for r in runs)
        scale = theirs.max()
        # NumPy's tanh and muParser's differ by roundings, which the control of steps lets grow.
        np.testing.assert_allclose(direct, theirs, atol=1e-6 * scale)
        # The table is within 1e-7 of the law, and so is its heat, to what the motion makes of it.
        np.testing.assert_allclose(tabulated, theirs, atol=1e-4 * scale)

    def test_the_table_states_its_error_and_keeps_to_it(self):
        routines = traction(True)
        self.assertLess(routines.errors["element_race"], 1e-7)
        self.assertIn("table of element_race within", repr(routines))
        slip = np.geomspace(1e-6, 50.0, 777)
        x, y, error = adore.routines._tabulated(lambda u: 0.06 * np.tanh(u / 0.2), 0.2, 100.0, 1e-7)
        found = adore._core.interpolate(x, y, slip)
        # Probes stand at seven places of each interval: elsewhere the table is hardly worse.
        self.assertLess(np.abs(found - 0.06 * np.tanh(slip / 0.2)).max() / 0.06, 1.5e-7)

    def test_a_table_costs_less_than_three_times_the_built_in_law_and_the_direct_cost_is_printed(self):
        def seconds(d, user):
            best = np.inf
            for _ in range(3):
                begin = time.process_time()
                d.run(until="0.5rev", progress=False, user=user)
                best = min(best, time.process_time() - begin)
            return best

        tabulated = traction(True)
        self.assertLess(seconds(deck(), tabulated), 3.0 * seconds(adore.new("ball"), None))
        self.assertEqual(tabulated.cost(), "no call of Python while computing")
        direct = traction()
        deck().run(until="0.05rev", progress=False, user=direct)
        self.assertRegex(direct.cost(), r"\d+ calls of Python while computing, [\d.]+ us each")

    def test_the_version_of_the_user_is_in_the_report(self):
        run = deck().run(until="0.01rev", progress=False, user=traction())
        self.assertIn("tanh 1", str(run.report))


class Others(unittest.TestCase):
    def test_a_force_law_gets_arrays_over_all_contacts(self):
        routines, seen = adore.Routines(), []

        @routines.force("pocket")
        def law(contacts):
            seen.append(len(contacts.gap))
            self.assertTrue((contacts.gap < 0).all())
            return contacts.built_in

        own = adore.new("ball").run(until="0.1rev", progress=False, user=routines)
        built_in = adore.new("ball").run(until="0.1rev", progress=False)
        if seen:
            np.testing.assert_allclose(own["pocket.force"], built_in["pocket.force"], rtol=1e-9, atol=1e-9)

    def test_results_go_to_sol9_and_the_heat_adds_up(self):
        routines, heat = adore.Routines(), []

        @routines.results
        def write(step):
            if step.start:
                return "step time heat\n"
            heat.append((step.total_heat, step.source_heat.sum()))
            return f"{step.step} {step.time} {step.total_heat}\n"

        run = adore.new("ball").run(until="0.02rev", progress=False, user=routines)
        text = (run.folder / "SOL9").read_text()
        self.assertIn("step time heat", text)
        self.assertGreater(len(heat), 1)
        for total, sources in heat:
            self.assertAlmostEqual(total, sources, delta=1e-9 * abs(total))


class Wrong(unittest.TestCase):
    def check(self, law, text):
        routines = adore.Routines()
        routines.traction("element_race")(law)
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaises(adore.AdoreError) as caught:
                deck().run(folder, until="0.05rev", progress=False, user=routines)
        self.assertIn("ADRX7", str(caught.exception))
        self.assertRegex(str(caught.exception), text)

    def test_what_a_function_raises_or_returns_wrongly_is_told_with_the_hooks_name(self):
        def fails(slip, contact):
            raise ValueError("my own mistake")

        self.check(fails, "my own mistake")
        self.check(lambda slip, contact: slip * np.nan, "(?i)nan|finite|not a number")
        self.check(lambda slip, contact: np.zeros(3), "has 3 values")
        self.check(lambda slip, contact: "text", "no array of numbers")

    def test_a_law_that_is_no_law_is_refused_when_it_is_given(self):
        routines = adore.Routines()
        with self.assertRaisesRegex(adore.InputError, ">= 0"):
            routines.traction("element_race", table=True)(lambda slip: -slip)
        with self.assertRaisesRegex(adore.InputError, "element_race"):
            routines.traction("balls")(lambda slip, contact: 0.0)
        with self.assertRaisesRegex(adore.InputError, "pocket"):
            routines.force("ball")

    def test_a_deck_that_asks_for_a_routine_gets_none_by_itself(self):
        with self.assertRaises(adore.InputError):
            deck().run(until="0.01rev", progress=False)


if __name__ == "__main__":
    unittest.main()
