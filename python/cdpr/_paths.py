"""Paths given by the user: their waypoints, their orientations, and the scene that they belong to."""

from __future__ import annotations

import warnings
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import Floats, flat_points, flat_quaternions, in_order, rows
from ._given import flag, instance
from ._results import Path, turns_of
from ._scene import Scene
from .exceptions import AnotherSceneWarning, InputError

# Largest difference of unit quaternions that are the same orientation, as in the core.
SAME_TURN = 1e-9


class Way(NamedTuple):
    """A path in a scene: the scene at its orientation, its positions, and the orientation at each if the platform turns."""

    core: _core.Scene
    positions: Floats
    turns: Floats | None


def way_of(
    scene: Scene,
    name: str,
    waypoints: ArrayLike | Path,
    orientations: ArrayLike | None = None,
    *,
    strict: bool = False,
    level: int = 3,
    place: bool = False,
    of_another: bool = False,
) -> Way:
    """Find the scene at the orientation of a path, and the path in it; `place` allows a single position.

    A path that was planned for another scene causes a warning or, with `strict`, an error, unless it may be `of_another`.
    """
    positions = _path_or_position(name, waypoints) if place else two_or_more(name, waypoints)
    given = turns_along(waypoints, orientations)
    turns = None if given is None else turns_of(positions, given)
    core, warning, turning = _turned(scene, waypoints, flag("strict", strict), turns)
    if warning is not None and not of_another:
        warnings.warn(warning, AnotherSceneWarning, stacklevel=level)
    return Way(core, positions, turns if turning else None)


def core_for(scene: Scene, waypoints: ArrayLike | Path, *, strict: bool = False, level: int = 3) -> _core.Scene:
    """Return the scene at the orientation of a path or result; warn of a path that was planned for another scene."""
    core, warning, _ = _turned(scene, waypoints, flag("strict", strict), turns_along(waypoints, None))
    if warning is not None:
        warnings.warn(warning, AnotherSceneWarning, stacklevel=level)
    return core


def scene_for(scene: Scene, waypoints: ArrayLike | Path) -> Scene:
    """Return the scene at the orientation of a path, without a warning: pictures may compare paths of several scenes."""
    core = _turned(scene, waypoints, False, turns_along(waypoints, None))[0]
    return scene if core is scene._core else scene.replace(orientation=core.orientation())


def _turned(
    scene: Scene, waypoints: ArrayLike | Path, strict: bool, turns: ArrayLike | None
) -> tuple[_core.Scene, str | None, bool]:
    """Return the scene at the orientation of a path, a warning if it is for another scene, and whether the platform turns."""
    instance("scene", scene, Scene)
    along = None if turns is None else in_order(np.asarray(turns, dtype=np.float64))
    if not isinstance(waypoints, Path):
        turned, _, turning = scene._core.for_path(None, turns=along)
        return turned or scene._core, None, turning
    turn, origin = waypoints.orientation, waypoints._origin()
    planned_for = (origin["scene"]["name"], origin["scene"]["fingerprint"]) if "scene" in origin else None
    turned, warning, turning = scene._core.for_path(
        None if turn is None else turn.tolist(), origin.get("orientation_name"), planned_for, strict, along
    )
    return turned or scene._core, warning, turning


def path_rows(name: str, waypoints: ArrayLike | Path) -> Floats:
    """Return the waypoints of a path that can be rewound: one on which the platform keeps its orientation."""
    if isinstance(waypoints, Path) and waypoints.orientations is not None:
        found = "found a path on which the platform turns, expected one on which it keeps its orientation"
        raise InputError(f"{name}.orientations: {found}; rewinding is for such paths, cdpr.refine for both")
    return two_or_more(name, waypoints)


def two_or_more(name: str, waypoints: ArrayLike | Path) -> Floats:
    array = rows(name, waypoints.waypoints if isinstance(waypoints, Path) else waypoints)
    if len(array) < 2:
        raise InputError(f"{name}: found {len(array)} waypoints, expected at least two")
    return array


def _path_or_position(name: str, waypoints: ArrayLike | Path) -> Floats:
    """Return the rows of a path; a single position becomes a path that stays there."""
    if isinstance(waypoints, Path):
        return two_or_more(name, waypoints)
    flat, shape = flat_points(name, waypoints)
    return np.repeat(flat, 2, axis=0) if shape == () else two_or_more(name, waypoints)


def turns_along(waypoints: ArrayLike | Path, orientations: ArrayLike | None) -> ArrayLike | None:
    """Return the orientations given for a path, or its own."""
    if orientations is None or not isinstance(waypoints, Path):
        return waypoints.orientations if isinstance(waypoints, Path) else orientations
    if waypoints.orientations is not None:
        raise InputError("orientations: found some for a path that has its own, expected none")
    kept = waypoints.orientation
    if kept is not None:
        given = flat_quaternions("orientations", orientations)[0]
        away = np.minimum(*(np.linalg.norm(given - sign * kept, axis=1) for sign in (1.0, -1.0)))
        if (away > SAME_TURN).any():
            found, own = given[away > SAME_TURN][0].tolist(), kept.tolist()
            raise InputError(f"orientations: found {found} for a path that keeps {own}, expected its own or none")
    return orientations
