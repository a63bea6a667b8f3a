"""The program behind the package: where it is, how it is called, what its refusals say."""

import os
import re
import shutil
import signal
import subprocess
import threading
from pathlib import Path


class StrandynError(Exception):
    """What all errors of the package have in common."""


class InputError(StrandynError, ValueError):
    """The case is wrong. `errors` lists every fault of the file: file, line, column, key, fault, remedy."""

    def __init__(self, message, errors):
        super().__init__(message)
        self.errors = errors
        first = errors[0] if errors else {}
        for name in ("file", "line", "column", "key", "fault", "remedy"):
            setattr(self, name, first.get(name))


class ComputationError(StrandynError, RuntimeError):
    """Nothing was computed."""


class NotConverged(StrandynError, RuntimeError):
    """The run ended early, or a bound or an acceptance of the case was broken. `result` holds what there is."""

    def __init__(self, message, result):
        super().__init__(message)
        self.result = result


class FileError(StrandynError, OSError):
    """A file could not be read or written."""


def find_program():
    """The path of the program; FileError where there is none."""
    named = os.environ.get("STRANDYN")
    beside = Path(__file__).resolve().parents[2] / "build" / "release" / "strandyn"
    for candidate in (named, shutil.which("strandyn"), beside if beside.is_file() else None):
        if candidate:
            return str(candidate)
    raise FileError("the program strandyn is neither on the PATH nor in build/release; install it, or set STRANDYN")


_place = re.compile(r"^(?:strandyn: )?(?P<file>[^:\n]+):(?P<line>\d+):(?P<column>\d+): (?P<rest>.*)$")


_unknown = re.compile(r"^(?P<fault>unknown \w+) `(?P<key>[^`]+)`; (?P<remedy>.*)$")


def parse_errors(text):
    """FILE:LINE:COLUMN: KEY = VALUE: FAULT; REMEDY, one a line, or that a key is unknown."""
    errors = []
    for line in text.splitlines():
        found = _place.match(line.strip())
        if not found:
            continue
        unknown = _unknown.match(found["rest"])
        if unknown:
            key, fault, remedy = unknown["key"], unknown["fault"], unknown["remedy"]
        else:
            key, _, says = found["rest"].partition(": ")
            key = key.partition(" = ")[0]
            fault, _, remedy = says.partition("; ")
        errors.append({"file": found["file"], "line": int(found["line"]), "column": int(found["column"]), "key": key,
                       "fault": fault, "remedy": remedy})
    return errors


_percent = re.compile(r"^\s*(\d+) %\s+(.*)$")


def call(arguments, progress=None):
    """Runs the program to its end. Returns exit code, standard output, standard error.

    `progress(part, words)` is told how far it is. Ctrl-C stops it as it would on a terminal: what was computed is kept,
    and KeyboardInterrupt goes on.
    """
    process = subprocess.Popen([find_program(), *map(str, arguments)], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True, encoding="utf-8", start_new_session=True)
    said, printed = [], []

    def listen():
        for line in process.stderr:
            said.append(line)
            step = _percent.match(line)
            if step and progress:
                progress(int(step[1]) / 100, step[2].strip())

    def read():
        printed.append(process.stdout.read())

    threads = [threading.Thread(target=task, daemon=True) for task in (listen, read)]
    for thread in threads:
        thread.start()
    try:
        process.wait()
    except BaseException:
        process.send_signal(signal.SIGINT)
        try:
            process.wait(timeout=10)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
        raise
    for thread in threads:
        thread.join()
    process.stdout.close()
    process.stderr.close()
    return process.returncode, "".join(printed), "".join(said)


def raise_for(code, said):
    """The exception of an exit code that left no result."""
    message = "\n".join(line for line in said.splitlines() if not _percent.match(line)).strip()
    message = message.removeprefix("strandyn: ")
    if code == 2:
        raise InputError(message, parse_errors(said))
    if code == 4:
        raise FileError(message)
    raise ComputationError(message or f"strandyn ended with {code}")
