"""Timed motions over time."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from typing import Any

import numpy as np
from matplotlib import pyplot
from matplotlib.axes import Axes

from .._arrays import Floats
from .._given import instance, several
from .._trajectory import Trajectory
from ..exceptions import InputError
from ._style import BLACK, COLUMN, CYCLE, GREY, LIGHT, Printed, styled

_CHART, _ROW, _REST = 1.0, 0.17, 1.3  # heights of a chart, of a row of the strip, and of the rest, inches
_SHOWN_TO = 2.0  # limits up to so many times the largest value are drawn
_ROUNDING = 1e-9  # a smaller range is rounding errors about zero
_ROOM = 0.06  # below the curves, and twice above them, as a share of their range
_DASHES = ("-", (0, (4, 1, 1, 1)))  # of the cables; the second once the colours are used up
_KINDS = {
    "speed": "speed",
    "acceleration": "acceleration",
    "turn_speed": "angular speed",
    "turn_acceleration": "angular acceleration",
    "jerk": "jerk",
    "cable_speed": "cable speed",
    "cable_acceleration": "cable acceleration",
    "tension": "tension",
}


@styled
def trajectory(trajectory: Trajectory, *, ax: Sequence[Axes] | None = None) -> tuple[Axes, ...]:
    """Draw a timed motion: speed, acceleration, cable speeds and tensions over time, and which limit binds when.

    If the platform turns, its angular speed as well.

    Limits are named above each chart; those that are not far away are drawn as dashed lines. Thin vertical lines are the
    corners of the path, with the indices of their waypoints. Below, a bar shows when a limit binds; that of a single cable
    has its colour.

    Parameters
    ----------
    trajectory : Trajectory
    ax : sequence of Axes, optional
        Where to draw: five, or four if tensions are not limited, and one more if the platform turns; default a new figure of
        the width of a column.

    Returns
    -------
    tuple of Axes
        Speed, acceleration, angular speed (if the platform turns), cable speeds, tensions (if they are limited), and which
        limit binds.

    Raises
    ------
    InputError
        A wrong number of Axes.

    Examples
    --------
    >>> import cdpr, cdpr.figures
    >>> scene = cdpr.example("hard1")
    >>> motion = cdpr.trajectory(scene, cdpr.plan(scene), speed=1, acceleration=2, blend=0.03)
    >>> charts = cdpr.figures.trajectory(motion)
    >>> [chart.get_title("left") for chart in charts]
    ['speed (m/s)', 'acceleration (m/s²)', 'cable speeds (m/s)', 'limited by']
    """
    motion = instance("trajectory", trajectory, Trajectory)
    axes = _panels(motion) if ax is None else given_axes(ax, _count(motion))
    quantities = _quantities(motion)
    platform, (cables, *tensions, strip) = axes[: len(quantities)], axes[len(quantities) :]
    speed, limits = platform[0], motion.limits
    for chart, (key, rows, unit) in zip(platform, quantities, strict=True):
        values = np.linalg.norm(rows, axis=1)
        chart.plot(motion.times, values, color=BLACK, gid=key, zorder=3)
        framed(chart, f"{_KINDS[key]} ({unit})", values, _limit(limits.get(key), unit), [limits[key]] if key in limits else [])
    _of_cables(cables, motion, motion.cable_speeds)
    most = limits.get("cable_speed")
    framed(cables, "cable speeds (m/s)", motion.cable_speeds, _limit(most, "m/s"), [] if most is None else [most, -most])
    for chart in tensions:
        assert motion.tensions is not None
        bounds = motion.tension_limits
        _of_cables(chart, motion, motion.tensions)
        words = "" if bounds is None else f"limits {_range(bounds[:, 0])} and {_range(bounds[:, 1])} N"
        framed(chart, "tensions (N)", motion.tensions, words, [] if bounds is None else np.unique(bounds).tolist())
    _strip(strip, motion)
    for chart in axes:
        for corner in motion.corners:
            chart.axvline(corner.time, color=LIGHT, linewidth=0.6, zorder=1, gid="corner")
        chart.set_xlim(0, motion.duration)
        chart.set_axisbelow(True)
    for corner in motion.corners:
        speed.annotate(
            *(str(corner.waypoint), (corner.time, 1.0)), xycoords=speed.get_xaxis_transform(), xytext=(1.5, -0.5),
            textcoords="offset points", ha="left", va="top", color=GREY, fontsize=6, gid="waypoint",
        )  # fmt: skip
    strip.set_xlabel("time (s)")
    if ax is None:
        named_cables(cables)
    return axes


def _quantities(motion: Trajectory) -> list[tuple[str, Floats, str]]:
    """What is drawn of the platform: the key of its limit, its vectors and its unit."""
    found = [("speed", motion.velocities, "m/s"), ("acceleration", motion.accelerations, "m/s²")]
    return [*found, ("turn_speed", motion.angular_velocities, "rad/s")] if motion.turns else found


def _count(motion: Trajectory) -> int:
    return len(_quantities(motion)) + (2 if motion.tensions is None else 3)


def given_axes(ax: Sequence[Axes], count: int) -> tuple[Axes, ...]:
    found = several("ax", ax, f"{count} Axes")
    if len(found) != count:
        raise InputError(f"ax: found {len(found)}, expected {count} Axes")
    return tuple(instance(f"ax[{k}]", entry, Axes) for k, entry in enumerate(found))


def _panels(motion: Trajectory) -> tuple[Axes, ...]:
    charts, rows = _count(motion) - 1, max(1, len(_kinds(motion)))
    heights = [_CHART] * charts + [_ROW * (rows + 0.5)]
    size = (COLUMN, sum(heights) + _REST)
    found = pyplot.subplots(
        charts + 1, 1, figsize=size, height_ratios=heights, sharex=True, layout="constrained", FigureClass=Printed
    )[1]
    return tuple(found)


def named_cables(chart: Axes) -> None:
    """Name the curves of a chart of cables above the whole figure."""
    handles, names = chart.get_legend_handles_labels()
    look: dict[str, Any] = {"ncols": min(4, len(names)), "handlelength": 1.4, "columnspacing": 1.2}
    chart.figure.legend(handles, names, loc="outside upper center", **look)


def look(cable: int) -> dict[str, object]:
    return {"color": CYCLE[cable % len(CYCLE)], "linestyle": _DASHES[cable // len(CYCLE) % len(_DASHES)]}


def _of_cables(chart: Axes, motion: Trajectory, rows: Floats) -> None:
    for k, (name, column) in enumerate(zip(motion.cables, rows.T, strict=True)):
        chart.plot(motion.times, column, linewidth=1.0, label=name, gid=name, zorder=3, **look(k))  # type: ignore[arg-type]


def _limit(most: float | None, unit: str) -> str:
    return "" if most is None else f"limit {most:g} {unit}"


def _range(values: Floats) -> str:
    low, high = values.min(), values.max()
    return f"{low:g}" if low == high else f"{low:g} to {high:g}"


def framed(chart: Axes, title: str, values: Floats, words: str, limits: list[float]) -> None:
    """Name a chart and its limits, and draw those that are not far away."""
    low, high = min(0.0, float(values.min())), float(values.max())
    low, high = (low, high) if high - low > _ROUNDING else (-1.0, 1.0)
    far = _SHOWN_TO * max(high, -low)
    shown = [value for value in limits if abs(value) <= far]
    low, high = min([low, *shown]), max([high, *shown])
    room = _ROOM * (high - low or 1.0)
    chart.set_ylim(low - (room if low < 0 else 0), high + 2 * room)
    chart.set_title(title, loc="left", pad=3)
    if words:
        out_of_sight = " (above)" if len(shown) < len(limits) else " (dashed)"
        chart.set_title(words + out_of_sight, loc="right", pad=3, color=GREY, fontsize=7)
    chart.grid(axis="y")
    for value in shown:
        chart.axhline(value, color=GREY, linewidth=0.8, linestyle="--", zorder=2, gid="limit")


def _kinds(motion: Trajectory) -> list[str]:
    """Return the kinds of limits that bind at some time, in a fixed order."""
    found = {entry.limit for entry in motion.limiting}
    return [kind for kind in _KINDS if kind in found]


def _strip(chart: Axes, motion: Trajectory) -> None:
    kinds = _kinds(motion)
    for entry in motion.limiting:
        row = kinds.index(entry.limit)
        color = GREY if entry.cable is None else look(motion.cables.index(entry.cable))["color"]
        chart.broken_barh([(entry.start, entry.end - entry.start)], (row - 0.32, 0.64), color=color, gid=entry.limit, zorder=3)
    chart.set_title("limited by", loc="left", pad=3)
    chart.set_ylim(max(1, len(kinds)) - 0.5, -0.5)
    chart.set_yticks(range(len(kinds)), [_KINDS[kind] for kind in kinds])
    chart.tick_params(axis="y", length=0)
    for above, _ in pairwise(range(len(kinds))):
        chart.axhline(above + 0.5, color=LIGHT, linewidth=0.4, zorder=1)
