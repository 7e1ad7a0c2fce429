"""Charts of experiments: sweeps, repeats, and distributions as box-whisker plots."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Any, Literal

import numpy as np
from matplotlib import pyplot
from matplotlib.axes import Axes
from numpy.typing import ArrayLike

from .._arrays import Floats, as_numbers, shown
from .._batch import BatchResult, summary_rows
from .._given import instance, table, text, texts
from ..exceptions import InputError
from ._style import BLACK, COLUMN, CYCLE, GREY, Printed, laid_out, make_high, styled

Measure = Literal["cost", "raw_cost", "reduction", "planning_seconds", "post_seconds", "waypoints"]

# Label of the axis of each measure, and the factor for the numbers of a run.
_AXES: dict[str, tuple[str, float]] = {
    "cost": ("path length (m)", 1.0),
    "raw_cost": ("raw path length (m)", 1.0),
    "reduction": ("reduction of path length (%)", 100.0),
    "planning_seconds": ("planning time (ms)", 1e3),
    "post_seconds": ("rewinding time (µs)", 1e6),
    "waypoints": ("waypoints", 1.0),
}
_TIMES = ("planning_seconds", "post_seconds")
_HEIGHT = 2.4
_TICK_WIDTHS, _GAP = (14, 10), 10  # characters in a line of a box's name; pixels between two names
_LINE_WIDTH, _HANDLE = 64, 7  # characters in a line of a legend, and what a handle takes of them
ROW = 0.15  # height of a row of a legend, inches
_SLOPE, _LETTER = 40, 0.04  # of names that are turned: degrees; height of a letter of theirs, inches
_MARKERS = "os^Dv"


@styled
def step_sweep(batch: BatchResult, measure: Measure = "reduction", *, ax: Axes | None = None) -> Axes:
    """Draw a measure over the step of rewinding: mean and confidence interval; for times, median and quartiles.

    Other activity on the machine distorts the mean of times of microseconds, but not their median.

    Parameters
    ----------
    batch : BatchResult
        A run of an experiment that sweeps the step, such as experiments/fig7.toml.
    measure : str
        "reduction", "post_seconds" or another measure of the summary.
    ax : Axes, optional
        Where to draw; default a new figure of the width of a column.

    Returns
    -------
    Axes
        A line for each scenario and method.

    Raises
    ------
    InputError
        A run that sweeps no step, an unknown measure.

    Examples
    --------
    >>> import cdpr, cdpr.figures
    >>> scenarios = [{"name": "pillar", "scene": cdpr.example("hard1")}]
    >>> methods = [{"name": "modified RRT", "sweep": {"step": [0.05, 0.1, 0.2]}}]
    >>> batch = cdpr.run_batch({"version": 1, "trials": 20, "scenarios": scenarios, "methods": methods})
    >>> ax = cdpr.figures.step_sweep(batch)
    """
    label, scale = _axis(measure)
    ax, own = _axes(ax), ax is None
    middle, low, high = ("median", "q25", "q75") if measure in _TIMES else ("mean", "low", "high")
    for k, (name, rows) in enumerate(_lines(batch, "step").items()):
        x = [row["step"] for row in rows]
        line, below, above = _column(rows, measure, scale, middle, low, high)
        ax.fill_between(x, below, above, color=CYCLE[k % len(CYCLE)], alpha=0.25, linewidth=0)
        ax.plot(x, line, color=CYCLE[k % len(CYCLE)], label=f"{name}, {middle}")
    ax.set(xlabel="step of rewinding (m)", ylabel=label, xlim=(0, None))
    ax.set_ylim(0 if measure in _TIMES else None)
    return _finished(ax, own, above=own)


@styled
def repeats(batch: BatchResult, measure: Measure = "reduction", *, ax: Axes | None = None) -> Axes:
    """Draw the mean of a measure over the number of repeats of rewinding, a line for each order.

    Parameters
    ----------
    batch : BatchResult
        A run of an experiment that sweeps the repeats, such as experiments/fig8.toml.
    measure : str
        "reduction", "post_seconds" or another measure of the summary.
    ax : Axes, optional
        Where to draw; default a new figure of the width of a column.

    Returns
    -------
    Axes
        The orders are drawn slightly offset, so that their confidence intervals can be distinguished.

    Examples
    --------
    >>> import cdpr, cdpr.figures
    >>> scenarios = [{"name": "pillar", "scene": cdpr.example("hard1")}]
    >>> methods = [{"name": "modified RRT", "sweep": {"post": ["backward", "forward"], "repeats": [1, 2, 3]}}]
    >>> batch = cdpr.run_batch({"version": 1, "trials": 20, "scenarios": scenarios, "methods": methods})
    >>> ax = cdpr.figures.repeats(batch)
    """
    label, scale = _axis(measure)
    ax, own = _axes(ax), ax is None
    lines = _lines(batch, "repeats")
    for k, (name, rows) in enumerate(lines.items()):
        beside = 0.12 * (k - (len(lines) - 1) / 2)
        x = [row["repeats"] + beside for row in rows]
        (means,), (low, high) = _column(rows, measure, scale, "mean"), _column(rows, measure, scale, "low", "high")
        style: dict[str, Any] = {"marker": _MARKERS[k % len(_MARKERS)], "markersize": 3, "capsize": 2, "linewidth": 1}
        ax.errorbar(x, means, [means - low, high - means], color=CYCLE[k % len(CYCLE)], label=name, elinewidth=0.8, **style)
    counts = sorted({row["repeats"] for rows in lines.values() for row in rows})
    ax.set(xlabel="repeats of rewinding", ylabel=label, xticks=counts)
    return _finished(ax, own, above=True)


@styled
def boxes(
    data: BatchResult | Mapping[str, ArrayLike],
    measure: Measure = "cost",
    *,
    scenario: str | None = None,
    methods: Sequence[str] | None = None,
    label: str | None = None,
    ax: Axes | None = None,
) -> Axes:
    """Draw distributions as box-whisker plots: median, quartiles, whiskers, outliers, and the mean as a diamond.

    Whiskers reach to the farthest number within 1.5 interquartile ranges of the box.

    Parameters
    ----------
    data : BatchResult, or mapping of str to array_like (n,)
        For a run, the solved trials of every method are drawn; NaN values are left out.
    measure : str
        Measure of a run to draw.
    scenario : str, optional
        Scenario of a run; required if there are several.
    methods : sequence of str, optional
        Methods of a run, in this order; default all.
    label : str, optional
        Label of the axis; default that of the measure.
    ax : Axes, optional
        Where to draw; default a new figure of the width of a column.

    Returns
    -------
    Axes

    Raises
    ------
    InputError
        Nothing to draw, unknown names.

    Examples
    --------
    >>> import cdpr.figures
    >>> ax = cdpr.figures.boxes({"a": [1, 2, 3, 9], "b": [2, 3, 4]}, label="length (m)")
    >>> [text.get_text() for text in ax.get_xticklabels()]
    ['a\\n(n = 4)', 'b\\n(n = 3)']
    """
    if isinstance(data, BatchResult):
        name, _ = _axis(measure)
        samples = _samples(data, measure, scenario, methods)
        label = name if label is None else label
    else:
        samples = {text("data", name): _numbers(name, values) for name, values in table("data", data).items()}
    if not samples:
        raise InputError("data: found nothing, expected numbers by name")
    label = None if label is None else text("label", label)
    ax, own = _axes(ax), ax is None
    drawn = ax.boxplot(
        list(samples.values()),
        widths=0.5,
        showmeans=True,
        patch_artist=True,
        medianprops={"color": BLACK, "linewidth": 1.2},
        meanprops={"marker": "D", "markersize": 3, "markerfacecolor": "white", "markeredgecolor": BLACK},
        flierprops={"marker": ".", "markersize": 2, "markerfacecolor": GREY, "markeredgecolor": "none"},
        whiskerprops={"linewidth": 0.8},
        capprops={"linewidth": 0.8},
    )
    for k, patch in enumerate(drawn["boxes"]):
        patch.set(facecolor=CYCLE[k % len(CYCLE)], alpha=0.55, linewidth=0.8)
    ax.set_ylabel(label or "")
    ax.grid(axis="y")
    ax.set_axisbelow(True)
    _name_boxes(ax, {name: len(values) for name, values in samples.items()}, own)
    return ax


def _name_boxes(ax: Axes, counts: dict[str, int], own: bool) -> None:
    """Name boxes below them, in lines that are short enough not to touch; if none are, aslant."""
    for width in _TICK_WIDTHS:
        lines = {name: textwrap.fill(name, width, break_long_words=False) for name in counts}
        ax.set_xticks(ax.get_xticks(), [f"{lines[name]}\n(n = {count})" for name, count in counts.items()])
        laid_out(ax)
        areas = [tick.get_window_extent() for tick in ax.get_xticklabels()]
        if all(left.x1 + _GAP < right.x0 for left, right in pairwise(areas)):
            return
    names = [f"{name} (n = {count})" for name, count in counts.items()]
    ax.set_xticks(ax.get_xticks(), names, rotation=_SLOPE, ha="right", rotation_mode="anchor")
    if own:
        make_high(ax, _HEIGHT + _LETTER * max(map(len, names)))


def _axis(measure: str) -> tuple[str, float]:
    if text("measure", measure) not in _AXES:
        raise InputError(f"measure: found {measure!r}, expected one of {', '.join(_AXES)}")
    return _AXES[measure]


def _axes(ax: Axes | None) -> Axes:
    if ax is None:
        return pyplot.subplots(figsize=(COLUMN, _HEIGHT), layout="constrained", FigureClass=Printed)[1]
    return instance("ax", ax, Axes)


def _finished(ax: Axes, own: bool, above: bool) -> Axes:
    """Add grid and legend, above the axes or where it covers least."""
    ax.grid()
    ax.set_axisbelow(True)
    place = {"loc": "lower center", "bbox_to_anchor": (0.5, 1), "ncols": columns(ax), "columnspacing": 1.2}
    ax.legend(**(place if above else {}))
    if own:
        make_high(ax, _HEIGHT + rows_beyond(ax, 1) * ROW)
    return ax


def rows_beyond(ax: Axes, rows: int) -> int:
    """Return the number of rows of a legend above axes, beyond those that a figure has room for."""
    return max(0, -(-len(ax.get_legend_handles_labels()[1]) // columns(ax)) - rows)


def columns(ax: Axes) -> int:
    """In how many columns the names of a legend fit above axes of the width of a column."""
    names = ax.get_legend_handles_labels()[1]
    return max(1, min(3, len(names), _LINE_WIDTH // (_HANDLE + max(map(len, names), default=0))))


def _lines(batch: BatchResult, key: str) -> dict[str, list[dict[str, Any]]]:
    """Return the rows of a sweep grouped by their other differences, in the order of the key."""
    if not isinstance(batch, BatchResult):
        raise InputError(f"batch: found {shown(batch)}, expected a BatchResult")
    rows = [row for row in summary_rows(batch) if key in row]
    if not rows:
        raise InputError(f"batch: found a run that does not sweep {key!r}, expected one that does")
    scenarios = {row["scenario"] for row in rows}
    others = [other for other in ("step", "post", "repeats") if other != key]
    lines: dict[str, list[dict[str, Any]]] = {}
    for row in sorted(rows, key=lambda row: float(row[key])):
        names = [row["scenario"]] if len(scenarios) > 1 else []
        names += [_words(other, row[other]) for other in others if other in row] or [row["of"]]
        lines.setdefault(", ".join(names), []).append(row)
    return lines


def _words(key: str, value: Any) -> str:
    return {"post": f"{value} first", "step": f"step {value} m", "repeats": f"{value} repeats"}[key]


def _column(rows: list[dict[str, Any]], measure: str, scale: float, *statistics: str) -> list[Floats]:
    """Return each of these statistics, NaN if undefined."""
    columns = ([row.get(f"{measure}_{name}", np.nan) for row in rows] for name in statistics)
    return [scale * np.array(column, dtype=np.float64) for column in columns]


def _samples(
    batch: BatchResult, measure: str, scenario: str | None, methods: Sequence[str] | None
) -> dict[str, Floats]:
    trials, timings = batch.trials, batch.timings
    scenarios = list(dict.fromkeys(np.asarray(trials["scenario"]).tolist()))
    if scenario is None and len(scenarios) > 1:
        raise InputError(f"scenario: found none, expected one of {', '.join(scenarios)}")
    chosen = known("scenario", scenarios[0] if scenario is None else scenario, scenarios)
    here = np.asarray(trials["scenario"]) == chosen
    names = np.asarray(trials["method"])
    all_methods = list(dict.fromkeys(names[here].tolist()))
    if measure == "reduction":
        numbers = 1 - np.asarray(trials["cost"]) / np.asarray(trials["raw_cost"])
    else:
        numbers = np.asarray((timings if measure in _TIMES else trials)[measure], dtype=np.float64)
    solved = np.asarray(trials["status"]) == "solved"
    scale = _AXES[measure][1]
    wanted = all_methods if methods is None else [known("methods", name, all_methods) for name in texts("methods", methods)]
    return {name: _numbers(name, scale * numbers[here & solved & (names == name)]) for name in wanted}


def known(place: str, name: str, names: list[str]) -> str:
    if text(place, name) not in names:
        raise InputError(f"{place}: found {name!r}, expected one of {', '.join(names)}")
    return name


def _numbers(name: str, values: ArrayLike) -> Floats:
    """Return finite numbers, at least one."""
    array = as_numbers(name, values)
    found: Floats = array[np.isfinite(array)] if array.ndim == 1 else array
    if found.ndim != 1 or not len(found):
        raise InputError(f"{name}: found an array of shape {array.shape}, expected (n,) with finite numbers")
    return found
