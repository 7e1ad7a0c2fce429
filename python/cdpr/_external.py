"""Planners of the user in experiments: they are called here, on the scenes of the trials; the core measures their paths."""

from __future__ import annotations

import inspect
import time
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import Floats, rows, shown
from ._results import Path, Result
from ._scene import Scene
from .exceptions import InputError

# Called with the scene of a trial and `seed=`, its seed; returns waypoints, (n, 3), a path or result, or None.
Planner: TypeAlias = Callable[..., "ArrayLike | Path | None"]

# Time between two calls of the progress function, s.
_PERIOD = 0.05


class Answer(NamedTuple):
    """What a planner has answered, as the core takes it."""

    status: str
    path: Floats
    seconds: float | None
    history: list[tuple[float, int, float]]


def named(methods: Any) -> tuple[Any, dict[int, Planner]]:
    """Return the methods with each function replaced by its name, and the functions by the numbers of their methods."""
    if not isinstance(methods, Sequence) or isinstance(methods, str):
        return methods, {}
    functions = {
        number: method["planner"]
        for number, method in enumerate(methods)
        if isinstance(method, Mapping) and callable(method.get("planner"))
    }
    for number, function in functions.items():
        _check_arguments(f"methods[{number}].planner", function)
    written = [
        {**method, "planner": f"python:{name_of(functions[number])}"} if number in functions else method
        for number, method in enumerate(methods)
    ]
    return written, functions


def name_of(function: Planner) -> str:
    known = function if hasattr(function, "__qualname__") else type(function)
    return f"{known.__module__}.{known.__qualname__}"


def _check_arguments(place: str, function: Planner) -> None:
    try:
        signature = inspect.signature(function)
    except (TypeError, ValueError):
        return  # not known, as for some functions in C
    try:
        signature.bind(None, seed=0)
    except TypeError as problem:
        raise InputError(f"{place}: found {name_of(function)}{signature}, expected a function of (scene, *, seed): {problem}") from None


def run(
    experiment: _core.Experiment,
    functions: Mapping[int, Planner],
    trials: range,
    finished: Callable[[int], object],
) -> tuple[dict[int, bytes], list[str]]:
    """Run the trials of the functions; return the rows of their groups, and what went wrong.

    `finished` is called now and then with the number of finished trials.
    """
    lines: dict[int, list[bytes]] = {}
    problems: dict[tuple[int, str], list[str]] = {}
    told, done, total = time.monotonic(), 0, len(trials) * len(functions) * len(experiment.scenarios)
    kept: dict[int, Scene] = {}
    decided: dict[int, str | None] = {}  # of groups whose trials have the same scene
    for trial in trials if functions else ():
        for number, (name, fixed) in enumerate(experiment.scenarios):
            scene = kept[number] if number in kept else Scene._of_core(experiment.scene(number, trial))
            if fixed:
                kept[number] = scene
            for method, function in functions.items():
                group = number * len(experiment.methods) + method
                seed = experiment.seed(group, trial)
                place = f"{name}, {experiment.methods[method][0]}, trial {trial} (seed {seed})"
                status = decided[group] if group in decided else experiment.foregone(group, scene._core)
                if fixed:
                    decided[group] = status
                answer, problem = _answer(function, scene, seed, place) if status is None else (_without(status), None)
                row, invalid = experiment.external_rows((group, trial), scene._core, *answer)
                lines.setdefault(group, []).append(row)
                for kind, reason in (("failed", problem), ("not valid", invalid)):
                    if reason is not None:
                        problems.setdefault((group, kind), []).append(f"{place}: {reason}")
                done += 1
                if done == total or time.monotonic() - told >= _PERIOD:
                    told = time.monotonic()
                    finished(done)
    return {group: b"".join(parts) for group, parts in lines.items()}, [_brief(kind, all_) for (_, kind), all_ in problems.items()]


def _brief(kind: str, problems: list[str]) -> str:
    more = f" (and {len(problems) - 1} more trials of this method)" if len(problems) > 1 else ""
    return f"{kind}: {problems[0]}{more}"


def _without(status: str, seconds: float | None = None) -> Answer:
    return Answer(status, np.empty((0, 3)), seconds, [])


def _answer(function: Planner, scene: Scene, seed: int, place: str) -> tuple[Answer, str | None]:
    """Call a function, and return its answer and the exception that it raised, in words."""
    began = time.perf_counter()
    try:
        found = function(scene, seed=seed)
    except Exception as problem:
        seconds = time.perf_counter() - began
        return _without("failed", seconds), f"{type(problem).__name__}: {problem}"
    seconds = time.perf_counter() - began
    if found is None:
        return _without("unsolved", seconds), None
    if isinstance(found, Result) and not found.solved:
        return _without(found.status, seconds), None
    return Answer("solved", _path(found, place), seconds, _history(found)), None


def _path(found: ArrayLike | Path, place: str) -> Floats:
    """Return the waypoints that a function has returned."""
    if isinstance(found, Path) and found.orientations is not None:
        raise InputError(f"{place}: found a path on which the platform turns, expected one on which it keeps its orientation")
    try:
        waypoints = rows("waypoints", found.waypoints if isinstance(found, Path) else found)
    except InputError as problem:
        raise InputError(f"{place}: found {shown(found)}, expected waypoints (n, 3), a path or None: {problem}") from None
    if len(waypoints) < 2:
        raise InputError(f"{place}: found {len(waypoints)} waypoints, expected at least two, or None without a path")
    return waypoints


def _history(found: Any) -> list[tuple[float, int, float]]:
    return [(m.seconds, m.samples, m.cost) for m in found.history] if isinstance(found, Result) else []
