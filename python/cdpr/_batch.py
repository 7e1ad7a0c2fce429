"""Experiments: scenarios × methods × trials, on the cores of this machine or on any executor."""

from __future__ import annotations

import csv
import io
import json
import os
import pickle
import re
import warnings
from collections.abc import Mapping
from concurrent.futures import Executor
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np

from . import _core, _external
from ._arrays import thread_count, whole
from ._executors import Progress, check, gathered, ranges
from ._given import file_name, plain, text
from ._pandas import pandas_or_none
from ._scene import Scene
from .exceptions import CdprWarning, InputError

# Rows of each group, and what went wrong.
_Rows: TypeAlias = tuple[list[bytes], list[str]]

# As in the core.
_MOST_TRIALS = 1_000_000_000

_TABLES = ("trials.csv", "timings.csv", "history.csv", "summary.json")
_NAMES = ("scenario", "method", "status")
# In CSV files, text that looks like a formula is preceded by an apostrophe, so that no spreadsheet evaluates it.
_FORMULA = re.compile(r"^'(?=[=+\-@\t\r'])")
_INTEGERS = {"trial": np.int64, "seed": np.uint64, "samples": np.int64}


@dataclass(frozen=True, eq=False, repr=False)
class BatchResult:
    """Tables of a run: pandas DataFrames if pandas is installed, else structured NumPy arrays.

    Attributes
    ----------
    name : str
        Name of the experiment.
    trials : DataFrame or structured ndarray
        One row per trial: ``scenario``, ``method``, ``trial``, ``seed``, ``status``, ``raw_cost`` and ``cost`` (m),
        ``raw_waypoints``, ``waypoints``, ``nodes``, ``motion_checks``; numbers of unsolved trials are NaN. Planning the
        trial's scene with its ``seed`` reproduces its path.
    timings : DataFrame or structured ndarray
        ``scenario``, ``method``, ``trial``, ``planning_seconds``, ``post_seconds``, ``compile_seconds``: the last is the
        time to compile the scene for the engine, only in the first trial of a method that needed it.
    history : DataFrame, structured ndarray or None
        When the planners' paths improved, if the experiment sets ``history: true``: ``scenario``, ``method``,
        ``trial``, ``seconds`` since the search began, ``samples`` drawn by then, ``cost`` (m) before post-processing.
        Variants of a sweep share one history, under the name of the swept method.
    summary : DataFrame or dict
        One row per scenario and method: ``n``, ``solved``, and for each measure ``_mean``, ``_sd``, ``_median``,
        ``_q05``, ``_q25``, ``_q75``, ``_q95``, ``_min``, ``_max``, ``_low`` and ``_high`` (the confidence interval of
        the mean); for swept methods also ``of``, the method's name, and the swept ones of ``step``, ``post``,
        ``repeats``. Without pandas, the dict of ``summary.json``.
    t_tests : list of dict
        ``group``, ``measure``, ``a``, ``b``, ``variances``, ``t``, ``df``, ``p``; None if undefined. These compare all solved
        trials of a with all of b. If both are in one scenario, ``paired`` compares them in the trials that both solved, which
        have the same scene: ``n`` pairs, in how many a or b is less (``a_less``, ``b_less``), ``mean_difference`` and the paired
        ``t``, ``df``, ``p``.
    pairs : list of dict
        For each method but the first of its scenario by name: ``scenario``, ``a`` (that first method), ``b`` and ``cost``, the
        lengths of both compared in pairs, as in ``paired``.
    trials_csv : bytes
        Contents of the trials.csv that ``cdpr batch`` writes, byte for byte.

    Examples
    --------
    >>> scene = Scene.example("hard1")
    >>> scenarios, methods = [{"name": "pillar", "scene": scene}], [{"name": "RRT", "planner": "rrt"}]
    >>> run_batch({"version": 1, "trials": 5, "scenarios": scenarios, "methods": methods})
    BatchResult('experiment', 5 rows)
    """

    name: str
    trials: Any
    timings: Any
    history: Any
    summary: Any
    t_tests: list[dict[str, Any]]
    pairs: list[dict[str, Any]]
    trials_csv: bytes
    _json: str
    _range: tuple[int, int]
    _rows: list[bytes]
    _random: tuple[str, ...] = ()

    def save(self, folder: str | os.PathLike[str]) -> None:
        """Write a folder like that of ``cdpr batch -o``; ``cdpr report`` and ``cdpr merge`` read it.

        Parameters
        ----------
        folder : path
            New, or empty.

        Raises
        ------
        FileError
            A folder that is not empty, or that cannot be written.
        """
        _core.Experiment.from_json(self._json).save(file_name(folder, "folder"), *self._range, self._rows)

    def __eq__(self, other: object) -> bool:
        """Compare by value: experiment, range of trials, and rows including times."""
        if not isinstance(other, BatchResult):
            return NotImplemented
        return (self._json, self._range, self._rows) == (other._json, other._range, other._rows)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        """Show name and size."""
        return f"BatchResult({self.name!r}, {len(self.trials)} rows)"


