"""What happens along a path: clearance, turns, tensions and margins."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from matplotlib import pyplot
from matplotlib.axes import Axes
from matplotlib.patheffects import withStroke
from numpy.typing import ArrayLike

from .._arrays import Floats
from .._given import instance
from .._paths import scene_for
from .._planning import check
from .._results import Path
from .._scene import Scene
from .._tensions import Tensions, tensions_along
from ._motion import framed, given_axes, look, named_cables
from ._poses import Way, way_of
from ._style import BLACK, COLUMN, LIGHT, VERMILION, Printed, styled

_CHART, _REST = 1.1, 0.9  # heights of a chart and of the rest, inches
_STEPS = 400  # steps of a curve
_MANY = 20  # waypoints, whose lines are then thinner


@styled
def along(scene: Scene, path: ArrayLike | Path, *, ax: Sequence[Axes] | None = None) -> tuple[Axes, ...]:
    """Draw what happens along a path: the clearance, how far the platform has turned, tensions and the capacity margin.

    Thin vertical lines are waypoints. The dot in the chart of the clearance is the nearest approach, found between the steps as
    well, and its pair. The platform is at rest, as in `cdpr.tensions_along`.

    Parameters
    ----------
    scene : Scene
    path : array_like (k, 3), Path or Result
        Positions of the platform's origin, m; a path with orientations is drawn with its turns.
    ax : sequence of Axes, optional
        Where to draw: one, one more if the platform turns, and two more if the robot has a mass and tension limits; default a
        new figure of the width of a column.

    Returns
    -------
    tuple of Axes
        Clearance, turn so far (if the platform turns), tensions and capacity margin (if the robot has a mass and tension
        limits). The abscissa is the length of the path so far, with its turns.

    Raises
    ------
    InputError
        A wrong number of Axes, a result without a path.

    Examples
    --------
    >>> import cdpr, cdpr.figures
    >>> bar = cdpr.example("turn")
    >>> charts = cdpr.figures.along(bar, cdpr.plan(bar, "rrt-connect"))
    >>> [chart.get_title("left") for chart in charts]
    ['clearance (m)', 'turned so far (°)']
    """
    scene = scene_for(instance("scene", scene, Scene), path)
    way = way_of("path", scene, path)
    ends = np.concatenate([[0.0], np.cumsum(way.steps(scene))])
    length = float(ends[-1])
    loads = _loads(scene, way, length)
    count = 1 + way.turns + (0 if loads is None else 2)
    axes = _panels(count) if ax is None else given_axes(ax, count)
    charts = iter(axes)
    _clearance(next(charts), scene, way, ends)
    if way.turns:
        _turned(next(charts), way, ends)
    if loads is not None:
        forces = next(charts)
        _tensions(forces, scene, loads)
        _margin(next(charts), loads)
        if ax is None:
            named_cables(forces)
    for chart in axes:
        for end in ends[1:-1]:
            chart.axvline(end, color=LIGHT, linewidth=0.6 if len(ends) < _MANY else 0.3, zorder=1, gid="waypoint")
        chart.set_xlim(0, length or 1.0)
        chart.set_axisbelow(True)
    axes[-1].set_xlabel("length of the path so far, with turns (m)" if way.turns else "distance along the path (m)")
    return axes


def _loads(scene: Scene, way: Way, length: float) -> Tensions | None:
    """Return the tensions along the path, if the robot has what they need."""
    if scene.robot.mass is None or not np.isfinite(scene.robot.tensions).all():
        return None
    path = Path(way.positions, length, orientations=way.orientations if way.turns else None)
    return tensions_along(scene, path, step=length / _STEPS or 1.0)


def _panels(count: int) -> tuple[Axes, ...]:
    size = (COLUMN, count * _CHART + _REST)
    figure: dict[str, Any] = {"figsize": size, "layout": "constrained", "FigureClass": Printed}
    found = pyplot.subplots(count, 1, sharex=True, squeeze=False, **figure)[1]
    return tuple(found[:, 0])


def _clearance(chart: Axes, scene: Scene, way: Way, ends: Floats) -> None:
    places = np.unique(np.concatenate([np.linspace(0.0, ends[-1], _STEPS + 1), ends]))
    gaps = scene.clearance(*way.at(scene, places))
    chart.plot(places, gaps, color=BLACK, gid="clearance", zorder=3)
    nearest = check(scene, way.positions, way.orientations if way.turns else None).min_clearance
    required = 0.0 if nearest is None else nearest["required"]
    words = f"{required:g} m required of {' and '.join(nearest['culprits'])}" if nearest and required > 0 else ""
    framed(chart, "clearance (m)", _known(gaps), words, [required] if required > 0 else [])
    if nearest is not None:
        place = ends[nearest["segment"]] + nearest["at"] * (ends[nearest["segment"] + 1] - ends[nearest["segment"]])
        chart.plot([place], [nearest["value"]], color=VERMILION, marker="o", markersize=3, gid="nearest", zorder=4)
        side = "left" if place < 0.5 * ends[-1] else "right"
        chart.annotate(
            " and ".join(nearest["culprits"]), (place, nearest["value"]), (4 if side == "left" else -4, 4),
            textcoords="offset points", ha=side, va="bottom", color=VERMILION, fontsize=6, zorder=5,
            path_effects=[withStroke(linewidth=2, foreground="white")],
        )  # fmt: skip


def _turned(chart: Axes, way: Way, ends: Floats) -> None:
    angles = np.degrees(np.concatenate([[0.0], np.cumsum(way.angles)]))
    chart.plot(ends, angles, color=BLACK, gid="turned", zorder=3)
    framed(chart, "turned so far (°)", angles, "", [])


def _tensions(chart: Axes, scene: Scene, loads: Tensions) -> None:
    for k, (name, column) in enumerate(zip(loads.cables, loads.tensions.T, strict=True)):
        chart.plot(loads.s, column, linewidth=1.0, label=name, gid=name, zorder=3, **look(k))  # type: ignore[arg-type]
    limits = np.unique(scene.robot.tensions).tolist()
    framed(chart, "tensions (N)", _known(loads.tensions), f"limits {min(limits):g} to {max(limits):g} N", limits)


def _margin(chart: Axes, loads: Tensions) -> None:
    chart.plot(loads.s, loads.capacity_margin, color=BLACK, gid="capacity margin", zorder=3)
    framed(chart, "capacity margin (N)", _known(loads.capacity_margin), "", [])


def _known(values: Floats) -> Floats:
    """Return those of some values that are finite, for the range of a chart."""
    found: Floats = values[np.isfinite(values)]
    return found if len(found) else np.zeros(1)
