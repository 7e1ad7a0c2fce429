"""Queries of a scene: validity, clearance, violations. These functions are methods of `Scene`."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._arrays import Floats, Shape, flat_points, point, rows, shaped, thread_count
from ._given import text
from ._violation import Violation, violation_from
from .exceptions import InputError

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
    *,
    engine: Engine = "cspace",
    interference: Interference = "exact",
    threads: int | None = None,
) -> NDArray[np.bool_]:
    """Whether each position of the platform is valid.

    Parameters
    ----------
    points : array_like (..., 3)
        Positions of the platform's origin, world, m. C-contiguous float64 is not copied.
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
    >>> scene = cdpr.Scene.load("testdata/scenes/hard1.toml")
    >>> bool(scene.states_valid([0.3, 1.0, 0.3])), scene.states_valid([[0.3, 1.0, 0.3], [1.0, 1.0, 1.0]])
    (True, array([ True, False]))
    """
    flat, shape = flat_points("points", points)
    return shaped(self._core.states_valid(flat, *judges(engine, interference), thread_count(threads)), shape)


def motions_valid(
    self: Scene,
    starts: ArrayLike,
    ends: ArrayLike,
    *,
    engine: Engine = "cspace",
    interference: Interference = "exact",
    threads: int | None = None,
) -> NDArray[np.bool_]:
    """Whether each straight motion of the platform, at fixed orientation, is valid.

    Parameters
    ----------
    starts, ends : array_like (..., 3)
        Positions of the platform's origin, world, m: one end for each start, or a single one for all. C-contiguous
        float64 is not copied.
    engine : {"cspace", "gjk"}
    interference : {"exact", "swept"}
        "swept" is the paper's stricter rule for pairs of cables.
    threads : int, optional
        Default all cores; the answers do not depend on it.

    Returns
    -------
    ndarray of bool (...)
        A NumPy scalar for a single motion.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.Scene.load("testdata/scenes/hard1.toml")
    >>> scene.motions_valid([[0.3, 1.0, 0.3], [0.3, 1.0, 0.3]], [[1.7, 1.0, 1.7], [0.3, 1.0, 0.8]])
    array([False,  True])
    """
    (first, shape), (last, other) = flat_points("starts", starts), flat_points("ends", ends)
    if shape != other:
        first, last, shape = _paired(first.reshape(*shape, 3), last.reshape(*other, 3))
    return shaped(self._core.motions_valid(first, last, *judges(engine, interference), thread_count(threads)), shape)


def _paired(starts: Floats, ends: Floats) -> tuple[Floats, Floats, Shape]:
    try:
        first, last = np.broadcast_arrays(starts, ends)
    except ValueError:
        found = f"found an array of shape {ends.shape}"
        raise InputError(f"ends: {found}, expected {starts.shape}, one for each start, or a single one") from None
    return rows("starts", first.reshape(-1, 3)), rows("ends", last.reshape(-1, 3)), first.shape[:-1]


def clearance(self: Scene, points: ArrayLike, *, threads: int | None = None) -> Floats:
    """Signed clearance of each position: the smallest gap between bodies that must not touch.

    Parameters
    ----------
    points : array_like (..., 3)
        Positions of the platform's origin, world, m. C-contiguous float64 is not copied.
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
    >>> scene = cdpr.Scene.load("testdata/scenes/hard1.toml")
    >>> scene.clearance([[0.3, 1.0, 0.3], [1.0, 1.0, 1.7]]).round(6)
    array([0.05    , 0.024121])
    """
    flat, shape = flat_points("points", points)
    return shaped(self._core.clearance(flat, thread_count(threads)), shape)


def violations(
    self: Scene,
    start: ArrayLike,
    end: ArrayLike | None = None,
    *,
    engine: Engine = "cspace",
    interference: Interference = "exact",
) -> tuple[Violation, ...]:
    """Every violation at a position or along a straight motion; `cdpr.check` checks a whole path.

    Parameters
    ----------
    start : array_like (3,)
        Position of the platform's origin, world, m.
    end : array_like (3,), optional
        End of a straight motion from ``start``, m; default: only the position is checked.
    engine : {"cspace", "gjk"}
    interference : {"exact", "swept"}

    Returns
    -------
    tuple of Violation
        Every condition that is violated, in the order in which the violations begin; empty if there are none.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.Scene.load("testdata/scenes/hard1.toml")
    >>> [violation.culprits for violation in scene.violations([1.0, 1.0, 1.5])][:2]
    [('platform', 'pillar'), ('cable 0', 'pillar')]
    >>> scene.violations([0.3, 1.0, 0.3])
    ()
    """
    first = point("start", start)
    last = first if end is None else point("end", end)
    found = json.loads(self._core.violations(first, last, *judges(engine, interference)))
    return tuple(violation_from(values) for values in found)


def explain_motion(
    self: Scene,
    start: ArrayLike,
    end: ArrayLike,
    *,
    engine: Engine = "cspace",
    interference: Interference = "exact",
) -> Violation | None:
    """Why a motion is invalid: the condition that it violates first, or None if it is valid.

    Parameters
    ----------
    start, end : array_like (3,)
        Positions of the platform's origin, world, m; if they are equal, the position is checked.
    engine : {"cspace", "gjk"}
    interference : {"exact", "swept"}

    Returns
    -------
    Violation or None

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.Scene.load("testdata/scenes/hard1.toml")
    >>> found = scene.explain_motion([0.3, 1.0, 0.3], [1.7, 1.0, 1.7])
    >>> found.kind, found.culprits
    ('cable-obstacle', ('cable 1', 'pillar'))
    """
    return next(iter(violations(self, start, end, engine=engine, interference=interference)), None)