def run_batch(
    experiment: str | os.PathLike[str] | Mapping[str, Any],
    executor: Executor | None = None,
    progress: Progress | None = None,
    trials: int | range | None = None,
    threads: int | None = None,
) -> BatchResult:
    """Run an experiment: the given number of trials of every method in every scenario.

    Parameters
    ----------
    experiment : path or mapping
        An experiment file (TOML or JSON), or its contents; in a mapping, a scene may be a `Scene`, a mapping, or the
        path of a file relative to the working directory, and the planner of a method may be a function.
    executor : concurrent.futures.Executor, optional
        Where to run; default: threads of this process. Any executor works: threads, processes, or a Dask cluster
        (``Client.get_executor()``). Workers receive ranges of trials as plain JSON with inline scenes, so they need
        cdpr but no files.
    progress : callable, optional
        Called now and then with the number of finished trials and the total number, over all methods and scenarios; an
        exception in it ends the run.
    trials : int or range, optional
        Number of trials instead of the experiment's, or a range of them.
    threads : int, optional
        Threads of this process, default: the number of cores; with an executor, threads of each task, default 1.

    Returns
    -------
    BatchResult
        Its ``trials`` do not depend on executor, workers or threads.

    Raises
    ------
    InputError
        Names the key, what was found and what is expected; or the trial, if a function returns something else than a path.
    FileError
        A file that cannot be read.
    KeyboardInterrupt
        After Ctrl-C. With an executor, running tasks finish and waiting ones are cancelled.

    Warns
    -----
    CdprWarning
        The trials in which the program or a function failed, with the reason; their rows have the status "failed". Paths of
        functions that are not valid.

    Notes
    -----
    A planner that is a function is called with the scene of each trial, which has start and goal, and with ``seed``, the seed of
    the trial. It returns waypoints, (n, 3), a `Path` or `Result`, or None if it has found no path. Its calls are timed; its path
    is checked, shortened if the method sets ``post``, and measured. Its statuses are also "unsolved" (None), "invalid_path" (the
    path is not valid, or does not lead from start to goal) and "failed" (an exception); warnings give the reasons. Functions run
    one trial after the other in the calling thread, after the other methods; with an executor, in its tasks. As with the planners
    of cdpr, the decision that a scene has no path comes first, unless ``proof`` is False.

    Examples
    --------
    >>> experiment = {
    ...     "version": 1,
    ...     "trials": 20,
    ...     "scenarios": [{"name": "pillar", "scene": Scene.example("hard1")}],
    ...     "methods": [{"name": "RRT", "planner": "rrt"}, {"name": "modified RRT"}],
    ... }
    >>> result = run_batch(experiment)
    >>> len(result.trials), sorted(set(result.trials["status"]))
    (40, ['solved'])

    Trials can run on an executor:

    >>> from concurrent.futures import ThreadPoolExecutor
    >>> with ThreadPoolExecutor(2) as pool:
    ...     again = run_batch(experiment, pool)
    >>> again.trials_csv == result.trials_csv
    True

    A planner of one's own, here one that tries detours over random points:

    >>> import numpy as np
    >>> def detour(scene, *, seed):
    ...     for over in np.random.default_rng(seed).uniform(*scene.workspace, (500, 3)):
    ...         path = np.array([scene.start, over, scene.goal])
    ...         if scene.motions_valid(path[:-1], path[1:]).all():
    ...             return path
    >>> mine = run_batch({**experiment, "methods": [{"name": "detour", "planner": detour}, {"name": "modified RRT"}]})
    >>> mine.pairs[0]["a"], mine.pairs[0]["b"], mine.pairs[0]["cost"]["n"]  # trials that both solved
    ('detour', 'modified RRT', 18)
    """
    check(executor, progress)
    checked, functions = _checked(experiment)
    first, end = _first_and_end(checked, trials)
    if executor is None:
        rows, failures = _run(checked, functions, (first, end), thread_count(threads), progress)
    else:
        each = thread_count(threads)
        try:
            rows, failures = _on_executor(checked, functions, executor, progress, (first, end), 1 if each is None else each)
        except (pickle.PicklingError, AttributeError, TypeError) as problem:
            if not (functions and re.search("pickle|serialize", str(problem))):
                raise
            found = f"{', '.join(map(_external.name_of, functions.values()))}, which the executor cannot send to its workers"
            raise InputError(f"methods: found {found}, expected functions of a module that they can import: {problem}") from problem
    for failure in failures:
        warnings.warn(failure, CdprWarning, stacklevel=2)
    return _result(*checked.tables(first, end, rows), checked.to_json(), (first, end), rows)


