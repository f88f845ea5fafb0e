"""Decks as objects: variables, units, completion, text that stays."""

import copy
import json
import pickle
import tempfile
import unittest
import warnings
from pathlib import Path

import numpy as np

import adore


class Values(unittest.TestCase):
    def setUp(self):
        self.deck = adore.new("ball")

    def test_variables_are_attributes_with_the_manual_names(self):
        self.assertIsInstance(self.deck.nRe, int)
        self.assertIsInstance(self.deck.pitchDia, float)
        self.assertEqual(self.deck.pitchDia, self.deck["pitchDia"])
        self.assertEqual(self.deck.record("5A").pitchDia, self.deck.pitchDia)

    def test_setting_acts_and_is_what_a_run_sees(self):
        self.deck.rpm2 = 12345
        self.assertEqual(self.deck.rpm2, 12345.0)
        self.assertIn("12345.0", self.deck.source())

    def test_units_beside_values_are_converted(self):
        self.deck["pitchDia"] = 60.5, "mm"
        self.assertEqual(self.deck.pitchDia, 0.0605)
        self.assertAlmostEqual(self.deck.get("pitchDia", "in"), 60.5 / 25.4, places=13)
        self.deck.set("appLoadX", 0.8, "kN")
        self.assertEqual(self.deck.appLoadX, 800.0)
        self.assertAlmostEqual(self.deck.get("rpm2", "SI"), self.deck.rpm2 * np.pi / 30, places=9)
        self.assertEqual(self.deck.unit("pitchDia"), "m")

    def test_a_unit_of_something_else_is_refused_with_a_sentence(self):
        with self.assertRaisesRegex(adore.UnitError, "are units of different quantities"):
            self.deck["pitchDia"] = 60.5, "kg"
        with self.assertRaisesRegex(adore.UnitError, "is unknown"):
            self.deck["pitchDia"] = 60.5, "furlong"
        with self.assertRaisesRegex(adore.UnitError, "kelvin"):
            adore.units.factor("degC", "K")
        with self.assertRaisesRegex(adore.UnitError, "without a unit"):
            self.deck["nRe"] = 16, "mm"

    def test_every_unit_of_the_schema_is_understood_and_has_the_factor_of_the_solver(self):
        seen = set()
        for record in json.loads(adore._core.schema_json())["records"]:
            for v in record["variables"]:
                for unit, factor in ((v["unit_si"], v["si_factor"]), (v["unit_en"], v["en_factor"])):
                    if unit not in ("", "-"):
                        self.assertAlmostEqual(adore.units._parse(unit)[0] / factor, 1.0, places=12, msg=f"{v['name']} [{unit}]")
                        seen.add(unit)
        self.assertGreater(len(seen), 30)

    def test_english_decks_keep_their_units(self):
        english = self.deck.in_units("English")
        self.assertEqual(english.unit("pitchDia"), "in")
        self.assertAlmostEqual(english.get("pitchDia", "m"), self.deck.pitchDia, places=12)
        english["pitchDia"] = 60.5, "mm"
        self.assertAlmostEqual(english.pitchDia, 60.5 / 25.4, places=12)

    def test_arrays_cannot_be_changed_behind_the_decks_back(self):
        name = next(n for n in self.deck.variables() if isinstance(self.deck[n], np.ndarray) and len(self.deck[n]) > 1)
        with self.assertRaises(ValueError):
            self.deck[name][0] = 1
        whole = list(self.deck[name])
        self.deck[f"{name}[2]"] = whole[1]
        self.deck[name] = whole
        np.testing.assert_array_equal(self.deck[name], whole)
        self.assertEqual(self.deck[f"{name}[2]"], whole[1])

    def test_a_wrong_value_leaves_the_deck_as_it_was(self):
        before = self.deck.copy()
        with self.assertRaises(adore.InputError) as caught:
            self.deck.update(rpm2=5000, pitchDai=0.06)
        self.assertIn("did you mean pitchDia", str(caught.exception))
        self.assertEqual(self.deck, before)
        with self.assertRaises(adore.InputError):
            self.deck.nRe = 16.5
        with self.assertRaises(adore.InputError):
            self.deck.rpm2 = float("nan")
        self.assertEqual(self.deck, before)

    def test_values_of_no_use_are_refused_by_name(self):
        for value in (None, object(), {}, b"12"):
            before = self.deck.copy()
            with self.assertRaisesRegex(adore.InputError, "^rpm2 = "):
                self.deck.rpm2 = value
            self.assertEqual(self.deck, before)

    def test_it_is_iterated_like_a_dictionary(self):
        self.assertEqual(list(self.deck), self.deck.variables())
        self.assertEqual(len(self.deck), len(set(self.deck)))
        self.assertEqual({name: self.deck[name] for name in self.deck}["nRe"], 12)

    def test_copies_and_pickles_are_decks_of_their_own(self):
        for deck in [adore.new(name) for name in adore.examples()] + [self.deck.in_units("English")]:
            deck.options["contactDamping"] = "0.1"
            for again in (copy.copy(deck), copy.deepcopy(deck), pickle.loads(pickle.dumps(deck))):
                self.assertEqual(again, deck)
                self.assertEqual(again.source(), deck.source())
                self.assertEqual(again.options, deck.options)
                again.rpm2 = 321.0
                again.options["contactDamping"] = "0.2"
                self.assertNotEqual(again, deck)
                self.assertEqual(deck.options["contactDamping"], "0.1")

    def test_a_bearing_of_the_catalogue_is_a_deck(self):
        deck = adore.catalogue("7208 B")
        self.assertEqual((deck.get("brgBore", "mm"), deck.get("brgOD", "mm")), (40.0, 80.0))
        self.assertIn("ESTIMATE", deck.source())
        self.assertGreater(deck.statics().summary["largest_contact_load_N"], 0.0)
        with self.assertRaisesRegex(adore.InputError, "is not in the catalogue"):
            adore.catalogue("99999")

    def test_candidates_of_published_facts_become_a_deck(self):
        facts = {"designation": "6203", "C": "9.6 kN", "C0": "4.8 kN"}
        found = adore.candidates(facts)
        self.assertEqual(found[0]["count"], 8)
        self.assertAlmostEqual(found[0]["element_diameter [m]"], 6.747e-3, 6)
        self.assertEqual(found.given_ratings, {"C [N]": 9600.0, "C0 [N]": 4800.0})
        self.assertIn("BPFO", repr(found))
        self.assertEqual(adore.new(facts=facts, choose=1).nRe, 8)
        self.assertEqual(adore.candidates({"C": "14 kN"}).missing[0], "designation or type")
        wrong = adore.candidates({"designation": "6205", "bore": "30 mm"})
        self.assertIn("bore", wrong.contradictions[0][1])
        for bad in ({"bore": 25}, {"bor": "25 mm"}):
            with self.assertRaises(adore.InputError):
                adore.candidates(bad)
        with self.assertRaises(adore.InputError):
            adore.new("ball", facts=facts)

    def test_a_mistyped_name_is_an_error_with_the_near_ones(self):
        with self.assertRaisesRegex(AttributeError, "pitchDia"):
            self.deck.pitchDai
        with self.assertRaisesRegex(adore.InputError, "pitchDia"):
            self.deck.pitchDai = 0.06
        with self.assertRaises(AttributeError):
            self.deck.run = 3
        with self.assertRaises(AttributeError):
            self.deck.record("5A").rpm2 = 3

    def test_options_bring_their_records_with_a_warning(self):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            self.deck.update(kTherm=1)
        self.assertTrue(any(issubclass(w.category, adore.DeckWarning) for w in caught))
        self.assertEqual(self.deck.kTherm, 1)

    def test_records_that_repeat_come_with_the_instances_first(self):
        names = [r.id for r in self.deck.records]
        for record in self.deck.records:
            spec = adore.schema.records()[record.id]
            if spec.repeat and names.count(record.id) > 1:
                name = record.names[0]
                self.assertEqual(len(self.deck[name]), names.count(record.id))
                self.assertEqual(self.deck[f"{name}[2]"], self.deck.record(record.id, 2)[name])
                return
        self.fail("the example has no repeated record")


