#!/usr/bin/env python3
"""RUNS.csv opens in pandas, STUDY.h5 in h5py: the same numbers, units and words. Where Octave is installed, both open there too.

    open_tables.py ADORE

Exit 0: so it is. 1: not. 77: pandas or h5py is not installed (packages python3-pandas, python3-h5py).
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

try:
    import h5py
    import numpy
    import pandas
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)


def study(adore, folder, name, text):
    (folder / f"{name}.json").write_text(json.dumps({"adore_study": 1, "deck": "DATA.txt", **text}))
    subprocess.run([adore, "study", "run", f"{name}.json", "--quiet"], cwd=folder, check=False)
    return folder / f"{name}.study"


def plain(text):
    """Texts of a fixed length come as bytes."""
    return text.decode() if isinstance(text, bytes) else str(text)


def compare(folder, rows, varied, quantities):
    frame = pandas.read_csv(folder / "RUNS.csv", float_precision="round_trip")  # its default loses the last bit
    assert len(frame) == rows, (len(frame), rows)
    assert list(frame["run"]) == list(range(1, rows + 1))
    with h5py.File(folder / "STUDY.h5") as table:
        assert table.attrs["program"] and table.attrs["study"] and "SI" in str(table.attrs["conventions"])
        assert list(table["run"][:]) == list(frame["run"])
        exits = frame["exit"].fillna(-1)
        assert list(table["exit"][:]) == list(exits)
        for group, names in (("variables", varied), ("quantities", quantities)):
            assert set(table[group] if group in table else []) == set(names), names
            for name, unit in names.items():
                values = table[group][name]
                heading = f"{name} [{unit}]" if unit else name
                assert values.dtype == numpy.float64 and values.shape == (rows,)
                assert not unit or plain(values.attrs["unit"]) == unit, values.attrs["unit"]
                numpy.testing.assert_array_equal(values[:], frame[heading].to_numpy(float))
        words = [plain(text) for text in table["message"][:]]
        assert words == list(frame["message"].fillna("")), words
        # As a separate frame, for users who never open the CSV.
        pandas.DataFrame({name: table["quantities"][name][:] for name in quantities}, index=table["run"][:])
    return frame


def compare_in_octave(folder, quantity):
    """MATLAB's dialect, and its order of dimensions. Octave reads no text that is declared as UTF-8."""
    read = (f'h = load("{folder}/STUDY.h5"); c = dlmread("{folder}/RUNS.csv", ",", 1, 0);'
            f'printf("%.17g %.17g %d\\n", h.quantities.{quantity}(1), c(1, 5), rows(h.message) > 0)')
    said = subprocess.run(["octave-cli", "--norc", "--eval", read], capture_output=True, text=True, check=False)
    assert said.returncode == 0 and "warning" not in said.stderr, said.stderr
    of_h5, of_csv, words = said.stdout.split()
    with h5py.File(folder / "STUDY.h5") as table:
        assert float(of_h5) == float(of_csv) == table["quantities"][quantity][0] and words == "1", said.stdout


def main():
    adore = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory(prefix="adore-tables-") as passing:
        folder = pathlib.Path(passing)
        subprocess.run([adore, "new", "ball", "--out", "DATA.txt"], cwd=folder, check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)
        load = {"largest_contact_load_N": "N", "life_lp_hours": "hr"}
        # The last value of the list cannot be: its run keeps its diagnosis, a text with commas and quotes may stand in it.
        frame = compare(study(adore, folder, "sweep", {
            "kind": "sweep", "set": {"mode": -1}, "quantities": list(load),
            "variables": [{"name": "appLoadX", "list": [500, 1000]}, {"name": "freeConAng", "list": [15, 25, 400]}]}),
            6, {"appLoadX": "N", "freeConAng": "deg"}, load)
        if shutil.which("octave-cli"):
            compare_in_octave(folder / "sweep.study", "largest_contact_load_N")
        assert sum(frame["exit"] != 0) == 2 and frame["message"].notna().sum() == 2, frame
        compare(study(adore, folder, "what-if", {
            "kind": "what-if", "set": {"mode": -1}, "quantities": list(load),
            "cases": [{"name": "half, as it \"were\"", "set": {"appLoadX": 750}}]}), 2, {}, load)
    print("RUNS.csv and STUDY.h5 open in pandas and h5py with equal numbers, units and words")


if __name__ == "__main__":
    main()
