"""Tasks: picking payloads and setting them down."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import whole
from ._given import file_name, function, instance
from ._planning import turned
from ._questions import Engine, Interference
from ._results import Path
from ._scene import Scene
from ._search import search_options
from ._tables import Names
from ._values import ByValue
from .exceptions import FileError


@dataclass(frozen=True, eq=False, repr=False)
class TaskLeg(Path):
    """A leg of a task: the path from one stop to the next; see `Task.legs`.

    Attributes
    ----------
    waypoints : ndarray (k, 3)
        Positions of the platform's origin, world, m; (0, 3) without a path.
    cost : float
        Length, m; infinite without a path.
    orientation : ndarray (4,)
        World-from-platform unit quaternion w x y z of the leg's scene.
    orientations : ndarray (k, 4) or None
        Unit quaternion w x y z at each waypoint, if the platform turns.
    start, goal : str or None
        The station or payload where it begins and ends, if it was named.
    status : str
        How planning ended, as in :class:`Result`.
    reason : str or None
        Why there is no path, if there is none.
    carried : tuple of str
        Names of the payloads that are carried.
    touch : tuple of tuple of str
        Pairs of names that may touch on this leg, because a payload is picked or placed where it begins or ends.
    scene : Scene
        The scene that holds on the leg: what is carried is a part of the platform, and payloads stand where they were set down.

    Examples
    --------
    >>> import cdpr
    >>> crate = {"body": {"box": [0.1, 0.1, 0.1], "position": [0, 0, -0.1]}, "mass": 2, "at": [1.7, 1, 0.3]}
    >>> rows = [{"pick": "crate"}, {"go": [1.7, 0.4, 0.3]}, {"place": "crate"}]
    >>> leg = cdpr.task(cdpr.example("hard1").replace(payloads={"crate": crate}, task=rows)).legs[1]
    >>> leg.start, leg.carried, cdpr.check(leg.scene, leg).valid
    ('crate', ('crate',), True)
    """

    start: str | None = None
    goal: str | None = None
    status: str = "solved"
    reason: str | None = None
    carried: tuple[str, ...] = ()
    touch: tuple[Names, ...] = ()
    scene: Scene | None = None

    def __repr__(self) -> str:
        """Show the ends and the length or the status."""
        ends = " to ".join(end or "(position)" for end in (self.start, self.goal))
        return f"TaskLeg({ends}, {f'{self.cost:.4f} m' if len(self.waypoints) else self.status})"


@dataclass(frozen=True, eq=False, repr=False)
class Task(ByValue):
    """A planned task.

    Attributes
    ----------
    legs : tuple of TaskLeg
        The paths from each stop to the next.
    status : str
        "solved" if all legs have paths, else the status of the first one that has none.
    cost : float
        Length of all legs, m; infinite if one has no path.

    Examples
    --------
    >>> import cdpr
    >>> crate = {"body": {"box": [0.1, 0.1, 0.1], "position": [0, 0, -0.1]}, "mass": 2, "at": [1.7, 1, 0.3]}
    >>> rows = [{"pick": "crate"}, {"go": [1.7, 0.4, 0.3]}, {"place": "crate"}]
    >>> cdpr.task(cdpr.example("hard1").replace(payloads={"crate": crate}, task=rows)).legs[1]
    TaskLeg(crate to (position), 0.6000 m)
    """

    legs: tuple[TaskLeg, ...]
    status: str
    cost: float
    _json: str = field(default="{}", compare=False, kw_only=True)

    def save(self, folder: str | os.PathLike[str]) -> None:
        """Write the task into a folder, as ``cdpr task`` does, for ``cdpr check``.

        Parameters
        ----------
        folder : path
            It is made if it does not exist; task.json and the path of each leg, leg-1.json and so on, are written there.

        Raises
        ------
        FileError
            A folder or file that cannot be written.
        """
        name = file_name(folder)
        try:
            os.makedirs(name, exist_ok=True)
        except OSError as problem:
            raise FileError(f"{name}: cannot be created: {problem}") from None
        for leg, keys in zip(self.legs, json.loads(self._json)["legs"]):
            leg.save(os.path.join(name, keys["path"]))
        _core.save_text(os.path.join(name, "task.json"), json.dumps(json.loads(self._json), indent=2) + "\n")

    def __repr__(self) -> str:
        """Show the length and the number of legs."""
        legs = f"{len(self.legs)} leg{'' if len(self.legs) == 1 else 's'}"
        return f"Task({f'{self.cost:.4f} m' if self.status == 'solved' else self.status}, {legs})"


def task(
    scene: Scene,
    *,
    gap: float | None = None,
    budget: float | None = None,
    seed: int = 0,
    orientation: ArrayLike | str | None = None,
    engine: Engine = "cspace",
    interference: Interference = "exact",
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Task:
    """Plan the task of a scene: each leg in the scene that holds then.

    On a leg, a carried payload is a part of the platform and of its mass; the others are obstacles where they stand. A leg without a path
    does not keep the others from being planned. Where a payload is picked or placed, it may touch what it stands on, and the platform may
    touch it, on the legs that begin or end there.

    Parameters
    ----------
    scene : Scene
        With ``payloads`` and ``task``. The task begins at its start or, without one, where the first row goes.
    gap : float, optional
        Search on each leg until the path is proved to be at most this fraction longer than the shortest. Where wrenches or
        clearances bind, that may never be: give a budget as well.
    budget : float, optional
        Time limit of each leg, s. Without it, the result does not depend on the number of threads.
    seed : int
        Seed of all random numbers.
    orientation : array_like (4,) or str, optional
        As in :func:`plan`.
    engine : {"cspace", "gjk"}
    interference : {"exact", "swept"}
    threads : int, optional
        Number of threads; default: all cores.
    progress : callable, optional
        Called now and then with the number of planned legs and the total number; an exception in it ends the work.

    Returns
    -------
    Task
        After Ctrl-C, legs that were not planned yet are "interrupted".

    Raises
    ------
    InputError
        A scene without a task, bad options.
    KeyboardInterrupt
        On Ctrl-C before the first search.

    Examples
    --------
    >>> crate = {"body": {"box": [0.1, 0.1, 0.1], "position": [0, 0, -0.1]}, "mass": 2, "at": [1.7, 1, 0.3]}
    >>> rows = [{"pick": "crate"}, {"go": [1.7, 0.4, 0.3]}, {"place": "crate"}, {"go": [0.3, 1, 0.3]}]
    >>> found = task(Scene.example("hard1").replace(payloads={"crate": crate}, task=rows))
    >>> found.status, [leg.carried for leg in found.legs]
    ('solved', [(), ('crate',), ()])
    """
    instance("scene", scene, Scene)
    function("progress", progress)
    search = search_options("anytime", seed=seed, gap=gap, budget=budget, engine=engine, interference=interference, proof=True)
    count = None if threads is None else whole("threads", threads)
    written, paths = _core.task(turned(scene, orientation), search, count, progress)
    keys: dict[str, Any] = json.loads(written)
    legs = tuple(_leg(leg, *path) for leg, path in zip(keys["legs"], paths, strict=True))
    return Task(legs, keys["status"], sum((leg.cost for leg in legs), 0.0), _json=written)


def _leg(keys: dict[str, Any], written: str, scene: _core.Scene) -> TaskLeg:
    """Make a leg from JSON of the core."""
    path: dict[str, Any] = json.loads(written)
    turns = path.get("orientations")
    return TaskLeg(
        np.array(path["waypoints"], dtype=np.float64).reshape(-1, 3),
        float("inf") if keys["cost"] is None else float(keys["cost"]),
        np.array(path["orientation"]),
        orientations=None if turns is None else np.array(turns).reshape(-1, 4),
        start=keys["from"].get("name"),
        goal=keys["to"].get("name"),
        status=keys["status"],
        reason=keys["reason"],
        carried=tuple(keys["carried"]),
        touch=tuple((first, second) for first, second in keys["touch"]),
        scene=Scene._of_core(scene),
        _json=written,
    )
