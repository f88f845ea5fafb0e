"""Runs: files as the command line writes them, progress, interruption, errors, results."""

import os
import signal
import subprocess
import tempfile
import threading
import time
import unittest
from pathlib import Path

import numpy as np

import adore

ADORE = os.environ.get("ADORE_PROGRAM", "")


class Folder(unittest.TestCase):
    def setUp(self):
        self._folder = tempfile.TemporaryDirectory()
        self.addCleanup(self._folder.cleanup)
        self.folder = Path(self._folder.name)


class Files(Folder):
    def test_the_files_are_those_of_the_command_line_to_the_byte(self):
        self.assertTrue(ADORE, "ADORE_PROGRAM names the program adore")
        deck = adore.new("ball")
        for place in ("cli", "python"):
            (self.folder / place).mkdir()
            deck.copy().save(self.folder / place / "DATA.txt")
        subprocess.run([ADORE, "run", "--until", "0.05rev", "--quiet"], cwd=self.folder / "cli", check=True)
        before = os.getcwd()
        os.chdir(self.folder / "python")
        self.addCleanup(os.chdir, before)
        run = adore.read().run(".", until="0.05rev", progress=False)
        compared = 0
        for file in sorted((self.folder / "cli").iterdir()):
            if file.name in ("DATA.txt", "RUN.json", "PRINT.txt", "MASTER") or file.name.startswith("."):
                continue  # RUN.json, PRINT.txt and MASTER hold computing times
            self.assertEqual(file.read_bytes(), (run.folder / file.name).read_bytes(), file.name)
            compared += 1
        self.assertGreaterEqual(compared, 8)
        mine, theirs = run.report, adore.open_run(self.folder / "cli").report
        for report in (mine, theirs):
            report.pop("measured")
        self.assertEqual(mine, theirs)

    def test_a_run_without_a_folder_lives_as_long_as_its_result(self):
        run = adore.new("ball").run(until="0.02rev", progress=False)
        folder = run.folder
        self.assertTrue((folder / "RUN.json").exists())
        del run
        self.assertFalse(folder.exists())

    def test_earlier_results_are_replaced_only_when_it_is_said_and_continued_when_asked(self):
        deck = adore.new("ball")
        deck.run(self.folder, until="0.02rev", progress=False)
        with self.assertRaises(adore.ResultsExistError):
            deck.run(self.folder, until="0.02rev", progress=False)
        more = deck.run(self.folder, until="0.04rev", progress=False, resume=True)
        whole = deck.run(until="0.04rev", progress=False)
        # The first end cut a step short, so that the two differ by the error of a step: tol is 1e-6.
        np.testing.assert_allclose(more["contact.load"][-1], whole["contact.load"][-1], rtol=1e-5)
        self.assertEqual(more["contact.load"].shape[1:], whole["contact.load"].shape[1:])
        deck.run(self.folder, until="0.02rev", progress=False, overwrite=True)
        with self.assertRaises(adore.InputError):
            deck.run(self.folder, until="0.02rev", overwrite=True, resume=True)

    def test_an_opened_run_says_what_the_run_said(self):
        run = adore.new("ball").run(self.folder, until="0.02rev", progress=False)
        opened = adore.open_run(self.folder)
        self.assertEqual(opened.status, "done")
        self.assertEqual(set(opened.summary), set(run.summary))
        for name, value in run.summary.items():
            self.assertAlmostEqual(opened.summary[name], value, delta=1e-12 * abs(value))
        self.assertEqual([f.name for f in opened.files], [f.name for f in run.files])


