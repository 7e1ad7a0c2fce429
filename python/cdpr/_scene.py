"""Scenes."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Iterable, Mapping, Sequence
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _core, _obstacles, _payloads, _questions, _shadows
from ._arrays import Floats, finite
from ._given import file_name, instance, plain, table, text
from ._payloads import SCENE
from ._robot import Robot
from ._stations import Station
from ._tables import KEPT, QUERY, Bodies, Clearances, Kept, Names, box_table, put
from ._values import Immutable
from .exceptions import CdprWarning, InputError


class Scene(Immutable):
    """A robot among obstacles in a workspace, with a planning query.

    Parameters
    ----------
    robot : Robot
    obstacles : mapping of str to array_like, mesh or mapping
        Corners of each convex obstacle, (k, 3), world, m; a concave one is a sequence of several such arrays. A mesh,
        concave or not, is any object with ``vertices`` (n, 3), world, m, and ``faces`` (m, 3), such as those of
        trimesh: it is replaced by convex parts that cover it, and a `CdprWarning` states how far they extend beyond it.
        A mapping is a table of a scene file, such as ``{"box": [1, 1, 2], "position": [0, 0, 1]}``.
    workspace : array_like (2, 3)
        Smallest and largest coordinates, m; every platform corner must stay within this box.
    start, goal : array_like (3,) or str, optional
        Positions of the platform's origin, world, m, or names of stations.
    orientation : array_like (4,) or str, optional
        World-from-platform unit quaternion w x y z, held along the whole path, or the name of one of `orientations`. If
        omitted, planning uses the one of `orientations` with the shortest path, paths are checked at their own
        orientation, and everything else uses the first, with a `CdprWarning`; without `orientations`, no rotation.
    orientations : mapping of str to array_like (4,) or mapping, optional
        Named orientations: quaternions as above, or tables of a scene file, such as ``{"rpy_degrees": [0, 0, 90]}``.
    stations : mapping of str to array_like (3,), mapping or Station, optional
        Named positions of the platform's origin, world, m, for starts and goals; or tables of a scene file, such as
        ``{"position": [1, 2, 3], "orientation": [1, 0, 0, 0]}``, if the platform has an orientation of its own there.
    payloads : mapping of str to mapping, optional
        What the platform can carry, each a table of a scene file: ``{"body": {"box": [0.4, 0.4, 0.3], "position": [0, 0, -0.2]},
        "mass": 5, "at": "rack"}``; ``body`` may also be as in ``obstacles``, in the frame of the platform that carries it.
    task : iterable of mapping, optional
        What `cdpr.task` plans, row by row, such as ``[{"pick": "crate"}, {"go": "mill"}, {"place": "crate"}]``.
    start_orientation, goal_orientation : array_like (4,) or str, optional
        Orientations at start and goal, if the platform turns on its way; default those of the stations, else ``orientation``.
    clearance : float, default 0
        Minimum distance between bodies that must not touch, m.
    clearances : mapping of str or tuple of str to float, optional
        Clearances that differ from ``clearance``, m: of a kind, "platform_obstacle", "cable_obstacle", "cable_platform"
        or "cable_cable", or of a pair of names such as ``("cable 1", "pillar")``, which takes precedence over its kind.
    touch : iterable of tuple of str, optional
        Pairs of names that may touch but not overlap, such as ``("platform", "conveyor")``.
    ignore : iterable of tuple of str, optional
        Pairs of names that are not checked against each other.
    gravity : array_like (3,), optional
        World axes, m/s²; default (0, 0, -9.81).
    wrench : mapping, optional
        Requirements on wrench feasibility, as in the table ``[wrench]`` of a scene file: ``{"force": 50, "moment": 5}``
        requires balls of 50 N and 5 N·m, ``{}`` the weight alone. If omitted, wrench feasibility is not checked.
    motion : mapping, optional
        Limits of `cdpr.trajectory`, as in the table ``[motion]`` of a scene file: ``{"speed": 1, "acceleration": 2}``.
    turning : mapping, optional
        How the platform may turn on its way, as in the table ``[turning]`` of a scene file: ``{"axis": [0, 0, 1]}`` for
        turns about the vertical, ``{"max_tilt": 20}`` for tilts up to 20°, ``{}`` for any. If omitted, it only turns if
        start and goal differ in orientation.
    name : str, optional
        Name used in messages and figures.

    Raises
    ------
    InputError
        Wrong shapes, numbers that are not finite, an obstacle without volume or with a corner inside its hull, an outlet
        inside an obstacle.

    Examples
    --------
    >>> scene = Scene.example("hard1")
    >>> scene
    Scene('hard1', 8 cables, 1 obstacle)
    >>> scene.states_valid([[0.3, 1.0, 0.3], [1.0, 1.0, 1.0]])
    array([ True, False])
    """

    def __init__(
        self,
        robot: Robot,
        obstacles: Mapping[str, Bodies] | None = None,
        *,
        workspace: ArrayLike,
        start: ArrayLike | str | None = None,
        goal: ArrayLike | str | None = None,
        orientation: ArrayLike | str | None = None,
        orientations: Mapping[str, ArrayLike | Mapping[str, Any]] | None = None,
        stations: Mapping[str, ArrayLike | Mapping[str, Any] | Station] | None = None,
        payloads: Mapping[str, Mapping[str, Any]] | None = None,
        task: Iterable[Mapping[str, Any]] | None = None,
        start_orientation: ArrayLike | str | None = None,
        goal_orientation: ArrayLike | str | None = None,
        clearance: float = 0.0,
        clearances: Clearances | None = None,
        touch: Iterable[Names] = (),
        ignore: Iterable[Names] = (),
        gravity: ArrayLike | None = None,
        wrench: Mapping[str, Any] | None = None,
        motion: Mapping[str, Any] | None = None,
        turning: Mapping[str, Any] | None = None,
        name: str | None = None,
    ) -> None:
        """See the class."""
        query = {"start": start, "goal": goal, "orientation": orientation}
        query |= {"start_orientation": start_orientation, "goal_orientation": goal_orientation}
        spec: dict[str, Any] = {
            "version": 1,
            "robot": _robot_table(robot),
            "workspace": box_table(workspace),
            "clearance": finite("clearance", clearance),
            "query": {key: QUERY[key](value) for key, value in query.items() if value is not None},
        }
        given: dict[str, Any] = {"obstacles": obstacles, "orientations": orientations, "clearances": clearances}
        given |= {"touch": touch, "ignore": ignore, "gravity": gravity, "wrench": wrench, "motion": motion}
        given |= {"turning": turning, "stations": stations, "payloads": payloads, "task": task, "name": name}
        for key, value in given.items():
            put(spec, key, value, SCENE[key])
        self._keep(_from_spec(spec))
        self._warned()

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Scene:
        """Load a scene file.

        Parameters
        ----------
        path : path
            .toml or .json.

        Returns
        -------
        Scene

        Raises
        ------
        FileError
            It cannot be read, or its name has another extension.
        InputError
            Bad contents; the message names file, key, what was found and what is expected.
        """
        return cls._of_core(_core.Scene.load(file_name(path)))._warned()

    @classmethod
    def example(cls, name: str) -> Scene:
        """Make one of the example scenes that the package contains.

        Parameters
        ----------
        name : str
            Name of the scene: ``hard1`` (one pillar) and ``hard3`` (three) with the robot of the paper's study; ``cogiro``,
            ``caroca``, ``acrobot``, ``ipanema2``, ``mpi_simulator`` with built robots; ``forest`` (thirty pillars); ``turn``
            (the platform must turn); ``closed`` (no path); ``plank``, ``concave``, ``empty``, ``hard1_rank6``,
            ``hard3_rank6``, ``empty_rank6``.

        Returns
        -------
        Scene

        Raises
        ------
        InputError
            Another name; the message lists all.

        Warns
        -----
        CdprWarning
            As for `load`.

        Examples
        --------
        >>> import cdpr
        >>> cdpr.example("hard1")
        Scene('hard1', 8 cables, 1 obstacle)
        """
        return cls._of_core(_core.Scene.from_json(_core.example(text("name", name))))._warned()

    @classmethod
    def from_dict(cls, spec: Mapping[str, Any]) -> Scene:
        """Make a scene from the contents of a scene file.

        Parameters
        ----------
        spec : mapping
            The contents of a scene file with an inline robot, such as :meth:`to_dict` returns.

        Returns
        -------
        Scene

        Raises
        ------
        InputError
            Names the key, what was found and what is expected.
        """
        return cls._of_core(_from_spec(table("scene", spec)))._warned()

    def _warned(self, level: int = 3, told: Sequence[str] = ()) -> Scene:
        """Give the warnings of the scene, except those already told; `level` is how far the caller is away."""
        for note in self._core.warnings(list(told)):
            warnings.warn(note, CdprWarning, stacklevel=level)
        return self

    def _keep(self, core: _core.Scene) -> None:
        self._core = core
        self._spec: dict[str, Any] = json.loads(core.to_json())
        # Payloads among the obstacles or on the platform.
        self._plain: dict[str, Any] = json.loads(core.plain()) if "payloads" in self._spec else self._spec

    def to_dict(self) -> dict[str, Any]:
        """Return the contents of a scene file.

        Returns
        -------
        dict
            A copy, with an inline robot, as accepted by :meth:`from_dict`.
        """
        copy: dict[str, Any] = json.loads(self._core.to_json())
        return copy

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write a scene file with an inline robot.

        Parameters
        ----------
        path : path
            .toml or .json. A scene without a name is named after its file when it is loaded again.

        Raises
        ------
        FileError
            Another extension, or a file that cannot be written; nothing half-written is left.
        """
        self._core.save(file_name(path))

    def replace(
        self,
        *,
        robot: Robot | None = None,
        obstacles: Mapping[str, Bodies] | None | Kept = KEPT,
        workspace: ArrayLike | None = None,
        start: ArrayLike | str | None | Kept = KEPT,
        goal: ArrayLike | str | None | Kept = KEPT,
        orientation: ArrayLike | str | None | Kept = KEPT,
        orientations: Mapping[str, ArrayLike | Mapping[str, Any]] | None | Kept = KEPT,
        stations: Mapping[str, ArrayLike | Mapping[str, Any] | Station] | None | Kept = KEPT,
        payloads: Mapping[str, Mapping[str, Any]] | None | Kept = KEPT,
        task: Iterable[Mapping[str, Any]] | None | Kept = KEPT,
        start_orientation: ArrayLike | str | None | Kept = KEPT,
        goal_orientation: ArrayLike | str | None | Kept = KEPT,
        clearance: float | None = None,
        clearances: Clearances | None | Kept = KEPT,
        touch: Iterable[Names] | None | Kept = KEPT,
        ignore: Iterable[Names] | None | Kept = KEPT,
        gravity: ArrayLike | None | Kept = KEPT,
        wrench: Mapping[str, Any] | None | Kept = KEPT,
        motion: Mapping[str, Any] | None | Kept = KEPT,
        turning: Mapping[str, Any] | None | Kept = KEPT,
        name: str | None | Kept = KEPT,
    ) -> Scene:
        """Return a copy of the scene with the given changes.

        Parameters
        ----------
        robot : Robot, optional
        obstacles : mapping or None, optional
            All obstacles, as in the class; None removes them. See also `with_obstacle` and `without`.
        workspace : array_like (2, 3), optional
            Smallest and largest coordinates, m.
        start, goal : array_like (3,), str or None, optional
            Positions of the platform's origin, world, m, or names of stations; None removes them.
        orientation : array_like (4,), str or None, optional
            World-from-platform unit quaternion w x y z, or the name of one of the scene's orientations; None means the
            first of those, or no rotation.
        orientations : mapping or None, optional
            All named orientations, as in the class; None removes them.
        stations : mapping or None, optional
            All stations, as in the class; None removes them.
        payloads : mapping or None, optional
            All payloads, as in the class; None removes them.
        task : iterable of mapping or None, optional
            All rows of the task, as in the class; None removes them.
        start_orientation, goal_orientation : array_like (4,), str or None, optional
            Orientations at start and goal, as in the class; None removes them.
        clearance : float, optional
            Metres.
        clearances : mapping or None, optional
            All clearances by kind and pair, as in the class; None removes them.
        touch, ignore : iterable of tuple of str or None, optional
            All such pairs; None removes them.
        gravity : array_like (3,) or None, optional
            World axes, m/s²; None means (0, 0, -9.81).
        wrench : mapping or None, optional
            Requirements on wrench feasibility, as in the class; None removes them.
        motion : mapping or None, optional
            Limits of motions, as in the class; None removes them.
        turning : mapping or None, optional
            How the platform may turn, as in the class; None removes it.
        name : str or None, optional
            None removes it.

        Returns
        -------
        Scene

        Raises
        ------
        InputError
            Values that `Scene` refuses.

        Examples
        --------
        >>> scene = Scene.example("hard1")
        >>> wide = scene.replace(clearance=0.02, goal=[1.7, 1.0, 1.0])
        >>> wide.required_clearance, scene.required_clearance
        (0.02, 0.0)
        """
        spec = self.to_dict()
        if robot is not None:
            spec["robot"] = _robot_table(robot)
        given: dict[str, Any] = {"obstacles": obstacles, "orientations": orientations, "clearances": clearances}
        given |= {"touch": touch, "ignore": ignore, "gravity": gravity, "wrench": wrench, "motion": motion}
        given |= {"turning": turning, "stations": stations, "payloads": payloads, "task": task, "name": name}
        given |= {"workspace": KEPT if workspace is None else workspace}
        given |= {"clearance": KEPT if clearance is None else clearance}
        for key, value in given.items():
            put(spec, key, value, SCENE[key])
        query = spec.setdefault("query", {})
        asked = {"start": start, "goal": goal, "orientation": orientation}
        asked |= {"start_orientation": start_orientation, "goal_orientation": goal_orientation}
        for key, value in asked.items():
            put(query, key, value, QUERY[key])
        return self._edited(spec)

    __replace__ = replace  # copy.replace of Python 3.13

    def _edited(self, spec: dict[str, Any]) -> Scene:
        return self._of_core(_from_spec(spec))._warned(level=4, told=self._core.notes())

    @property
    def robot(self) -> Robot:
        """The robot; payloads that it carries are parts of its platform and of its mass."""
        return Robot._of_sound(self._plain["robot"])

    @property
    def obstacles(self) -> Mapping[str, tuple[Floats, ...]]:
        """Obstacles by name, also payloads that stand, read-only: the corners of each convex part, (k, 3), world, m.

        Examples
        --------
        >>> corners = Scene.example("hard1").obstacles["pillar"][0]
        >>> corners.min(axis=0), corners.max(axis=0)
        (array([0.85, 0.85, 0.  ]), array([1.15, 1.15, 1.5 ]))
        """
        drawn = json.loads(self._core.bodies())["obstacles"]
        bodies = {body["name"]: tuple(_read_only(part["vertices"]) for part in body["parts"]) for body in drawn}
        return MappingProxyType(bodies)

    @property
    def gravity(self) -> Floats:
        """World axes, (3,), m/s²."""
        return np.array(self._spec.get("gravity", _core.GRAVITY), dtype=np.float64)

    @property
    def wrench(self) -> Mapping[str, Any] | None:
        """Requirements on wrench feasibility, read-only, as in the table of a scene file; None if there are none."""
        demand = self.to_dict().get("wrench")
        return None if demand is None else MappingProxyType(demand)

    @property
    def motion(self) -> Mapping[str, Any] | None:
        """Limits of motions, read-only, as in the table of a scene file; None if there are none."""
        limits = self.to_dict().get("motion")
        return None if limits is None else MappingProxyType(limits)

    @property
    def turning(self) -> Mapping[str, Any] | None:
        """How the platform may turn, read-only, as in the table of a scene file; None if the scene does not say."""
        limits = self.to_dict().get("turning")
        return None if limits is None else MappingProxyType(limits)

    @property
    def notes(self) -> tuple[str, ...]:
        """Remarks about the scene, and how meshes were replaced by convex parts. One warning stands for many alike."""
        return tuple(self._core.notes())

    @property
    def workspace(self) -> Floats:
        """Smallest and largest coordinates that every platform corner must stay within, (2, 3), m."""
        return np.array([self._spec["workspace"][key] for key in ("min", "max")], dtype=np.float64)

    @property
    def position_box(self) -> Floats:
        """Smallest and largest coordinates of the platform's origin with the platform inside the workspace, (2, 3), m.

        Examples
        --------
        >>> Scene.example("hard1").position_box
        array([[0.075, 0.075, 0.025],
               [1.925, 1.925, 1.975]])
        """
        return np.array(self._core.position_box(), dtype=np.float64)

    @property
    def orientation(self) -> Floats:
        """World-from-platform unit quaternion w x y z, (4,): the one selected, else the first of `orientations`."""
        return np.array(self._core.orientation(), dtype=np.float64)

    @property
    def orientations(self) -> Mapping[str, Floats]:
        """Named orientations, read-only: world-from-platform unit quaternions w x y z, (4,).

        Examples
        --------
        >>> scene = Scene.example("plank")
        >>> list(scene.orientations), scene.replace(orientation="along").orientation
        (['across', 'along'], array([1., 0., 0., 0.]))
        """
        return MappingProxyType({name: _read_only(turn) for name, turn in self._core.orientations()})

    @property
    def stations(self) -> Mapping[str, Station]:
        """Named positions of the platform, read-only.

        Examples
        --------
        >>> scene = Scene.example("hard1").replace(stations={"rack": [1.7, 1, 0.5]}, goal="rack")
        >>> scene.stations["rack"].position, scene.goal
        (array([1.7, 1. , 0.5]), array([1.7, 1. , 0.5]))
        """
        known = self._core.stations()
        return MappingProxyType({name: Station._of(position, turn) for name, position, turn in known})

    @property
    def payloads(self) -> Mapping[str, Mapping[str, Any]]:
        """What the platform can carry by name, read-only, as in the tables of a scene file.

        Examples
        --------
        >>> import cdpr
        >>> crate = {"body": {"box": [0.1, 0.1, 0.1], "position": [0, 0, -0.1]}, "mass": 2, "at": [1.7, 1, 0.3]}
        >>> cdpr.example("hard1").replace(payloads={"crate": crate}).payloads["crate"]["mass"]
        2.0
        """
        tables: list[dict[str, Any]] = self.to_dict().get("payloads", [])
        return MappingProxyType({payload.pop("name"): MappingProxyType(payload) for payload in tables})

    @property
    def task(self) -> tuple[Mapping[str, Any], ...]:
        """What `cdpr.task` plans, row by row, read-only.

        Examples
        --------
        >>> import cdpr
        >>> dict(cdpr.example("hard1").replace(task=[{"go": [1.7, 1, 0.3]}]).task[0])
        {'go': [1.7, 1.0, 0.3]}
        """
        return tuple(MappingProxyType(row) for row in self.to_dict().get("task", []))

    @property
    def required_clearance(self) -> float:
        """Minimum distance between bodies that must not touch, m; `clearances` may override it."""
        return float(self._spec.get("clearance", 0.0))

    @property
    def clearances(self) -> Mapping[str | Names, float]:
        """Clearances of kinds and of pairs of names that differ from `required_clearance`, read-only, m.

        Examples
        --------
        >>> scene = Scene.example("hard1").replace(clearances={("cable 1", "pillar"): 0.05})
        >>> dict(scene.clearances)
        {('cable 1', 'pillar'): 0.05}
        """
        table = dict(self._spec.get("clearances", {}))
        pairs = {tuple(pair["between"]): pair["clearance"] for pair in table.pop("pairs", [])}
        return MappingProxyType(table | pairs)

    @property
    def touch(self) -> tuple[Names, ...]:
        """Pairs of names that may touch but not overlap."""
        return tuple((a, b) for a, b in self._spec.get("touch", []))

    @property
    def ignore(self) -> tuple[Names, ...]:
        """Pairs of names that are not checked against each other."""
        return tuple((a, b) for a, b in self._spec.get("ignore", []))

    @property
    def name(self) -> str:
        """The name, or "scene"."""
        return str(self._spec.get("name", "scene"))

    @property
    def start(self) -> Floats | None:
        """Start of the query, (3,), m, if given."""
        return self._end("start")

    @property
    def goal(self) -> Floats | None:
        """Goal of the query, (3,), m, if given."""
        return self._end("goal")

    @property
    def start_orientation(self) -> Floats:
        """Unit quaternion w x y z at the start, (4,): that of the query, or `orientation`.

        Examples
        --------
        >>> scene = Scene.example("hard1").replace(goal_orientation=[0, 0, 0, 1])
        >>> scene.start_orientation, scene.goal_orientation
        (array([1., 0., 0., 0.]), array([0., 0., 0., 1.]))
        """
        return np.array(self._core.end_orientations()[0], dtype=np.float64)

    @property
    def goal_orientation(self) -> Floats:
        """Unit quaternion w x y z at the goal, (4,): that of the query, or `orientation`."""
        return np.array(self._core.end_orientations()[1], dtype=np.float64)

    def _end(self, key: str) -> Floats | None:
        end = json.loads(self._core.located_query()).get(key)
        return None if end is None else np.array(end, dtype=np.float64)

    with_obstacle = _obstacles.with_obstacle
    without = _obstacles.without
    moved = _obstacles.moved
    carrying = _payloads.carrying
    placed = _payloads.placed
    states_valid = _questions.states_valid
    motions_valid = _questions.motions_valid
    clearance = _questions.clearance
    violations = _questions.violations
    nearest_valid = _questions.nearest_valid
    explain_motion = _questions.explain_motion
    shadows = _shadows.shadows
    save_shadows = _shadows.save_shadows

    @classmethod
    def _of_sound(cls, text: str) -> Scene:
        """Make a scene from values that have already been checked, without repeating its warnings."""
        return cls._of_core(_core.Scene.from_json(text))

    @classmethod
    def _of_core(cls, core: _core.Scene) -> Scene:
        """Make a scene from one of the core, without its warnings."""
        scene = cls.__new__(cls)
        scene._keep(core)
        return scene

    def __reduce__(self) -> tuple[Any, tuple[str]]:
        """Pickle by value."""
        return Scene._of_sound, (self._core.to_json(),)

    def __repr__(self) -> str:
        """Show name and size."""
        cables = len(self._spec["robot"]["cables"])
        count = len(set(_obstacles.obstacle_names(self)))
        return f"Scene({self.name!r}, {cables} cables, {count} obstacle{'' if count == 1 else 's'})"


def _robot_table(robot: Any) -> dict[str, Any]:
    """Return the table of a robot."""
    return instance("robot", robot, Robot).to_dict()


def _from_spec(spec: Mapping[str, Any]) -> _core.Scene:
    return _core.Scene.from_json(json.dumps(plain("", spec)))


def _read_only(corners: ArrayLike) -> Floats:
    array = np.array(corners, dtype=np.float64)
    array.flags.writeable = False
    return array
