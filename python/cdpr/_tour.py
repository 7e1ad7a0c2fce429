"""Tours of stations."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import Floats, Ints, whole
from ._given import flag, function, instance, one_of, plain, table, text, texts
from ._planning import turned
from ._questions import Engine, Interference
from ._results import Path
from ._scene import Scene
from ._search import search_options

TourOrder: TypeAlias = Literal["best", "given"]
TourBy: TypeAlias = Literal["length", "time"]


def _nothing() -> Floats:
    return np.empty((0, 0))


@dataclass(frozen=True, eq=False, repr=False)
class Tour(Path):
    """A path through stations.

    Attributes
    ----------
    waypoints : ndarray (k, 3)
        Positions of the platform's origin, world, m; (0, 3) if there is no tour.
    cost : float
        Length, m; infinite if there is no tour.
    orientation : ndarray (4,)
        World-from-platform unit quaternion w x y z of the scene.
    orientations : ndarray (k, 4) or None
        Unit quaternion w x y z at each waypoint, if the platform turns.
    order : tuple of str
        Names of the stations in the order of the tour; the first one again at the end if it returns.
    lower_bound : float
        No tour is shorter, m: in any order or, if it was given, in this one. Infinite if it is certain that there is no tour.
    stops : ndarray (len(order),)
        For each station of ``order``, the index of its waypoint; empty if there is no tour.
    stations : tuple of str
        Names of the stations, in the order of the rows and columns of ``costs``.
    costs : ndarray (n, n)
        Length of the path between each pair of stations, m; infinite where no path was found, NaN if it was not planned.
    lower_bounds : ndarray (n, n)
        No path between the two is shorter, m; infinite if it is certain that there is none, NaN if it was not planned.
    statuses : dict
        How planning ended for each pair of names, in the order of ``stations``, as in :class:`Result`.
    duration : float or None
        By time, duration of all motions, each from rest at one station to rest at the next, s; infinite if there is no tour.
    least_duration : float or None
        By time, no tour that stops at its stations takes less, s: in any order or, if it was given, in this one. Infinite if it is certain
        that there is no tour; 0 if speeds and accelerations have no limit.
    durations : ndarray (n, n) or None
        By time, duration of the motion along each path, either way, s; infinite where there is none, NaN if it was not planned.
    least_durations : ndarray (n, n) or None
        By time, no motion between the two takes less, s; infinite if it is certain that there is none, NaN if it was not planned.
    reasons : dict
        By time, why the path between a pair of names cannot be timed, for those of which it cannot.

    Examples
    --------
    >>> import cdpr
    >>> stations = {"dock": [0.3, 1, 0.3], "rack": [1.7, 1, 1.7], "shelf": [0.3, 1, 1.5]}
    >>> tour = cdpr.tour(cdpr.example("hard1").replace(stations=stations))
    >>> tour.order
    ('dock', 'shelf', 'rack')
    >>> tour.waypoints[tour.stops[1]]
    array([0.3, 1. , 1.5])
    """

    order: tuple[str, ...] = ()
    lower_bound: float = float("nan")
    stops: Ints = field(default_factory=lambda: np.empty(0, dtype=np.int64))
    stations: tuple[str, ...] = ()
    costs: Floats = field(default_factory=_nothing)
    lower_bounds: Floats = field(default_factory=_nothing)
    statuses: Mapping[tuple[str, str], str] = field(default_factory=dict)
    duration: float | None = None
    least_duration: float | None = None
    durations: Floats | None = None
    least_durations: Floats | None = None
    reasons: Mapping[tuple[str, str], str] = field(default_factory=dict)

    @property
    def legs(self) -> tuple[Path, ...]:
        """The path from each station of ``order`` to the next.

        Examples
        --------
        >>> import cdpr
        >>> stations = {"dock": [0.3, 1, 0.3], "rack": [1.7, 1, 1.7], "shelf": [0.3, 1, 1.5]}
        >>> cdpr.tour(cdpr.example("hard1").replace(stations=stations)).legs[0]
        Path(1.2000 m, 2 waypoints)
        """
        return tuple(self._leg(k) for k in range(max(len(self.stops) - 1, 0)))

    def _leg(self, k: int) -> Path:
        part = slice(self.stops[k], self.stops[k + 1] + 1)
        turns = None if self.orientations is None else self.orientations[part]
        first, last = (self.stations.index(name) for name in self.order[k : k + 2])
        cost = float(self.costs[first, last])
        return Path(self.waypoints[part], cost, self.orientation, orientations=turns, _json=json.dumps(self._origin()))

    def __repr__(self) -> str:
        """Show the length and the order."""
        if not len(self.waypoints):
            return f"Tour(none of {len(self.stations)} stations)"
        return f"Tour({self.cost:.4f} m, {len(self.stations)} stations)"


def tour(
    scene: Scene,
    stations: Sequence[str] | None = None,
    *,
    start: str | None = None,
    returns: bool = False,
    order: TourOrder = "best",
    by: TourBy = "length",
    motion: Mapping[str, float] | None = None,
    gap: float | None = None,
    budget: float | None = None,
    seed: int = 0,
    orientation: ArrayLike | str | None = None,
    engine: Engine = "cspace",
    interference: Interference = "exact",
    threads: int | None = None,
    progress: Callable[[int, int], object] | None = None,
) -> Tour:
    """Plan a tour: the paths between stations, and the order with the shortest way through all of them, or the least time.

    Up to 12 stations, the order is the best one for the paths that were found; beyond that, a search finds a short one.

    Parameters
    ----------
    scene : Scene
    stations : sequence of str, optional
        Names of the stations to visit; default: all of the scene's.
    start : str, optional
        Name of the station where the tour starts; default: the best one or, in the given order, the first.
    returns : bool
        Return to the start at the end.
    order : {"best", "given"}
        The order with the shortest way or the least time, or that of ``stations``.
    by : {"length", "time"}
        What tours are compared by: the length, or the duration of the fastest motions along the paths, each from rest at one station to rest
        at the next. A motion can be run backwards within the same limits, so one duration holds either way.
    motion : mapping, optional
        By time, the limits of :func:`trajectory` by name, which take precedence over those of the scene's table ``[motion]``.
    gap : float, optional
        Search between two stations until the path is proved to be at most this fraction longer than the shortest. Where wrenches or
        clearances bind, that may never be: give a budget as well.
    budget : float, optional
        Time limit of each pair of stations, s. Without it, the result does not depend on the number of threads.
    seed : int
        Seed of all random numbers.
    orientation : array_like (4,) or str, optional
        As in :func:`plan`. A scene with several orientations must select one.
    engine : {"cspace", "gjk"}
    interference : {"exact", "swept"}
    threads : int, optional
        Number of threads; default: all cores.
    progress : callable, optional
        Called now and then with the number of planned pairs and the total number; an exception in it ends the work.

    Returns
    -------
    Tour
        After Ctrl-C, pairs that were not planned yet are "interrupted" in ``statuses``.

    Raises
    ------
    InputError
        Fewer than two stations, unknown names, bad options, limits that are too few or contradict each other, a scene that selects none
        of its orientations.
    KeyboardInterrupt
        On Ctrl-C while the scene is compiled.

    Examples
    --------
    >>> stations = {"dock": [0.3, 1, 0.3], "rack": [1.7, 1, 1.7], "shelf": [0.3, 1, 1.5]}
    >>> scene = Scene.example("hard1").replace(stations=stations)
    >>> found = tour(scene, start="rack", returns=True)
    >>> found.order, found.cost <= 1.01 * found.lower_bound
    (('rack', 'dock', 'shelf', 'rack'), True)
    >>> found = tour(scene, by="time", motion={"speed": 1, "acceleration": 2})
    >>> found.durations[0].round(2).tolist(), found.least_duration <= found.duration
    ([0.0, 3.44, 1.7], True)
    """
    instance("scene", scene, Scene)
    function("progress", progress)
    search = search_options(
        "anytime", seed=seed, gap=gap, budget=budget, engine=engine, interference=interference, proof=True
    )
    names = None if stations is None else texts("stations", stations)
    written = _core.tour(
        turned(scene, orientation),
        search,
        names,
        None if start is None else text("start", start),
        flag("returns", returns),
        one_of("order", order, TourOrder),
        one_of("by", by, TourBy),
        None if motion is None else json.dumps(plain("motion", table("motion", motion))),
        None if threads is None else whole("threads", threads),
        progress,
    )
    return _tour(written, [*scene.stations] if names is None else names)


def _tour(written: str, stations: list[str]) -> Tour:
    """Make a tour from JSON of the core."""
    found: dict[str, Any] = json.loads(written)
    keys = found["tour"]
    timed = "duration" in keys

    def matrix(key: str) -> Floats:
        found: Floats = np.where(np.eye(len(stations), dtype=bool), 0.0, np.nan)
        for pair in keys["pairs"]:
            first, last = (stations.index(name) for name in pair["between"])
            found[first, last] = found[last, first] = _number(pair[key])
        return found

    def of_pairs(key: str) -> dict[tuple[str, str], str]:
        pairs = (pair for pair in keys["pairs"] if pair.get(key) is not None)
        return {(pair["between"][0], pair["between"][1]): pair[key] for pair in pairs}

    turns = found.get("orientations")
    return Tour(
        np.array(found["waypoints"], dtype=np.float64).reshape(-1, 3),
        _number(keys["cost"]),
        np.array(found["orientation"]),
        orientations=None if turns is None else np.array(turns),
        order=tuple(keys["order"]),
        lower_bound=_number(keys["lower_bound"]),
        stops=np.array(keys["stops"], dtype=np.int64),
        stations=tuple(stations),
        costs=matrix("cost"),
        lower_bounds=matrix("lower_bound"),
        statuses=of_pairs("status"),
        duration=_number(keys["duration"]) if timed else None,
        least_duration=_number(keys["least_duration"]) if timed else None,
        durations=matrix("duration") if timed else None,
        least_durations=matrix("least_duration") if timed else None,
        reasons=of_pairs("reason"),
        _json=written,
    )


def _number(value: float | None) -> float:
    return float("inf") if value is None else float(value)
