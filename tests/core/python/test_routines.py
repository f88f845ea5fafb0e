"""Routines of the user in Python: the same trajectories, the cost, and errors."""

import tempfile
import time
import unittest
import warnings
from pathlib import Path

import numpy as np

import adore


def value(slip):
    """The program's own curve of record 10.1A: (A + B u) exp(-C u) + D."""
    return -0.06 * np.exp(-5.0 * slip) + 0.06


def traction(table=False):
    """The same as a routine of the user."""
    routines = adore.Routines("exp 1")
    how = {"table": True} if table else {}
    law = value if table else lambda slip, contact: value(slip)
    routines.traction("element_race", slip_scale=0.2, **how)(law)
    return routines


def formula(folder):
    """The same through the solver's own formulas."""
    file = Path(folder) / "law.json"
    file.write_text('{"version": "exp 1", "adrx7": {"element_race": {"formula": "0.06-0.06*exp(-5*u)", "slip_scale": "0.2"}}}')
    return file


def built_in():
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return adore.new("ball").copy(kTracType=-1, reRaceTC1=-0.06, reRaceTC2=0, reRaceTC3=5, reRaceTC4=0.06)


def deck():
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return built_in().copy(kTrac=-1)


class Traction(unittest.TestCase):
    def test_function_table_and_formula_give_the_trajectory_of_the_built_in_law(self):
        # Constant steps: automatic ones answer rounding (1e-13) and the error of the table (1e-7) with other stored times.
        # Equilibria do not know routines: all runs start by the spin rule.
        steps = {"stpInit": 0.5, "stpMin": 0.5, "stpMax": 0.5}
        how = {"until": "0.1rev", "progress": False, "options": {"ballFriction": "spin-rule"}}
        own = built_in().copy(**steps).run(**how)
        with tempfile.TemporaryDirectory() as folder:
            runs = [deck().copy(**steps).run(user=user, **how) for user in (formula(folder), traction(), traction(True))]
        for run, least in zip(runs, (1e-9, 1e-9, 1e-7)):
            for channel in ("contact.load", "contact.heat", "element.orbital_velocity"):
                scale = np.abs(own[channel]).max()
                self.assertLess(np.abs(run[channel] - own[channel]).max() / scale, least, channel)

    def test_the_table_states_its_error_and_keeps_to_it(self):
        routines = traction(True)
        self.assertLess(routines.errors["element_race"], 1e-7)
        self.assertIn("element_race table: relative error up to", repr(routines))
        slip = np.geomspace(1e-6, 50.0, 777)
        x, y, error = adore.routines._tabulated(value, 0.2, 100.0, 1e-7)
        found = adore._core.interpolate(x, y, slip)
        # Probes stand at seven places of each interval: elsewhere the table is hardly worse.
        self.assertLess(np.abs(found - value(slip)).max() / 0.06, 1.5e-7)

    def test_a_table_costs_less_than_three_times_the_built_in_law_and_the_direct_cost_is_printed(self):
        def seconds(d, user):
            best = np.inf
            for _ in range(3):
                begin = time.process_time()
                d.run(until="0.5rev", progress=False, user=user)
                best = min(best, time.process_time() - begin)
            return best

        tabulated = traction(True)
        self.assertLess(seconds(deck(), tabulated), 3.0 * seconds(built_in(), None))
        self.assertEqual(tabulated.cost(), "no Python calls during the run")
        direct = traction()
        deck().run(until="0.05rev", progress=False, user=direct)
        self.assertRegex(direct.cost(), r"\d+ Python calls during the run, [\d.]+ µs each")

    def test_the_version_of_the_user_is_in_the_report(self):
        run = deck().run(until="0.01rev", progress=False, user=traction())
        self.assertIn("exp 1", str(run.report))