def trial_scene(experiment: str | os.PathLike[str] | Mapping[str, Any], scenario: str, trial: int) -> Scene:
    """Return the scene in which all methods of an experiment plan in a trial.

    Parameters
    ----------
    experiment : path or mapping
        As for `run_batch`.
    scenario : str
        Name of the scenario.
    trial : int
        Number of the trial, from 0.

    Returns
    -------
    Scene
        With start and goal; without random obstacles, each trial has the scene of the scenario.

    Raises
    ------
    InputError
        An unknown scenario, a negative number; the errors of `run_batch`.

    Examples
    --------
    >>> import cdpr
    >>> random = {"name": "prisms", "scene": Scene.example("empty"), "random": {"count": 3}}
    >>> experiment = {"version": 1, "trials": 5, "scenarios": [random], "methods": [{"name": "RRT", "planner": "rrt"}]}
    >>> scene = trial_scene(experiment, "prisms", 2)
    >>> len(scene.obstacles)
    3
    >>> trials = run_batch(experiment).trials
    >>> bool(cdpr.plan(scene, "rrt", seed=int(trials["seed"][2]), proof=False).cost == trials["cost"][2])
    True
    """
    checked, _ = _checked(experiment)
    names = [name for name, _ in checked.scenarios]
    if text("scenario", scenario) not in names:
        raise InputError(f'scenario: found "{scenario}", expected one of {", ".join(names)}')
    if not 0 <= whole("trial", trial) <= _MOST_TRIALS:
        raise InputError(f"trial: found {trial}, expected a number from 0 to {_MOST_TRIALS}")
    return Scene._of_core(checked.scene(names.index(scenario), int(trial)))


def load_tables(folder: str | os.PathLike[str]) -> BatchResult:
    """Read the tables in the folder of a run, to be drawn; the result has no rows to save."""
    trials, timings, history, summary = (Path(folder, name) for name in _TABLES)
    history_csv = history.read_bytes() if history.exists() else None
    return _result(trials.read_bytes(), timings.read_bytes(), history_csv, summary.read_text("utf-8"), "", (0, 0), [])


def _result(
    trials_csv: bytes,
    timings_csv: bytes,
    history_csv: bytes | None,
    summary: str,
    experiment: str,
    trials: tuple[int, int],
    rows: list[bytes],
) -> BatchResult:
    facts = json.loads(summary)
    return BatchResult(
        name=facts["experiment"],
        trials=_table(trials_csv),
        timings=_table(timings_csv),
        history=None if history_csv is None else _table(history_csv),
        summary=_summary(facts),
        t_tests=facts["t_tests"],
        pairs=facts["pairs"],
        trials_csv=trials_csv,
        _json=experiment,
        _range=trials,
        _rows=rows,
        _random=tuple(facts.get("random", ())),
    )


def _checked(experiment: str | os.PathLike[str] | Mapping[str, Any]) -> tuple[_core.Experiment, dict[int, _external.Planner]]:
    """Return the experiment, and those of its planners that are functions by the numbers of their methods."""
    functions: dict[int, _external.Planner] = {}
    if not isinstance(experiment, Mapping):
        checked = _core.Experiment.load(file_name(experiment, "experiment"))
    else:
        methods, functions = _external.named(experiment.get("methods"))
        spec = {**experiment, "methods": methods} if functions else experiment
        checked = _core.Experiment.from_json(json.dumps(plain("", spec, known=_spelled_out)))
    for number, (name, external) in enumerate(checked.methods):
        if external and number not in functions:
            raise InputError(f'methods[{number}].planner: found the name of a function for "{name}", expected the function')
    return checked, functions


def _spelled_out(value: object) -> object:
    """Return the value for an experiment file of a scene or a path."""
    match value:
        case Scene():
            return value.to_dict()
        case os.PathLike():
            return file_name(value)
    return value


