"""Path length over time."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from matplotlib import pyplot
from matplotlib.axes import Axes

from .._arrays import Floats, positive
from .._batch import BatchResult, summary_rows
from .._given import instance, several, texts
from ..exceptions import InputError
from ._charts import ROW, columns, known, rows_beyond
from ._style import COLUMN, CYCLE, Printed, make_high, styled

_HEIGHT = 3.6
_INSTANTS = 500  # points of a curve
_LEAST = 1e-6  # s; the time axis begins where the first path is found, but not earlier
_ENDLESS = 1e6  # %
_FINE = 0.1  # %; below this the axis of lengths is linear, so that zero is on it


@styled
def convergence(
    batch: BatchResult,
    *,
    scenario: str | None = None,
    methods: Sequence[str] | None = None,
    best: float | None = None,
    ax: Sequence[Axes] | None = None,
) -> tuple[Axes, Axes]:
    """Draw the excess length of the best path so far over time, and the share of trials that have a path.

    A line is the median over all trials, the band goes from the first to the third quartile; trials without a path yet
    count as infinitely long, so a line begins when half of the trials have a path. It ends, with a dot, when its last
    trial ends. The last step of a post-processed trial is at the end of post-processing.

    Parameters
    ----------
    batch : BatchResult
        A run of an experiment with ``history = true``, such as experiments/planners.toml.
    scenario : str, optional
        Scenario; required if there are several.
    methods : sequence of str, optional
        Methods, in this order; default all.
    best : float, optional
        Length of the best known path, m; default the shortest path in the run, of all methods and trials, or in random
        scenes of all methods in the same trial.
    ax : two Axes, optional
        Where to draw lengths and shares; default a new figure of the width of a column.

    Returns
    -------
    tuple of two Axes

    Raises
    ------
    InputError
        A run without history, unknown names, a scenario without any path.

    Examples
    --------
    >>> import cdpr.figures
    >>> experiment = {
    ...     "version": 1,
    ...     "trials": 5,
    ...     "history": True,
    ...     "scenarios": [{"name": "pillar", "scene": cdpr.example("hard1")}],
    ...     "methods": [{"name": "anytime", "planner": "anytime", "budget_ms": 5}, {"name": "modified RRT"}],
    ... }
    >>> lengths, shares = cdpr.figures.convergence(cdpr.run_batch(experiment), best=2.435167)
    >>> shares.get_ylabel()
    'solved (%)'
    """
    if not isinstance(batch, BatchResult) or batch.history is None:
        raise InputError("batch: found no run with a history, expected one of an experiment with history = true")
    runs = _courses(batch, scenario, best)
    names = list(runs) if methods is None else texts("methods", methods)
    if not names:
        raise InputError("methods: found none, expected at least one")
    chosen = {name: runs[known("methods", name, list(runs))] for name in names}
    lengths, shares = _panels() if ax is None else _two_axes(ax)
    ends = {name: max(course.ended for course in courses) for name, courses in chosen.items()}
    first = min((course.times[0] for courses in chosen.values() for course in courses if len(course.times)), default=0.0)
    instants = np.geomspace(max(first, _LEAST), max(ends.values()), _INSTANTS)
    longest = _FINE
    for k, (name, courses) in enumerate(chosen.items()):
        until = np.append(instants[instants < ends[name]], ends[name])
        excess = np.array([course.excess_at(until) for course in courses])
        low, middle, high = np.quantile(excess, (0.25, 0.5, 0.75), axis=0, method="inverted_cdf")
        solved = 100 * np.isfinite(excess).mean(axis=0)
        longest = float(np.max(middle[np.isfinite(middle)], initial=longest))
        style: dict[str, Any] = {"color": CYCLE[k % len(CYCLE)], "markersize": 3}
        band = np.isfinite(low)
        ceiling = np.minimum(high[band], _ENDLESS)  # a band without an upper end leaves the picture
        lengths.fill_between(1e3 * until[band], low[band], ceiling, color=style["color"], alpha=0.18, linewidth=0)
        for axes, line in ((lengths, np.where(np.isfinite(middle), middle, np.nan)), (shares, solved)):
            axes.plot(1e3 * until, line, label=name, linewidth=1.2, **style)
            axes.plot(1e3 * until[-1:], line[-1:], "o", **style)
    lengths.set_yscale("symlog", linthresh=_FINE)
    lengths.set_ylim(-_FINE / 6, 1.5 * longest)
    ticks = [tick for tick in (0, 0.1, 1, 10, 100, 1000) if tick < 1.5 * longest]
    lengths.set_yticks(ticks, [f"{tick:g}" for tick in ticks])
    lengths.set(xscale="log", ylabel="longer than the best known (%)")
    shares.set(xscale="log", xlabel="time (ms)", ylabel="solved (%)", ylim=(-4, 104), yticks=[0, 50, 100])
    for axes in (lengths, shares):
        axes.grid()
        axes.set_axisbelow(True)
        axes.xaxis.set_major_formatter("{x:g}")
    if ax is None:
        make_high(lengths, _HEIGHT + rows_beyond(lengths, 2) * ROW)
        lengths.figure.legend(*lengths.get_legend_handles_labels(), loc="outside upper center", ncols=min(2, columns(lengths)))
    return lengths, shares


class _Course(NamedTuple):
    """A trial: when its path improved (s), its excess length over the best known path (%), and when the trial ended."""

    times: Floats
    excess: Floats
    ended: float

    def excess_at(self, instants: Floats) -> Floats:
        """Return the excess length of the path at that time; infinity while there is none."""
        held: Floats = np.append(np.inf, self.excess)[np.searchsorted(self.times, instants, side="right")]
        return held


def _two_axes(ax: Any) -> tuple[Axes, Axes]:
    found = several("ax", ax, "two Axes")
    if len(found) != 2:
        raise InputError(f"ax: found {len(found)}, expected two Axes")
    return instance("ax[0]", found[0], Axes), instance("ax[1]", found[1], Axes)


def _panels() -> tuple[Axes, Axes]:
    _, (lengths, shares) = pyplot.subplots(
        2, 1, figsize=(COLUMN, _HEIGHT), height_ratios=[3, 1], sharex=True, layout="constrained", FigureClass=Printed
    )
    return lengths, shares


def _courses(batch: BatchResult, scenario: str | None, best: float | None) -> dict[str, list[_Course]]:
    """Return the trials of every method in a scenario."""
    scenarios, methods = _names(batch)
    if scenario is None and len(scenarios) > 1:
        raise InputError(f"scenario: found none, expected one of {', '.join(scenarios)}")
    place = known("scenario", scenarios[0] if scenario is None else scenario, scenarios)
    steps = {name: _steps(batch, place, name) for name in methods}
    shortest = np.array([[costs.min(initial=np.inf) for _, costs, _ in trials] for trials in steps.values()]).min(axis=0)
    if not np.isfinite(shortest).any():
        raise InputError(f"scenario: found no path in {place}, expected at least one")
    best = None if best is None else positive("best", best)
    if best is not None or place not in batch._random:
        shortest[:] = shortest.min() if best is None else best
    return {
        name: [
            _Course(times, 100 * (costs / reference - 1), ended)
            for (times, costs, ended), reference in zip(trials, shortest, strict=True)
        ]
        for name, trials in steps.items()
    }


def _names(batch: BatchResult) -> tuple[list[str], list[str]]:
    """Return scenarios and methods, swept ones once: in the order of the experiment or, of a folder, in that of its tables."""
    if batch._json:
        spec = json.loads(batch._json)
        return [entry["name"] for entry in spec["scenarios"]], [entry["name"] for entry in spec["methods"]]
    rows = summary_rows(batch)
    return list({row["scenario"]: 0 for row in rows}), list({row.get("of", row["method"]): 0 for row in rows})


def _steps(batch: BatchResult, scenario: str, method: str) -> list[tuple[Floats, Floats, float]]:
    """When the path of each trial improved (s), its length (m), including post-processing, and when the trial ended."""
    columns = {name: np.asarray(batch.history[name]) for name in ("scenario", "method", "trial", "seconds", "cost")}
    of_method = (columns["scenario"] == scenario) & (columns["method"] == method)
    found = []
    for trial, ended, cost in _ends(batch, scenario, method):
        mine = of_method & (columns["trial"] == trial)
        times, costs = columns["seconds"][mine], columns["cost"][mine]
        if cost < (costs[-1] if len(costs) else np.inf):
            times, costs = np.append(times, ended), np.append(costs, cost)
        found.append((times, costs, ended))
    return found


def _ends(batch: BatchResult, scenario: str, method: str) -> list[tuple[int, float, float]]:
    """Return the number, end (s) and length of the final path (m) of each trial; for a sweep, those of its first variant."""
    trials, timings = batch.trials, batch.timings
    variants = [row["method"] for row in summary_rows(batch) if row.get("of", row["method"]) == method]
    mine = (np.asarray(trials["scenario"]) == scenario) & (np.asarray(trials["method"]) == variants[0])
    seconds = np.nan_to_num([np.asarray(timings[name])[mine] for name in ("planning_seconds", "post_seconds")]).sum(axis=0)
    numbers, costs = (np.asarray(trials[name])[mine] for name in ("trial", "cost"))
    return [(int(trial), float(end), float(cost)) for trial, end, cost in zip(numbers, seconds, costs, strict=True)]
