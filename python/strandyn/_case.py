"""Cases as dicts: the tables of a case file, nested as TOML nests them."""

import math
import numbers
from collections.abc import Mapping, Sequence


def _value(value):
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        escaped = value.replace("\\", "\\\\").replace('"', '\\"')
        return '"' + "".join(c if c >= " " else f"\\u{ord(c):04x}" for c in escaped) + '"'
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        number = float(value)
        if not math.isfinite(number):
            raise ValueError(f"{number} is no number of a case file")
        return repr(number)
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{_key(k)} = {_value(v)}" for k, v in value.items()) + " }"
    if isinstance(value, Sequence) or hasattr(value, "tolist"):
        entries = value.tolist() if hasattr(value, "tolist") else value
        if not isinstance(entries, Sequence):  # a numpy scalar
            return _value(entries)
        return "[" + ", ".join(_value(entry) for entry in entries) + "]"
    raise TypeError(f"{type(value).__name__} has no place in a case file")


def _key(key):
    plain = key and all(c.isascii() and (c.isalnum() or c in "-_") for c in key)
    return key if plain else _value(str(key))


def to_toml(case):
    """The text of a case file. Dicts are tables, lists of dicts arrays of tables."""
    lines = []

    def write(table, path):
        inner = []
        for key, value in table.items():
            is_tables = isinstance(value, Sequence) and not isinstance(value, str) and value and all(
                isinstance(entry, Mapping) for entry in value)
            if isinstance(value, Mapping) or is_tables:
                inner.append((key, value))
            elif value is not None:
                lines.append(f"{_key(key)} = {_value(value)}")
        for key, value in inner:
            name = ".".join([*path, _key(key)])
            if isinstance(value, Mapping):
                lines.append(f"\n[{name}]")
                write(value, [*path, _key(key)])
                continue
            for entry in value:
                lines.append(f"\n[[{name}]]")
                write(entry, [*path, _key(key)])

    write(case, [])
    return "\n".join(lines) + "\n"
