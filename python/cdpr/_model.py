"""Robots and scenes."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, Protocol, TypeAlias, runtime_checkable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arrays import Floats, point, rows
from .exceptions import CdprWarning, InputError

Engine: TypeAlias = Literal["cspace", "gjk"]
Interference: TypeAlias = Literal["exact", "swept"]
Unit: TypeAlias = Literal["mm", "cm", "m", "in", "ft"]


@runtime_checkable
class TriangleMesh(Protocol):
    """What has ``vertices`` (n, 3) and ``faces`` (m, 3), counter-clockwise seen from outside; trimesh's meshes have."""

    @property
    def vertices(self) -> Any:
        """Corners, m."""

    @property
    def faces(self) -> Any:
        """Indices of the corners of each triangle, from 0."""


Obstacle: TypeAlias = ArrayLike | TriangleMesh | Sequence[ArrayLike | TriangleMesh]


@dataclass(frozen=True)
class Violation:
    """A condition that a motion breaks.

    Attributes
    ----------
    at : float
        Fraction of the motion (of the segment, on a path) at which it begins, 0 to 1.
    kind : str
        "workspace", "cable-length", "cable-platform", "cable-cable", "platform-obstacle", "cable-obstacle" or "wrench".
    culprits : tuple of str
        Who is involved, by the names of the scene; cables count from 0.
    margin : float or None
        Worst gap in the world over the motion, m: minus a penetration depth where bodies overlap, 0 where cables cross.
    segment : int
        Which segment of a path, counting from 0.
    wrench_margin : float or None
        For the kind "wrench": margin less demand, in ``unit``, where it is least.
    unit : str or None
        "N" or "N·m".
    measure : str or None
        What it is measured by: "capacity", "force" or "moment".
    rank : int or None
        Rank of the wrench matrix there; below 6 some wrenches cannot be had at any tension.
    at_greatest, at_least : tuple of str
        Cables at their greatest and least tension there.
    corner : tuple of float or None
        Corner of the grid cell for which the grid rule refused, m.
    """

    at: float
    kind: str
    culprits: tuple[str, ...]
    margin: float | None
    segment: int = 0
    wrench_margin: float | None = None
    unit: str | None = None
    measure: str | None = None
    rank: int | None = None
    at_greatest: tuple[str, ...] = ()
    at_least: tuple[str, ...] = ()
    corner: tuple[float, float, float] | None = None


def violation_from(values: Mapping[str, Any]) -> Violation:
    """A violation from the core's JSON."""
    fields: dict[str, Any] = {k: tuple(value) if isinstance(value, list) else value for k, value in values.items()}
    return Violation(**fields)


