"""Results of planning and checking."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import Floats, Ints, alike, flat_quaternions, numbers, rows, shown
from ._given import file_name
from ._pandas import frame
from ._proof import Proof
from ._values import ByValue, same
from ._violation import Exemption, Violation
from .exceptions import InputError

if TYPE_CHECKING:
    from ._trajectory import Trajectory


@dataclass(frozen=True, eq=False, repr=False)
class Path(ByValue):
    """A path of straight segments.

    Attributes
    ----------
    waypoints : ndarray (k, 3)
        Positions of the platform's origin, world, m.
    cost : float
        Length, m; if the platform turns, plus the weight of turns times their angles.
    orientation : ndarray (4,) or None
        World-from-platform unit quaternion w x y z, held along the whole path; None means the scene's orientation. If
        the scene selects no orientation, the path's is used.
    orientations : ndarray (k, 4) or None
        Unit quaternion w x y z at each waypoint, if the platform turns: between two of them it takes the shorter turn at
        constant rate. ``orientation`` is then that of the scene.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.example("hard1")
    >>> path = cdpr.refine(scene, cdpr.plan(scene, "modified-rrt"))
    >>> path
    Path(2.4352 m, 3 waypoints)
    >>> path.waypoints.shape
    (3, 3)
    """

    waypoints: Floats
    cost: float
    orientation: Floats | None = None
    orientations: Floats | None = field(default=None, kw_only=True)
    _json: str = field(default="{}", compare=False, kw_only=True)

    def __post_init__(self) -> None:
        """Convert array_likes."""
        object.__setattr__(self, "waypoints", rows("waypoints", self.waypoints))
        if not isinstance(self.cost, (float, int, np.floating)) or isinstance(self.cost, bool):
            raise InputError(f"cost: found {shown(self.cost)}, expected a number")
        if self.orientation is not None:
            object.__setattr__(self, "orientation", np.array(numbers("orientation", self.orientation, 4, "w x y z")))
        if self.orientations is not None:
            object.__setattr__(self, "orientations", turns_of(self.waypoints, self.orientations))

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Any:
        """Return the waypoints, (k, 3), m."""
        return np.array(self.waypoints, dtype=dtype, copy=copy)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write a path file: .json, or .csv for the waypoints alone, if the platform keeps its orientation.

        Parameters
        ----------
        path : path
            The extension selects the format.

        Raises
        ------
        FileError
            Another extension, or a file that cannot be written; nothing half-written is left.
        """
        file = file_name(path)
        _core.save_path(file, json.dumps(self._said()))

    def _said(self) -> dict[str, Any]:
        """Return the contents for the file: everything that is known about this path, and nothing about another one."""
        known: dict[str, Any] = json.loads(self._json)
        waypoints, turn = self.waypoints.tolist(), None if self.orientation is None else self.orientation.tolist()
        turned = None if self.orientations is None else self.orientations.tolist()
        same_turns = known.get("orientation") in (None, turn) and known.get("orientations") == turned
        if same_turns and known.get("waypoints") == waypoints:
            return known | {"orientation": turn}
        kept = {key: value for key, value in self._origin().items() if key == "scene"}
        kept |= {} if turned is None else {"orientations": turned}
        cost = self.cost if np.isfinite(self.cost) else None
        return {"version": 1, "waypoints": waypoints, "cost": cost, "orientation": turn} | kept

    def _origin(self) -> dict[str, Any]:
        """Return the scene that the path was planned for, and the name of its orientation there, as far as these are known."""
        known: dict[str, Any] = json.loads(self._json)
        turn = None if self.orientation is None else self.orientation.tolist()
        same_turn = known.get("orientation") in (None, turn)
        return {key: known[key] for key in ("scene", "orientation_name") if same_turn and known.get(key) is not None}

    def to_pandas(self) -> Any:
        """Return the waypoints as a table; requires pandas.

        Returns
        -------
        DataFrame
            One row per waypoint: ``s``, the distance along the path, and ``x``, ``y``, ``z``, world, all in m; if the
            platform turns, also the quaternion ``qw``, ``qx``, ``qy``, ``qz``.

        Examples
        --------
        >>> import cdpr
        >>> scene = cdpr.example("empty")
        >>> cdpr.plan(scene).to_pandas().round(3).loc[1].to_dict()
        {'s': 1.98, 'x': 1.7, 'y': 1.0, 'z': 1.7}
        """
        steps = np.linalg.norm(np.diff(self.waypoints, axis=0), axis=1)
        along = np.concatenate([np.zeros(min(len(self.waypoints), 1)), np.cumsum(steps)])
        turns = {} if self.orientations is None else dict(zip(("qw", "qx", "qy", "qz"), self.orientations.T, strict=True))
        return frame({"s": along, **_axes(self.waypoints), **turns}, "waypoint")

    def __repr__(self) -> str:
        """Show length and size."""
        return f"{type(self).__name__}({self.cost:.4f} m, {_count(len(self.waypoints), 'waypoint')})"


