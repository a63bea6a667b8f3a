"""What the program does, as functions."""

import concurrent.futures
import json
import os
import shutil
import tempfile
import weakref
from collections.abc import Mapping
from pathlib import Path

import numpy as np

from ._case import to_toml, _value
from ._program import InputError, NotConverged, call, raise_for
from ._result import Result


class _Folder:
    """A folder of its own, removed with the last object that holds on to it."""

    def __init__(self):
        self.path = Path(tempfile.mkdtemp(prefix="strandyn-"))
        weakref.finalize(self, shutil.rmtree, self.path, ignore_errors=True)


def _case_file(case, folder):
    if not isinstance(case, Mapping):
        return Path(case)
    path = folder / "case.toml"
    path.write_text(to_toml(case), encoding="utf-8")
    return path


def _sets(overrides):
    arguments = []
    for key, value in (overrides or {}).items():
        arguments += ["--set", f"{key}={_value(value)}"]
    return arguments


def run(case, *, out=None, overrides=None, progress=None, resume=False, strict=True):
    """Runs a case: the path of a file, or a dict of its tables.

    `out` is the folder of the results; without it they lie in a temporary one that goes with the result. `overrides`
    are those of --set, {"span.length_m": 20}. `progress(part, words)` is told how far it is. Where the run ends early or
    breaks a bound or an acceptance of the case, NotConverged is raised, or with `strict=False` the result is returned.
    """
    own = _Folder()
    folder = Path(out) if out is not None else own.path / "results"
    arguments = ["run", _case_file(case, own.path), "--out", folder, *_sets(overrides)]
    if resume:
        arguments.append("--resume")
    code, _, said = call(arguments, progress)
    if code not in (0, 3, 130) or not (folder / "summary.json").is_file():
        raise_for(code, said)
    result = Result(folder)
    if out is None:
        result.lies_in = own
    if code != 0 and strict:
        raise NotConverged(result.summary.get("message", result.status), result)
    return result


def check(case, *, overrides=None):
    """Raises InputError where `run` would refuse the case."""
    own = _Folder()
    code, _, said = call(["check", _case_file(case, own.path), *_sets(overrides)])
    if code != 0:
        raise_for(code, said)


def describe(case, *, overrides=None):
    """What will be modelled and what it will cost, as a dict."""
    own = _Folder()
    code, printed, said = call(["describe", _case_file(case, own.path), "--json", *_sets(overrides)])
    if code != 0:
        raise_for(code, said)
    return json.loads(printed)


def run_many(case, variants, *, workers=None, strict=True):
    """The results of one case under several overrides, in their order, computed on all cores."""
    workers = workers or os.cpu_count()
    with concurrent.futures.ThreadPoolExecutor(workers) as pool:
        jobs = [pool.submit(run, case, overrides=overrides, strict=strict) for overrides in variants]
        return [job.result() for job in jobs]


def conductors():
    """Names of the catalogue."""
    code, printed, said = call(["conductors"])
    if code != 0:
        raise_for(code, said)
    lines = printed.splitlines()
    start = next(i for i, line in enumerate(lines) if line.startswith("---"))
    names = []
    for line in lines[start + 1:]:
        if not line.strip():
            break
        names.append(line.split()[0])
    return names


def conductor(name):
    """A conductor of the catalogue as the table [conductor] of a case."""
    import tomllib

    code, printed, said = call(["conductors", name])
    if code != 0:
        raise_for(code, said)
    return tomllib.loads(printed)["conductor"]


def section_path(conductor, *, tension_N, curvature_per_m, law="return-map", points=36, friction=None):
    """The moment of a section along a path of curvature under a tension.

    conductor: name or table; tension_N, curvature_per_m: numbers or arrays along the path, broadcast against each other.
    Returns a Table with the columns of path.csv, M2_N_m and the energies among them.
    """
    own = _Folder()
    tension, curvature = np.broadcast_arrays(np.atleast_1d(np.asarray(tension_N, float)),
                                             np.atleast_1d(np.asarray(curvature_per_m, float)))
    lines = ["tension_N,curvature_2_per_m"] + [f"{t!r},{c!r}" for t, c in zip(tension.tolist(), curvature.tolist())]
    (own.path / "path.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    table = dict(conductor) if isinstance(conductor, Mapping) else {"catalogue": conductor}
    if friction is not None:
        table["friction"] = friction
    case = {"title": "a path of curvature", "conductor": table, "section": {"law": law, "points": points},
            "analysis": {"type": "section", "path": "path.csv"}}
    result = run(_case_file(case, own.path), out=own.path / "results")
    return result.table("path")


def self_damping(conductor, *, frequencies_Hz, tensions_rts, velocities_m_per_s=None, amplitude_over_diameter=None,
                 law="compliant", friction=0.5, method="quadrature", air=False):
    """Points of a self-damping study and what is fitted to them, as a Result."""
    analysis = {"type": "self-damping", "method": method, "frequencies_Hz": list(frequencies_Hz),
                "tensions_rts": list(tensions_rts)}
    if velocities_m_per_s is not None:
        analysis["antinode_velocity_m_per_s"] = list(velocities_m_per_s)
    if amplitude_over_diameter is not None:
        analysis["amplitude_over_diameter"] = list(amplitude_over_diameter)
    table = dict(conductor) if isinstance(conductor, Mapping) else {"catalogue": conductor}
    case = {"title": "self-damping", "conductor": {**table, "friction": friction}, "section": {"law": law},
            "analysis": analysis}
    if air:
        case["air"] = {"density_kg_per_m3": 1.204}
    return run(case)
