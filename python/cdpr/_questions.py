"""Queries of a scene: validity, clearance, violations. These functions are methods of `Scene`."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import TYPE_CHECKING, Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arrays import Floats, Shape, alike, flat_points, flat_quaternions, not_negative, point, quaternion, shaped, thread_count
from ._given import text
from ._violation import Violation, violation_from

if TYPE_CHECKING:
    from ._scene import Scene

Engine: TypeAlias = Literal["cspace", "gjk"]
Interference: TypeAlias = Literal["exact", "swept"]


def judges(engine: Engine, interference: Interference) -> tuple[Engine, Interference]:
    """Check that engine and interference rule are strings; the core checks their values."""
    text("engine", engine), text("interference", interference)
    return engine, interference


def states_valid(
    self: Scene,
    points: ArrayLike,
    orientations: ArrayLike | None = None,
    *,
    engine: Engine = "cspace",
    interference: Interference = "exact",
    threads: int | None = None,
) -> NDArray[np.bool_]:
    """Tell whether each position of the platform is valid, at the scene's orientation or at those given.

    Parameters
    ----------
    points : array_like (..., 3)
        Positions of the platform's origin, world, m. C-contiguous float64 is not copied.
    orientations : array_like (..., 4), optional
        World-from-platform unit quaternions w x y z, one for each position, or a single one for all; both signs are the
        same rotation. Default the scene's orientation.
    engine : {"cspace", "gjk"}
    interference : {"exact", "swept"}
    threads : int, optional
        Default all cores; the answers do not depend on it.

    Returns
    -------
    ndarray of bool (...)
        A NumPy scalar for a single position.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.example("hard1")
    >>> bool(scene.states_valid([0.3, 1.0, 0.3])), scene.states_valid([[0.3, 1.0, 0.3], [1.0, 1.0, 1.0]])
    (True, array([ True, False]))
    >>> half_turn = [0.0, 0.0, 0.0, 1.0]  # about the vertical: cables cross
    >>> scene.states_valid([0.3, 1.0, 0.3], [[1.0, 0.0, 0.0, 0.0], half_turn])
    array([ True, False])
    """
    flat, turns, shape = _poses(points, orientations)
    how = (*judges(engine, interference), thread_count(threads))
    if turns is not None and interference == "swept":
        return shaped(_held(self, turns, lambda core, rows: core.states_valid(flat[rows], *how)), shape)
    return shaped(self._core.states_valid(flat, *how, turns), shape)


def _held(
    scene: Scene, turns: Floats, answer: Callable[[_core.Scene, NDArray[np.bool_]], NDArray[np.bool_]]
) -> NDArray[np.bool_]:
    """Answer for rows without a turn, each at its own orientation: those at one orientation together."""
    answers = np.zeros(len(turns), dtype=np.bool_)
    for turn in np.unique(turns, axis=0):
        rows = (turns == turn).all(axis=1)
        w, x, y, z = turn.tolist()
        answers[rows] = answer(scene._core.at("orientations", (w, x, y, z)), rows)
    return answers


def motions_valid(
    self: Scene,
    starts: ArrayLike,
    ends: ArrayLike,
    start_orientations: ArrayLike | None = None,
    end_orientations: ArrayLike | None = None,
    *,
    engine: Engine = "cspace",
    interference: Interference = "exact",
    threads: int | None = None,
) -> NDArray[np.bool_]:
    """Tell whether each straight motion of the platform is valid, at fixed orientation or from one orientation to another.

    Parameters
    ----------
    starts, ends : array_like (..., 3)
        Positions of the platform's origin, world, m: one end for each start, or a single one for all. C-contiguous
        float64 is not copied.
    start_orientations, end_orientations : array_like (..., 4), optional
        World-from-platform unit quaternions w x y z, one for each motion, or a single one for all; both signs are the
        same rotation. Default the scene's orientation. The platform takes the shorter turn, at constant rate; of two half
        turns always the same one.
    engine : {"cspace", "gjk"}
    interference : {"exact", "swept"}
        "swept" is the paper's stricter rule for pairs of cables, for motions without a turn.
    threads : int, optional
        Default all cores; the answers do not depend on it.

    Returns
    -------
    ndarray of bool (...)
        A NumPy scalar for a single motion.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.example("hard1")
    >>> scene.motions_valid([[0.3, 1.0, 0.3], [0.3, 1.0, 0.3]], [[1.7, 1.0, 1.7], [0.3, 1.0, 0.8]])
    array([False,  True])
    >>> yaw = np.radians([20.0, 180.0])
    >>> turned = np.stack([np.cos(yaw / 2), 0 * yaw, 0 * yaw, np.sin(yaw / 2)], axis=-1)
    >>> scene.motions_valid([0.3, 1.0, 0.3], [0.3, 1.0, 0.8], end_orientations=turned)
    array([ True, False])
    """
    ends_of = ("starts", flat_points("starts", starts)), ("ends", flat_points("ends", ends))
    if start_orientations is None and end_orientations is None:
        (first, last), shape = alike("start", *ends_of)
        turns = None
    else:
        given = {"start_orientations": start_orientations, "end_orientations": end_orientations}
        turned = [(name, _turns(self, name, turn)) for name, turn in given.items()]
        (first, last, before, after), shape = alike("motion", *ends_of, *turned)
        turns = (before, after)
    how = (*judges(engine, interference), thread_count(threads))
    if turns is not None and interference == "swept" and (turns[0] == turns[1]).all():
        answers = _held(self, turns[0], lambda core, rows: core.motions_valid(first[rows], last[rows], *how))
        return shaped(answers, shape)
    return shaped(self._core.motions_valid(first, last, *how, turns), shape)


def _turns(scene: Scene, name: str, orientations: ArrayLike | None) -> tuple[Floats, Shape]:
    """Return orientations as rows; by default the scene's."""
    return flat_quaternions(name, scene.orientation if orientations is None else orientations)


