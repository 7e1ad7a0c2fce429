"""Tables of the file formats, made from arrays."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from enum import Enum
from typing import Any, Protocol, TypeAlias, cast, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import finite, numbers, point, rows, shown
from ._given import plain, several, table, text
from ._stations import place, station_tables
from .exceptions import InputError


@runtime_checkable
class TriangleMesh(Protocol):
    """Any object with ``vertices`` (n, 3) and ``faces`` (m, 3), counter-clockwise seen from outside, as in trimesh."""

    @property
    def vertices(self) -> Any:
        """Corners, m."""

    @property
    def faces(self) -> Any:
        """Indices of the corners of each triangle, from 0."""


Body: TypeAlias = ArrayLike | TriangleMesh | Mapping[str, Any]
Bodies: TypeAlias = Body | Sequence[Body]


def obstacle_tables(name: str, obstacle: Bodies) -> list[dict[str, Any]]:
    """Return one table per part, all with the same name."""
    place = f"obstacles[{text('obstacles', name)!r}]"
    parts = bodies(place, obstacle)
    if any("name" in part for part in parts):
        raise InputError(f"{place}: found a table with a name of its own, expected none")
    return [{"name": name, **part} for part in parts]


def bodies(place: str, given: Bodies) -> list[dict[str, Any]]:
    """Return one table per part of a body or of a sequence of bodies: corners (k, 3), meshes, tables of a file."""
    if _single(given):
        return [body_table(f"{place}[0]", cast(Body, given))]
    several_bodies = several(place, given, "corners (k, 3), a mesh, a table, or several of them")
    parts = [body_table(f"{place}[{k}]", part) for k, part in enumerate(several_bodies)]
    if not parts:
        raise InputError(f"{place}: found no parts, expected at least one array of shape (k, 3)")
    return parts


def _single(given: Any) -> bool:
    if isinstance(given, (TriangleMesh, Mapping)):
        return True
    try:
        return np.asarray(given, dtype=np.float64).ndim == 2
    except (TypeError, ValueError, OverflowError, RuntimeError):
        return False


def body_table(place: str, body: Body) -> dict[str, Any]:
    """Return the table of a body, from its corners, its mesh, or a table."""
    if isinstance(body, Mapping):
        copy: dict[str, Any] = plain(place, body)
        return copy
    if not isinstance(body, TriangleMesh):
        return {"vertices": rows(place, body).tolist()}
    try:
        triangles = np.asarray(body.faces)
    except (TypeError, ValueError, OverflowError) as problem:
        raise InputError(f"{place}.faces: found {problem}, expected integers of shape (m, 3)") from None
    if triangles.ndim != 2 or triangles.shape[1] != 3 or triangles.dtype.kind not in "iu":
        found = f"{triangles.dtype} of shape {triangles.shape}"
        raise InputError(f"{place}.faces: found {found}, expected integers of shape (m, 3)")
    if triangles.size and triangles.min() < 0:
        raise InputError(f"{place}.faces: found {triangles.min()}, expected indices from 0")
    vertices = rows(f"{place}.vertices", body.vertices).tolist()
    return {"mesh": {"vertices": vertices, "triangles": triangles.tolist()}}


def orientation_tables(orientations: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Return the table of orientations, from quaternions or tables of a file by name."""
    named = table("orientations", orientations).items()
    return [{"name": text("orientations", name)} | _turn(f"orientations[{name!r}]", turn) for name, turn in named]


def _turn(place: str, turn: Any) -> dict[str, Any]:
    if isinstance(turn, Mapping):
        copy: dict[str, Any] = plain(place, turn)
        return copy
    return {"quaternion": numbers(place, turn, 4, "w x y z")}


Names: TypeAlias = tuple[str, str]
Clearances: TypeAlias = Mapping[str | Names, float]


def clearances_table(clearances: Clearances) -> dict[str, Any]:
    """Return the table of clearances, from a mapping of kinds and pairs of names to metres."""
    if not isinstance(clearances, Mapping):
        raise InputError(f"clearances: found {shown(clearances)}, expected a mapping of kinds and pairs of names to metres")
    kinds = {key: finite(f"clearances[{key!r}]", value) for key, value in clearances.items() if isinstance(key, str)}
    if "pairs" in kinds:
        raise InputError("clearances: found the kind 'pairs', expected kinds and pairs of names as keys")
    pairs = [
        {"between": _names(f"clearances[{key!r}]", key), "clearance": finite(f"clearances[{key!r}]", value)}
        for key, value in clearances.items()
        if not isinstance(key, str)
    ]
    return kinds | ({"pairs": pairs} if pairs else {})


def pairs_table(key: str, pairs: Iterable[Names]) -> list[list[str]]:
    """Return the table of pairs of names."""
    return [_names(f"{key}[{k}]", pair) for k, pair in enumerate(several(key, pairs, "pairs of names"))]


def _names(place: str, pair: Any) -> list[str]:
    names = list(pair) if isinstance(pair, Sequence) and not isinstance(pair, str) else [pair]
    if len(names) != 2 or not all(isinstance(name, str) for name in names):
        found = repr(pair) if all(isinstance(name, str) for name in names) else shown(pair)
        raise InputError(f"{place}: found {found}, expected two names")
    return [text(place, name) for name in names]


class Kept(Enum):
    """The default of arguments for which None has a meaning of its own."""

    KEPT = "as it is"


KEPT = Kept.KEPT


def box_table(workspace: ArrayLike) -> dict[str, list[float]]:
    """Return the table of a workspace, from its corners."""
    box = rows("workspace", workspace)
    if box.shape != (2, 3):
        raise InputError(f"workspace: found an array of shape {box.shape}, expected (2, 3), the corners min and max")
    return {"min": box[0].tolist(), "max": box[1].tolist()}


def _orientation(key: str, value: Any) -> Any:
    """Return a name or a quaternion."""
    return text(key, value) if isinstance(value, str) else numbers(key, value, 4, "w x y z")


QUERY: dict[str, Callable[[Any], Any]] = {
    "start": lambda value: place("start", value),
    "goal": lambda value: place("goal", value),
    "orientation": lambda value: _orientation("orientation", value),
    "start_orientation": lambda value: _orientation("start_orientation", value),
    "goal_orientation": lambda value: _orientation("goal_orientation", value),
}


def put(spec: dict[str, Any], key: str, value: Any, entry: Callable[[Any], Any]) -> None:
    """Set a key; remove it if the value is None; keep it if no value was given."""
    if value is None:
        spec.pop(key, None)
    elif not isinstance(value, Kept):
        spec[key] = entry(value)


# How each key of a scene file is made from the argument of the same name; `robot`, `workspace`, `obstacles` and those of
# QUERY stand for themselves.
SCENE: dict[str, Callable[[Any], Any]] = {
    "name": lambda value: text("name", value),
    "gravity": lambda value: point("gravity", value),
    "clearance": lambda value: finite("clearance", value),
    "clearances": clearances_table,
    "touch": lambda value: pairs_table("touch", value),
    "ignore": lambda value: pairs_table("ignore", value),
    "orientations": orientation_tables,
    "stations": station_tables,
    "wrench": lambda value: plain("wrench", table("wrench", value)),
    "motion": lambda value: plain("motion", table("motion", value)),
    "turning": lambda value: plain("turning", table("turning", value)),
    "workspace": box_table,
    "obstacles": lambda value: [
        part for name, body in table("obstacles", value).items() for part in obstacle_tables(name, body)
    ],
}
