"""Tables of the file formats, made from arrays."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from enum import Enum
from typing import Any, Protocol, TypeAlias, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import number, numbers, point, rows
from .exceptions import InputError


@runtime_checkable
class TriangleMesh(Protocol):
    """What has ``vertices`` (n, 3) and ``faces`` (m, 3), counter-clockwise seen from outside; trimesh's meshes have."""

    @property
    def vertices(self) -> Any:
        """Corners, m."""

    @property
    def faces(self) -> Any:
        """Indices of the corners of each triangle, from 0."""


Obstacle: TypeAlias = ArrayLike | TriangleMesh | Sequence[ArrayLike | TriangleMesh]


def obstacle_tables(name: str, obstacle: Obstacle) -> list[dict[str, Any]]:
    """One table per part: an obstacle is a mesh, one (k, 3) array, or a sequence of such."""
    try:
        single = isinstance(obstacle, TriangleMesh) or np.asarray(obstacle, dtype=np.float64).ndim == 2
    except (TypeError, ValueError):
        single = False
    if not single and not isinstance(obstacle, Iterable):
        raise InputError(f"obstacles[{name!r}]: found {type(obstacle).__name__}, expected corners (k, 3), a mesh, or several")
    bodies: list[Any] = [obstacle] if single else list(obstacle)  # type: ignore[arg-type]
    if not bodies:
        raise InputError(f"obstacles[{name!r}]: found no parts, expected at least one array of shape (k, 3)")
    return [{"name": name, **body_table(f"obstacles[{name!r}][{k}]", body)} for k, body in enumerate(bodies)]


def body_table(place: str, body: ArrayLike | TriangleMesh) -> dict[str, Any]:
    """The table of a body, from its corners or its mesh."""
    if not isinstance(body, TriangleMesh):
        return {"vertices": rows(place, body).tolist()}
    triangles = np.asarray(body.faces)
    if triangles.ndim != 2 or triangles.shape[1] != 3 or triangles.dtype.kind not in "iu":
        found = f"{triangles.dtype} of shape {triangles.shape}"
        raise InputError(f"{place}.faces: found {found}, expected integers of shape (m, 3)")
    if triangles.size and triangles.min() < 0:
        raise InputError(f"{place}.faces: found {triangles.min()}, expected indices from 0")
    vertices = rows(f"{place}.vertices", body.vertices).tolist()
    return {"mesh": {"vertices": vertices, "triangles": triangles.tolist()}}


Names: TypeAlias = tuple[str, str]
Clearances: TypeAlias = Mapping[str | Names, float]


def clearances_table(clearances: Clearances) -> dict[str, Any]:
    """The table of clearances, from a mapping of kinds and pairs of names to metres."""
    if not isinstance(clearances, Mapping):
        found = type(clearances).__name__
        raise InputError(f"clearances: found {found}, expected a mapping of kinds and pairs of names to metres")
    kinds = {key: number(f"clearances[{key!r}]", value) for key, value in clearances.items() if isinstance(key, str)}
    if "pairs" in kinds:
        raise InputError("clearances: found the kind 'pairs', expected kinds and pairs of names as keys")
    pairs = [
        {"between": _names(f"clearances[{key!r}]", key), "clearance": number(f"clearances[{key!r}]", value)}
        for key, value in clearances.items()
        if not isinstance(key, str)
    ]
    return kinds | ({"pairs": pairs} if pairs else {})


def pairs_table(key: str, pairs: Iterable[Names]) -> list[list[str]]:
    """The table of pairs of names."""
    if isinstance(pairs, str) or not isinstance(pairs, Iterable):
        raise InputError(f"{key}: found {type(pairs).__name__}, expected pairs of names")
    return [_names(f"{key}[{k}]", pair) for k, pair in enumerate(pairs)]


def _names(place: str, pair: Any) -> list[str]:
    names = list(pair) if isinstance(pair, Sequence) and not isinstance(pair, str) else [pair]
    if len(names) != 2 or not all(isinstance(name, str) for name in names):
        raise InputError(f"{place}: found {pair!r}, expected two names")
    return names


class Kept(Enum):
    """Stands for what is not given where None means something."""

    KEPT = "as it is"


KEPT = Kept.KEPT


def box_table(workspace: ArrayLike) -> dict[str, list[float]]:
    """The table of a workspace, from its corners."""
    box = rows("workspace", workspace)
    if box.shape != (2, 3):
        raise InputError(f"workspace: found an array of shape {box.shape}, expected (2, 3), the corners min and max")
    return {"min": box[0].tolist(), "max": box[1].tolist()}


QUERY: dict[str, Callable[[Any], Any]] = {
    "start": lambda value: point("start", value),
    "goal": lambda value: point("goal", value),
    "orientation": lambda value: value if isinstance(value, str) else numbers("orientation", value, 4, "w x y z"),
}


def put(table: dict[str, Any], key: str, value: Any, plain: Callable[[Any], Any]) -> None:
    """Set a key, or take it away where the value is None, or leave it where nothing was given."""
    if value is None:
        table.pop(key, None)
    elif not isinstance(value, Kept):
        table[key] = plain(value)
