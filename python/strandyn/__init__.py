"""strandyn from Python: cases as files or dicts, results as numpy arrays.

>>> import strandyn
>>> result = strandyn.run("cases/curlew_lab_span.toml", overrides={"analysis.cycles": 20})
>>> result["steady.self_damping_W_per_m"]
>>> cycles = result.table("cycles")              # columns as numpy arrays
>>> cycles["friction_dissipation_J"].sum()
>>> result.dataset("cycles")                     # the same as an xarray data set, units in its attributes

Needs numpy; xarray for `dataset`, h5py for `fields`. The work is done by the program `strandyn`, which is looked for in the
environment variable STRANDYN, on the PATH, and in build/release of the source tree. Numbers are those of its files, to the bit.
"""

from ._case import to_toml
from ._program import ComputationError, FileError, InputError, NotConverged, StrandynError, find_program
from ._result import Result, Table, open_result, unit_of
from ._run import check, conductor, conductors, describe, run, run_many, section_path, self_damping

__all__ = [
    "ComputationError", "FileError", "InputError", "NotConverged", "Result", "StrandynError", "Table", "check",
    "conductor", "conductors", "describe", "find_program", "open_result", "run", "run_many", "section_path",
    "self_damping", "to_toml", "unit_of",
]
