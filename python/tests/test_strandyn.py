"""Run with `python3 -m unittest discover -s python/tests` or with pytest. Needs numpy, and the program."""

import csv
import json
import os
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import numpy as np

import strandyn

DECAY = {
    "title": "a decay", "conductor": {"catalogue": "curlew", "friction": 0.5},
    "section": {"law": "return-map", "points": 20}, "span": {"length_m": 8, "tension_rts": 0.2, "elements": 40},
    "integrator": {"method": "generalized-alpha", "steps_per_cycle": 50},
    "analysis": {"type": "decay", "mode": 4, "antinode_amplitude_mm": 8, "cycles": 3},
}


class Cases(unittest.TestCase):
    def test_a_dict_is_the_case_that_toml_says(self):
        import tomllib

        case = {"title": 'a "quoted" \\ title', "span": {"length_m": 30, "nodes_m": [[0, 0, 0], [1.5, 0, 0]]},
                "load": [{"type": "table", "history": [[0, 1e-300], [0.1, -2]]}, {"at_m": np.float64(0.1)}],
                "accept": {"steady.x": {"below": 3, "reason": "r"}}, "flag": True, "none": None,
                "array": np.array([1.0, 2.5])}
        read = tomllib.loads(strandyn.to_toml(case))
        case.pop("none")
        case["array"] = [1.0, 2.5]
        self.assertEqual(read, case)

    def test_what_is_no_case_is_refused_here(self):
        self.assertRaises(ValueError, strandyn.to_toml, {"x": float("nan")})
        self.assertRaises(TypeError, strandyn.to_toml, {"x": object()})


class Runs(unittest.TestCase):
    def test_numbers_are_those_of_the_files_to_the_bit(self):
        with tempfile.TemporaryDirectory() as folder:
            result = strandyn.run(DECAY, out=Path(folder) / "out")
            with open(Path(folder) / "out" / "cycles.csv", newline="") as file:
                rows = list(csv.DictReader(file))
            cycles = result.table("cycles")
            self.assertEqual(len(cycles), 3)
            for name, column in cycles.items():
                self.assertEqual([float(row[name]) for row in rows], column.tolist())
            summary = json.loads((Path(folder) / "out" / "summary.json").read_text())
            self.assertEqual(result["steady.self_damping_W_per_m"], summary["steady"]["self_damping_W_per_m"])
            self.assertEqual(result["figures[0].name"], summary["figures"][0]["name"])
            again = strandyn.open_result(Path(folder) / "out")
            self.assertEqual(again.summary, summary)
            self.assertIn("per cycle", result.findings[0])

    def test_without_a_folder_the_results_live_as_long_as_the_result(self):
        result = strandyn.run(DECAY, overrides={"analysis.cycles": 1})
        folder = result.folder
        self.assertEqual(len(result.table("cycles")), 1)
        self.assertTrue(folder.is_dir())
        del result
        self.assertFalse(folder.exists())

    def test_progress_is_told(self):
        parts = []
        strandyn.run(DECAY, progress=lambda part, words: parts.append(part))
        self.assertEqual(parts[-1], 1.0)
        self.assertEqual(parts, sorted(parts))

    def test_a_case_that_is_wrong_says_where_and_what_would_be_right(self):
        wrong = {**DECAY, "span": {"length_m": -3, "tension_rts": 0.2, "elments": 40}}
        with self.assertRaises(strandyn.InputError) as caught:
            strandyn.run(wrong)
        keys = {error["key"] for error in caught.exception.errors}
        self.assertEqual(keys, {"span.length_m", "span.elments"})
        self.assertTrue(all(error["line"] > 0 and error["remedy"] for error in caught.exception.errors))
        self.assertRaises(strandyn.InputError, strandyn.check, wrong)
        strandyn.check(DECAY)

    def test_a_broken_bound_keeps_the_result(self):
        case = {**DECAY, "accept": {"steady.loss_factor": {"below": 0, "reason": "cannot be"}}}
        with self.assertRaises(strandyn.NotConverged) as caught:
            strandyn.run(case)
        self.assertGreater(caught.exception.result["steady.loss_factor"], 0)
        self.assertEqual(strandyn.run(case, strict=False).status, "failed")

    def test_many_variants_come_back_in_their_order(self):
        results = strandyn.run_many(DECAY, [{"analysis.cycles": n} for n in (2, 1, 3)])
        self.assertEqual([len(result.table("cycles")) for result in results], [2, 1, 3])

    def test_an_interrupt_keeps_what_was_computed(self):
        program = f"""
import sys
sys.path.insert(0, {str(Path(strandyn.__file__).parents[1])!r})
import strandyn
try:
    strandyn.run({DECAY!r}, out=sys.argv[1], overrides={{"analysis.cycles": 100000}})
except KeyboardInterrupt:
    sys.exit(77)
"""
        with tempfile.TemporaryDirectory() as folder:
            import signal

            child = subprocess.Popen([sys.executable, "-c", program, f"{folder}/out"], start_new_session=True)
            deadline = time.monotonic() + 60
            while not (Path(folder) / "out" / "cycles.csv").exists() and time.monotonic() < deadline:
                time.sleep(0.1)
            time.sleep(0.5)
            child.send_signal(signal.SIGINT)
            self.assertEqual(child.wait(timeout=30), 77)
            self.assertEqual(strandyn.open_result(f"{folder}/out").status, "interrupted")