class Robot:
    """A cable robot: a platform of convex parts, hung on straight cables.

    Parameters
    ----------
    outlets : array_like (m, 3)
        Where the cables leave the frame, world, m.
    attachments : array_like (m, 3)
        Where they meet the platform, platform frame, m.
    platform : sequence of array_like (k, 3) or mesh
        Corners of each convex part, platform frame, m; a part may be flat, a segment or a point. A mesh is any object
        with ``vertices`` and ``faces``, as those of trimesh; see `Scene`.
    tensions : array_like (2,) or (m, 2), optional
        Least and largest tension, N, for all cables or each.
    mass : float, optional
        Mass of the platform, kg.
    center_of_mass : array_like (3,), optional
        Platform frame, m; default the origin.
    name : str, optional
        For messages and pictures.

    Raises
    ------
    InputError
        Wrong shapes, numbers that are not finite, an attachment inside a part, limits out of order.

    Examples
    --------
    >>> robot = Robot([[0, 0, 1], [1, 0, 1]], [[0, 0, 0], [0.1, 0, 0]], [[[0, 0, 0], [0.1, 0, 0]]])
    >>> robot
    Robot('robot', 2 cables)
    """

    def __init__(
        self,
        outlets: ArrayLike,
        attachments: ArrayLike,
        platform: Sequence[ArrayLike | TriangleMesh],
        *,
        tensions: ArrayLike | None = None,
        mass: float | None = None,
        center_of_mass: ArrayLike | None = None,
        name: str | None = None,
    ) -> None:
        """See the class."""
        ends = rows("outlets", outlets), rows("attachments", attachments)
        count = len(ends[0])
        if len(ends[1]) != count:
            raise InputError(f"attachments: found {len(ends[1])} rows, expected {count}, one for each outlet")
        cables: list[dict[str, Any]] = [
            {"outlet": outlet, "attachment": attachment}
            for outlet, attachment in zip(ends[0].tolist(), ends[1].tolist(), strict=True)
        ]
        if tensions is not None:
            for cable, limits in zip(cables, _limits(tensions, count), strict=True):
                cable["tension"] = limits
        parts = [_body(f"platform[{k}]", part) for k, part in enumerate(platform)]
        spec: dict[str, Any] = {"platform": parts, "cables": cables}
        if mass is not None:
            spec["mass"] = float(mass)
        if center_of_mass is not None:
            spec["center_of_mass"] = point("center_of_mass", center_of_mass)
        if name is not None:
            spec["name"] = name
        self._spec = _checked(spec)

    @classmethod
    def from_dict(cls, spec: Mapping[str, Any]) -> Robot:
        """Make a robot from the table of a robot file."""
        robot = cls.__new__(cls)
        robot._spec = _checked({key: value for key, value in spec.items() if key != "version"})
        return robot

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Robot:
        """Load a robot file (.toml or .json)."""
        return cls.from_dict(json.loads(_core.load_robot(os.fspath(path))))

    def to_dict(self) -> dict[str, Any]:
        """Return the table of a robot file."""
        copy: dict[str, Any] = json.loads(json.dumps(self._spec))
        return copy

    @property
    def name(self) -> str:
        """Name, or "robot"."""
        return str(self._spec.get("name", "robot"))

    @property
    def outlets(self) -> Floats:
        """Outlets, (m, 3), world, m."""
        return np.array([cable["outlet"] for cable in self._spec["cables"]], dtype=np.float64)

    @property
    def attachments(self) -> Floats:
        """Attachments, (m, 3), platform frame, m."""
        return np.array([cable["attachment"] for cable in self._spec["cables"]], dtype=np.float64)

    @property
    def mass(self) -> float | None:
        """Mass of the platform, kg, if given."""
        return self._spec.get("mass")

    def __eq__(self, other: object) -> bool:
        """Compare by value."""
        return isinstance(other, Robot) and self._spec == other._spec

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        """Say name and size."""
        return f"Robot({self.name!r}, {len(self._spec['cables'])} cables)"


def import_robot(
    path: str | os.PathLike[str],
    *,
    bodies: str | os.PathLike[str] | None = None,
    cable_set: str | None = None,
    platform: str | os.PathLike[str] | None = None,
    units: Unit = "m",
) -> Robot:
    """Import a robot of another program.

    Parameters
    ----------
    path : path
        CASPR: the cables file or the bodies file of a model, or their folder. Gazebo
        (https://github.com/oKermorgant/cdpr): its YAML file.
    bodies : path, optional
        CASPR's bodies file, where it does not stand beside the cables file under the same name.
    cable_set : str, optional
        CASPR's set of cables; default the one that the file names.
    platform : path, optional
        Mesh of the platform in its frame (.stl or .obj); default what the source says, or the hull of the attachments.
    units : {"mm", "cm", "m", "in", "ft"}
        Unit of that mesh.

    Returns
    -------
    Robot
        A `CdprWarning` lists what was not carried over.

    Raises
    ------
    InputError
        The file makes no sense; the message names the element and its line.

    Examples
    --------
    >>> import warnings
    >>> with warnings.catch_warnings():
    ...     warnings.simplefilter("ignore")
    ...     import_robot("testdata/caspr/CoGiRo")
    Robot('CoGiRo', 8 cables)
    """
    files = [None if given is None else os.fspath(given) for given in (bodies, platform)]
    text, notes = _core.import_robot(os.fspath(path), files[0], cable_set, files[1], units)
    if notes:
        warnings.warn("not carried over: " + "; ".join(notes), CdprWarning, stacklevel=2)
    return Robot.from_dict(json.loads(text))