def turns_of(waypoints: Floats, orientations: ArrayLike) -> Floats:
    """Return one quaternion for each waypoint, (k, 4), from as many or a single one."""
    turns = flat_quaternions("orientations", orientations)
    (_, found), shape = alike("waypoint", ("waypoints", (waypoints, waypoints.shape[:1])), ("orientations", turns))
    if shape != waypoints.shape[:1]:
        raise InputError(f"orientations: found an array of shape {(*turns[1], 4)}, expected {(len(waypoints), 4)}, one for each waypoint")
    return found


class Milestone(NamedTuple):
    """A path that was better than all before it.

    Attributes
    ----------
    seconds : float
        Time since the search began, s.
    samples : int
        Number of samples drawn by then.
    cost : float
        Length of the path, m.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.example("hard1")
    >>> best = cdpr.plan(scene).history[-1]
    >>> print(f"{best.cost:.6f}")
    2.435167
    """

    seconds: float
    samples: int
    cost: float


class SearchTree(NamedTuple):
    """The tree of a planner, or several trees, one after the other.

    Attributes
    ----------
    states : ndarray (n, 3)
        Position of each node, world, m.
    parents : ndarray (n,) of int64
        Index of each node's parent; a root is its own parent.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.example("hard1")
    >>> tree = cdpr.plan(scene, "rrt").tree
    >>> bool(scene.motions_valid(tree.states[tree.parents], tree.states).all())
    True
    """

    states: Floats
    parents: Ints

    def to_pandas(self) -> Any:
        """Return the nodes as a table; requires pandas.

        Returns
        -------
        DataFrame
            One row per node: ``x``, ``y``, ``z``, world, m, and ``parent``.
        """
        return frame({**_axes(self.states), "parent": self.parents}, "node")

    def __eq__(self, other: object) -> bool:
        """Compare by value."""
        return isinstance(other, SearchTree) and same(tuple(self), tuple(other))

    def __ne__(self, other: object) -> bool:
        """Compare by value."""
        return not self == other

    def __repr__(self) -> str:
        """Show the size."""
        return f"SearchTree({_count(len(self.states), 'node')})"


def _no_tree() -> SearchTree:
    return SearchTree(np.empty((0, 3)), np.empty(0, dtype=np.int64))


@dataclass(frozen=True, eq=False, repr=False)
class Result(Path):
    """Result of planning.

    Attributes
    ----------
    waypoints : ndarray (k, 3)
        The final path, m; (0, 3) unless solved.
    cost : float
        Its length, m; NaN unless solved.
    orientation : ndarray (4,)
        World-from-platform unit quaternion w x y z, held along the whole path.
    orientations : ndarray (k, 4) or None
        Unit quaternion w x y z at each waypoint; None if the platform keeps its orientation.
    status : str
        "solved", "budget_spent", "no_path", "start_invalid" or "goal_invalid".
    found_by : str or None
        Name of the planner, if it found the path; "decision", if it found none, but the decision whether there is a path
        did; "kept" or "repaired", if it is a path given to :func:`replan`. None unless solved.
    orientation_name : str or None
        Name of the orientation, if the scene names it.
    raw_waypoints : ndarray (k, 3)
        The planner's path before post-processing, m.
    raw_cost : float
        Its length, m; NaN unless solved.
    reason : Violation or None
        The worst of what makes the start or goal invalid.
    reasons : tuple of Violation
        Everything that makes the start or goal invalid, worst first.
    nearest_valid : ndarray (3,) or None
        If the start or goal is invalid: a valid position near it, m, if one was found.
    proof : Proof or None
        Why there is no path, if that was proved.
    opening_below : float or None
        If no path was found and none proved impossible: every path passes an opening narrower than this, m, if known.
    min_clearance : dict or None
        Nearest approach of the final path: ``value`` (m), ``segment``, ``at``, ``culprits``, and ``required``, the
        clearance required of this pair, m. Exempt pairs are included.
    min_clearance_not_exempt : dict or None
        Nearest approach of the pairs that are not exempt, with the keys of ``min_clearance``, if some are exempt.
    exempt : tuple of Exemption
        Pairs that are exempt from the clearance of their kind.
    widest : dict or None
        If the widest path was asked for: ``clearance``, the smallest one of the path from obstacles, m, and ``none_above``, which no
        path keeps, as is proved, m, or None if nothing is proved. Both are about the pairs that keep the scene's ``clearance``, and,
        if ``longest`` is among the keys, m, about paths that are not longer.
    route : dict or None
        If via points, several goals or a box of goals were asked for: ``via``, the index of the waypoint of each via point;
        ``goal``, the index of the goal that the path leads to, if there were several; without a path, ``leg``, which of the legs
        between via points has none, counted from 0, and their number.
    stats : dict
        ``nodes``, ``motion_checks``, ``samples``, ``planning_seconds``, ``post_seconds``.
    history : tuple of Milestone
        When the planner's path improved, first to last.
    tree : SearchTree
        The planner's tree, ``states`` (n, 3), m, and ``parents`` (n,); if solved, its last node is the goal. Empty if
        start or goal is invalid; path files do not contain it.
    trajectory : Trajectory or None
        The fastest motion, along this path, if the time of a motion is minimised; None if there is no path, or if the search
        was interrupted or out of time before a motion was known. Path files do not contain it.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.example("hard1")
    >>> cdpr.plan(scene)
    Result('solved', 2.4352 m, 3 waypoints)
    >>> cdpr.plan(scene, goal=[1, 1, 1]).reason.kind
    'platform-obstacle'
    """

    status: str = ""
    found_by: str | None = None
    orientation_name: str | None = None
    raw_waypoints: Floats = field(default_factory=lambda: np.empty((0, 3)))
    raw_cost: float = float("nan")
    reason: Violation | None = None
    reasons: tuple[Violation, ...] = ()
    nearest_valid: Floats | None = None
    proof: Proof | None = None
    opening_below: float | None = None
    min_clearance: Mapping[str, Any] | None = None
    min_clearance_not_exempt: Mapping[str, Any] | None = None
    exempt: tuple[Exemption, ...] = ()
    widest: Mapping[str, float | None] | None = None
    route: Mapping[str, Any] | None = None
    stats: Mapping[str, float] = field(default_factory=dict)
    history: tuple[Milestone, ...] = ()
    tree: SearchTree = field(default_factory=_no_tree)
    trajectory: Trajectory | None = None

    @property
    def solved(self) -> bool:
        """Whether a path was found."""
        return self.status == "solved"

    def history_to_pandas(self) -> Any:
        """Return the history of the planner's path as a table; requires pandas.

        Returns
        -------
        DataFrame
            One row per milestone: ``seconds``, ``samples``, ``cost`` (m).
        """
        columns = {name: [getattr(entry, name) for entry in self.history] for name in Milestone._fields}
        return frame(columns, "milestone")

    def __repr__(self) -> str:
        """Show the path's length and size, or why there is none."""
        if self.solved:
            return f"Result({self.status!r}, {self.cost:.4f} m, {_count(len(self.waypoints), 'waypoint')})"
        why = self.proof if self.reason is None else self.reason
        return f"Result({self.status!r}{'' if why is None else f', {why}'})"


