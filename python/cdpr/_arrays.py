"""Arrays as the core takes them: float64, C-contiguous, checked for shape and finite numbers."""

from __future__ import annotations

from typing import TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._core import MAX_COORDINATE
from .exceptions import InputError

Floats: TypeAlias = NDArray[np.float64]
Ints: TypeAlias = NDArray[np.int64]


def rows(name: str, values: ArrayLike, columns: int = 3) -> Floats:
    """An (n, columns) array, copied only if it is not C-contiguous float64 already."""
    array = _numbers(name, values)
    if array.ndim != 2 or array.shape[1] != columns:
        raise InputError(f"{name}: found an array of shape {array.shape}, expected (n, {columns})")
    _finite(name, array)
    return array


def point(name: str, values: ArrayLike) -> tuple[float, float, float]:
    """Three numbers."""
    array = _numbers(name, values)
    if array.shape != (3,):
        raise InputError(f"{name}: found an array of shape {array.shape}, expected (3,)")
    _finite(name, array)
    x, y, z = array.tolist()
    return x, y, z


def numbers(name: str, values: ArrayLike, count: int, parts: str = "") -> list[float]:
    """A list of so many numbers; `parts` names them."""
    array = _numbers(name, values)
    if array.shape != (count,):
        named = f": {parts}" if parts else ""
        raise InputError(f"{name}: found an array of shape {array.shape}, expected ({count},){named}")
    if not np.isfinite(array).all():
        raise InputError(f"{name}: found {array}, expected finite numbers")
    found: list[float] = array.tolist()
    return found


def number(name: str, value: float) -> float:
    """One number; texts are none, even where they read like one."""
    try:
        if isinstance(value, (str, bytes)):
            raise TypeError(f"the text {value!r}")
        return float(value)
    except (TypeError, ValueError) as problem:
        raise InputError(f"{name}: found {problem}, expected a number") from None


def whole(name: str, value: int) -> int:
    """A whole number that a seed or a count can be."""
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)) or not 0 <= value < 2**64:
        raise InputError(f"{name}: found {value!r}, expected a whole number from 0 to 2**64 - 1")
    return int(value)


def thread_count(threads: int | None) -> int | None:
    """A number of threads; None is as many as there are cores."""
    return None if threads is None else whole("threads", threads)


def _numbers(name: str, values: ArrayLike) -> Floats:
    try:
        array = np.asarray(values)
        if np.iscomplexobj(array):
            raise TypeError("complex numbers")
        return np.ascontiguousarray(array, dtype=np.float64) if array.ndim else array.astype(np.float64)
    except (TypeError, ValueError) as problem:
        raise InputError(f"{name}: found {problem}, expected numbers") from None


def _finite(name: str, array: Floats) -> None:
    # Least and greatest carry NaN along, and need no array of their own.
    if array.size and not (array.min() >= -MAX_COORDINATE and array.max() <= MAX_COORDINATE):
        good = np.abs(array) <= MAX_COORDINATE
        index = tuple(int(i) for i in np.argwhere(~good)[0])
        place = name + "".join(f"[{i}]" for i in index)
        raise InputError(f"{place}: found {array[index]}, expected finite coordinates up to {MAX_COORDINATE:g} m")
