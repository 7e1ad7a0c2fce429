"""Planners of OMPL with the collision checker of this package: ``pip install '.[ompl]'``.

OMPL (Şucan, Moll and Kavraki, *The Open Motion Planning Library*, IEEE Robotics & Automation Magazine, 2012,
https://ompl.kavrakilab.org) provides the planners; the scene provides the space of positions and decides which states
and motions are valid. As everywhere in this package, a motion is checked as a whole, not by samples.

>>> import cdpr, cdpr.ompl
>>> from ompl import geometric
>>> scene = cdpr.example("hard3")
>>> setup = cdpr.ompl.simple_setup(scene)
>>> setup.setPlanner(geometric.RRTConnect(setup.getSpaceInformation()))
>>> bool(cdpr.ompl.solve(setup, 10.0))
True
>>> path = cdpr.ompl.path(setup)
>>> cdpr.check(scene, path).valid
True
"""

from __future__ import annotations

import json
import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

try:
    from ompl import base, geometric, util
except ImportError as problem:
    raise ImportError("cdpr.ompl needs the bindings of OMPL 2: pip install 'cdpr[ompl]'") from problem

from ._arrays import point, positive, quaternion
from ._planning import as_it_is, check
from ._results import Path
from ._given import instance
from ._questions import Engine, Interference, judges
from ._scene import Scene
from .exceptions import InputError

__all__ = ["MotionValidator", "PoseSpace", "StateSpace", "StateValidityChecker", "path", "simple_setup", "solve"]

# A motion is shortened by these fractions, smallest first, until the rest is certainly valid.
_CUTS = [2.0**-k for k in range(40, -1, -1)]

util.setLogLevel(util.LOG_WARN)  # its default prints every step of every planner


class StateSpace(base.RealVectorStateSpace):
    """The positions at which the platform is inside the workspace of a scene.

    Parameters
    ----------
    scene : Scene
        The bounds are its workspace, reduced by the extent of the platform around its origin, world, m.

    Raises
    ------
    InputError
        A workspace that the platform does not fit into.

    Examples
    --------
    >>> space = StateSpace(Scene.example("hard1"))
    >>> bounds = space.getBounds()
    >>> list(bounds.low), list(bounds.high)
    ([0.075, 0.075, 0.025], [1.925, 1.925, 1.975])
    """

    def __init__(self, scene: Scene) -> None:
        """See the class."""
        super().__init__(3)
        low, high = instance("scene", scene, Scene).position_box
        bounds = base.RealVectorBounds(3)
        for axis in range(3):
            if not low[axis] < high[axis]:
                raise InputError(f"workspace: found one that the platform does not fit into along {'xyz'[axis]}")
            bounds.setLow(axis, low[axis])
            bounds.setHigh(axis, high[axis])
        self.setBounds(bounds)
        self.setName("positions")

    def state(self, position: ArrayLike) -> Any:
        """Return a state at a position.

        Parameters
        ----------
        position : array_like (3,)
            Of the platform's origin, world, m.

        Returns
        -------
        ompl.base.State
            The state belongs to the space, which must outlive it.
        """
        state = self.allocState()
        state[0], state[1], state[2] = point("position", position)
        return state


class PoseSpace(base.SE3StateSpace):
    """The poses of a platform that turns on its way: OMPL's SE(3).

    Parameters
    ----------
    scene : Scene
        The bounds of positions are those of the platform's centre in its workspace, world, m. A turn by one radian is as
        long as in the scene, by default as the distance from the platform's origin to its farthest corner.

    Raises
    ------
    InputError
        A scene in which the platform turns about one axis only: OMPL samples turns about any.

    Notes
    -----
    OMPL samples all orientations alike: where few are valid, as with a small ``max_tilt``, `cdpr.plan` is faster.

    Examples
    --------
    >>> space = PoseSpace(Scene.example("hard1"))
    >>> half_turn = space.state([0.3, 1.0, 0.3]), space.state([0.3, 1.0, 0.3], [0.0, 0.0, 0.0, 1.0])
    >>> round(space.distance(*half_turn) / np.pi, 4)  # the platform's corners are 0.109 m from its origin
    0.109
    """

    def __init__(self, scene: Scene) -> None:
        """See the class."""
        super().__init__()
        if not isinstance((instance("scene", scene, Scene).turning or {}).get("axis", "free"), str):
            raise InputError('turning.axis: found one axis, expected "free" for OMPL')
        corners = np.vstack([part["vertices"] for part in json.loads(scene._core.bodies())["platform"]])
        slack = np.linalg.norm(corners.mean(axis=0))  # the platform's origin may be outside of the platform
        bounds = base.RealVectorBounds(3)
        for axis, (low, high) in enumerate(scene.workspace.T):
            bounds.setLow(axis, float(low - slack))
            bounds.setHigh(axis, float(high + slack))
        self.setBounds(bounds)
        self.setSubspaceWeight(1, 2.0 * scene._core.turn_weight())  # its distance of rotations is half their angle
        self.setName("poses")
        self._level = tuple(scene.orientation.tolist())

    def state(self, position: ArrayLike, orientation: ArrayLike | None = None) -> Any:
        """Return a state at a pose.

        Parameters
        ----------
        position : array_like (3,)
            Of the platform's origin, world, m.
        orientation : array_like (4,), optional
            World-from-platform unit quaternion w x y z; default that of the scene.

        Returns
        -------
        ompl.base.State
            The state belongs to the space, which must outlive it.
        """
        state = self.allocState()
        state.setXYZ(*point("position", position))
        turn = state.rotation()
        turn.w, turn.x, turn.y, turn.z = quaternion("orientation", self._level if orientation is None else orientation)
        return state