def _poses(points: ArrayLike, orientations: ArrayLike | None) -> tuple[Floats, Floats | None, Shape]:
    """Return positions and orientations as rows, and their leading shape; no orientations if none are given."""
    positions = flat_points("points", points)
    if orientations is None:
        return positions[0], None, positions[1]
    turns = flat_quaternions("orientations", orientations)
    (flat, quaternions), shape = alike("position", ("points", positions), ("orientations", turns))
    return flat, quaternions, shape


def clearance(
    self: Scene, points: ArrayLike, orientations: ArrayLike | None = None, *, threads: int | None = None
) -> Floats:
    """Compute the signed clearance of each position: the smallest gap between bodies that must not touch.

    Parameters
    ----------
    points : array_like (..., 3)
        Positions of the platform's origin, world, m. C-contiguous float64 is not copied.
    orientations : array_like (..., 4), optional
        World-from-platform unit quaternions w x y z, one for each position, or a single one for all; default the scene's
        orientation.
    threads : int, optional
        Default all cores; the answers do not depend on it.

    Returns
    -------
    ndarray of float (...)
        Metres, a NumPy scalar for a single position: minus the penetration depth if bodies overlap, 0 if cables cross,
        infinite if there is nothing to collide with. Pairs that may touch, and pairs that can never keep the required
        clearance, count too. Cables and the bodies that they end on are left out, and so are ignored pairs and the
        workspace.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.example("hard1")
    >>> scene.clearance([[0.3, 1.0, 0.3], [1.0, 1.0, 1.7]]).round(6)
    array([0.05    , 0.024121])
    """
    flat, turns, shape = _poses(points, orientations)
    return shaped(self._core.clearance(flat, thread_count(threads), turns), shape)