class Progress(Folder):
    def test_progress_comes_live_and_rises_to_one(self):
        seen = []
        run = adore.new("ball").run(until="5rev", progress=seen.append)  # a few tenths of a second, 20 looks each
        self.assertGreater(len(seen), 2)
        fractions = [p.fraction for p in seen]
        self.assertEqual(fractions, sorted(fractions))
        self.assertEqual(fractions[-1], 1.0)
        self.assertEqual(seen[-1].step, run.outcome.steps)

    def test_a_callback_that_returns_false_ends_the_run_with_valid_files(self):
        run = adore.new("ball").run(self.folder, until="50rev", progress=lambda at: at.fraction < 0.001)
        self.assertEqual(run.status, "interrupted")
        self.assertTrue((self.folder / "FINAL").exists())
        self.assertGreater(len(run.channels.time), 0)

    def test_what_a_callback_raises_ends_the_run_and_comes_out(self):
        def fail(at):
            raise RuntimeError("callback")

        with self.assertRaisesRegex(RuntimeError, "callback"):
            adore.new("ball").run(self.folder, until="50rev", progress=fail)
        self.assertEqual(adore.open_run(self.folder).status, "interrupted")

    def test_ctrl_c_ends_the_run_with_valid_files_which_resume_goes_on_with(self):
        timer = threading.Timer(1.5, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        start = time.monotonic()
        with self.assertRaises(adore.Interrupted) as caught:
            adore.new("ball").run(self.folder, until="2000rev", progress=False)
        timer.join()
        self.assertLess(time.monotonic() - start, 60.0)
        self.assertIsInstance(caught.exception, KeyboardInterrupt)
        self.assertEqual(caught.exception.exit_code, 130)
        run = caught.exception.run
        self.assertEqual(run.status, "interrupted")
        turns = run.outcome.revolutions
        more = adore.new("ball").run(self.folder, until=f"{turns + 0.01}rev", progress=False, resume=True)
        self.assertEqual(more.status, "done")

    def test_the_interpreter_is_free_while_a_run_computes(self):
        ticks, done = [], threading.Event()

        def count():
            while not done.is_set():
                ticks.append(time.monotonic())
                time.sleep(0.005)

        thread = threading.Thread(target=count)
        thread.start()
        begin = time.monotonic()
        adore.new("ball").run(until="0.5rev", progress=False)
        end = time.monotonic()
        done.set()
        thread.join()
        inside = [begin] + [t for t in ticks if begin <= t <= end] + [end]
        gaps = np.diff(inside)
        # Held, the other thread would stand still for the whole run; free, it wakes every few milliseconds. The
        # limit leaves room for a machine that is busy.
        self.assertLess(gaps.max(), 0.5 * (end - begin))
        self.assertGreater(len(inside), 10)


class Errors(Folder):
    def test_numerics_that_give_up_raise_with_the_run(self):
        deck = adore.new("ball")
        with self.assertRaises(adore.AdoreError) as caught:
            deck.run(self.folder, until="1rev", integrator="rkf9", progress=False)
        self.assertIsInstance(caught.exception, adore.InputError)
        self.assertIn("rkf5", str(caught.exception))

    def test_an_equilibrium_that_cannot_be_is_a_solver_error(self):
        deck = adore.new("ball")
        deck.update(appLoadX=4e8)
        with self.assertRaises(adore.SolverError) as caught:
            deck.statics()
        self.assertEqual(caught.exception.exit_code, 3)
        self.assertIsInstance(caught.exception, ArithmeticError)

    def test_an_unknown_option_names_the_valid_ones(self):
        with self.assertRaisesRegex(adore.InputError, "seed"):
            adore.new("ball").plan(sead=3)


class Results(Folder):
    @classmethod
    def setUpClass(cls):
        cls.run_ = adore.new("ball").run(until="0.1rev", progress=False)

    def test_channels_are_arrays_with_a_row_for_each_step(self):
        run = self.run_
        loads = run["contact.load"]
        self.assertEqual(loads.shape, (len(run.channels.time), 12, 2))
        self.assertEqual(run.channels.info("contact.load").unit, "N")
        self.assertAlmostEqual(run.channels.revolutions[-1], 0.1, places=6)
        np.testing.assert_array_equal(run.channels.read("contact.load", first=2, every=3), loads[2::3])
        with self.assertRaisesRegex(adore.InputError, "has no channel"):
            run["contact.laod"]

    def test_data_frames_have_names_units_and_the_same_numbers(self):
        run = self.run_
        frame = run.channels.frame("contact.load", "cage.position")
        np.testing.assert_array_equal(frame["contact.load[3].inner"], run["contact.load"][:, 2, 1])
        self.assertEqual(list(frame.columns[-3:]), [f"cage.position[1].{c}" for c in "xyz"])
        sol = run.table("SOL1")
        self.assertEqual(sol.attrs["units"]["time"], "s")
        # SOL files hold five digits and more.
        np.testing.assert_allclose(sol["contact.load.outer"], run["contact.load"][:, 0, 0], rtol=1e-4)
        h5 = run.table("RESULTS.h5")
        self.assertEqual(len(h5), len(frame))

    def test_a_damaged_file_is_a_sentence(self):
        data = (self.run_.folder / "RESULTS.h5").read_bytes()
        (self.folder / "RESULTS.h5").write_bytes(data[:1000])
        with self.assertRaises(adore.InputError):
            adore.Channels(self.folder / "RESULTS.h5")
        text = (self.run_.folder / "SOL1").read_bytes()
        (self.folder / "SOL1").write_bytes(text[: len(text) * 2 // 3])
        cut = adore.read_table(self.folder / "SOL1")
        self.assertTrue(cut.attrs["note"])
        self.assertGreater(len(cut), 0)

    def test_statics_are_arrays_and_a_table(self):
        for name in ("ball", "tapered"):
            solution = adore.new(name).statics()
            self.assertEqual(solution.stiffness.shape, (5, 5))
            table = solution.table()
            self.assertEqual(table.index[0], 1)
            self.assertAlmostEqual(
                solution.summary["largest_contact_load_N"],
                max(table[c].max() for c in table if c in ("outer load [N]", "inner load [N]")), delta=1e-6,
            )  # fmt: skip
        # The loads that the deck applies are those that the equilibrium carries.
        deck = adore.new("ball")
        np.testing.assert_allclose(deck.statics().load[[0, 2]], [deck.appLoadX, deck.appLoadZ], rtol=1e-6)

    def test_a_sweep_is_a_table_with_a_row_for_each_run(self):
        frame = adore.new("ball").sweep("appLoadX", 1000, 2000, 3, self.folder, until="0.01rev", progress=False)
        self.assertEqual(list(frame["appLoadX"]), [1000.0, 1500.0, 2000.0])
        self.assertEqual(frame.attrs["units"]["appLoadX"], "N")
        self.assertEqual(frame.attrs["exit_code"], 0)

    def test_a_plan_is_text_and_data(self):
        plan = adore.new("ball").plan()
        self.assertIn("effects", plan.text)
        self.assertIn(True, plan.effects.values())


class Pictures(unittest.TestCase):
    def test_a_run_shows_its_chart_and_its_bearing(self):
        if os.environ.get("ADORE_WITH_QT") == "0":
            self.skipTest("this build has no Qt and draws no pictures")
        self.assertIsNotNone(adore.pictures.program())
        run = adore.new("ball").run(until="0.05rev", progress=False)
        chart = run.plot(page=1)[0]
        self.assertTrue(chart.data.startswith(b"\x89PNG"))
        self.assertTrue(run.picture().data.startswith(b"\x89PNG"))
        page = run._repr_html_()
        self.assertEqual(page.count("data:image/png;base64,"), 2)
        self.assertIn("Largest contact load", page)
        self.assertTrue(run._repr_png_().startswith(b"\x89PNG"))
        with tempfile.TemporaryDirectory() as folder:
            files = run.plot("SOL7").save(folder)
            self.assertTrue(all(f.stat().st_size > 1000 for f in files))
        with self.assertRaises(adore.InputError):
            run.picture(frame=100000)

    def test_without_the_program_a_sentence_says_what_is_missing(self):
        os.environ["ADORE_PICTURES"] = "/nowhere/adore-pictures"
        self.addCleanup(os.environ.pop, "ADORE_PICTURES")
        with self.assertRaisesRegex(adore.PicturesMissingError, "does not start"):
            adore.pictures.plot("SOL1")


class Calculators(unittest.TestCase):
    def test_every_calculator_takes_its_own_example(self):
        found = adore.calc.calculators()
        self.assertGreater(len(found), 20)
        for name, calculator in found.items():
            for calculation in calculator.calculations():
                with self.subTest(name=name, kind=calculation.get("kind")):
                    given = dict(calculation["example"])
                    result = calculator(given)
                    self.assertTrue(result)

    def test_results_are_those_of_the_formula_and_have_units(self):
        ball = {"Rx": 0.01, "Ry": 0.01, "E": 2.06e11, "nu": 0.3}
        flat = {"Rx": "inf", "Ry": "inf", "E": 2.06e11, "nu": 0.3}
        result = adore.calc.hertz(body1=ball, body2=flat, load=np.float64(100.0), stress_poisson=0.3)
        e_star = 2.06e11 / (2 * (1 - 0.09))
        self.assertAlmostEqual(result.a, (3 * 100 * 0.01 / (4 * e_star)) ** (1 / 3), delta=1e-12)
        self.assertEqual(result.units["a"], "m")
        self.assertIn("hertz", dir(adore.calc))
        self.assertIn("load", adore.calc.hertz.__doc__)

    def test_wrong_inputs_are_sentences(self):
        with self.assertRaisesRegex(adore.InputError, "laod"):
            adore.calc.hertz(laod=3)
        with self.assertRaises(AttributeError):
            adore.calc.herz


if __name__ == "__main__":
    unittest.main()
