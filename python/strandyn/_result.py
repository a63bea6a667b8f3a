"""Results of a run: summary.json, its tables, its fields."""

import csv
import json
from pathlib import Path

import numpy as np

_units = [
    ("_N_s_per_m2", "N s/m^2"), ("_N_s_per_m", "N s/m"), ("_kg_m_per_s", "kg m/s"), ("_N_s", "N s"),
    ("_kg_per_m3", "kg/m^3"), ("_kg_per_m", "kg/m"), ("_N_per_mm", "N/mm"), ("_N_per_m", "N/m"), ("_W_per_m", "W/m"),
    ("_J_per_m", "J/m"), ("_m_per_s", "m/s"), ("_rad_per_m", "rad/m"), ("_per_mm", "1/mm"), ("_per_m", "1/m"),
    ("_kg_m2", "kg m^2"), ("_N_m2", "N m^2"), ("_kN_m", "kN m"), ("_N_m", "N m"), ("_mm4", "mm^4"), ("_mm2", "mm^2"),
    ("_m4", "m^4"), ("_m2", "m^2"), ("_um", "um"), ("_mm", "mm"), ("_km", "km"), ("_m", "m"), ("_MN", "MN"),
    ("_kN", "kN"), ("_N", "N"), ("_mJ", "mJ"), ("_J", "J"), ("_mW", "mW"), ("_W", "W"), ("_Hz", "Hz"), ("_ms", "ms"),
    ("_s", "s"), ("_deg", "degree"), ("_rad", "rad"), ("_GPa", "GPa"), ("_MPa", "MPa"), ("_Pa", "Pa"), ("_kg", "kg"),
    ("_B", "B"),
]


def unit_of(name):
    """The unit that the name of a column or key ends with: "W/m" of self_damping_W_per_m; "" where it has none."""
    for suffix, unit in _units:
        if name.endswith(suffix) and len(name) > len(suffix):
            return unit
    return ""


class Table(dict):
    """Columns by name, numpy arrays of equal length."""

    @classmethod
    def read(cls, path):
        with open(path, newline="", encoding="utf-8") as file:
            rows = csv.reader(file)
            names = next(rows)
            values = np.array([[float(x) for x in row] for row in rows], dtype=float).reshape(-1, len(names))
        return cls((name, values[:, i].copy()) for i, name in enumerate(names))

    def unit(self, name):
        return unit_of(name)

    def __len__(self):
        return len(next(iter(self.values()), ()))

    def __bool__(self):
        return len(self) > 0


class Result:
    """What a run left in its folder.

    `summary` is summary.json as a dict; `result["steady.self_damping_W_per_m"]` or `result["modes[0].frequency_Hz"]`
    looks a number up in it. `findings` and `warnings` are sentences, `tables` the names of the CSV files.
    """

    def __init__(self, folder):
        self.folder = Path(folder)
        with open(self.folder / "summary.json", encoding="utf-8") as file:
            self.summary = json.load(file)
        self._read = {}

    @property
    def status(self):
        return self.summary["status"]

    @property
    def findings(self):
        return self.summary.get("findings", [])

    @property
    def warnings(self):
        return self.summary.get("warnings", [])

    @property
    def tables(self):
        return [name.removesuffix(".csv") for name in self.summary["files"] if name.endswith(".csv")]

    def __getitem__(self, path):
        value = self.summary
        for part in path.replace("[", ".[").split("."):
            value = value[int(part[1:-1])] if part.startswith("[") else value[part]
        return value

    def table(self, name):
        """A table by the name of its file, without ".csv"."""
        if name not in self._read:
            self._read[name] = Table.read(self.folder / f"{name}.csv")
        return self._read[name]

    def dataset(self, name, index=None):
        """A table as an xarray.Dataset along `index` (its first column unless given), with units in the attributes."""
        import xarray

        table = self.table(name)
        index = index or next(iter(table))
        data = xarray.Dataset({column: (index, values) for column, values in table.items() if column != index},
                              coords={index: table[index]}, attrs={"title": self.summary["title"]})
        for column in table:
            data[column].attrs["units"] = unit_of(column)
        return data

    def fields(self):
        """fields.vtkhdf as a dict of numpy arrays: time [moment], points [node, 3], and every array
        [moment, node or element (, 3)]. Needs h5py."""
        import h5py

        with h5py.File(self.folder / "fields.vtkhdf", "r") as file:
            root = file["VTKHDF"]
            steps = root["Steps"]
            moments = int(steps.attrs["NSteps"])
            found = {"time": steps["Values"][:moments], "points": root["Points"][:]}
            for group in ("PointData", "CellData"):
                for name, data in root[group].items():
                    rows = data[:]
                    entries = len(rows) // len(steps["Values"])
                    found[name] = rows[:moments * entries].reshape(moments, entries, *rows.shape[1:])
        return found


def open_result(folder):
    """The results that an earlier run left in a folder."""
    return Result(folder)