class Others(unittest.TestCase):
    def test_a_force_law_gets_arrays_of_contacts(self):
        routines, seen = adore.Routines(), []

        @routines.force("pocket")
        def law(contacts):
            seen.append(len(contacts.gap))
            self.assertTrue((contacts.gap < 0).all())
            return contacts.built_in

        own = adore.new("ball").run(until="0.3rev", progress=False, user=routines)
        built_in = adore.new("ball").run(until="0.3rev", progress=False)
        self.assertGreater(len(seen), 10)
        np.testing.assert_allclose(own["pocket.force"], built_in["pocket.force"], rtol=1e-9, atol=1e-9)

    def test_channels_and_a_load_in_mode_2_are_those_of_formulas(self):
        routines, seen = adore.Routines(), []
        routines.motion(lambda now: {} if now.start else {"force": [0, 0, 0, 0, 0, 300.0]})

        @routines.results
        def write(step):
            if not step.start:
                np.testing.assert_array_equal(step.channels["contact.load"], step.load.ravel())
                seen.append(step.channels["race.z"][1])

        deck = adore.new("ball").copy(mode=2)
        deck.run(until="1e-4s", progress=False, user=routines)
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "load.json"
            file.write_text('{"adrx1": {"inner_race": {"force": ["0", "0", "300"]}}, "adrx9": {"channels": ["race.z[2]"]}}')
            run = deck.run(until="1e-4s", progress=False, user=file)
            rows = [line.split() for line in (run.folder / "SOL9").read_text().splitlines()]
        column = [float(row[1]) for row in rows if len(row) == 2 and row[0][0].isdigit()]
        self.assertGreater(len(seen), 3)
        np.testing.assert_allclose(seen[-1], column[-1], rtol=1e-12)

    def test_results_go_to_sol9_and_the_heat_adds_up(self):
        routines, heat = adore.Routines(), []

        @routines.results
        def write(step):
            if step.start:
                return "step time heat\n"
            heat.append((step.total_heat, step.source_heat.sum()))
            return f"{step.step} {step.time} {step.total_heat}\n"

        run = adore.new("ball").run(until="0.1rev", progress=False, user=routines)
        text = (run.folder / "SOL9").read_text()
        self.assertIn("step time heat", text)
        self.assertGreater(len(heat), 1)
        for total, sources in heat:
            self.assertAlmostEqual(total, sources, delta=1e-9 * abs(total))


class Surfaces(unittest.TestCase):
    def waves(self):
        """Waves of the inner race, with amplitude, number and phase from record 12.1."""
        routines = adore.Routines("waves 1")
        routines.read("races", 3)

        @routines.races
        def law(places):
            amplitude, number, phase = places.numbers
            return {"radius": amplitude * np.sin(number * places.azimuth + phase) if places.race == "inner_race" else 0.0}

        return routines

    def with_lines(self, deck, *lines):
        return adore.Deck.from_text(deck.source() + "".join(f"{line}\n" for line in lines))

    def test_waves_by_a_routine_that_reads_record_12_are_those_of_the_deck(self):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            of_deck = adore.new("ball").copy(kRaceGeoImp2=2, rndVar12=1e-6, rndVar22=9, rndVar32=0.3)
            asks = self.with_lines(adore.new("ball").copy(kRaceGeoImp2=3), f"1e-6 9 {np.radians(0.3):.17g}")
        routines = self.waves()
        self.assertFalse([issue for issue in asks.check(user=routines) if issue.severity == "error"])
        a = of_deck.run(until="0.05rev", progress=False)
        b = asks.run(until="0.05rev", progress=False, user=routines)
        for channel in ("contact.load", "element.orbital_velocity"):
            np.testing.assert_allclose(b[channel], a[channel], rtol=1e-6, atol=1e-9 * np.abs(a[channel]).max())

    def test_check_names_what_routines_make_of_a_deck(self):
        issues = adore.new("ball").check(user=self.waves())
        self.assertIn("needs 3 numbers", " ".join(issue.text for issue in issues))
        routines = adore.Routines()
        routines.elements(lambda places: 1e-6 * np.sin(places.azimuth))
        self.assertIn("out-of-round", " ".join(issue.text for issue in adore.new("cylindrical").check(user=routines)))
        routines = adore.Routines()
        routines.force("flange")(lambda contacts: contacts.built_in)
        self.assertIn("no flanges", " ".join(issue.text for issue in adore.new("ball").check(user=routines)))

    def test_larger_elements_by_adrx5_and_by_adrx8_are_the_same(self):
        larger = np.where(np.arange(16) % 2 == 1, 1e-6, 0.0)
        by_radius, by_table = adore.Routines(), adore.Routines()
        by_radius.elements(lambda places: 0.5 * larger[places.element])
        by_table.imperfections(lambda bearing: {"diameter": larger[: bearing.n]})
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            listed = adore.new("ball").copy(kReGeoImp=3)
        a = adore.new("ball").run(until="0.1rev", progress=False, user=by_radius)
        b = listed.run(until="0.1rev", progress=False, user=by_table)
        np.testing.assert_array_equal(a["contact.load"], b["contact.load"])


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
        self.check(lambda slip, contact: "text", "not an array of numbers")

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