@dataclass(frozen=True, eq=False, repr=False)
class Report(ByValue):
    """Result of checking a path.

    Attributes
    ----------
    valid : bool
        Whether there are no violations.
    length : float
        Metres.
    violations : tuple of Violation
        In order along the path.
    min_clearance : dict or None
        Nearest approach: ``value`` (m), ``segment``, ``at``, ``culprits``, and ``required``, the
        clearance required of this pair, m. Exempt pairs are included.
    min_clearance_not_exempt : dict or None
        Nearest approach of the pairs that are not exempt, with the keys of ``min_clearance``, if some are exempt.
    exempt : tuple of Exemption
        Pairs that are exempt from the clearance of their kind: ``valid`` does not mean that they keep it.
    min_wrench_margin : dict or None
        For scenes with ``[wrench]``: the smallest margin beyond the required one: ``value``, ``unit``, ``measure``,
        ``segment``, ``at``, and the cables that limit it, ``at_greatest`` and ``at_least``.
    tension_range : dict or None
        For scenes with ``[wrench]``: the smallest and the largest tension, ``min`` and ``max``: ``value`` (N),
        ``cable``, ``segment``, ``at``. None if the loads cannot be balanced everywhere.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.example("hard1")
    >>> cdpr.check(scene, cdpr.plan(scene))
    Report(valid, 2.4352 m)
    """

    valid: bool
    length: float
    violations: tuple[Violation, ...]
    min_clearance: Mapping[str, Any] | None
    min_clearance_not_exempt: Mapping[str, Any] | None = None
    exempt: tuple[Exemption, ...] = ()
    min_wrench_margin: Mapping[str, Any] | None = None
    tension_range: Mapping[str, Any] | None = None

    def to_pandas(self) -> Any:
        """Return the violations as a table; requires pandas.

        Returns
        -------
        DataFrame
            One row per violation, with the attributes of `Violation` as columns.

        Examples
        --------
        >>> import cdpr
        >>> scene = cdpr.example("hard1")
        >>> table = cdpr.check(scene, [[0.3, 1, 0.3], [1.7, 1, 1.7]]).to_pandas()
        >>> sorted(set(table["kind"]))
        ['cable-obstacle', 'platform-obstacle']
        """
        names = [field.name for field in fields(Violation)]
        return frame({name: [getattr(entry, name) for entry in self.violations] for name in names}, "violation")

    def __repr__(self) -> str:
        """Show validity and length."""
        found = "valid" if self.valid else _count(len(self.violations), "violation")
        return f"Report({found}, {self.length:.4f} m)"


def _axes(positions: Floats) -> dict[str, Floats]:
    return {"x": positions[:, 0], "y": positions[:, 1], "z": positions[:, 2]}


def _count(number: int, what: str) -> str:
    return f"{number} {what}{'' if number == 1 else 's'}"
