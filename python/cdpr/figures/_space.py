"""Drawings in space: scenes, the model, paths, rewinding, and the set of available forces."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any, Literal

import numpy as np
from mpl_toolkits.mplot3d import Axes3D
from numpy.typing import ArrayLike

from .._arrays import Floats, number, point, shown, whole
from .._given import flag, instance, one_of, table, text
from .._robot import Robot
from .._scene import Scene
from .._paths import path_rows, scene_for
from .._results import Path, Result
from .._wrench import force_set, moment_set
from ..exceptions import InputError
from ._charts import known
from ._hanging import course
from ._polyhedra import faces_of_mesh, paper_axes
from ._poses import Way, rotation, way_of
from ._stage import Stage, View
from ._style import BLACK, BLUE, CYCLE, GREEN, GREY, LIGHT, PALE, PURPLE, SAND, SKY, VERMILION, styled

Direction = Literal["backward", "forward"]

VIEW: View = (22.0, -62.0)
_CABLE = {"color": "#333333", "linewidth": 0.8}
_PASSING = {"color": "#9a9a9a", "linewidth": 0.4}  # cables of poses between the ends
_POSES, _MOST_POSES = 5, 100
_FRAME = 0.17  # length of a frame's axes, relative to the robot
_CASTING = (SKY, PURPLE, GREEN)  # colours of shadows of so many cables; with more, all have the first


@styled
def scene(
    scene: Scene,
    path: ArrayLike | Path | None = None,
    *,
    at: ArrayLike | None = None,
    poses: int | None = None,
    shadows: bool | str | Sequence[str] = False,
    robot: bool = True,
    labels: bool = True,
    view: View = VIEW,
    ax: Axes3D | None = None,
) -> Axes3D:
    """Draw a scene: obstacles, outlets, cables and platform, and optionally shadows and a path.

    Parameters
    ----------
    scene : Scene
    path : array_like (k, 3), Path or Result, optional
        Positions of the platform's origin, m; a ``Result`` is drawn with its raw path, dashed.
    at : array_like (3,), optional
        Position at which the platform is drawn, m, at the scene's orientation; default the scene's start, else the centre of
        its workspace.
    poses : int, optional
        Number of places at even steps along the path, from start to goal, at which platform and cables are drawn, those
        between the ends in a lighter colour; turns count as in the length of the path. Default 5 if the platform turns;
        otherwise the platform is drawn once. The path is seen through several platforms.
    shadows : bool, str or sequence of str
        Whether to draw the shadows, where the ends of cables cannot be: of all cables, or of the named ones.
    robot : bool
        Whether to draw platform and cables; outlets are always drawn.
    labels : bool
        Whether to name obstacles, start and goal; obstacles whose names would cover others are left without.
    view : (float, float)
        Elevation and azimuth of the eye, degrees. Hidden lines are computed for this view: change the view here, not
        with the mouse.
    ax : Axes3D, optional
        Where to draw; default a new figure of the width of a column.

    Returns
    -------
    Axes3D
        Artists carry the names of the scene as ``gid``: "pillar", "cable 3", "cable 3 / pillar", "platform".

    Raises
    ------
    InputError
        Wrong shapes, a cable that is not in the scene, axes of another kind, ``at`` together with poses along a path.

    Examples
    --------
    >>> import cdpr, cdpr.figures
    >>> hard1 = cdpr.example("hard1")
    >>> ax = cdpr.figures.scene(hard1, cdpr.plan(hard1), shadows="cable 1")
    >>> ax.figure.savefig("/dev/null", format="svg")
    >>> bar = cdpr.example("turn")
    >>> ax = cdpr.figures.scene(bar, cdpr.plan(bar, "rrt-connect"), poses=7)
    """
    scene = scene if path is None else scene_for(scene, path)
    robot, labels = flag("robot", robot), flag("labels", labels)
    way = None if path is None else way_of("path", scene, path)
    count = _pose_count(way, at, poses)
    stage, bodies = _stage_of(scene, ax, view)
    if shadows is not False:
        _add_shadows(stage, scene, bodies, None if shadows is True else shadows)
    if robot and way is not None and count:
        _add_poses(stage, scene, bodies, way, count)
    elif robot:
        turn = scene.orientation if at is not None else scene.start_orientation
        _add_robot(stage, turned(bodies, scene, turn), _position(scene, at))
    if way is not None:
        _add_path(stage, way, path, through="platform" if count > 1 else False)
    if labels:
        _add_labels(stage, scene, bodies)
    drawn = stage.paint()
    if path is not None and labels:
        _legend(stage)
    return drawn


@styled
def paths(
    scene: Scene,
    paths: Mapping[str, ArrayLike | Path],
    *,
    robot: bool = False,
    view: View = VIEW,
    ax: Axes3D | None = None,
) -> Axes3D:
    """Draw several paths through one scene, with their lengths and numbers of waypoints in the legend.

    Parameters
    ----------
    scene : Scene
    paths : mapping of str to array_like (k, 3) or Path
        Paths by name, m; of a ``Result`` the final path. Of a path on which the platform turns, the legend states the length of
        the line of its origin and the angles of all turns.
    robot : bool
        Whether to draw platform and cables at the start.
    view : (float, float)
        Elevation and azimuth of the eye, degrees. Hidden lines are computed for this view: change the view here, not
        with the mouse.
    ax : Axes3D, optional
        Where to draw; default a new figure of the width of a column.

    Returns
    -------
    Axes3D

    Examples
    --------
    >>> import cdpr, cdpr.figures
    >>> hard1 = cdpr.example("hard1")
    >>> found = {"planned": cdpr.plan(hard1, post="none"), "rewound": cdpr.plan(hard1)}
    >>> ax = cdpr.figures.paths(hard1, found)
    """
    if not table("paths", paths):
        raise InputError("paths: found none, expected at least one")
    flag("robot", robot)
    first, *others = [scene_for(scene, path) for path in paths.values()]
    if any(not np.allclose(other.orientation, first.orientation) for other in others):
        raise InputError("paths: found paths at several orientations, expected one")
    scene = first
    stage, bodies = _stage_of(scene, ax, view)
    if robot:
        _add_robot(stage, turned(bodies, scene, scene.start_orientation), _position(scene, None))
    for k, (name, path) in enumerate(paths.items()):
        way = way_of(f"paths[{name!r}]", scene, path)
        colour = CYCLE[k % len(CYCLE)]
        label = f"{text('paths', name)}: {way.length:.2f} m{way.words}, {len(way.positions)} waypoints"
        stage.line(way.positions, color=colour, linewidth=1.6, gid=name, label=label)
        for place in way.positions[1:-1]:
            stage.point(place, color=colour, marker="o", markersize=2)
    _add_labels(stage, scene, {**bodies, "obstacles": []})
    drawn = stage.paint()
    _legend(stage, columns=1)
    return drawn


@styled
def model(
    scene: Scene, *, cable: int | str = 0, at: ArrayLike | None = None, view: View = VIEW, ax: Axes3D | None = None
) -> Axes3D:
    """Draw the model with its symbols: world frame O, platform frame P at p, outlet and attachment of one cable.

    The cable runs straight from its outlet B_i to p + R a_i, where it meets the platform.

    Parameters
    ----------
    scene : Scene
    cable : int or str
        The cable to draw in full: its name, or its number counting from 0.
    at : array_like (3,), optional
        Position of the platform, m; default the scene's start, else the centre of its workspace.
    view : (float, float)
        Elevation and azimuth of the eye, degrees. Hidden lines are computed for this view: change the view here, not
        with the mouse.
    ax : Axes3D, optional
        Where to draw; default a new figure of the width of a column.

    Returns
    -------
    Axes3D
        The vectors carry the ``gid`` "p", "b", "a" and "cable <cable>".

    Examples
    --------
    >>> import cdpr, cdpr.figures
    >>> ax = cdpr.figures.model(cdpr.example("hard1"), cable=4)
    """
    stage, bodies = _stage_of(scene, ax, view)
    cables, place = bodies["cables"], _position(scene, at)
    cable = _number_of(cable, [drawn["name"] for drawn in cables])
    _add_robot(stage, bodies, place, PALE)
    outlet, end = np.array(cables[cable]["outlet"]), place + np.array(cables[cable]["attachment"])
    origin, size = np.zeros(3), float(np.ptp([c["outlet"] for c in cables], axis=0).max())
    _add_frame(stage, origin, np.eye(3), _FRAME * size, "O")
    _add_frame(stage, place, rotation(scene.orientation), _FRAME * size, "P")
    stage.arrow(origin, place, GREEN, "p")
    stage.arrow(origin, outlet, PURPLE, "b")
    stage.arrow(place, end, VERMILION, "a")
    stage.line(np.array([outlet, end]), color=BLACK, linewidth=1.8)
    stage.words(origin + 0.45 * place, r"$\mathbf{p}$", color=GREEN, fontsize=9)
    stage.words((origin + outlet) / 2, r"$\mathbf{b}_i$", color=PURPLE, fontsize=9, offset=(-4, -4))
    stage.words(place + 0.55 * (end - place), r"$\mathbf{R}\,\mathbf{a}_i$", color=VERMILION, fontsize=9, offset=(5, 5))
    stage.words(outlet + 0.45 * (end - outlet), r"$\mathbf{l}_i$", fontsize=9, offset=(4, 6))
    stage.words(outlet, rf"$B_i$, outlet of {cables[cable]['name']}", offset=(5, 6))
    stage.words(end, "$A_i$, attachment", offset=(-5, 6))
    stage.point(end, color=VERMILION, marker="o", markersize=3)
    for obstacle in bodies["obstacles"]:
        stage.words(_middle(obstacle), obstacle["name"], offset=(0, 0))
    return stage.paint()


@styled
def rewinding(
    scene: Scene,
    waypoints: ArrayLike | Path,
    *,
    direction: Direction = "backward",
    step: float = 0.1,
    view: View = VIEW,
    ax: Axes3D | None = None,
) -> Axes3D:
    """Draw one rewinding of a path: each connection that was tried, and the resulting path.

    Parameters
    ----------
    scene : Scene
    waypoints : array_like (k, 3) or Path
        A valid path, m, on which the platform keeps its orientation.
    direction : {"backward", "forward"}
        The paper's Algorithm 4 or 5.
    step : float
        Distance of the points tried along each segment, m.
    view : (float, float)
        Elevation and azimuth of the eye, degrees. Hidden lines are computed for this view: change the view here, not
        with the mouse.
    ax : Axes3D, optional
        Where to draw; default a new figure of the width of a column.

    Returns
    -------
    Axes3D
        The path before has the ``gid`` "before", that afterwards "after", refused connections "refused".

    Examples
    --------
    >>> import cdpr, cdpr.figures
    >>> hard1 = cdpr.example("hard1")
    >>> ax = cdpr.figures.rewinding(hard1, cdpr.plan(hard1, seed=1, post="none"))
    """
    before, scene = _level_way(waypoints), scene_for(scene, waypoints)
    after, starts, ends, valid = scene._core.rewind_tries(
        before, number("step", step), f"{one_of('direction', direction, Direction)}-only"
    )
    stage, bodies = _stage_of(scene, ax, view)
    refused = [np.array(pair) for pair, good in zip(zip(starts, ends, strict=True), valid, strict=True) if not good]
    for k, pair in enumerate(refused):
        label = {"label": f"refused ({len(refused)})"} if k == 0 else {}
        stage.line(pair, color=VERMILION, linewidth=0.5, linestyle=":", gid="refused", **label)
    lengths = [f"{name}: {_length(way):.3f} m" for name, way in (("before", before), ("after", after))]
    stage.line(before, color=GREY, linewidth=1.2, linestyle="--", gid="before", label=lengths[0])
    stage.line(after, color=GREEN, linewidth=1.8, gid="after", label=lengths[1])
    for place in after[1:-1]:
        stage.point(place, color=GREEN, marker="o", markersize=3)
    for k, place in enumerate(before):
        stage.words(place, f"{k}", offset=(4, 5), color=GREY)
    drawn = stage.paint()
    _legend(stage)
    return drawn


@styled
def available_set(
    robot: Robot,
    position: ArrayLike,
    *,
    kind: Literal["force", "moment"] = "force",
    load: ArrayLike | None = None,
    gravity: ArrayLike | None = None,
    orientation: ArrayLike | None = None,
    view: View = VIEW,
    ax: Axes3D | None = None,
) -> Axes3D:
    """Draw the forces (or moments) that the cables can exert at a position, and the largest ball around the balance.

    Parameters
    ----------
    robot : Robot
        With a mass and tension limits.
    position : array_like (3,)
        World, m.
    kind : {"force", "moment"}
    load : array_like (6,), optional
        An additional constant wrench, world axes, with its moment about the platform's origin, N and N·m.
    gravity : array_like (3,), optional
        World axes, m/s²; default (0, 0, -9.81). It acts at the robot's centre of mass.
    orientation : array_like (4,), optional
        World-from-platform unit quaternion w x y z; default: no rotation.
    view : (float, float)
        Elevation and azimuth of the eye, degrees. Hidden lines are computed for this view: change the view here, not
        with the mouse.
    ax : Axes3D, optional
        Where to draw; default a new figure of the width of a column.

    Returns
    -------
    Axes3D
        N or N·m. The surface has the ``gid`` "available set"; the ball, if there is one, "ball".

    Examples
    --------
    >>> import cdpr, cdpr.figures
    >>> ax = cdpr.figures.available_set(cdpr.example("empty").robot, [0.7, 1.2, 0.8])
    """
    if text("kind", kind) not in ("force", "moment"):
        raise InputError(f'kind: found {kind!r}, expected "force" or "moment"')
    function = force_set if kind == "force" else moment_set
    found = function(robot, position, load=load, gravity=gravity, orientation=orientation)
    if found.rank < 3:
        raise InputError(f"position: found a set of {kind}s of dimension {found.rank} there, expected 3")
    low, high = found.vertices.min(axis=0), found.vertices.max(axis=0)
    symbol, unit = ("F", "N") if kind == "force" else ("M", "N·m")
    stage = Stage(ax, low, high, view, unit, zoom=0.82)  # numbers of forces are wide
    stage.sheet(faces_of_mesh(found.vertices, found.triangles), VERMILION, 0.12, "available set")
    if found.margin > 0:
        _add_ball(stage, found.balance, found.margin)
    stage.point(found.balance, color=BLACK, marker="o", markersize=3, gid="balance")
    drawn = stage.paint()
    drawn.tick_params(axis="z", pad=4)
    for axis, pad in ((drawn.xaxis, -4), (drawn.yaxis, -1), (drawn.zaxis, 4)):
        axis.labelpad = pad
    drawn.set(xlabel=f"${symbol}_x$ ({unit})", ylabel=f"${symbol}_y$ ({unit})", zlabel=f"${symbol}_z$ ({unit})")
    margin = f"ball of {found.margin:.0f} {unit}" if found.margin > 0 else "the balance is outside"
    drawn.set_title(f"available {kind}s; {margin}", y=1.0)
    return drawn


def _stage_of(scene: Scene, ax: Axes3D | None, view: View) -> tuple[Stage, dict[str, Any]]:
    """Return a stage as large as workspace and outlets, with the obstacles, the workspace box and the outlets on it."""
    instance("scene", scene, Scene)
    bodies = json.loads(scene._core.bodies())
    box = scene._spec["workspace"]
    corners = np.array([box["min"], box["max"]])
    outlets = np.array([cable["outlet"] for cable in bodies["cables"]])
    everything = np.vstack([corners, outlets, *(p["vertices"] for o in bodies["obstacles"] for p in o["parts"])])
    stage = Stage(ax, everything.min(axis=0), everything.max(axis=0), view)
    for obstacle in bodies["obstacles"]:
        for part in obstacle["parts"]:
            stage.solid(np.array(part["vertices"]), part["faces"], SAND, obstacle["name"])
    for edge in _box_edges(corners):
        stage.line(edge, color=LIGHT, linewidth=0.6)
    for cable in bodies["cables"]:
        place, name = np.array(cable["outlet"]), f"outlet of {cable['name']}"
        stage.point(place, color=BLACK, marker="o", markersize=2.5, gid=name)
    return stage, bodies


def _number_of(cable: int | str, names: list[str]) -> int:
    if isinstance(cable, str):
        return names.index(known("cable", text("cable", cable), names))
    if whole("cable", cable) >= len(names):
        raise InputError(f"cable: found {shown(cable)}, expected a name, or a number from 0 to {len(names) - 1}")
    return cable


def _box_edges(corners: Floats) -> list[Floats]:
    """Return the twelve edges of a box."""
    ends = [[i, j, k] for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    places = {tuple(e): np.array([corners[e[axis]][axis] for axis in range(3)]) for e in ends}
    pairs = [(a, b) for a in places for b in places if a < b and sum(x != y for x, y in zip(a, b, strict=True)) == 1]
    return [np.array([places[a], places[b]]) for a, b in pairs]


def turned(bodies: dict[str, Any], scene: Scene, orientation: Floats) -> dict[str, Any]:
    """Return the bodies, which are at the scene's orientation, with the platform at another one."""
    if np.array_equal(orientation, scene.orientation):
        return bodies
    turn = rotation(orientation) @ rotation(scene.orientation).T
    platform = [part | {"vertices": np.array(part["vertices"]) @ turn.T} for part in bodies["platform"]]
    cables = [cable | {"attachment": turn @ np.array(cable["attachment"])} for cable in bodies["cables"]]
    return bodies | {"platform": platform, "cables": cables}


