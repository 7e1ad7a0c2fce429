"""Names of the choices of tensions."""

from __future__ import annotations

from typing import Any, Literal, TypeAlias

from ._given import one_of
from .exceptions import InputError

Distribution: TypeAlias = Literal["middle", "least", "p4", "p8", "closed-form"]


def distribution(tensions: Any, reference: Any = None) -> str | None:
    """Return the name of a choice, if one is given; a reference takes its place."""
    if tensions is not None and reference is not None:
        raise InputError("tensions: found a reference as well, expected only one of them")
    return None if tensions is None else one_of("tensions", tensions, Distribution)