def _pose(state: Any) -> tuple[tuple[float, float, float], tuple[float, float, float, float]]:
    turn = state.rotation()
    return (state.getX(), state.getY(), state.getZ()), (turn.w, turn.x, turn.y, turn.z)


class _Judge:
    """Decides about motions between states of a space."""

    def __init__(self, information: Any, scene: Scene, choice: tuple[Engine, Interference]) -> None:
        self.space = instance("information", information, base.SpaceInformation).getStateSpace()
        self.scene, self.choice = scene, choice
        self.turns = isinstance(self.space, PoseSpace)

    def valid(self, s1: Any, s2: Any) -> bool:
        valid = self.scene._core.motion_valid
        if not self.turns:
            return valid((s1[0], s1[1], s1[2]), (s2[0], s2[1], s2[2]), *self.choice)
        (start, first), (end, last) = _pose(s1), _pose(s2)
        return valid(start, end, *self.choice, (first, last))

    def violated_at(self, s1: Any, s2: Any) -> float:
        """Find the fraction of the motion at which the first violation begins; 0 if there is none."""
        engine, interference = self.choice
        if self.turns:
            (start, first), (end, last) = _pose(s1), _pose(s2)
            found = self.scene.explain_motion(start, end, first, last, engine=engine, interference=interference)
        else:
            start, end = (s1[0], s1[1], s1[2]), (s2[0], s2[1], s2[2])
            found = self.scene.explain_motion(start, end, engine=engine, interference=interference)
        return 0.0 if found is None else found.at


class StateValidityChecker(base.StateValidityChecker):
    """Decides which positions or poses of the platform are valid.

    Parameters
    ----------
    information : ompl.base.SpaceInformation
        Of a `StateSpace` or a `PoseSpace`.
    scene : Scene
    engine : {"cspace", "gjk"}
    interference : {"exact", "swept"}

    Examples
    --------
    >>> information = simple_setup(Scene.example("hard1")).getSpaceInformation()
    >>> states, space = information.getStateValidityChecker(), information.getStateSpace()
    >>> states.isValid(space.state([0.3, 1.0, 0.3])), states.isValid(space.state([1.0, 1.0, 1.0]))
    (True, False)
    """

    def __init__(
        self, information: Any, scene: Scene, *, engine: Engine = "cspace", interference: Interference = "exact"
    ) -> None:
        """See the class."""
        super().__init__(instance("information", information, base.SpaceInformation))
        self.scene = instance("scene", scene, Scene)
        self._judge = _Judge(information, scene, judges(engine, interference))

    def isValid(self, state: Any) -> bool:
        """Tell whether the state is valid.

        Parameters
        ----------
        state : ompl.base.State

        Returns
        -------
        bool
        """
        return self._judge.valid(state, state)

    def clearance(self, state: Any) -> float:
        """Compute the signed clearance of a state, for planners that ask for it.

        Parameters
        ----------
        state : ompl.base.State

        Returns
        -------
        float
            The smallest gap between bodies that must not touch, m, negative if they overlap.
        """
        if not self._judge.turns:
            return float(self.scene.clearance([[state[0], state[1], state[2]]], threads=1)[0])
        position, orientation = _pose(state)
        return float(self.scene.clearance([position], orientation, threads=1)[0])