def _pose_count(way: Way | None, at: ArrayLike | None, poses: int | None) -> int:
    """At how many places along a path the platform is drawn; none if it is drawn at one place of its own."""
    if poses is not None and way is None:
        raise InputError("poses: found a number of poses without a path, expected a path as well")
    if poses is not None and not 1 <= whole("poses", poses) <= _MOST_POSES:
        raise InputError(f"poses: found {poses}, expected 1 to {_MOST_POSES}")
    count = poses if poses is not None else _POSES if way is not None and way.turns else 0
    if count and at is not None:
        raise InputError("at: found a position for a platform that is drawn along its path, expected none")
    return count


def _add_robot(
    stage: Stage, bodies: dict[str, Any], place: Floats, colour: str = BLUE, cables: dict[str, Any] = _CABLE
) -> None:
    for part in bodies["platform"]:
        stage.solid(np.array(part["vertices"]) + place, part["faces"], colour, "platform")
    for cable in bodies["cables"]:
        points = course(cable, place + np.array(cable["attachment"]))
        stage.line(points, gid=cable["name"], **cables)


def _add_shadows(
    stage: Stage, scene: Scene, bodies: dict[str, Any], cables: str | Sequence[str] | None
) -> None:
    found = scene.shadows(cables=cables)
    casting = list(dict.fromkeys(mesh.culprits[0] for mesh in found.values()))
    few = len(casting) <= len(_CASTING)
    for mesh in found.values():
        colour = _CASTING[casting.index(mesh.culprits[0])] if few else SKY
        stage.sheet(faces_of_mesh(mesh.vertices, mesh.triangles), colour, 0.18 if few else 0.07, mesh.name)
    if few:
        outlets = {cable["name"]: np.array(cable["outlet"]) for cable in bodies["cables"]}
        for cable, colour in zip(casting, _CASTING, strict=False):
            stage.point(outlets[cable], color=colour, marker="o", markersize=6)