class Completion(unittest.TestCase):
    def test_dir_lists_the_variables_that_the_deck_has(self):
        deck = adore.new("ball")
        self.assertIn("pitchDia", dir(deck))
        self.assertIn("run", dir(deck))
        self.assertNotIn("rolLen", dir(deck))
        self.assertEqual(set(deck.record("5A").names), set(dir(deck.record("5A"))) - {"id", "instance", "names", "title"})
        self.assertIn("pitchDia", deck._ipython_key_completions_())

    def test_every_listed_variable_can_be_read(self):
        for name in adore.examples():
            deck = adore.new(name)
            for variable in deck.variables():
                deck[variable]
                self.assertTrue(deck.help(variable))

    def test_no_method_hides_a_variable(self):
        methods = {n for n in dir(adore.Deck) if not n.startswith("_")} | {"id", "instance", "names", "title"}
        self.assertEqual(methods & set(adore.schema.variable_names()), set())


class Text(unittest.TestCase):
    def test_remarks_and_blanks_stay_when_values_change(self):
        deck = adore.new("ball")
        before = deck.source().splitlines()
        deck.rpm2 = deck.rpm2 + 1
        after = deck.source().splitlines()
        changed = [i for i, (a, b) in enumerate(zip(before, after)) if a != b]
        self.assertEqual(len(before), len(after))
        self.assertEqual(len(changed), 1)
        self.assertEqual(adore.Deck.from_text(deck.source()), deck)

    def test_every_change_reads_back_to_the_same_deck(self):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            for changes in ({"kTherm": 1, "baseTemp": 300, "aveTime": 0.1}, {"nRe": 14}, {"rpm1": 10.5, "appLoadZ": -100}, {"kUnit": 2}):
                deck = adore.new("ball").copy(**changes)
                self.assertEqual(adore.Deck.from_text(deck.source()), deck, changes)

    def test_save_writes_what_was_read_and_replaces_nothing_unasked(self):
        with tempfile.TemporaryDirectory() as folder:
            path = adore.new("ball").save(Path(folder) / "DATA.txt")
            text = path.read_bytes()
            deck = adore.read(folder)
            deck.save()
            self.assertEqual(path.read_bytes(), text)
            with self.assertRaisesRegex(adore.InputError, "exists already"):
                adore.new("tapered").save(path)
            adore.new("tapered").save(path, overwrite=True)
            self.assertNotEqual(path.read_bytes(), text)
            self.assertEqual(list(Path(folder).iterdir()), [path])

    def test_save_writes_records_x_into_the_extension_file(self):
        with tempfile.TemporaryDirectory() as folder:
            extension = Path(folder) / "ADORE.json"
            extension.write_text('{"ellipseMajor": 20}')
            deck = adore.new("ball")
            path = deck.save(folder)
            plain = path.read_text()
            self.assertEqual(json.loads(extension.read_text()), {"ellipseMajor": 20})
            deck.update(ratingC=55300.0)
            deck.save()
            self.assertEqual(path.read_text(), plain)
            self.assertEqual(json.loads(extension.read_text()), {"ellipseMajor": 20, "version": 1, "ratingC": 55300.0})
            self.assertEqual(adore.read(folder), deck)


