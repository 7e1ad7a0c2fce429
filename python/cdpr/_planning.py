"""Planning, shortening and checking of paths, and path files."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import fields
from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import Floats, finite, number, quaternion, whole
from ._given import file_name, flag, function, instance, one_of, plain, table, text
from ._paths import way_of
from ._questions import Engine, Interference, judges
from ._proof import proof_from
from ._results import Milestone, Path, Report, Result, SearchTree
from ._scene import Scene
from ._search import Planner, Post, search_options
from ._stations import between, route
from ._trajectory import Trajectory
from ._violation import exemption_from, violation_from
from .exceptions import AnotherSceneWarning, CdprError, InputError

Order: TypeAlias = Literal["both", "backward", "forward", "backward-only", "forward-only"]
Minimise: TypeAlias = Literal["length", "time"]
Maximise: TypeAlias = Literal["clearance"]


def _array(waypoints: list[list[float]]) -> Floats:
    return np.array(waypoints, dtype=np.float64).reshape(-1, 3)


def _number(value: float | None) -> float:
    return float("nan") if value is None else value


def plan(
    scene: Scene,
    planner: Planner = "anytime",
    *,
    seed: int = 0,
    start: ArrayLike | str | None = None,
    goal: ArrayLike | str | None = None,
    via: Sequence[ArrayLike | str] = (),
    goals: Sequence[ArrayLike | str] = (),
    goal_box: ArrayLike | None = None,
    step: float | None = None,
    post: Post | None = None,
    budget: float | None = None,
    repeats: int | None = None,
    max_samples: int | None = None,
    max_nodes: int | None = None,
    keep_going: bool = False,
    target_cost: float | None = None,
    gap: float | None = None,
    extend_step: float | None = None,
    goal_bias: float | None = None,
    check_goal: bool = False,
    near_radius: float | None = None,
    near_cap: float | None = None,
    orientation: ArrayLike | str | None = None,
    start_orientation: ArrayLike | str | None = None,
    goal_orientation: ArrayLike | str | None = None,
    engine: Engine = "cspace",
    interference: Interference = "exact",
    proof: bool = True,
    minimise: Minimise = "length",
    motion: Mapping[str, float] | None = None,
    maximise: Maximise | None = None,
    within: float | None = None,
    on_improvement: Callable[[float, float, Floats], object] | None = None,
) -> Result:
    """Plan a path from start to goal, the shortest one, the fastest one or the widest one.

    The fastest motion need not follow the shortest path, which often leaves no room to round corners. To find it is a question
    of planning, with the same options and the same answers if there is no path; to time a path that is known, use
    :func:`trajectory`.

    Parameters
    ----------
    scene : Scene
    planner : {"anytime", "two-trees", "rrt-connect", "modified-rrt", "rrt", "rrt-star"}
        The anytime planner (a first path quickly, then shorter ones), two trees connected directly to samples (the
        fastest first path), RRT-Connect, the paper's Algorithm 3, plain RRT, or the paper's Algorithm 1.
    seed : int
        Seed of all random numbers: the same seed gives the same path.
    start, goal : array_like (3,) or str, optional
        Positions to use instead of the scene's, m, or names of its stations.
    via : sequence of array_like (3,) or str, optional
        Positions or stations that the path passes, in this order. Each leg between them has the seed and the limits of the search;
        they share ``budget``. Where the platform turns, it has the orientation of the station, if that has one, else that of the
        point before.
    goals : sequence of array_like (3,) or str, optional
        Several goals instead of one: the path leads to the one with the shortest path.
    goal_box : array_like (2, 3), optional
        Least and largest coordinates of a box, m, instead of a goal: the path ends anywhere in it. Its end is chosen among
        valid positions that are spread over the box, and then slides through the box as long as the path becomes shorter.
    step : float, optional
        Distance between the points that rewinding tries, m; also the step of "rrt" and "rrt-star". Default 0.1.
    post : {"both", "backward", "forward", "backward-only", "forward-only", "taut", "none"}, optional
        Post-processing of the planner's path. "backward" and "forward" rewind it (Algorithms 4 and 5), starting in that
        direction, and "both" keeps the shorter result of the two orders; "backward-only" is Algorithm 4 alone,
        "forward-only" Algorithm 5; "taut" is string pulling, as by :func:`refine`. Default "none" for "anytime", which pulls
        its paths itself, "taut" for "two-trees" and "rrt-connect", and "both" for the paper's planners.
    budget : float, optional
        Time limit of the call, s, including the time to compile the scene; "anytime" uses all of it, and without it
        stops by itself. If the time of a motion is minimised, each path that is tried gets a sixth.
    repeats : int, optional
        Number of times that rewinding runs; default 1.
    max_samples : int, optional
        Stop after this many random samples; default 20 000, for "rrt-star" and "rrt-connect" 500 000, for "anytime" no
        limit.
    max_nodes : int, optional
        Stop after this many nodes of the tree.
    keep_going : bool
        Continue after the first path until samples, nodes or time run out; the shortest path is kept.
    target_cost : float, optional
        Continue after the first path until the path is at most this long, m.
    gap : float, optional
        With "anytime", continue until the path is proved to be at most this fraction longer than the shortest: 0.01 for
        1 %.
    extend_step : float, optional
        Longest edge that "rrt", "rrt-star" and "rrt-connect" add, m; default ``step``, as in the paper, for
        "rrt-connect" a fifth of the diagonal of the box of positions.
    goal_bias : float, optional
        Probability with which "rrt", "rrt-star" and "modified-rrt" use the goal as the sample; default 0, for
        "modified-rrt" the paper's rule, which tries the goal after every change of the tree.
    check_goal : bool
        With "rrt", use the goal as the next sample after every change of the tree, as "modified-rrt" does.
    near_radius : float, optional
        Radius of rrt-star's neighbourhood around a new node, m; default min(γ (ln n / n)^(1/3), ``near_cap``) for n
        nodes.
    near_cap : float, optional
        Largest radius of rrt-star's neighbourhood if it shrinks with the number of nodes, m; default ``extend_step``.
    orientation : array_like (4,) or str, optional
        World-from-platform unit quaternion w x y z, or the name of one of the scene's orientations, to use instead of
        the scene's. If neither selects one, the orientation with the shortest path is used.
    start_orientation, goal_orientation : array_like (4,) or str, optional
        World-from-platform unit quaternions w x y z, or names of the scene's orientations, at start and goal instead of
        the scene's. If they differ, or the scene has ``turning``, the platform turns on its way.
    engine : {"cspace", "gjk"}
    interference : {"exact", "swept"}
    proof : bool
        Decide, beside the search, whether there is a path at all. If there is none, ``status`` is "no_path" and ``proof``
        says why; if the search fails in a narrow passage, the decision finds the path. It costs almost nothing.
    minimise : {"length", "time"}
        "time" times the planned path and up to five others, of the next two seeds and with a clearance that is larger by
        ``blend``, which leaves room to round corners. The result is the path with the fastest motion, ``trajectory``.
    motion : mapping, optional
        With ``minimise="time"``, limits of the motion: keywords of :func:`trajectory` from ``speed`` to ``wrench_margin``, such
        as ``{"speed": 1, "acceleration": 2}``. They take precedence over those of the scene.
    maximise : {"clearance"}, optional
        Find the widest path instead of a short one: its smallest clearance from obstacles, of all pairs that keep the key
        ``clearance`` of the scene, is the largest possible within 1 mm. ``widest`` has that clearance and a proved limit. A budget
        or Ctrl-C ends the search with the widest path so far.
    within : float, optional
        With ``maximise``, the path may be at most this many times as long as the shortest: 1.05 for 5 % longer.
    on_improvement : callable, optional
        Called with (seconds, cost, waypoints) for every better path that the planner finds, or for every wider one; while the time
        of a motion is minimised, only until the first path is complete.

    Returns
    -------
    Result
        Every returned path has been rechecked as a whole. ``orientations`` is None unless the platform turns, ``trajectory``
        unless the time of a motion is minimised.

    Raises
    ------
    InputError
        No start or goal, neither in the scene nor as an argument; bad options, or options that have no effect with this planner
        and post-processing; a goal together with goals or a box; with via points, a ``target_cost`` or ``maximise``; with ``minimise="time"``, limits that allow no motion along any path; with ``maximise``, a platform that
        may turn, or a scene in which nothing keeps the key ``clearance`` from an obstacle.
    KeyboardInterrupt
        On Ctrl-C, if there is no path yet; otherwise the best one is returned.

    Examples
    --------
    >>> scene = Scene.example("hard1")
    >>> print(f"{plan(scene).cost:.6f}")
    2.435167
    >>> result = plan(scene, "modified-rrt", seed=3)
    >>> result.solved, result.cost <= result.raw_cost
    (True, True)
    >>> plan(Scene.example("plank")).orientation_name
    'along'
    >>> yawed = [0.9961946980917455, 0.0, 0.0, 0.08715574274765817]  # by 10°
    >>> turning = plan(scene, goal_orientation=yawed, goal=[0.3, 1.0, 0.8], seed=1)
    >>> turning.orientations[-1].round(3)
    array([0.996, 0.   , 0.   , 0.087])
    >>> over = plan(Scene.example("hard1"), via=[[1, 1, 1.8]], goal_box=[[1.5, 0.8, 0.2], [1.9, 1.2, 0.4]])
    >>> over.waypoints[over.route["via"][0]], over.waypoints[-1].round(2)
    (array([1. , 1. , 1.8]), array([1.5, 1. , 0.4]))
    >>> from cdpr import trajectory
    >>> forest, limits = Scene.example("forest"), {"speed": 1, "acceleration": 2, "blend": 0.01}
    >>> shortest, fastest = plan(forest, "two-trees"), plan(forest, "two-trees", minimise="time", motion=limits)
    >>> widest = plan(Scene.example("hard3"), maximise="clearance").widest
    >>> print(f"{widest['clearance']:.4f} {widest['none_above']:.4f}")
    0.0257 0.0257
    >>> short = plan(Scene.example("hard1"), maximise="clearance", within=1.02)
    >>> short.cost <= short.widest["longest"], short.widest["none_above"] - short.widest["clearance"] < 0.005
    (True, True)
    >>> fastest.cost > shortest.cost, fastest.trajectory.duration < trajectory(forest, shortest, **limits).duration
    (True, True)
    """
    instance("scene", scene, Scene)
    function("on_improvement", on_improvement)
    search = search_options(
        planner,
        seed=seed,
        step=step,
        post=post,
        budget=budget,
        repeats=repeats,
        max_samples=max_samples,
        max_nodes=max_nodes,
        keep_going=keep_going,
        target_cost=target_cost,
        gap=gap,
        extend_step=extend_step,
        goal_bias=goal_bias,
        check_goal=check_goal,
        near_radius=near_radius,
        near_cap=near_cap,
        engine=engine,
        interference=interference,
        proof=proof,
    )
    written, tree, certificate, fastest = _core.plan(
        between(turned(scene, orientation), start, goal),
        search,
        turn_of("start_orientation", start_orientation),
        turn_of("goal_orientation", goal_orientation),
        route(goal, via, goals, goal_box),
        text("minimise", minimise),
        None if motion is None else json.dumps(plain("motion", table("motion", motion))),
        None if maximise is None else text("maximise", maximise),
        None if within is None else number("within", within),
        on_improvement,
    )
    return result_of(written, SearchTree(*tree), certificate, None if fastest is None else Trajectory._of(fastest))


def turned(scene: Scene, orientation: ArrayLike | str | None) -> _core.Scene:
    turn = turn_of("orientation", orientation)
    return scene._core if turn is None else scene._core.at("orientation", turn)


def turn_of(name: str, orientation: ArrayLike | str | None) -> str | tuple[float, float, float, float] | None:
    if orientation is None:
        return None
    return text(name, orientation) if isinstance(orientation, str) else quaternion(name, orientation)


def result_of(written: str, tree: SearchTree, certificate: str | None, fastest: Trajectory | None) -> Result:
    """Make a result from JSON of the core: the keys that `Result` has, with arrays and tuples converted."""
    found = json.loads(written)
    converted = {
        "waypoints": _array(found["waypoints"]),
        "cost": _number(found["cost"]),
        "orientation": np.array(found["orientation"]),
        "orientations": np.array(found["orientations"]) if "orientations" in found else None,
        "found_by": found.get("found_by", found["planner"]) if found["status"] == "solved" else None,
        "raw_waypoints": _array(found["raw_waypoints"]),
        "raw_cost": _number(found["raw_cost"]),
        "reason": None if found["reason"] is None else violation_from(found["reason"]),
        "reasons": tuple(violation_from(values) for values in found.get("reasons", ())),
        "nearest_valid": None if found.get("nearest_valid") is None else np.array(found["nearest_valid"]),
        "proof": None if certificate is None else proof_from(found["proof"], certificate),
        "exempt": tuple(exemption_from(values) for values in found["exempt"]),
        "history": tuple(Milestone(**entry) for entry in found["history"]),
    }
    known = {entry.name for entry in fields(Result)}
    kept = {key: value for key, value in found.items() if key in known}
    return Result(**kept | converted, tree=tree, trajectory=fastest, _json=written)


def rewind(
    scene: Scene,
    waypoints: ArrayLike | Path,
    *,
    step: float = 0.1,
    order: Order = "both",
    repeats: int = 1,
    engine: Engine = "cspace",
    interference: Interference = "exact",
    strict: bool = False,
) -> Path:
    """Shorten a path from any source by backward and forward rewinding; the result is valid and never longer.

    Parameters
    ----------
    scene : Scene
    waypoints : array_like (k, 3), k >= 2
        Positions of the platform's origin, world, m; every segment must be valid.
    step : float
        Distance between the points tried along each segment, m.
    order : {"both", "backward", "forward", "backward-only", "forward-only"}
        Which direction comes first; "both" keeps the shorter of the two, "backward-only" is Algorithm 4 alone and
        "forward-only" Algorithm 5.
    repeats : int
        Number of times that the rewindings run.
    engine : {"cspace", "gjk"}
    interference : {"exact", "swept"}
    strict : bool
        Raise an error for a path that was planned for another scene, instead of an `AnotherSceneWarning`.

    Returns
    -------
    Path
        First and last waypoint as given.

    Raises
    ------
    InputError
        Wrong shape, a step that is not positive, or a segment that is not valid, named with the reason; a path on which the
        platform turns, for which there is `refine`.

    Notes
    -----
    The paper's Algorithms 4 and 5.

    Examples
    --------
    >>> scene = Scene.example("empty")
    >>> rewind(scene, [[0.3, 1, 0.3], [1, 1, 1.5], [1.7, 1, 1.7]]).waypoints.shape
    (2, 3)
    """
    how = (one_of("order", order, Order), number("step", step), whole("repeats", repeats))
    return _shortened(scene, waypoints, how, engine, interference, strict)


def refine(
    scene: Scene,
    waypoints: ArrayLike | Path,
    orientations: ArrayLike | None = None,
    *,
    engine: Engine = "cspace",
    interference: Interference = "exact",
    strict: bool = False,
) -> Path:
    """Shorten a path from any source by string pulling; the result is valid and never longer.

    Parameters
    ----------
    scene : Scene
    waypoints : array_like (k, 3), k >= 2
        Positions of the platform's origin, world, m; every segment must be valid.
    orientations : array_like (k, 4) or (4,), optional
        World-from-platform unit quaternions w x y z, as in `check`. Default those of the path; without any, the platform
        keeps its orientation.
    engine : {"cspace", "gjk"}
    interference : {"exact", "swept"}
    strict : bool
        Raise an error for a path that was planned for another scene, instead of an `AnotherSceneWarning`.

    Returns
    -------
    Path
        First and last waypoint as given. The path is locally shortest: it bends only at edges of the forbidden regions in the
        space of positions. If the platform turns, positions and orientations are shortened together, and the path is not
        proved locally shortest.

    Raises
    ------
    InputError
        Wrong shape, or a segment that is not valid, named with the reason.

    Examples
    --------
    >>> scene = Scene.example("hard1")
    >>> raw = plan(scene, "modified-rrt", post="none")
    >>> print(f"{refine(scene, raw).cost:.6f}")
    2.435167
    """
    return _shortened(scene, waypoints, ("taut", 1.0, 1), engine, interference, strict, orientations)


def as_it_is(scene: Scene, waypoints: ArrayLike, engine: Engine, interference: Interference) -> Path:
    """Check a path from any source, and return it unchanged."""
    return _shortened(scene, waypoints, ("none", 1.0, 1), engine, interference)


def _shortened(
    scene: Scene,
    waypoints: ArrayLike | Path,
    how: tuple[str, float, int],
    engine: Engine,
    interference: Interference,
    strict: bool = False,
    turns: ArrayLike | None = None,
) -> Path:
    """Shorten a path by a kind of post-processing with its step and repeats."""
    core, positions, along = way_of(scene, "waypoints", waypoints, turns, strict=strict, level=4)
    if along is not None and how[0] != "taut":
        found = "found a path on which the platform turns, expected one on which it keeps its orientation"
        raise InputError(f"waypoints.orientations: {found}; rewinding is for such paths, cdpr.refine for both")
    written = core.shorten(positions, *how, *judges(engine, interference), along)
    found = json.loads(written)
    turned = found.get("orientations")
    return Path(_array(found["waypoints"]), found["cost"], found["orientation"], orientations=turned, _json=written)


def lower_bound(
    scene: Scene,
    *,
    gap: float | None = None,
    budget: float | None = None,
    start: ArrayLike | str | None = None,
    goal: ArrayLike | str | None = None,
    certificate: str | os.PathLike[str] | None = None,
) -> float:
    """Return a lower bound on the length of every valid path, m: the straight line or better.

    Parameters
    ----------
    scene : Scene
    gap : float, optional
        Search for a path and for a bound until the path exceeds the bound by at most this share, such as 0.001. That
        usually takes less than a second, but with clearances, crossing cables and wrenches it may never be reached: give a
        budget as well. Without gap and budget the bound takes some milliseconds and is looser.
    budget : float, optional
        Return the best bound found within this time, s.
    start, goal : array_like (3,) or str, optional
        Positions to use instead of the scene's, m, or names of its stations.
    certificate : path, optional
        Write a certificate of the bound to this file (.json), which anyone can check: see :func:`cdpr.check_proof`. The
        bound returned is the certified one, which may be a little smaller. The scene must have one orientation and a path.

    Returns
    -------
    float
        Infinite if it is certain that there is no path. With a gap, a budget or a certificate, the bound does not apply to
        paths that come closer than 1e-7 m to something between their ends: they may be shorter. It is infinite only if no
        path keeps that much, also where :func:`plan` finds none that keeps 1e-6 m.

    Examples
    --------
    >>> scene = Scene.example("hard1")
    >>> plan(scene).cost / lower_bound(scene) < 1.1
    True
    >>> plan(scene).cost / lower_bound(scene, gap=0.001) < 1.0011
    True
    """
    file = None if certificate is None else file_name(certificate)
    asked = between(instance("scene", scene, Scene)._core, start, goal)
    if file is not None and asked.orientation_is_open():
        problem = "found a scene with several orientations that selects none, expected one: scene.replace(orientation=...)"
        raise InputError(f"certificate: {problem}")
    bound, written = asked.lower_bound(
        None if gap is None else number("gap", gap),
        None if budget is None else number("budget", budget),
        file is not None,
    )
    if file is not None:
        if written is None:
            problem = "found nothing to certify: there is no path, the platform may turn, or effort ran out"
            raise CdprError(f"certificate: {problem}")
        _core.save_text(file, written + "\n")
    return bound


def check(
    scene: Scene,
    waypoints: ArrayLike | Path,
    orientations: ArrayLike | None = None,
    *,
    engine: Engine = "cspace",
    interference: Interference = "exact",
    strict: bool = False,
) -> Report:
    """Check a path or a position: report every violation (bodies involved, place, margin) and the nearest approach.

    Parameters
    ----------
    scene : Scene
    waypoints : array_like (k, 3) or (3,)
        Positions of the platform's origin, world, m; a single one is checked as a position.
    orientations : array_like (k, 4) or (4,), optional
        World-from-platform unit quaternions w x y z, one for each waypoint, or a single one for all; between two of them
        the platform takes the shorter turn at constant rate. Default those of the path or, if it has none, the scene's
        orientation.
    engine : {"cspace", "gjk"}
    interference : {"exact", "swept"}
    strict : bool
        Raise an error for a path that was planned for another scene, instead of an `AnotherSceneWarning`.

    Returns
    -------
    Report
        If the platform turns, margin and tensions are those at a thousand even steps; required wrenches are checked everywhere.

    Raises
    ------
    InputError
        Wrong shape, fewer than two waypoints, numbers that are not finite; a path at an orientation that the scene does not
        have; with ``strict``, a path that was planned for another scene.

    Examples
    --------
    >>> scene = Scene.example("hard1")
    >>> check(scene, [[0.3, 1, 0.3], [1.7, 1, 1.7]]).valid
    False
    >>> check(scene, [0.3, 1, 0.3])
    Report(valid, 0.0000 m)
    >>> half_turn = [0, 0, 0, 1]  # about the vertical
    >>> check(scene, [[0.3, 1, 0.3], [0.3, 1, 0.3]], [[1, 0, 0, 0], half_turn]).violations[0].kind
    'cable-cable'
    """
    core, positions, along = way_of(scene, "waypoints", waypoints, orientations, strict=strict, place=True)
    found = json.loads(core.check(positions, *judges(engine, interference), along))
    violations = tuple(violation_from(values) for values in found["violations"])
    exempt = tuple(exemption_from(values) for values in found["exempt"])
    return Report(**{**found, "violations": violations, "exempt": exempt})


def load_path(path: str | os.PathLike[str], scene: Scene | None = None, *, strict: bool = False) -> Path:
    """Load a path file.

    Parameters
    ----------
    path : path
        .json or .csv.
    scene : Scene, optional
        If the file was planned for another scene, an `AnotherSceneWarning` is issued.
    strict : bool
        Raise an error for such a file instead.

    Returns
    -------
    Path
        Can be passed wherever an array (k, 3) of waypoints is expected. The cost of a .csv path that turns includes its turns only
        if the scene is given, which says how long a turn is.

    Raises
    ------
    FileError
        It cannot be read, or its name has another extension.
    InputError
        Bad contents; a path at an orientation that the scene does not have; with ``strict``, a path planned for another
        scene.

    Examples
    --------
    >>> import tempfile
    >>> scene = Scene.example("hard1")
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     plan(scene).save(f"{folder}/path.csv")
    ...     load_path(f"{folder}/path.csv", scene)
    Path(2.4352 m, 3 waypoints)
    """
    core = None if scene is None else instance("scene", scene, Scene)._core
    file = file_name(path)
    rows_of_file, turn, written, warning = _core.load_path(file, core, flag("strict", strict))
    if warning is not None:
        warnings.warn(f"{file}: {warning}", AnotherSceneWarning, stacklevel=2)
    waypoints = _array(rows_of_file)
    cost = float(np.linalg.norm(np.diff(waypoints, axis=0), axis=1).sum())
    known = json.loads(written)
    turns = known.get("orientations")
    if turns is not None:
        cost = known.get("cost") or cost
    orientation = None if turn is None else np.array(turn)
    return Path(waypoints, cost, orientation, orientations=turns, _json=written)


def schema(of: Literal["scene", "robot", "path", "experiment"] = "scene") -> dict[str, Any]:
    """Return the JSON Schema of a file format.

    Parameters
    ----------
    of : {"scene", "robot", "path", "experiment"}

    Returns
    -------
    dict

    Examples
    --------
    >>> sorted(schema("robot")["required"])
    ['cables', 'platform']
    """
    return dict(json.loads(_core.schema(text("of", of))))