def _add_path(stage: Stage, way: Way, path: ArrayLike | Path | None, through: str | bool) -> None:
    if isinstance(path, Result) and len(path.raw_waypoints) > 1 and not np.array_equal(path.raw_waypoints, path.waypoints):
        raw = path.raw_waypoints
        stage.line(raw, color=GREY, linewidth=1, linestyle="--", gid="raw path", label=f"raw: {_length(raw):.3f} m")
    label = f"path: {way.length:.3f} m{way.words}"
    stage.line(way.positions, color=GREEN, linewidth=2, gid="path", label=label, through=through)
    for place in way.positions[1:-1]:
        stage.point(place, color=GREEN, marker="o", markersize=3.5, through=through)


def _add_poses(stage: Stage, scene: Scene, bodies: dict[str, Any], way: Way, count: int) -> None:
    """Platform and cables at even steps along a path."""
    places = np.linspace(0.0, way.steps(scene).sum(), count)
    for k, (place, turn) in enumerate(zip(*way.at(scene, places), strict=True)):
        end = k in (0, count - 1)
        _add_robot(stage, turned(bodies, scene, turn), place, BLUE if end else PALE, _CABLE if end else _PASSING)


def _add_labels(stage: Stage, scene: Scene, bodies: dict[str, Any]) -> None:
    for obstacle in bodies["obstacles"]:
        stage.words(_middle(obstacle), obstacle["name"], offset=(0, 0))
    for name, place in (("start", scene.start), ("goal", scene.goal)):
        if place is not None:
            stage.point(place, color=BLACK, marker="D", markersize=3, gid=name)
            stage.words(place, name, offset=(6, -6))


