"""Planning of many paths in one scene."""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import Executor
from typing import Any, TypeAlias, Unpack

from numpy.typing import ArrayLike

from . import _core
from ._arrays import as_numbers, thread_count
from ._executors import Progress, check, gathered, ranges
from ._given import instance, text
from ._planning import result_of, turn_of, turned
from ._results import Result, SearchTree
from ._scene import Scene
from ._search import Planner, SearchOptions, search_options, unknown_option
from ._stations import place
from .exceptions import InputError


def plan_many(
    scene: Scene,
    starts: ArrayLike | str | Sequence[str],
    goals: ArrayLike | str | Sequence[str],
    planner: Planner = "anytime",
    *,
    orientation: ArrayLike | str | None = None,
    start_orientation: ArrayLike | str | None = None,
    goal_orientation: ArrayLike | str | None = None,
    threads: int | None = None,
    executor: Executor | None = None,
    progress: Progress | None = None,
    **options: Unpack[SearchOptions],
) -> list[Result]:
    """Plan many paths in one scene, on all cores: the same results as of :func:`plan` one by one.

    The scene is compiled once. Without a time budget, results do not depend on the number of threads.

    Parameters
    ----------
    scene : Scene
    starts, goals : array_like (n, 3) or (3,), or sequence of str or str
        Positions of the platform's origin, world, m, or names of stations: a path for each row. A single one is that of all paths.
    planner : {"anytime", "two-trees", "rrt-connect", "modified-rrt", "rrt", "rrt-star"}
        "two-trees" gives most paths per second, "anytime" shorter ones.
    orientation, start_orientation, goal_orientation : array_like (4,) or str, optional
        For all paths, as in :func:`plan`.
    threads : int, optional
        Number of threads; default: all cores. With an executor, threads of each task, default 1.
    executor : concurrent.futures.Executor, optional
        Where to run; default: threads of this process. Any executor works: threads, processes, or a Dask cluster
        (``Client.get_executor()``). Workers receive parts of the rows, and compile the scene for each.
    progress : callable, optional
        Called now and then with the number of finished paths and the total number; an exception in it ends the work.
    **options
        Further keywords of :func:`plan`, from ``seed`` to ``proof``, except those about the motion. ``budget`` is the time limit
        of each path, s, without the time to compile the scene.

    Returns
    -------
    list of Result
        In the order of the rows, whatever the number of threads or workers. After Ctrl-C, the ``status`` of paths that were not
        found yet is "interrupted"; with an executor, that of all in tasks that were not finished.

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
    check(executor, progress)
    if unknown := unknown_option(options):
        raise TypeError(f"plan_many() got an unexpected keyword argument '{unknown}'")
    core, search = turned(scene, orientation), search_options(planner, **options)
    turns = (turn_of("start_orientation", start_orientation), turn_of("goal_orientation", goal_orientation))
    ends, count = _ends(starts, goals), thread_count(threads)
    if executor is None:
        found = _core.plan_many(core, search, ends, *turns, count, progress)
    else:
        parts, written = ranges(0, len(ends)), core.to_json()
        calls = [(written, search, ends[first:end], turns, 1 if count is None else count) for first, end in parts]
        sizes = [end - first for first, end in parts]
        none = _core.not_planned(core, search)
        together = gathered(executor, _work, calls, sizes, progress, [[none] * size for size in sizes])
        found = [each for part in together for each in part]
    return [result_of(written, SearchTree(*tree), certificate, None) for written, tree, certificate in found]


def _work(written: str, search: Any, ends: Any, turns: tuple[Any, Any], threads: int) -> list[_Found]:
    """Plan some of the paths in a worker; input and output are plain data."""
    return _core.plan_many(_core.Scene.from_json(written), search, ends, *turns, threads, None)


_Place: TypeAlias = str | tuple[float, float, float]
_Found: TypeAlias = tuple[str, tuple[Any, Any], str | None]


def _ends(starts: Any, goals: Any) -> list[tuple[_Place, _Place]]:
    """Return the start and goal of each path."""
    given = {"starts": _places("starts", starts), "goals": _places("goals", goals)}
    counts = {len(places) for places in given.values() if isinstance(places, list)}
    if len(counts) > 1:
        rows = " and ".join(f"{len(places)} {name}" for name, places in given.items())
        raise InputError(f"goals: found {rows}, expected as many, or one position")
    count = counts.pop() if counts else 1
    first, last = (places if isinstance(places, list) else [places] * count for places in given.values())
    return list(zip(first, last))


def _places(name: str, places: Any) -> _Place | list[_Place]:
    """Return one position or station, or a list of them."""
    if isinstance(places, str):
        return text(name, places)
    if isinstance(places, Sequence) and any(isinstance(each, str) for each in places):
        return [place(f"{name}[{k}]", each) for k, each in enumerate(places)]
    array = as_numbers(name, places)
    if array.ndim not in (1, 2) or array.shape[-1] != 3:
        raise InputError(f"{name}: found an array of shape {array.shape}, expected (n, 3) or (3,), or names of stations")
    rows: list[Any] = array.tolist()
    return tuple(rows) if array.ndim == 1 else [tuple(row) for row in rows]
