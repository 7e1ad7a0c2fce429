"""Equality and hashing of values that contain arrays."""

from __future__ import annotations

from collections.abc import Hashable, Mapping
from dataclasses import fields
from typing import Any, Self

import numpy as np


def same(a: Any, b: Any) -> bool:
    """Tell whether two values are equal: arrays element by element, NaN to NaN."""
    if isinstance(a, np.ndarray) and isinstance(b, np.ndarray):
        return a.dtype == b.dtype and np.array_equal(a, b, equal_nan=a.dtype.kind == "f")
    if isinstance(a, Mapping) and isinstance(b, Mapping):
        return a.keys() == b.keys() and all(same(value, b[key]) for key, value in a.items())
    if isinstance(a, (tuple, list)) and type(a) is type(b):
        return len(a) == len(b) and all(map(same, a, b))
    if isinstance(a, float) and isinstance(b, float):
        return a == b or (a != a and b != b)
    return type(a) is type(b) and bool(a == b)


def frozen(value: Any) -> Hashable:
    """Return JSON data in a hashable form; equal values have equal forms."""
    if isinstance(value, Mapping):
        return frozenset((key, frozen(entry)) for key, entry in value.items())
    return tuple(map(frozen, value)) if isinstance(value, (list, tuple)) else value


class Immutable:
    """An immutable object that is fully described by a table."""

    _spec: dict[str, Any]

    def __eq__(self, other: object) -> bool:
        """Compare by value."""
        return isinstance(other, Immutable) and type(self) is type(other) and self._spec == other._spec

    def __hash__(self) -> int:
        """Hash by value."""
        return hash(frozen(self._spec))

    def __copy__(self) -> Self:
        """Return the object itself."""
        return self

    def __deepcopy__(self, memo: object) -> Self:
        """Return the object itself."""
        return self


class ByValue:
    """A dataclass whose fields, including arrays, are compared by value; like a list, it cannot be hashed."""

    def __eq__(self, other: object) -> bool:
        """Compare by value."""
        if type(other) is not type(self):
            return NotImplemented
        names = [field.name for field in fields(self) if field.compare]  # type: ignore[arg-type]
        return all(same(getattr(self, name), getattr(other, name)) for name in names)

    __hash__ = None  # type: ignore[assignment]