class Sections(unittest.TestCase):
    def test_a_path_sticks_then_slips(self):
        chi = np.linspace(0, 0.1, 101)
        path = strandyn.section_path("curlew", tension_N=24.4e3, curvature_per_m=chi)
        moment = path["M2_N_m"]
        first, last = moment[1] / chi[1], (moment[-1] - moment[-2]) / (chi[-1] - chi[-2])
        self.assertAlmostEqual(first, 2387.418, delta=0.5)  # EI_max
        self.assertLess(last, 0.2 * first)

    def test_the_catalogue_and_its_tables(self):
        names = strandyn.conductors()
        self.assertGreater(len(names), 100)
        self.assertIn("drake", names)
        self.assertEqual(strandyn.conductor("ACSR Drake")["mass_kg_per_m"], 1.628)


class Units(unittest.TestCase):
    def test_units_are_read_off_names(self):
        for name, unit in [("self_damping_W_per_m", "W/m"), ("frequency_Hz", "Hz"), ("cycle", ""), ("EI_N_m2", "N m^2"),
                           ("speed_m_per_s", "m/s"), ("curvature_per_m", "1/m")]:
            self.assertEqual(strandyn.unit_of(name), unit)

    def test_units_are_those_of_the_program(self):
        import re

        label = Path(__file__).resolve().parents[2] / "src" / "results" / "label.cpp"
        if not label.is_file():
            self.skipTest("the sources are not beside the package")
        pairs = re.findall(r'\{"(_\w+)", "([^"]+)"\}', label.read_text(encoding="utf-8"))
        plain = str.maketrans({"²": "^2", "³": "^3", "⁴": "^4", "µ": "u"})
        self.assertGreater(len(pairs), 40)
        for suffix, unit in pairs:
            unit = "degree" if unit == "°" else unit.translate(plain)
            self.assertEqual(strandyn.unit_of("x" + suffix), unit)

    def test_a_data_set_carries_units(self):
        try:
            import xarray  # noqa: F401
        except ImportError:
            self.skipTest("xarray is not installed")
        data = strandyn.run(DECAY).dataset("cycles")
        self.assertEqual(data["friction_dissipation_J"].attrs["units"], "J")
        self.assertEqual(data.sizes["cycle"], 3)


class Fields(unittest.TestCase):
    def test_fields_are_the_moving_span(self):
        try:
            import h5py  # noqa: F401
        except ImportError:
            self.skipTest("h5py is not installed")
        case = {**DECAY, "output": {"fields_per_cycle": 10}}
        result = strandyn.run(case)
        fields = result.fields()
        self.assertEqual(len(fields["time"]), 31)
        self.assertEqual(fields["displacement"].shape, (31, 41, 3))
        self.assertEqual(fields["tension"].shape, (31, 40))
        lost = fields["dissipated_J_per_m"]
        self.assertTrue((np.diff(lost, axis=0) >= 0).all())
        length = np.diff(fields["points"][:, 0])
        whole = result.table("cycles")["friction_dissipation_J"].sum()
        self.assertAlmostEqual((lost[-1] * length).sum() / whole, 1, delta=0.01)


if __name__ == "__main__":
    unittest.main()
