"""Converts numbers for the core: float64, C-contiguous, checked for shape and finite values."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, TypeAlias, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._core import MAX_COORDINATE, UNIT_QUATERNION
from .exceptions import InputError

Floats: TypeAlias = NDArray[np.float64]
Ints: TypeAlias = NDArray[np.int64]
Shape: TypeAlias = tuple[int, ...]
_Entry = TypeVar("_Entry", bound=np.generic)


def rows(name: str, values: ArrayLike, columns: int = 3) -> Floats:
    """Return an (n, columns) array, copied only if it is not already C-contiguous float64."""
    array = as_numbers(name, values)
    if array.ndim != 2 or array.shape[1] != columns:
        raise InputError(f"{name}: found an array of shape {array.shape}, expected (n, {columns})")
    _in_reach(name, array)
    return array


def flat_points(name: str, values: ArrayLike) -> tuple[Floats, Shape]:
    """Return a (..., 3) array as rows (n, 3), not copied if it is C-contiguous float64, and the leading shape (...)."""
    array = as_numbers(name, values)
    if array.ndim == 0 or array.shape[-1] != 3:
        raise InputError(f"{name}: found an array of shape {array.shape}, expected (..., 3)")
    _in_reach(name, array)
    return array.reshape(-1, 3), array.shape[:-1]


def shaped(answers: NDArray[_Entry], shape: Shape) -> NDArray[_Entry]:
    """Reshape results, one per row of `flat_points`, to the shape of its points; a single result is a NumPy scalar."""
    whole: NDArray[_Entry] = answers.reshape(shape + answers.shape[1:])[()]
    return whole


def point(name: str, values: ArrayLike) -> tuple[float, float, float]:
    """Return three numbers."""
    array = as_numbers(name, values)
    if array.shape != (3,):
        raise InputError(f"{name}: found an array of shape {array.shape}, expected (3,)")
    _in_reach(name, array)
    x, y, z = array.tolist()
    return x, y, z


def flat_quaternions(name: str, values: ArrayLike) -> tuple[Floats, Shape]:
    """Return a (..., 4) array of unit quaternions w x y z as rows (n, 4), and the leading shape (...)."""
    array = as_numbers(name, values)
    if array.ndim == 0 or array.shape[-1] != 4:
        raise InputError(f"{name}: found an array of shape {array.shape}, expected (..., 4): w x y z")
    with np.errstate(over="ignore"):
        lengths = np.asarray(np.linalg.norm(array, axis=-1))
    good = np.abs(lengths - 1.0) <= UNIT_QUATERNION
    if not good.all():
        index = tuple(int(i) for i in np.argwhere(~good)[0])
        place = name + "".join(f"[{i}]" for i in index)
        expected = f"expected length 1 within {UNIT_QUATERNION:g} (w x y z)"
        raise InputError(f"{place}: found a quaternion of length {lengths[index]}, {expected}")
    return array.reshape(-1, 4), array.shape[:-1]


def quaternion(name: str, values: ArrayLike) -> tuple[float, float, float, float]:
    """Return one unit quaternion w x y z."""
    found, shape = flat_quaternions(name, values)
    if shape != ():
        raise InputError(f"{name}: found an array of shape {(*shape, 4)}, expected (4,): w x y z")
    w, x, y, z = found[0].tolist()
    return w, x, y, z


def alike(of: str, *several: tuple[str, tuple[Floats, Shape]]) -> tuple[list[Floats], Shape]:
    """Broadcast rows of several arguments to one leading shape; rows that have it are not copied. `of` names an entry of the first."""
    shape: Shape = several[0][1][1]
    for name, (array, own) in several[1:]:
        try:
            shape = np.broadcast_shapes(shape, own)
        except ValueError:
            found, expected = (*own, array.shape[1]), (*shape, array.shape[1])
            problem = f"found an array of shape {found}, expected {expected}, one for each {of}, or a single one"
            raise InputError(f"{name}: {problem}") from None
    return [_spread(array, own, shape) for _, (array, own) in several], shape


def _spread(array: Floats, own: Shape, shape: Shape) -> Floats:
    columns = array.shape[1]
    if own == shape:
        return array
    spread = np.broadcast_to(array.reshape(*own, columns), (*shape, columns))
    return np.ascontiguousarray(spread).reshape(-1, columns)


def numbers(name: str, values: ArrayLike, count: int, parts: str = "") -> list[float]:
    """Return a list of `count` numbers; `parts` names them."""
    array = as_numbers(name, values)
    if array.shape != (count,):
        named = f": {parts}" if parts else ""
        raise InputError(f"{name}: found an array of shape {array.shape}, expected ({count},){named}")
    if not np.isfinite(array).all():
        raise InputError(f"{name}: found {array}, expected finite numbers")
    found: list[float] = array.tolist()
    return found


def of_each(name: str, values: ArrayLike, count: int, entry: Shape) -> list[Any]:
    """Broadcast one entry of shape `entry`, or `count` of them, to a list of `count` entries."""
    array = as_numbers(name, values)
    if array.shape not in (entry, (count, *entry)):
        one = str(entry) if entry else "a number"
        raise InputError(f"{name}: found an array of shape {array.shape}, expected {one} or {(count, *entry)}")
    if not np.isfinite(array).all():
        raise InputError(f"{name}: found {array}, expected finite numbers")
    found: list[Any] = np.broadcast_to(array, (count, *entry)).tolist()
    return found


def number(name: str, value: Any) -> float:
    """Return one number, whose range the core checks. Strings and booleans are rejected even if Python would convert them."""
    found = as_numbers(name, value)
    if found.ndim:
        raise InputError(f"{name}: found an array of shape {found.shape}, expected a number")
    return float(found)


def positive(name: str, value: Any) -> float:
    """Return one finite number above 0."""
    found = finite(name, value)
    if found <= 0:
        raise InputError(f"{name}: found {found}, expected a positive number")
    return found


def not_negative(name: str, value: Any) -> float:
    """Return a finite number that is not negative."""
    found = finite(name, value)
    if found < 0:
        raise InputError(f"{name}: found {found}, expected a number of at least 0")
    return found


def finite(name: str, value: Any) -> float:
    """Return one finite number, as JSON can hold it."""
    found = number(name, value)
    if not np.isfinite(found):
        raise InputError(f"{name}: found {found}, expected a finite number")
    return found


def whole(name: str, value: int) -> int:
    """Return a whole number for a seed or a count."""
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)) or not 0 <= value < 2**64:
        raise InputError(f"{name}: found {shown(value)}, expected a whole number from 0 to 2**64 - 1")
    return int(value)


def thread_count(threads: int | None) -> int | None:
    """Return a number of threads; None means the number of cores."""
    return None if threads is None else whole("threads", threads)


def shown(value: Any) -> str:
    """Describe a value for a message: short values literally, others by their type."""
    if value is None or isinstance(value, (bool, float, np.generic)):
        return str(value)
    if isinstance(value, int):
        return str(value) if abs(value) < 2**64 else f"a whole number of {value.bit_length()} bits"
    if isinstance(value, str):
        return f"the text {value!r}" if len(value) <= 100 else f"a text of {len(value)} characters"
    if isinstance(value, np.ndarray):
        return f"an array of shape {value.shape}"
    name = type(value).__name__
    return f"{'an' if name[0].lower() in 'aeiou' else 'a'} {name}"


def in_order(array: NDArray[_Entry]) -> NDArray[_Entry]:
    """Return an array made C-contiguous and aligned, as the core requires; unpickled arrays may be neither."""
    return np.require(array, requirements=["C", "A"])


def as_numbers(name: str, values: Any) -> Floats:
    """Return an array of any shape, C-contiguous and aligned float64."""
    if (other := _no_number(values)) is not None:
        raise InputError(f"{name}: found {other}, expected numbers" if _many(values) else f"{name}: found {other}, expected a number")
    try:
        array = np.asarray(values)
    except (TypeError, ValueError, OverflowError, RuntimeError) as problem:
        raise InputError(f"{name}: found {problem}, expected numbers") from None
    if array.dtype.kind not in "iufO":
        raise InputError(f"{name}: found {_KINDS.get(array.dtype.kind, str(array.dtype))}, expected numbers")
    if array.dtype.kind == "O" and (other := next(filter(None, map(_no_number, array.flat)), None)) is not None:
        raise InputError(f"{name}: found {other}, expected numbers")
    try:
        return np.require(array, np.float64, ["C", "A"])
    except (TypeError, ValueError, OverflowError) as problem:
        raise InputError(f"{name}: found {problem}, expected numbers") from None


_KINDS = {"b": "truth values", "U": "texts", "S": "bytes", "c": "complex numbers"}
# Lists nested more deeply are not arrays.
_DEEPEST = 32


def _many(values: Any) -> bool:
    return isinstance(values, (list, tuple, np.ndarray))


def _no_number(values: Any, depth: int = 0) -> str | None:
    """Describe the first entry that NumPy would silently convert or drop; None if all entries are numbers."""
    if isinstance(values, np.ma.MaskedArray) and np.ma.getmaskarray(values).any():
        return "masked entries"
    if isinstance(values, (list, tuple)):
        kinds = set(map(type, values))
        if kinds <= {float, int} or depth > _DEEPEST:
            return None
        return next((found for entry in values if (found := _no_number(entry, depth + 1)) is not None), None)
    if values is None or isinstance(values, (str, bytes, bytearray, bool, np.bool_, np.str_, np.bytes_, dict, set)):
        return shown(values)
    if not any(hasattr(values, way) for way in _WAYS_TO_NUMBERS):
        return f"a {type(values).__name__}"
    return None


_WAYS_TO_NUMBERS = ("__float__", "__index__", "__array__", "__array_interface__", "__array_struct__", "__iter__", "__getitem__", "__buffer__")


def _in_reach(name: str, array: Floats) -> None:
    # Minimum and maximum propagate NaN and need no temporary array.
    if array.size and not (array.min() >= -MAX_COORDINATE and array.max() <= MAX_COORDINATE):
        good = np.abs(array) <= MAX_COORDINATE
        index = tuple(int(i) for i in np.argwhere(~good)[0])
        place = name + "".join(f"[{i}]" for i in index)
        raise InputError(f"{place}: found {array[index]}, expected finite coordinates up to {MAX_COORDINATE:g} m")


def one_for_each(name: str, values: Sequence[Any], count: int, of: str) -> None:
    """Check that there are `count` values."""
    if len(values) != count:
        raise InputError(f"{name}: found {len(values)}, expected {count}, one for each {of}")