class MotionValidator(base.MotionValidator):
    """Decides which straight motions are valid, checking each as a whole, without samples or a resolution to choose.

    Parameters
    ----------
    information : ompl.base.SpaceInformation
        Of a `StateSpace` or a `PoseSpace`.
    scene : Scene
    engine : {"cspace", "gjk"}
    interference : {"exact", "swept"}

    Examples
    --------
    >>> information = simple_setup(Scene.example("hard1")).getSpaceInformation()
    >>> motions, space = information.getMotionValidator(), information.getStateSpace()
    >>> ends = space.state([0.3, 1.0, 0.3]), space.state([1.7, 1.0, 1.7])
    >>> valid, fraction = motions.checkMotionWithLastValid(*ends, None)
    >>> valid, round(fraction, 4)
    (False, 0.2668)
    """

    def __init__(
        self, information: Any, scene: Scene, *, engine: Engine = "cspace", interference: Interference = "exact"
    ) -> None:
        """See the class."""
        super().__init__(instance("information", information, base.SpaceInformation))
        self.scene = instance("scene", scene, Scene)
        self._judge = _Judge(information, scene, judges(engine, interference))

    def checkMotion(self, s1: Any, s2: Any) -> bool:
        """Tell whether the straight motion between two states is valid.

        Parameters
        ----------
        s1, s2 : ompl.base.State

        Returns
        -------
        bool
        """
        return self._judge.valid(s1, s2)

    def checkMotionWithLastValid(self, s1: Any, s2: Any, last_valid: Any | None) -> tuple[bool, float]:
        """Check a motion and return up to where it is valid.

        Parameters
        ----------
        s1, s2 : ompl.base.State
            The first one is valid, as OMPL guarantees.
        last_valid : ompl.base.State or None
            Set to the last valid state, unless the motion is valid.

        Returns
        -------
        valid : bool
        fraction : float
            Fraction of the motion that is certainly valid, 0 to 1: up to the first violation, reduced by a margin for
            rounding.

        Notes
        -----
        The overload of ``checkMotion`` with ``lastValid``. The bindings of OMPL 2.0.1 do not expose it to Python;
        later ones do, under this name (https://github.com/ompl/ompl/pull/1442).
        """
        if self.checkMotion(s1, s2):
            return True, 1.0
        judge, until = self._judge, self._judge.space.allocState()
        first = judge.violated_at(s1, s2)
        for fraction in (first * (1.0 - cut) for cut in [0.0, *_CUTS]):
            judge.space.interpolate(s1, s2, fraction, until)
            if judge.valid(s1, until):
                break
        else:
            fraction = 0.0
            judge.space.copyState(until, s1)
        if last_valid is not None:
            judge.space.copyState(last_valid, until)
        return False, fraction


def simple_setup(
    scene: Scene,
    *,
    start: ArrayLike | str | None = None,
    goal: ArrayLike | str | None = None,
    start_orientation: ArrayLike | str | None = None,
    goal_orientation: ArrayLike | str | None = None,
    engine: Engine = "cspace",
    interference: Interference = "exact",
) -> Any:
    """Return OMPL's ``SimpleSetup`` of a scene: space, validity, start and goal; only the planner is left to choose.

    The space is a `PoseSpace` if the platform may turn, otherwise a `StateSpace`.

    Parameters
    ----------
    scene : Scene
    start, goal : array_like (3,) or str, optional
        Positions instead of the scene's, m, or names of stations.
    start_orientation, goal_orientation : array_like (4,) or str, optional
        World-from-platform unit quaternions w x y z, or names of the scene's orientations, instead of the scene's.
    engine : {"cspace", "gjk"}
    interference : {"exact", "swept"}

    Returns
    -------
    ompl.geometric.SimpleSetup
        Unless a planner is set, OMPL uses RRT-Connect, or another planner for objectives other than length.

    Raises
    ------
    InputError
        No start or goal, neither in the scene nor as an argument; a scene that lists several orientations and selects
        none, or in which the platform may turn about one axis only; a workspace into which the platform does not fit.

    Examples
    --------
    >>> setup = simple_setup(Scene.example("hard1"))
    >>> setup.setPlanner(geometric.BITstar(setup.getSpaceInformation()))
    >>> solve(setup, 0.2).asString()
    'Exact solution'
    """
    instance("scene", scene, Scene)._core.for_path(None)  # a path of OMPL has no orientation: an error if the scene selects none
    ends = {"start": start, "goal": goal, "start_orientation": start_orientation, "goal_orientation": goal_orientation}
    if given := {key: end for key, end in ends.items() if end is not None}:
        scene = scene.replace(**given)  # type: ignore[arg-type]
    first, last = _end("start", scene.start), _end("goal", scene.goal)
    space, states = _space(scene, first, last)
    information = base.SpaceInformation(space)
    information.setStateValidityChecker(
        StateValidityChecker(information, scene, engine=engine, interference=interference)
    )
    information.setMotionValidator(MotionValidator(information, scene, engine=engine, interference=interference))
    setup = geometric.SimpleSetup(information)
    setup.setStartAndGoalStates(*states)
    return setup


