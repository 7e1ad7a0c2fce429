"""Optional use of pandas."""

from __future__ import annotations

import importlib
from collections.abc import Mapping, Sequence
from typing import Any

from ._arrays import Floats


def pandas_or_none() -> Any | None:
    """Return the module, if it is installed."""
    try:
        return importlib.import_module("pandas")
    except ImportError:
        return None


def frame(columns: Any, index: str | None = None) -> Any:
    """Return a DataFrame of columns by name, or of rows, with a name for its index."""
    pandas = pandas_or_none()
    if pandas is None:
        raise ImportError("to_pandas needs pandas: pip install 'cdpr[pandas]'")
    table = pandas.DataFrame(columns)
    table.index.name = index
    return table


def by_cable(cables: Sequence[str], quantities: Mapping[str, Floats | None]) -> dict[str, Floats]:
    """Return the columns ``quantity:cable`` of those quantities (n, m) that are known."""
    known = [(name, matrix) for name, matrix in quantities.items() if matrix is not None]
    return {f"{name}:{cable}": column for name, matrix in known for cable, column in zip(cables, matrix.T, strict=True)}