class Errors(unittest.TestCase):
    def test_a_wrong_deck_raises_all_its_sentences(self):
        text = adore.new("ball").source()
        broken = text.replace(str(adore.new("ball").pitchDia), "-0.06", 1)
        with self.assertRaises(adore.InputError) as caught:
            adore.Deck.from_text(broken, "broken.txt")
        error = caught.exception
        self.assertEqual(error.exit_code, 2)
        self.assertIsInstance(error, ValueError)
        self.assertTrue(any(i.variable == "pitchDia" and i.severity == "error" for i in error.issues))
        self.assertIn("broken.txt:", str(error))

    def test_check_says_what_the_command_line_says(self):
        self.assertEqual([i for i in adore.new("ball").check() if i.severity == "error"], [])
        deck = adore.new("ball")
        deck.pitchDia = 0.2
        self.assertTrue(deck.check())
        with tempfile.TemporaryDirectory() as folder:
            with self.assertRaisesRegex(adore.InputError, "there is no DATA.txt"):
                adore.read(folder)

    def test_options_of_an_adore_json_come_with_the_deck_and_nothing_is_loaded(self):
        with tempfile.TemporaryDirectory() as folder:
            adore.new("ball").save(folder)
            (Path(folder) / "ADORE.json").write_text('{"seed": 7}')
            self.assertEqual(adore.read(folder).options, {"seed": "7"})
            (Path(folder) / "ADORE.json").write_text('{"user": "/tmp/evil.so"}')
            with self.assertRaisesRegex(adore.InputError, "no run option named \"user\""):
                adore.read(folder)
            self.assertTrue(any(i.severity == "error" for i in adore.check(folder)))

    def test_variables_of_an_adore_json_are_values_of_the_deck(self):
        with tempfile.TemporaryDirectory() as folder:
            adore.new("ball").save(folder)
            (Path(folder) / "ADORE.json").write_text('{"version": 1, "ratingC": "55.3 kN", "seed": 7}')
            deck = adore.read(folder)
            self.assertAlmostEqual(deck["ratingC"], 55300.0)
            self.assertEqual(deck.options, {"seed": "7"})
            again = adore.Deck.from_text(deck.source())
            self.assertAlmostEqual(again["ratingC"], 55300.0)


if __name__ == "__main__":
    unittest.main()