def _first_and_end(experiment: _core.Experiment, trials: int | range | None) -> tuple[int, int]:
    if trials is None:
        return 0, experiment.trials
    if isinstance(trials, range):
        if trials.step != 1 or trials.start < 0 or not trials:
            raise InputError(f"trials: found {trials}, expected a range of at least one trial, in steps of 1 from 0 or more")
        return trials.start, trials.stop
    if whole("trials", trials) < 1:
        raise InputError(f"trials: found {trials}, expected at least 1")
    return 0, int(trials)


def _run(
    experiment: _core.Experiment,
    functions: Mapping[int, _external.Planner],
    trials: tuple[int, int],
    threads: int | None,
    progress: Progress | None,
) -> _Rows:
    """Run a range of trials: those of the core, then those of functions."""
    count = (trials[1] - trials[0]) * len(experiment.scenarios)
    own, total = count * len(functions), count * len(experiment.methods)

    def tell(done: int, _: int = 0) -> None:
        if progress is not None:
            progress(done, total)

    rows, failures = experiment.run(*trials, threads, tell if progress is not None and functions else progress)
    lines, problems = _external.run(experiment, functions, range(*trials), lambda done: tell(total - own + done))
    return [lines.get(group, part) for group, part in enumerate(rows)], [f"failed: {failure}" for failure in failures] + problems


def _work(written: str, functions: Mapping[int, _external.Planner], first: int, end: int, threads: int) -> _Rows:
    """Run a range of trials in a worker; apart from functions, input and output are plain data."""
    return _run(_core.Experiment.from_json(written), functions, (first, end), threads, None)


def _on_executor(
    experiment: _core.Experiment,
    functions: Mapping[int, _external.Planner],
    executor: Executor,
    progress: Progress | None,
    trials: tuple[int, int],
    threads: int,
) -> _Rows:
    """Distribute ranges of trials and combine their rows in order, whichever finishes first."""
    parts, written = ranges(*trials), experiment.to_json()
    calls = [(written, functions, start, stop, threads) for start, stop in parts]
    sizes = [(stop - start) * experiment.groups for start, stop in parts]
    results = gathered(executor, _work, calls, sizes, progress)
    rows = [b"".join(lines) for lines in zip(*(lines for lines, _ in results), strict=True)]
    return rows, [failure for _, failures in results for failure in failures]


def _table(text: bytes) -> Any:
    """Return CSV as a DataFrame, or as a structured array; empty numbers are NaN."""
    lines = csv.reader(io.StringIO(text.decode()))
    header = next(lines)
    columns = dict(zip(header, list(zip(*lines, strict=True)) or [()] * len(header), strict=True))
    arrays = {name: _column(name, values) for name, values in columns.items()}
    if (pandas := pandas_or_none()) is not None:
        return pandas.DataFrame(arrays)
    table = np.empty(len(arrays["trial"]), dtype=[(name, column.dtype) for name, column in arrays.items()])
    for name, column in arrays.items():
        table[name] = column
    return table


def _column(name: str, values: tuple[str, ...]) -> np.ndarray[Any, Any]:
    if name in _NAMES:
        return np.array([_FORMULA.sub("", value) for value in values])
    if name in _INTEGERS:
        return np.array([int(value) for value in values], dtype=_INTEGERS[name])
    return np.array([float(value) if value else np.nan for value in values])


def _summary(facts: dict[str, Any]) -> Any:
    if (pandas := pandas_or_none()) is None:
        return facts
    return pandas.DataFrame([_flat(entry) for entry in facts["methods"]])


def summary_rows(batch: BatchResult) -> list[dict[str, Any]]:
    """Return the rows of a summary, leaving out undefined entries; works without pandas."""
    if isinstance(batch.summary, dict):
        return [_flat(entry) for entry in batch.summary["methods"]]
    rows: list[dict[str, Any]] = batch.summary.to_dict("records")
    return [{key: value for key, value in row.items() if value == value} for row in rows]


def _flat(entry: dict[str, Any]) -> dict[str, Any]:
    """Return one row: measures with their statistics become columns."""
    row = {name: entry[name] for name in ("scenario", "method", "n", "solved")}
    row |= {name: value for name, value in entry.get("sweep", {}).items() if value is not None}
    for measure, statistics in entry.items():
        if measure in ("scenario", "method", "n", "solved", "statuses", "sweep"):
            continue
        numbers = dict(statistics)
        low, high = numbers.pop("confidence_interval")
        for name, value in {**numbers, "low": low, "high": high}.items():
            row[f"{measure}_{name}"] = np.nan if value is None else value
    return row
