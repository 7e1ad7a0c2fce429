"""Planning of many paths in one scene."""

from __future__ import annotations

from collections.abc import Callable
from typing import Unpack

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import Floats, as_numbers, shown, whole
from ._given import instance
from ._planning import result_of, turn_of, turned
from ._results import Result, SearchTree
from ._scene import Scene
from ._search import Planner, SearchOptions, search_options
from .exceptions import InputError


def plan_many(
    scene: Scene,
    starts: ArrayLike,
    goals: ArrayLike,
    planner: Planner = "anytime",
    *,
    orientation: ArrayLike | str | None = None,
    start_orientation: ArrayLike | str | None = None,
    goal_orientation: ArrayLike | str | None = None,
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
    **options: Unpack[SearchOptions],
) -> list[Result]:
    """Plan many paths in one scene, on all cores: the same results as of :func:`plan` one by one.

    The scene is compiled once. Without a time budget, results do not depend on the number of threads.

    Parameters
    ----------
    scene : Scene
    starts, goals : array_like (n, 3) or (3,)
        Positions of the platform's origin, world, m: a path for each row. A single position is that of all paths.
    planner : {"anytime", "two-trees", "rrt-connect", "modified-rrt", "rrt", "rrt-star"}
        "two-trees" gives most paths per second, "anytime" shorter ones.
    orientation, start_orientation, goal_orientation : array_like (4,) or str, optional
        For all paths, as in :func:`plan`.
    threads : int, optional
        Number of threads; default: all cores.
    progress : callable, optional
        Called now and then with the number of finished paths and the total number; an exception in it ends the work.
    **options
        Further keywords of :func:`plan`, from ``seed`` to ``proof``, except those about the motion. ``budget`` is the time limit
        of each path, s, without the time to compile the scene.

    Returns
    -------
    list of Result
        In the order of the rows. After Ctrl-C, the ``status`` of paths that were not found yet is "interrupted".

    Raises
    ------
    InputError
        Arrays of wrong shape, bad options. An invalid start or goal is no error: see ``status``.
    KeyboardInterrupt
        On Ctrl-C while the scene is compiled.

    Examples
    --------
    >>> scene = Scene.example("hard1")
    >>> goals = [[1.7, 1, 1.7], [1.7, 1, 0.3], [1, 1, 0.5]]
    >>> [(path.status, round(path.cost, 3)) for path in plan_many(scene, scene.start, goals)]
    [('solved', 2.435), ('solved', 3.469), ('goal_invalid', nan)]
    """
    instance("scene", scene, Scene)
    if progress is not None and not callable(progress):
        raise InputError(f"progress: found {shown(progress)}, expected a function")
    if unknown := set(options) - set(SearchOptions.__annotations__):
        raise TypeError(f"plan_many() got an unexpected keyword argument '{min(unknown)}'")
    first, last = _ends(starts, goals)
    found = _core.plan_many(
        turned(scene, orientation),
        search_options(planner, **options),
        first,
        last,
        turn_of("start_orientation", start_orientation),
        turn_of("goal_orientation", goal_orientation),
        None if threads is None else whole("threads", threads),
        progress,
    )
    return [result_of(written, SearchTree(*tree), certificate, None) for written, tree, certificate in found]


def _ends(starts: ArrayLike, goals: ArrayLike) -> list[Floats]:
    """Return starts and goals as arrays (n, 3)."""
    given = {"starts": as_numbers("starts", starts), "goals": as_numbers("goals", goals)}
    for name, array in given.items():
        if array.ndim not in (1, 2) or array.shape[-1] != 3:
            raise InputError(f"{name}: found an array of shape {array.shape}, expected (n, 3) or (3,)")
    counts = {len(array) for array in given.values() if array.ndim == 2}
    if len(counts) > 1:
        rows = " and ".join(f"{len(array)} {name}" for name, array in given.items())
        raise InputError(f"goals: found {rows}, expected as many, or one position")
    count = counts.pop() if counts else 1
    return [np.ascontiguousarray(np.broadcast_to(array, (count, 3))) for array in given.values()]