def _checked(spec: dict[str, Any]) -> dict[str, Any]:
    try:
        text = json.dumps(spec, allow_nan=False)
    except (TypeError, ValueError) as problem:
        raise InputError(f"robot: {problem}") from None
    checked: dict[str, Any] = json.loads(_core.check_robot(text))
    return checked


def _limits(tensions: ArrayLike, count: int) -> list[list[float]]:
    array = np.asarray(tensions, dtype=np.float64)
    if array.shape not in ((2,), (count, 2)):
        raise InputError(f"tensions: found an array of shape {array.shape}, expected (2,) or ({count}, 2)")
    limits: list[list[float]] = np.broadcast_to(array, (count, 2)).tolist()
    return limits


class Scene:
    """A robot among obstacles in a workspace, with the question asked of it.

    Parameters
    ----------
    robot : Robot
    obstacles : mapping of str to array_like or mesh
        Corners of each convex obstacle, (k, 3), world, m; a concave one is a sequence of several such arrays. A mesh,
        concave or not, is any object with ``vertices`` (n, 3), world, m, and ``faces`` (m, 3), as those of trimesh:
        convex parts that cover it stand for it, and a `CdprWarning` tells how far they reach beyond it.
    workspace : array_like (2, 3)
        Smallest and largest coordinates that every platform corner must stay within, m.
    start, goal : array_like (3,), optional
        Positions of the platform's origin, world, m.
    orientation : array_like (4,), optional
        World-from-platform unit quaternion w x y z, held all the way; default no turn.
    clearance : float, default 0
        Least distance to keep between whatever must not touch, m.
    name : str, optional
        For messages and pictures.

    Raises
    ------
    InputError
        Wrong shapes, numbers that are not finite, an obstacle without volume or with a corner inside its hull, an outlet
        inside an obstacle.

    Examples
    --------
    >>> scene = Scene.load("testdata/scenes/hard1.toml")
    >>> scene
    Scene('hard1', 8 cables, 1 obstacle)
    >>> scene.states_valid([[0.3, 1.0, 0.3], [1.0, 1.0, 1.0]])
    array([ True, False])
    """

    def __init__(
        self,
        robot: Robot,
        obstacles: Mapping[str, Obstacle] | None = None,
        *,
        workspace: ArrayLike,
        start: ArrayLike | None = None,
        goal: ArrayLike | None = None,
        orientation: ArrayLike | None = None,
        clearance: float = 0.0,
        name: str | None = None,
    ) -> None:
        """See the class."""
        box = rows("workspace", workspace)
        if box.shape != (2, 3):
            raise InputError(f"workspace: found an array of shape {box.shape}, expected (2, 3), the corners min and max")
        query: dict[str, Any] = {}
        if start is not None:
            query["start"] = point("start", start)
        if goal is not None:
            query["goal"] = point("goal", goal)
        if orientation is not None:
            query["orientation"] = _quaternion(orientation)
        parts = [part for label, body in (obstacles or {}).items() for part in _parts(label, body)]
        spec: dict[str, Any] = {
            "version": 1,
            "clearance": float(clearance),
            "workspace": {"min": box[0].tolist(), "max": box[1].tolist()},
            "robot": robot.to_dict(),
            "obstacles": parts,
            "query": query,
        }
        if name is not None:
            spec["name"] = name
        self._adopt(_from_spec(spec))

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Scene:
        """Load a scene file (.toml or .json).

        Raises
        ------
        FileError
            It cannot be read, or its name has another extension.
        InputError
            Bad contents; the message names file, key, what was found and what is expected.
        """
        scene = cls.__new__(cls)
        scene._adopt(_core.Scene.load(os.fspath(path)))
        return scene

    @classmethod
    def from_dict(cls, spec: Mapping[str, Any]) -> Scene:
        """Make a scene from the contents of a scene file, the robot in place."""
        scene = cls.__new__(cls)
        scene._adopt(_from_spec(dict(spec)))
        return scene

    def _adopt(self, core: _core.Scene) -> None:
        self._core = core
        self._spec: dict[str, Any] = json.loads(core.to_json())
        for note in core.notes():
            warnings.warn(note, CdprWarning, stacklevel=3)

    def to_dict(self) -> dict[str, Any]:
        """Return the contents of a scene file, the robot in place."""
        copy: dict[str, Any] = json.loads(self._core.to_json())
        return copy

    @property
    def robot(self) -> Robot:
        """The robot."""
        return Robot.from_dict(self._spec["robot"])

    @property
    def name(self) -> str:
        """Name, or "scene"."""
        return str(self._spec.get("name", "scene"))

    @property
    def start(self) -> Floats | None:
        """Start of the query, (3,), m, if given."""
        return self._end("start")

    @property
    def goal(self) -> Floats | None:
        """Goal of the query, (3,), m, if given."""
        return self._end("goal")

    def _end(self, key: str) -> Floats | None:
        end = self._spec.get("query", {}).get(key)
        return None if end is None else np.array(end, dtype=np.float64)

    def states_valid(
        self,
        points: ArrayLike,
        *,
        engine: Engine = "cspace",
        interference: Interference = "exact",
        threads: int | None = None,
    ) -> NDArray[np.bool_]:
        """Whether the platform may be at each position.

        Parameters
        ----------
        points : array_like (n, 3)
            Positions of the platform's origin, world, m. C-contiguous float64 is not copied.
        engine : {"cspace", "gjk"}
        interference : {"exact", "swept"}
        threads : int, optional
            Default all cores; the answers do not depend on it.

        Returns
        -------
        ndarray of bool (n,)
        """
        return self._core.states_valid(rows("points", points), engine, interference, threads)

    def motions_valid(
        self,
        starts: ArrayLike,
        ends: ArrayLike,
        *,
        engine: Engine = "cspace",
        interference: Interference = "exact",
        threads: int | None = None,
    ) -> NDArray[np.bool_]:
        """Whether the platform may go straight from each start to its end, at fixed orientation.

        Parameters
        ----------
        starts, ends : array_like (n, 3)
            Positions of the platform's origin, world, m. C-contiguous float64 is not copied.
        engine : {"cspace", "gjk"}
        interference : {"exact", "swept"}
            "swept" is the paper's stricter rule for pairs of cables.
        threads : int, optional
            Default all cores; the answers do not depend on it.

        Returns
        -------
        ndarray of bool (n,)

        Examples
        --------
        >>> scene = Scene.load("testdata/scenes/hard1.toml")
        >>> scene.motions_valid([[0.3, 1.0, 0.3], [0.3, 1.0, 0.3]], [[1.7, 1.0, 1.7], [0.3, 1.0, 0.8]])
        array([False,  True])
        """
        first, last = rows("starts", starts), rows("ends", ends)
        if len(first) != len(last):
            raise InputError(f"ends: found {len(last)} rows, expected {len(first)}, one for each start")
        return self._core.motions_valid(first, last, engine, interference, threads)

    def clearance(self, points: ArrayLike, *, threads: int | None = None) -> Floats:
        """Signed clearance of each position: the least gap in the world between what must not touch.

        Parameters
        ----------
        points : array_like (n, 3)
            Positions of the platform's origin, world, m. C-contiguous float64 is not copied.
        threads : int, optional
            Default all cores; the answers do not depend on it.

        Returns
        -------
        ndarray of float (n,)
            Metres: minus a penetration depth where bodies overlap, 0 where cables cross; infinite where there is nothing
            to keep away from. Cables and what they end on are left out, and so is the workspace.

        Examples
        --------
        >>> scene = Scene.load("testdata/scenes/hard1.toml")
        >>> scene.clearance([[0.3, 1.0, 0.3], [1.0, 1.0, 1.7]]).round(6)
        array([0.05    , 0.024121])
        """
        return self._core.clearance(rows("points", points), threads)

    def explain_motion(
        self,
        start: ArrayLike,
        end: ArrayLike,
        *,
        engine: Engine = "cspace",
        interference: Interference = "exact",
    ) -> Violation | None:
        """Why a motion is refused: the condition it breaks first, or None if it is valid.

        Parameters
        ----------
        start, end : array_like (3,)
            Positions of the platform's origin, world, m; equal ones ask about a state.

        Examples
        --------
        >>> scene = Scene.load("testdata/scenes/hard1.toml")
        >>> found = scene.explain_motion([0.3, 1.0, 0.3], [1.7, 1.0, 1.7])
        >>> found.kind, found.culprits
        ('cable-obstacle', ('cable 1', 'pillar'))
        """
        found = json.loads(self._core.violations(point("start", start), point("end", end), engine, interference))
        return violation_from(found[0]) if found else None

    def __eq__(self, other: object) -> bool:
        """Compare by value."""
        return isinstance(other, Scene) and self._spec == other._spec

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[Any, tuple[dict[str, Any]]]:
        """Pickle by value."""
        return Scene.from_dict, (self.to_dict(),)

    def __repr__(self) -> str:
        """Say name and size."""
        cables = len(self._spec["robot"]["cables"])
        parts = self._spec.get("obstacles", [])
        count = len({part.get("name", k) for k, part in enumerate(parts)})
        return f"Scene({self.name!r}, {cables} cables, {count} obstacle{'' if count == 1 else 's'})"


