"""Timed motions over time."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from matplotlib import pyplot
from matplotlib.axes import Axes

from .._arrays import Floats
from .._given import instance, several
from .._trajectory import Trajectory
from ..exceptions import InputError
from ._style import BLACK, COLUMN, CYCLE, GREY, LIGHT, styled

_CHART, _ROW, _REST = 1.05, 0.16, 0.9  # heights of a chart, of a row of the strip, and of the rest, inches
_SHOWN_TO = 2.0  # limits up to so many times the largest value are in the picture; the others are named at its edge
_ROOM = 0.08  # above and below the curves, as a share of their range
_DASHES = ("-", (0, (4, 1, 1, 1)))  # of the cables; the second once the colours are used up
_KINDS = {
    "speed": "speed",
    "acceleration": "acceleration",
    "jerk": "jerk",
    "cable_speed": "cable speed",
    "cable_acceleration": "cable acceleration",
    "tension": "tensions",
}


@styled
def trajectory(trajectory: Trajectory, *, ax: Sequence[Axes] | None = None) -> tuple[Axes, ...]:
    """Draw a timed motion: speed, acceleration, cable speeds and tensions over time, and which limit binds when.

    Limits are dashed; one that is far above the curve is named at the edge of the chart. Thin vertical lines are the
    corners of the path, with the indices of their waypoints. Below, a bar shows when a limit binds, in the colour of the
    cable, if it is that of a cable.

    Parameters
    ----------
    trajectory : Trajectory
    ax : sequence of Axes, optional
        Where to draw: five, or four if tensions are not limited; default a new figure of the width of a column.

    Returns
    -------
    tuple of Axes
        Speed, acceleration, cable speeds, tensions (if they are limited), and which limit binds.

    Raises
    ------
    InputError
        A wrong number of Axes.

    Examples
    --------
    >>> import cdpr, cdpr.figures
    >>> scene = cdpr.Scene.load("testdata/scenes/hard1.toml")
    >>> motion = cdpr.trajectory(scene, cdpr.plan(scene), speed=1, acceleration=2, blend=0.03)
    >>> charts = cdpr.figures.trajectory(motion)
    >>> [chart.get_ylabel() for chart in charts]
    ['speed (m/s)', 'acceleration (m/s²)', 'cable speeds (m/s)', 'limited by']
    """
    motion = instance("trajectory", trajectory, Trajectory)
    axes = _panels(motion) if ax is None else _given_axes(ax, _count(motion))
    speed, acceleration, cables, *tensions, strip = axes
    for chart, rows, key, label in (
        (speed, motion.velocities, "speed", "speed (m/s)"),
        (acceleration, motion.accelerations, "acceleration", "acceleration (m/s²)"),
    ):
        values = np.linalg.norm(rows, axis=1)
        chart.plot(motion.times, values, color=BLACK, gid=key, zorder=3)
        most = motion.limits.get(key)
        _framed(chart, label, values, [] if most is None else [(most, f"limit {most:g} {label[label.index('(') + 1 : -1]}")])
    _of_cables(cables, motion, motion.cable_speeds)
    most = motion.limits.get("cable_speed")
    _framed(
        *(cables, "cable speeds (m/s)", motion.cable_speeds),
        [] if most is None else [(most, f"limit {most:g} m/s"), (-most, "")],
    )
    for chart in tensions:
        assert motion.tensions is not None
        _of_cables(chart, motion, motion.tensions)
        _framed(chart, "tensions (N)", motion.tensions, _tension_limits(motion))
    _strip(strip, motion)
    for chart in axes:
        for corner in motion.corners:
            chart.axvline(corner.time, color=LIGHT, linewidth=0.6, zorder=1, gid="corner")
        chart.set_xlim(0, motion.duration)
        chart.set_axisbelow(True)
    for corner in motion.corners:
        place = (corner.time, 1.0)
        speed.annotate(
            *(str(corner.waypoint), place), xycoords=speed.get_xaxis_transform(), xytext=(0, 2), textcoords="offset points",
            ha="center", color=GREY, fontsize=6, gid="waypoint",
        )  # fmt: skip
    strip.set_xlabel("time (s)")
    if ax is None:
        handles, names = cables.get_legend_handles_labels()
        speed.figure.legend(handles, names, loc="outside upper center", ncols=min(4, len(names)), handlelength=1.4, columnspacing=1.2)
        speed.figure.align_ylabels(axes)  # type: ignore[union-attr]
    return axes


def _count(motion: Trajectory) -> int:
    return 4 if motion.tensions is None else 5


def _given_axes(ax: Sequence[Axes], count: int) -> tuple[Axes, ...]:
    found = several("ax", ax, f"{count} Axes")
    if len(found) != count:
        raise InputError(f"ax: found {len(found)}, expected {count} Axes")
    return tuple(instance(f"ax[{k}]", entry, Axes) for k, entry in enumerate(found))


def _panels(motion: Trajectory) -> tuple[Axes, ...]:
    charts, rows = _count(motion) - 1, max(1, len(_kinds(motion)))
    heights = [_CHART] * charts + [_ROW * (rows + 0.5)]
    size = (COLUMN, sum(heights) + _REST)
    return tuple(pyplot.subplots(charts + 1, 1, figsize=size, height_ratios=heights, sharex=True, layout="constrained")[1])


def _look(cable: int) -> dict[str, object]:
    return {"color": CYCLE[cable % len(CYCLE)], "linestyle": _DASHES[cable // len(CYCLE) % len(_DASHES)]}


def _of_cables(chart: Axes, motion: Trajectory, rows: Floats) -> None:
    for k, (name, column) in enumerate(zip(motion.cables, rows.T, strict=True)):
        chart.plot(motion.times, column, linewidth=1.0, label=name, gid=name, zorder=3, **_look(k))  # type: ignore[arg-type]


def _tension_limits(motion: Trajectory) -> list[tuple[float, str]]:
    """The minimum and maximum tensions, each with the cables that it is for, if not for all."""
    found = []
    assert motion.tension_limits is not None
    for word, column in zip(("min", "max"), motion.tension_limits.T, strict=True):
        for value in np.unique(column):
            cables = [name for name, limit in zip(motion.cables, column, strict=True) if limit == value]
            some = cables[0] if len(cables) == 1 else f"{len(cables)} cables"
            found.append((float(value), f"{word} {value:g} N" + ("" if len(cables) == len(column) else f", {some}")))
    return found


def _framed(chart: Axes, label: str, values: Floats, limits: list[tuple[float, str]]) -> None:
    """Label a chart and draw its limits."""
    low, high = min(0.0, float(values.min())), float(values.max())
    far = _SHOWN_TO * max(high, -low)
    shown = [value for value, _ in limits if abs(value) <= far]
    low, high = min([low, *shown]), max([high, *shown])
    room = _ROOM * (high - low or 1.0)
    chart.set(ylabel=label, ylim=(low - (room if low < 0 else 0), high + room))
    chart.grid(axis="y")
    beyond = [words for value, words in limits if abs(value) > far and words]
    for value, words in limits:
        if abs(value) > far:
            continue
        chart.axhline(value, color=GREY, linewidth=0.8, linestyle="--", zorder=2, gid="limit")
        _named(chart, words, value, above=value < 0.5 * (low + high))
    if beyond:
        chart.annotate(
            *(", ".join(beyond) + " ↑", (1, 1)), xycoords="axes fraction", xytext=(-2, -1), textcoords="offset points",
            ha="right", va="top", color=GREY, fontsize=6, gid="beyond",
        )  # fmt: skip


def _named(chart: Axes, words: str, value: float, *, above: bool) -> None:
    """Write the name of a limit beside its line, where the curves usually are not."""
    chart.annotate(
        *(words, (1, value)), xycoords=chart.get_yaxis_transform(), xytext=(-2, 1.5 if above else -1.5), gid="limit",
        textcoords="offset points", ha="right", va="bottom" if above else "top", color=GREY, fontsize=6, zorder=4,
        bbox={"facecolor": "white", "edgecolor": "none", "alpha": 0.7, "pad": 0.5},
    )  # fmt: skip


def _kinds(motion: Trajectory) -> list[str]:
    """The kinds of limits that bind at some time, in a fixed order."""
    found = {entry.limit for entry in motion.limiting}
    return [kind for kind in _KINDS if kind in found]


def _strip(chart: Axes, motion: Trajectory) -> None:
    kinds = _kinds(motion)
    for entry in motion.limiting:
        row = kinds.index(entry.limit)
        color = GREY if entry.cable is None else _look(motion.cables.index(entry.cable))["color"]
        chart.broken_barh([(entry.start, entry.end - entry.start)], (row - 0.32, 0.64), color=color, gid=entry.limit, zorder=3)
    chart.set(ylabel="limited by", ylim=(max(1, len(kinds)) - 0.5, -0.5))
    chart.set_yticks(range(len(kinds)), [_KINDS[kind] for kind in kinds])
    chart.tick_params(axis="y", length=0)
    for above, _ in pairwise(range(len(kinds))):
        chart.axhline(above + 0.5, color=LIGHT, linewidth=0.4, zorder=1)