def _add_frame(stage: Stage, origin: Floats, axes: Floats, length: float, name: str) -> None:
    for k, letter in enumerate("xyz"):
        end = origin + length * axes[:, k]
        stage.arrow(origin, end, BLUE, f"frame {name}")
        stage.words(end, f"${letter}_{name}$", offset=(3, 3), color=BLUE)


def _add_ball(stage: Stage, middle: Floats, radius: float, lines: int = 8) -> None:
    """Draw a disc, which is what a ball looks like from far away, and the nearer halves of circles on it."""
    right, up = paper_axes(stage.toward)
    turn = np.linspace(0, 2 * np.pi, 49)
    disc = np.outer(np.cos(turn), right) + np.outer(np.sin(turn), up)
    stage.sheet([middle + radius * disc], BLUE, 0.25, "ball")
    for k in range(lines):
        around = np.pi * k / lines
        meridian = np.column_stack([np.cos(turn) * np.cos(around), np.cos(turn) * np.sin(around), np.sin(turn)])
        height = np.sin(np.pi * ((k + 0.5) / lines - 0.5))
        wide = np.sqrt(1 - height**2)
        parallel = np.column_stack([wide * np.cos(turn), wide * np.sin(turn), np.full_like(turn, height)])
        for circle in (meridian, parallel):
            near = np.where((circle @ stage.toward >= 0)[:, None], circle, np.nan)
            stage.line(middle + radius * near, color=BLUE, linewidth=0.5, gid="ball circle")