def _from_spec(spec: dict[str, Any]) -> _core.Scene:
    try:
        text = json.dumps(spec, allow_nan=False)
    except (TypeError, ValueError) as problem:
        raise InputError(f"scene: {problem}") from None
    return _core.Scene.from_json(text)


def _quaternion(values: ArrayLike) -> list[float]:
    array = np.asarray(values, dtype=np.float64)
    if array.shape != (4,) or not np.isfinite(array).all():
        raise InputError(f"orientation: found {array}, expected a unit quaternion w x y z")
    numbers: list[float] = array.tolist()
    return numbers


def _parts(name: str, obstacle: Obstacle) -> list[dict[str, Any]]:
    """One table per part: an obstacle is a mesh, one (k, 3) array, or a sequence of such."""
    try:
        single = isinstance(obstacle, TriangleMesh) or np.asarray(obstacle, dtype=np.float64).ndim == 2
    except (TypeError, ValueError):
        single = False
    bodies: list[Any] = [obstacle] if single else list(obstacle)  # type: ignore[arg-type]
    if not bodies:
        raise InputError(f"obstacles[{name!r}]: found no parts, expected at least one array of shape (k, 3)")
    return [{"name": name, **_body(f"obstacles[{name!r}][{k}]", body)} for k, body in enumerate(bodies)]


def _body(place: str, body: ArrayLike | TriangleMesh) -> dict[str, Any]:
    """The table of a body, from its corners or its mesh."""
    if not isinstance(body, TriangleMesh):
        return {"vertices": rows(place, body).tolist()}
    triangles = np.asarray(body.faces)
    if triangles.ndim != 2 or triangles.shape[1] != 3 or triangles.dtype.kind not in "iu":
        found = f"{triangles.dtype} of shape {triangles.shape}"
        raise InputError(f"{place}.faces: found {found}, expected integers of shape (m, 3)")
    if triangles.size and triangles.min() < 0:
        raise InputError(f"{place}.faces: found {triangles.min()}, expected indices from 0")
    vertices = rows(f"{place}.vertices", body.vertices).tolist()
    return {"mesh": {"vertices": vertices, "triangles": triangles.tolist()}}
