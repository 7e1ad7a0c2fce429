"""Obstacles of a scene: with one more, without some. These functions are methods of `Scene`."""

from __future__ import annotations

import difflib
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from numpy.typing import ArrayLike

from ._arrays import numbers, point
from ._given import text
from ._tables import Bodies, obstacle_tables
from .exceptions import InputError

if TYPE_CHECKING:
    from ._scene import Scene


def with_obstacle(
    self: Scene,
    name: str,
    obstacle: Bodies,
    *,
    position: ArrayLike | None = None,
    rpy: ArrayLike | None = None,
    rpy_degrees: ArrayLike | None = None,
    quaternion: ArrayLike | None = None,
) -> Scene:
    """Return a scene with one more obstacle.

    Parameters
    ----------
    name : str
        A name that is not in use.
    obstacle : array_like (k, 3), mesh, mapping, or sequence of them
        Corners of a convex obstacle, a mesh, or a table of a scene file, in its own frame, m; several for a concave one.
    position : array_like (3,), optional
        Position of its frame in the world, m; default the origin.
    rpy : array_like (3,), optional
        Rotation of its frame: roll, pitch and yaw, rad, R = Rz(yaw) Ry(pitch) Rx(roll).
    rpy_degrees : array_like (3,), optional
        Roll, pitch and yaw in degrees, in place of ``rpy``.
    quaternion : array_like (4,), optional
        Unit quaternion w x y z, in place of ``rpy``.

    Returns
    -------
    Scene

    Raises
    ------
    InputError
        A name that is in use, a position or rotation that the obstacle's table also gives; otherwise as for the
        class.

    Examples
    --------
    >>> cube = [[x, y, z] for x in (0, 0.2) for y in (0, 0.2) for z in (0, 0.2)]
    >>> import cdpr
    >>> cdpr.example("hard1").with_obstacle("crate", cube, position=[1.5, 0.3, 0.0])
    Scene('hard1', 8 cables, 2 obstacles)
    """
    if text("name", name) in obstacle_names(self):
        raise InputError(f"name: found {name!r}, which is already the name of an obstacle, expected a new one")
    placed = {"position": position, "rpy": rpy, "rpy_degrees": rpy_degrees}
    pose: dict[str, Any] = {key: point(key, value) for key, value in placed.items() if value is not None}
    if quaternion is not None:
        pose["quaternion"] = numbers("quaternion", quaternion, 4, "w x y z")
    parts = obstacle_tables(name, obstacle)
    if twice := [key for key in pose if any(key in part for part in parts)]:
        raise InputError(f"{twice[0]}: also found in the table of the obstacle, expected it once")
    spec = self.to_dict()
    spec.setdefault("obstacles", []).extend({**part, **pose} for part in parts)
    return self._edited(spec)

def without(self: Scene, *names: str) -> Scene:
    """Return a scene without the named obstacles and their pairs in ``clearances``, ``touch`` and ``ignore``.

    Parameters
    ----------
    *names : str
        Names of obstacles.

    Returns
    -------
    Scene

    Raises
    ------
    InputError
        A name that no obstacle has; the message suggests the nearest one.

    Examples
    --------
    >>> import cdpr
    >>> cdpr.example("hard3").without("north", "south")
    Scene('hard3', 8 cables, 1 obstacle)
    """
    known = obstacle_names(self)
    for name in names:
        if text("names", name) not in known:
            raise InputError(f"without: {_unknown(name, known)}")
    spec = self.to_dict()
    parts = zip(known, spec.get("obstacles", []))  # payloads come after them
    spec["obstacles"] = [{**part, "name": name} for name, part in parts if name not in names]
    if "payloads" in spec:
        spec["payloads"] = [payload for payload in spec["payloads"] if payload["name"] not in names]
    for key in ("ignore", "touch"):
        spec[key] = [pair for pair in spec.get(key, []) if not set(pair) & set(names)]
    clearances = spec.get("clearances", {})
    if "pairs" in clearances:
        clearances["pairs"] = [pair for pair in clearances["pairs"] if not set(pair["between"]) & set(names)]
    return self._edited(spec)


def moved(self: Scene, name: str, position: ArrayLike) -> Scene:
    """Return a scene with an obstacle at another place.

    Only this obstacle is compiled again: what was compiled of this scene is used for the new one.

    Parameters
    ----------
    name : str
        Name of an obstacle.
    position : array_like (3,)
        The ``position`` of the obstacle's first part, world, m; its other parts move along. For a part with ``vertices`` it is
        what is added to them.

    Returns
    -------
    Scene

    Raises
    ------
    InputError
        A name that no obstacle has; an outlet inside the obstacle.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.example("hard1")
    >>> round(cdpr.plan(scene.moved("pillar", [1.0, 1.0, 0.7])).cost, 3)
    2.386
    """
    if text("name", name) not in (known := obstacle_names(self)):
        raise InputError(f"moved: {_unknown(name, known)}")
    moved = self._core.moved(name, point("position", position))
    return self._of_core(moved)._warned(told=self._core.notes())


def obstacle_names(self: Scene) -> list[str]:
    """Return the obstacle's name, of each part; payloads that stand come last."""
    return [part.get("name", f"obstacle {k}") for k, part in enumerate(self._plain.get("obstacles", []))]


def _unknown(name: str, known: Sequence[str]) -> str:
    near = difflib.get_close_matches(name, known, 1)
    hint = f"; did you mean {near[0]!r}?" if near else ""
    return f"found no obstacle {name!r}, expected one of {', '.join(dict.fromkeys(known)) or '(there are none)'}{hint}"