def violations(
    self: Scene,
    start: ArrayLike,
    end: ArrayLike | None = None,
    start_orientation: ArrayLike | None = None,
    end_orientation: ArrayLike | None = None,
    *,
    engine: Engine = "cspace",
    interference: Interference = "exact",
) -> tuple[Violation, ...]:
    """List every violation at a position or along a straight motion; `cdpr.check` checks a whole path.

    Parameters
    ----------
    start : array_like (3,)
        Position of the platform's origin, world, m.
    end : array_like (3,), optional
        End of a straight motion from ``start``, m; default: only the position is checked.
    start_orientation, end_orientation : array_like (4,), optional
        World-from-platform unit quaternions w x y z, for a platform that turns on its way; default the scene's
        orientation, without ``end`` that at the start.
    engine : {"cspace", "gjk"}
    interference : {"exact", "swept"}

    Returns
    -------
    tuple of Violation
        Every condition that is violated, in the order in which the violations begin; empty if there are none.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.example("hard1")
    >>> [violation.culprits for violation in scene.violations([1.0, 1.0, 1.5])][:2]
    [('platform', 'pillar'), ('cable 0', 'pillar')]
    >>> scene.violations([0.3, 1.0, 0.3])
    ()
    """
    first = point("start", start)
    last = first if end is None else point("end", end)
    if end is None and end_orientation is None:
        end_orientation = start_orientation
    turns = None
    if start_orientation is not None or end_orientation is not None:
        given = {"start_orientation": start_orientation, "end_orientation": end_orientation}
        before, after = [quaternion(name, self.orientation if turn is None else turn) for name, turn in given.items()]
        turns = (before, after)
    core, how = self._core, judges(engine, interference)
    if turns is not None and interference == "swept" and turns[0] == turns[1]:
        core, turns = core.at("start_orientation", turns[0]), None
    found = json.loads(core.violations(first, last, *how, turns))
    return tuple(violation_from(values) for values in found)


def nearest_valid(
    self: Scene,
    position: ArrayLike,
    orientation: ArrayLike | None = None,
    *,
    margin: float = 0.001,
    engine: Engine = "cspace",
    interference: Interference = "exact",
) -> Floats | None:
    """Find a valid position near a start or goal that is not valid.

    Parameters
    ----------
    position : array_like (3,)
        Position of the platform's origin, world, m.
    orientation : array_like (4,), optional
        World-from-platform unit quaternion w x y z; default the scene's.
    margin : float
        How far the position is inside the valid ones, m: it stays valid if it is moved so far along axes and diagonals.
    engine : {"cspace", "gjk"}
    interference : {"exact", "swept"}

    Returns
    -------
    ndarray (3,) or None
        The position itself if it is valid by the margin. Otherwise the first one found on spheres of growing radius, moved back
        toward the position; not always the nearest one. None if none was found.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.example("hard1")
    >>> scene.nearest_valid([0.8, 1.0, 0.3]).round(3).tolist()
    [0.672, 1.0, 0.3]
    >>> scene.nearest_valid([0.3, 1.0, 0.3]).tolist()
    [0.3, 1.0, 0.3]
    """
    at, room = point("position", position), not_negative("margin", margin)
    turn = None if orientation is None else quaternion("orientation", orientation)
    core, how = self._core, judges(engine, interference)
    if turn is not None and interference == "swept":
        core, turn = core.at("orientation", turn), None
    found = core.nearest_valid(at, room, *how, turn)
    return None if found is None else np.array(found)


def explain_motion(
    self: Scene,
    start: ArrayLike,
    end: ArrayLike,
    start_orientation: ArrayLike | None = None,
    end_orientation: ArrayLike | None = None,
    *,
    engine: Engine = "cspace",
    interference: Interference = "exact",
) -> Violation | None:
    """Explain why a motion is invalid: name the condition that it violates first.

    Parameters
    ----------
    start, end : array_like (3,)
        Positions of the platform's origin, world, m; if they are equal, the position is checked.
    start_orientation, end_orientation : array_like (4,), optional
        World-from-platform unit quaternions w x y z, for a platform that turns on its way; default the scene's
        orientation.
    engine : {"cspace", "gjk"}
    interference : {"exact", "swept"}

    Returns
    -------
    Violation or None
        None if the motion is valid.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.example("hard1")
    >>> found = scene.explain_motion([0.3, 1.0, 0.3], [1.7, 1.0, 1.7])
    >>> found.kind, found.culprits
    ('cable-obstacle', ('cable 1', 'pillar'))
    >>> scene.explain_motion([0.3, 1.0, 0.3], [0.3, 1.0, 0.3], end_orientation=[0.0, 0.0, 0.0, 1.0]).kind
    'cable-cable'
    """
    found = violations(
        self, start, end, start_orientation, end_orientation, engine=engine, interference=interference
    )
    return next(iter(found), None)
