"""Optional use of pandas."""

from __future__ import annotations

import importlib
from typing import Any


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
