"""Checks of arguments that are not arrays: names, flags, files, tables, scenes and robots."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Mapping
from typing import Any, TypeVar, get_args

import numpy as np

from ._arrays import shown
from .exceptions import InputError

_Kind = TypeVar("_Kind")


def text(name: str, value: Any) -> str:
    """Return a string without lone surrogates, so that it can be written to a file."""
    if not isinstance(value, str):
        raise InputError(f"{name}: found {shown(value)}, expected a text")
    try:
        value.encode()
    except UnicodeEncodeError:
        raise InputError(f"{name}: found {value!a}, half of a surrogate pair, expected whole characters") from None
    return str(value)


def function(name: str, value: Any) -> None:
    """Check that a value, if it is given, can be called."""
    if value is not None and not callable(value):
        raise InputError(f"{name}: found {shown(value)}, expected a function")


def one_of(name: str, value: Any, names: Any) -> str:
    """Return one of the names of a ``Literal``."""
    known = get_args(names)
    if (found := text(name, value)) in known:
        return found
    raise InputError(f'{name}: found "{found}", expected one of {", ".join(known)}')


def texts(name: str, values: Any) -> list[str]:
    """Return a sequence of texts as a list."""
    return [text(f"{name}[{k}]", value) for k, value in enumerate(several(name, values, "a sequence of texts"))]


def several(name: str, values: Any, expected: str) -> list[Any]:
    """Return the entries of a sequence; a string does not count as a sequence."""
    try:
        if isinstance(values, (str, bytes)):
            raise TypeError
        return list(values)
    except TypeError:
        raise InputError(f"{name}: found {shown(values)}, expected {expected}") from None


def flag(name: str, value: Any) -> bool:
    """Return True or False."""
    if not isinstance(value, (bool, np.bool_)):
        raise InputError(f"{name}: found {shown(value)}, expected True or False")
    return bool(value)


def file_name(path: Any, name: str = "path") -> str:
    """Return the name of a file, as the system represents it."""
    try:
        found = os.fsdecode(path)
        os.fsencode(found)
    except (TypeError, UnicodeError):
        raise InputError(f"{name}: found {shown(path)}, expected the name of a file") from None
    if "\0" in found:
        raise InputError(f"{name}: found {found!r}, expected a name without zero characters")
    return found


_HINTS = {
    ("Scene", "Robot"): "; its robot is scene.robot",
    ("Robot", "Scene"): "; cdpr.Scene(robot, workspace=...) makes one",
}


def instance(name: str, value: Any, kind: type[_Kind]) -> _Kind:
    """Return a value of this kind."""
    if not isinstance(value, kind):
        hint = _HINTS.get((type(value).__name__, kind.__name__), "")
        raise InputError(f"{name}: found {shown(value)}, expected a {kind.__name__}{hint}")
    return value


def table(name: str, value: Any) -> Mapping[str, Any]:
    """Return a mapping."""
    if not isinstance(value, Mapping):
        raise InputError(f"{name}: found {shown(value)}, expected a mapping")
    return value


# Maximum nesting; also stops at a table that contains itself.
_DEEPEST = 32


def plain(place: str, value: Any, depth: int = 0, known: Callable[[Any], Any] = lambda value: value) -> Any:
    """Convert a value to plain data for a file. `place` is its key path; `known` converts additional types first."""
    value = known(value)
    if depth > _DEEPEST:
        raise InputError(f"{place[:200]}: found tables within tables more than {_DEEPEST} deep, expected fewer")
    if isinstance(value, Mapping):
        where = f"{place}." if place else ""
        return {key: plain(f"{where}{text(place or 'key', key)}", entry, depth + 1, known) for key, entry in value.items()}
    if isinstance(value, np.ma.MaskedArray) and np.ma.getmaskarray(value).any():
        raise InputError(f"{place}: found masked entries, expected numbers")
    if isinstance(value, (np.ndarray, np.generic)):
        value = value.tolist()
    if isinstance(value, (list, tuple)):
        return [plain(f"{place}[{k}]", entry, depth + 1, known) for k, entry in enumerate(value)]
    if isinstance(value, str):
        return text(place, value)
    if isinstance(value, float) and not math.isfinite(value):
        raise InputError(f"{place}: found {value}, expected a finite number")
    if value is None or isinstance(value, (bool, float)) or (isinstance(value, int) and abs(value) < 2**64):
        return value
    raise InputError(f"{place}: found {shown(value)}, expected what a file can hold")
