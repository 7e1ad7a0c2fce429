"""Named positions of the platform."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import Floats, point, rows, shown
from ._given import plain, table, text
from ._values import ByValue
from .exceptions import InputError


Point: TypeAlias = tuple[float, float, float]
Place: TypeAlias = str | Point


@dataclass(frozen=True, eq=False)
class Station(ByValue):
    """A named position of the platform; see `Scene.stations`.

    Attributes
    ----------
    position : ndarray (3,)
        Position of the platform's origin, world, m.
    orientation : ndarray (4,) or None
        World-from-platform unit quaternion w x y z, if the platform has an orientation of its own there.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.example("hard1").replace(stations={"rack": [1.7, 1, 0.5]})
    >>> scene.stations["rack"]
    Station(position=array([1.7, 1. , 0.5]), orientation=None)
    """

    position: Floats
    orientation: Floats | None = None

    @classmethod
    def _of(cls, position: list[float], orientation: list[float] | None) -> Station:
        """Make a station from lists of the core, read-only."""
        arrays = [None if digits is None else np.array(digits, dtype=np.float64) for digits in (position, orientation)]
        for array in arrays:
            if array is not None:
                array.flags.writeable = False
        return cls(*arrays)  # type: ignore[arg-type]


def station_tables(stations: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Return the table of stations, from positions, tables of a file or stations by name."""
    named = table("stations", stations).items()
    return [{"name": text("stations", name)} | _station(f"stations[{name!r}]", station) for name, station in named]


def _station(name: str, station: Any) -> dict[str, Any]:
    if isinstance(station, Station):
        turn = {} if station.orientation is None else {"orientation": list(station.orientation)}
        return {"position": point(name, station.position)} | turn
    if isinstance(station, Mapping):
        copy: dict[str, Any] = plain(name, station)
        return copy
    return {"position": point(name, station)}


def place(key: str, value: ArrayLike | str) -> Place:
    """Return the name of a station or a position."""
    return text(key, value) if isinstance(value, str) else point(key, value)


def places(key: str, values: Sequence[ArrayLike | str]) -> list[Place]:
    """Return names of stations and positions."""
    listed = isinstance(values, Sequence) or isinstance(values, np.ndarray) and values.ndim > 0
    if isinstance(values, str) or not listed:
        raise InputError(f"{key}: found {shown(values)}, expected a list of positions and stations")
    return [place(f"{key}[{k}]", value) for k, value in enumerate(values)]


def route(
    goal: ArrayLike | str | None, via: Sequence[ArrayLike | str], goals: Sequence[ArrayLike | str], goal_box: ArrayLike | None
) -> tuple[list[Place], list[Place], tuple[Point, Point] | None]:
    """Return via points, goals and the box of goals, checked as far as the scene is not needed."""
    passed, several = places("via", via), places("goals", goals)
    if goal is not None and (several or goal_box is not None):
        other = "goals" if several else "goal_box"
        raise InputError(f"{other}: found with goal, expected one of the two")
    if goal_box is None:
        return passed, several, None
    corners = rows("goal_box", goal_box)
    if len(corners) != 2:
        raise InputError(f"goal_box: found {len(corners)} rows, expected 2: the least and the largest coordinates")
    return passed, several, (point("goal_box[0]", corners[0]), point("goal_box[1]", corners[1]))


def between(scene: _core.Scene, start: ArrayLike | str | None, goal: ArrayLike | str | None) -> _core.Scene:
    """Return the scene with this start and goal instead of its own, as far as given."""
    if start is None and goal is None:
        return scene
    ends = {"start": start, "goal": goal}.items()
    first, last = (None if end is None else place(key, end) for key, end in ends)
    return scene.between(first, last)