def _legend(stage: Stage, columns: int = 3) -> None:
    """Below the drawing, where nothing else is; a figure of its own becomes so much higher."""
    ax = stage.ax
    place = {"loc": "upper center", "bbox_to_anchor": (0.5, 0.0), "borderaxespad": 0}
    legend = ax.legend(ncols=columns, handlelength=1.6, columnspacing=1.2, **place)
    if stage.own:
        stage.lower(legend.get_window_extent().height)


def _position(scene: Scene, at: ArrayLike | None) -> Floats:
    if at is not None:
        return np.array(point("at", at))
    box = scene._spec["workspace"]
    return scene.start if scene.start is not None else np.mean([box["min"], box["max"]], axis=0)


def _middle(obstacle: dict[str, Any]) -> Floats:
    corners = np.vstack([part["vertices"] for part in obstacle["parts"]])
    middle: Floats = (corners.min(axis=0) + corners.max(axis=0)) / 2
    return middle


def _level_way(path: ArrayLike | Path) -> Floats:
    """Return the waypoints (k, 3) of a path that can be rewound."""
    if isinstance(path, Result) and not path.solved:
        raise InputError(f"waypoints: found a result with status {path.status!r}, expected a solved one")
    return path_rows("waypoints", path)


def _length(way: Floats) -> float:
    return float(np.linalg.norm(np.diff(way, axis=0), axis=1).sum())
