"""Tasks: picking payloads and setting them down."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import positive, whole
from ._given import file_name, function, instance, plain, table
from ._planning import turned
from ._questions import Engine, Interference
from ._results import Path
from ._scene import Scene
from ._search import search_options
from ._tables import Names
from ._trajectory import Trajectory
from ._values import ByValue
from .exceptions import FileError, InputError


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
        Why there is no path or, if legs are timed, no motion.
    carried : tuple of str
        Names of the payloads that are carried.
    touch : tuple of tuple of str
        Pairs of names that may touch on this leg, because a payload is picked or placed where it begins or ends.
    scene : Scene
        The scene that holds on the leg: what is carried is a part of the platform, and payloads stand where they were set down.
    motion : Trajectory or None
        The motion along the path in ``scene``, from rest to rest, if legs are timed; its times begin at 0.
    starts, ends : float or None
        When it starts and has ended in `Task.motion`, s; None if there is none.

    Examples
    --------
    >>> import cdpr
    >>> crate = {"body": {"box": [0.1, 0.1, 0.1], "position": [0, 0, -0.1]}, "mass": 2, "at": [1.7, 1, 0.3]}
    >>> rows = [{"pick": "crate"}, {"go": [1.7, 1, 1]}, {"place": "crate"}]
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
    motion: Trajectory | None = None
    starts: float | None = None
    ends: float | None = None

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
    motion : Trajectory or None
        The motion through all legs, which stops between them, if they are timed and each has a motion. It has samples only, as a .csv file
        has: exact states are those of `TaskLeg.motion`. Where payloads are picked or placed, tensions and what follows from them are those
        just before.
    actions : tuple of (float, str, str)
        What is done when in ``motion``: time, s, "pick" or "place", and the name of the payload; empty without a motion.

    Examples
    --------
    >>> import cdpr
    >>> crate = {"body": {"box": [0.1, 0.1, 0.1], "position": [0, 0, -0.1]}, "mass": 2, "at": [1.7, 1, 0.3]}
    >>> rows = [{"pick": "crate"}, {"go": [1.7, 1, 1]}, {"place": "crate"}]
    >>> cdpr.task(cdpr.example("hard1").replace(payloads={"crate": crate}, task=rows)).legs[1]
    TaskLeg(crate to (position), 0.7000 m)
    """

    legs: tuple[TaskLeg, ...]
    status: str
    cost: float
    motion: Trajectory | None = None
    actions: tuple[tuple[float, str, str], ...] = ()
    _json: str = field(default="{}", compare=False, kw_only=True)

    def save(self, folder: str | os.PathLike[str]) -> None:
        """Write the task into a folder, as ``cdpr task`` does, for ``cdpr check``.

        Parameters
        ----------
        folder : path
            It is made if it does not exist; task.json and the path of each leg, leg-1.json and so on, are written there, and if they are
            timed their motions, leg-1-motion.json and so on, and the one through all of them, motion.json. Files of a task that was
            saved there before are removed.

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
        _core.remove_earlier_task(name)
        written: dict[str, Any] = json.loads(self._json)
        for leg, keys in zip(self.legs, written["legs"]):
            leg.save(os.path.join(name, keys["path"]))
            if leg.motion is not None:
                leg.motion.save(os.path.join(name, keys["motion"]["file"]))
        if self.motion is not None:
            self.motion.save(os.path.join(name, written["motion"]["file"]))
        _core.save_text(os.path.join(name, "task.json"), json.dumps(written, indent=2) + "\n")

    def __repr__(self) -> str:
        """Show the length and the number of legs."""
        legs = f"{len(self.legs)} leg{'' if len(self.legs) == 1 else 's'}"
        return f"Task({f'{self.cost:.4f} m' if self.status == 'solved' else self.status}, {legs})"


def task(
    scene: Scene,
    *,
    motion: Mapping[str, float] | None = None,
    rate: float | None = None,
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
    motion : mapping, optional
        Also time the legs, each in the scene that holds then, with the mass and inertia of what is carried: the limits of :func:`trajectory`
        by name, which take precedence over those of the scene's table ``[motion]``; ``{}`` for the latter alone. A leg without a motion
        does not keep the others from being timed.
    rate : float, optional
        With ``motion``, samples per second; default 100, or as many hundreds as the leg with the largest accelerations needs.
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
        A scene without a task, bad options, limits that are too few or contradict each other.
    KeyboardInterrupt
        On Ctrl-C before the first search.

    Examples
    --------
    >>> crate = {"body": {"box": [0.1, 0.1, 0.1], "position": [0, 0, -0.1]}, "mass": 2, "at": [1.7, 1, 0.3]}
    >>> rows = [{"pick": "crate"}, {"go": [1.7, 1, 1]}, {"place": "crate"}, {"go": [0.3, 1, 0.3]}]
    >>> found = task(Scene.example("hard1").replace(payloads={"crate": crate}, task=rows))
    >>> found.status, [leg.carried for leg in found.legs]
    ('solved', [(), ('crate',), ()])

    One motion through all legs:

    >>> scene = Scene.example("hard1").replace(payloads={"crate": crate}, task=rows)
    >>> timed = task(scene, motion={"speed": 1, "acceleration": 2})
    >>> timed.motion
    Trajectory(10.497 s, 6.9854 m, 1051 samples)
    >>> timed.actions, timed.legs[1].starts
    (((4.97, 'pick', 'crate'), (6.18, 'place', 'crate')), 4.97)
    """
    instance("scene", scene, Scene)
    function("progress", progress)
    search = search_options("anytime", seed=seed, gap=gap, budget=budget, engine=engine, interference=interference, proof=True)
    count = None if threads is None else whole("threads", threads)
    if motion is None and rate is not None:
        raise InputError("rate: found without motion, where it has no effect; expected motion={...}")
    limits = None if motion is None else json.dumps(plain("motion", table("motion", motion)))
    samples = None if rate is None else positive("rate", rate)
    written, found, through = _core.task(turned(scene, orientation), search, limits, samples, count, progress)
    keys: dict[str, Any] = json.loads(written)
    legs = tuple(_leg(leg, *parts) for leg, parts in zip(keys["legs"], found, strict=True))
    actions = tuple(_action(**action) for action in keys.get("motion", {}).get("actions", ()))
    cost = sum((leg.cost for leg in legs), 0.0)
    return Task(legs, keys["status"], cost, None if through is None else Trajectory._of(through), actions, _json=written)


def _action(time: float, pick: str | None = None, place: str | None = None) -> tuple[float, str, str]:
    return (time, "place", str(place)) if pick is None else (time, "pick", pick)


def _leg(keys: dict[str, Any], written: str, scene: _core.Scene, timed: _core.Trajectory | None) -> TaskLeg:
    """Make a leg from JSON of the core."""
    motion: dict[str, Any] = keys.get("motion", {})
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
        reason=keys["reason"] or motion.get("reason"),
        carried=tuple(keys["carried"]),
        touch=tuple((first, second) for first, second in keys["touch"]),
        scene=Scene._of_core(scene),
        motion=None if timed is None else Trajectory._of(timed),
        starts=motion.get("start"),
        ends=motion.get("end"),
        _json=written,
    )