def _space(scene: Scene, first: ArrayLike, last: ArrayLike) -> tuple[Any, tuple[Any, Any]]:
    """Return the space of a scene, start and goal in it."""
    if not scene._core.turns():
        positions = StateSpace(scene)
        return positions, (positions.state(first), positions.state(last))
    poses = PoseSpace(scene)
    return poses, (poses.state(first, scene.start_orientation), poses.state(last, scene.goal_orientation))


def _end(key: str, end: ArrayLike | None) -> tuple[float, float, float]:
    if end is None:
        raise InputError(f"query.{key}: found none, expected a position")
    return point(key, end)


def solve(setup: Any, seconds: float = 1.0) -> Any:
    """Run the planner like ``setup.solve(seconds)``, but stop on Ctrl-C with every planner.

    Parameters
    ----------
    setup : ompl.geometric.SimpleSetup
        A set-up that :func:`simple_setup` has made.
    seconds : float
        Time limit of the search, s; optimising planners use all of it.

    Returns
    -------
    ompl.base.PlannerStatus
        True if there is a path; the path may end short of the goal, in which case :func:`path` raises an error.

    Raises
    ------
    InputError
        A time that is not positive.
    KeyboardInterrupt
        On Ctrl-C; the best result so far stays in ``setup``.

    Notes
    -----
    A planner that searches with threads, as PRM does, must not get a termination condition written in Python: the
    bindings do not release the interpreter, so both sides would wait forever. Those of OMPL are safe, and `solve` uses
    one. An exception amid PRM would end the process, so here Ctrl-C ends the search first and is raised afterwards.

    Examples
    --------
    >>> setup = simple_setup(Scene.example("hard1"))
    >>> setup.setPlanner(geometric.PRM(setup.getSpaceInformation()))
    >>> solve(setup, 10.0).asString()
    'Exact solution'
    """
    instance("setup", setup, geometric.SimpleSetup)
    until = base.timedPlannerTerminationCondition(positive("seconds", seconds))
    with _ctrl_c_after(until.terminate):
        return setup.solve(until)


@contextmanager
def _ctrl_c_after(stop: Any) -> Iterator[None]:
    """Let Ctrl-C stop the work first and raise it afterwards; only the main thread receives signals."""
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    caught = []

    def remember(number: int, frame: object) -> None:
        caught.append(number)
        stop()

    previous = signal.signal(signal.SIGINT, remember)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, previous)
    if caught:
        raise KeyboardInterrupt


def path(setup: Any) -> Path:
    """Return the path that the planner found.

    Parameters
    ----------
    setup : ompl.geometric.SimpleSetup
        A set-up that :func:`simple_setup` has made and :func:`solve` has solved.

    Returns
    -------
    Path
        ``waypoints`` (k, 3), world, m, and ``cost``, its length, m, for `check`, `rewind`, `refine`, `show`, and to
        save; with ``orientations`` (k, 4), w x y z, if the platform may turn. It has been rechecked as a whole.

    Raises
    ------
    InputError
        No path from start to goal, or a setup that was not made by :func:`simple_setup`.

    Examples
    --------
    >>> import cdpr
    >>> scene = Scene.example("hard1")
    >>> setup = simple_setup(scene)
    >>> bool(solve(setup, 10.0))
    True
    >>> cdpr.refine(scene, path(setup)).cost < 3.0
    True
    """
    motions = instance("setup", setup, geometric.SimpleSetup).getSpaceInformation().getMotionValidator()
    if not isinstance(motions, MotionValidator):
        raise InputError(f"setup: found a {type(motions).__name__}, expected a setup with a cdpr.ompl.MotionValidator")
    if not setup.haveExactSolutionPath():
        raise InputError("setup: found no path from start to goal, expected a solved one")
    states = setup.getSolutionPath().getStates()
    engine, interference = motions._judge.choice
    if motions._judge.turns:
        return _turning_path(motions.scene, [_pose(state) for state in states], engine, interference)
    waypoints = np.array([[state[0], state[1], state[2]] for state in states])
    return as_it_is(motions.scene, waypoints, engine, interference)


def _turning_path(scene: Scene, poses: list[Any], engine: Engine, interference: Interference) -> Path:
    waypoints, turns = (np.array(rows) for rows in zip(*poses, strict=True))
    report = check(scene, waypoints, turns, engine=engine, interference=interference)
    if not report.valid:
        raise InputError(f"setup: found a path that is not valid, expected one of valid motions: {report.violations[0]}")
    planned_for = {"scene": {"name": scene.name, "fingerprint": scene._core.fingerprint()}}
    return Path(waypoints, report.length, scene.orientation, orientations=turns, _json=json.dumps(planned_for))
