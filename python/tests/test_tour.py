"""Tours of stations."""

import itertools
import json
import subprocess
from pathlib import Path

import numpy as np
import pytest
from conftest import program

import cdpr


def with_stations(name: str, count: int, seed: int = 0) -> cdpr.Scene:
    scene, rng = cdpr.example(name), np.random.default_rng(seed)
    places = (rng.uniform(*scene.workspace) for _ in itertools.count())
    valid = (place for place in places if scene.states_valid(place))
    return scene.replace(stations={f"station {k}": place for k, place in zip(range(count), valid)})


@pytest.fixture(scope="module")
def scene() -> cdpr.Scene:
    return with_stations("hard3", 6)


def test_the_order_is_the_best_of_all(scene: cdpr.Scene) -> None:
    tour = cdpr.tour(scene, returns=True)
    orders = ((0, *rest, 0) for rest in itertools.permutations(range(1, 6)))
    best = min(sum(tour.costs[a, b] for a, b in itertools.pairwise(order)) for order in orders)
    assert tour.cost == pytest.approx(best, abs=1e-9)
    assert tour.lower_bound <= tour.cost <= 1.0101 * tour.lower_bound
    assert tour.order[0] == tour.order[-1] == "station 0"
    np.testing.assert_array_equal(tour.costs, tour.costs.T)
    assert (tour.lower_bounds <= tour.costs).all() and set(tour.statuses.values()) == {"solved"}


def test_a_tour_is_a_path(scene: cdpr.Scene, tmp_path: Path) -> None:
    tour = cdpr.tour(scene, ["station 3", "station 1", "station 4"], start="station 4")
    assert cdpr.check(scene, tour).valid and tour.order[0] == "station 4"
    assert sum(leg.cost for leg in tour.legs) == pytest.approx(tour.cost)
    for name, stop in zip(tour.order, tour.stops):
        assert tour.waypoints[stop].tolist() == scene.stations[name].position.tolist()
    for (start, goal), leg in zip(itertools.pairwise(tour.order), tour.legs):
        alone = cdpr.plan(scene, start=start, goal=goal, gap=0.01)
        assert leg.cost == pytest.approx(alone.cost, rel=0.011)
        assert cdpr.check(scene, leg).valid
    tour.save(tmp_path / "tour.json")
    assert cdpr.load_path(tmp_path / "tour.json").waypoints.tolist() == tour.waypoints.tolist()
    cdpr.save_view(tmp_path / "tour.html", scene, tour)
    motion = cdpr.trajectory(scene, tour, speed=1, acceleration=2)
    assert motion.duration > tour.cost


def test_threads_and_seeds(scene: cdpr.Scene) -> None:
    one, two = (cdpr.tour(scene, threads=threads) for threads in (1, 2))
    assert one == two
    given = cdpr.tour(scene, order="given")
    assert given.order == tuple(scene.stations) and given.cost >= one.cost
    assert np.isnan(given.costs[0, 2]) and len(given.statuses) == 5


def test_what_cannot_be_visited() -> None:
    scene = cdpr.example("hard1").replace(stations={"dock": [0.3, 1, 0.3], "pillar": [1, 1, 0.5]})
    tour = cdpr.tour(scene)
    assert repr(tour) == "Tour(none of 2 stations)" and tour.legs == ()
    assert tour.statuses == {("dock", "pillar"): "goal_invalid"}
    assert tour.cost == tour.lower_bound == np.inf and tour.waypoints.shape == (0, 3)


def test_progress_and_its_exceptions(scene: cdpr.Scene) -> None:
    told: list[tuple[int, int]] = []
    cdpr.tour(scene, progress=lambda done, total: told.append((done, total)))
    assert told[-1] == (15, 15)

    def broken(done: int, total: int) -> None:
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        cdpr.tour(scene, progress=broken)


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"stations": ["station 1"]}, "stations: found one, expected at least two"),
        ({"stations": ["station 1", "station 9"]}, 'stations: found "station 9", expected'),
        ({"stations": ["station 1", "station 1"]}, 'stations: found "station 1" twice'),
        ({"stations": "station 1"}, "stations: found"),
        ({"start": "nowhere"}, 'start: found "nowhere", expected one of the stations of the tour'),
        ({"order": "worst"}, 'order: found "worst"'),
        ({"gap": -1.0}, "gap: found -1"),
        ({"budget": -1.0}, "budget: found -1"),
        ({"threads": 0}, "threads: found 0"),
        ({"returns": 1}, "returns: found 1"),
        ({"progress": 1}, "progress: found 1"),
    ],
)
def test_bad_options_are_named(scene: cdpr.Scene, options: dict[str, object], said: str) -> None:
    with pytest.raises(cdpr.InputError, match=said):
        cdpr.tour(scene, **options)  # type: ignore[arg-type]


LIMITS = {"speed": 1.0, "acceleration": 2.0}


def test_tours_by_time(scene: cdpr.Scene, tmp_path: Path) -> None:
    tour = cdpr.tour(scene, by="time", motion=LIMITS, returns=True)
    assert tour.durations is not None and tour.least_durations is not None
    assert tour.duration is not None and tour.least_duration is not None
    orders = ((0, *rest, 0) for rest in itertools.permutations(range(1, 6)))
    best = min(sum(tour.durations[a, b] for a, b in itertools.pairwise(order)) for order in orders)
    assert tour.duration == pytest.approx(best, abs=1e-9)
    assert 0 < tour.least_duration <= tour.duration
    np.testing.assert_array_equal(tour.durations, tour.durations.T)
    # At 1 m/s and 2 m/s², a length of more than 0.5 m takes half a second more than its metres.
    lengths = tour.lower_bounds[~np.eye(6, dtype=bool)]
    least = np.where(lengths > 0.5, lengths + 0.5, np.sqrt(2 * lengths))
    np.testing.assert_allclose(tour.least_durations[~np.eye(6, dtype=bool)], least, rtol=1e-9)
    for (start, goal), leg in zip(itertools.pairwise(tour.order), tour.legs):
        a, b = (tour.stations.index(name) for name in (start, goal))
        assert cdpr.trajectory(scene, leg, **LIMITS).duration == pytest.approx(tour.durations[a, b], rel=1e-4)
    assert tour == cdpr.tour(scene, by="time", motion=LIMITS, returns=True, threads=1)
    own = scene.replace(motion=LIMITS)
    assert cdpr.tour(own, by="time").duration == cdpr.tour(scene, by="time", motion=LIMITS).duration
    plain = cdpr.tour(scene)
    assert plain.duration is plain.durations is plain.least_duration is plain.least_durations is None
    scene.save(tmp_path / "scene.json")
    line = ["tour", "scene.json", "--by", "time", "--speed", "1", "--acceleration", "2", "--return"]
    told = subprocess.run([program(), *line, "--matrix", "s.csv"], cwd=tmp_path, capture_output=True, text=True)
    assert told.returncode == 0 and f"tour: {tour.duration:.4f}".rstrip("0") in told.stdout, told.stderr
    assert "no tour that stops at its stations takes less than" in told.stdout and "too slow" in told.stdout
    rows = [line.split(",") for line in (tmp_path / "s.csv").read_text().splitlines()]
    assert rows[0][0] == "s"
    np.testing.assert_array_equal(np.array([row[1:] for row in rows[1:]], dtype=float), tour.durations)
    text = (tmp_path / "scene.json").read_text()
    line = ["tour", "-", *line[2:], "--format", "json", "-q"]
    found = subprocess.run([program(), *line], cwd=tmp_path, capture_output=True, text=True, input=text)
    assert json.loads(found.stdout)["tour"]["duration"] == tour.duration


def test_a_pair_that_cannot_be_timed_is_named() -> None:
    # So high up, the cables cannot hold the platform.
    scene = cdpr.example("cogiro").without("column")
    low = scene.replace(stations={"a": [0, 0, 2], "b": [1, 1, 2], "c": [0, 0, 4.9]}, wrench=None, start=None, goal=None)
    tour = cdpr.tour(low, by="time", motion=LIMITS)
    assert set(tour.reasons) == {("a", "c"), ("b", "c")} and tour.duration == tour.cost == np.inf
    assert all("waypoints" in reason for reason in tour.reasons.values()) and set(tour.statuses.values()) == {"solved"}
    assert repr(tour) == "Tour(none of 3 stations)"


@pytest.mark.parametrize(
    ("options", "said"),
    [
        ({"motion": LIMITS}, 'motion: found with by="length"'),
        ({"by": "time"}, "acceleration: found no limit"),
        ({"by": "duration"}, 'by: found "duration"'),
        ({"by": "time", "motion": {"speed": 0}}, "motion.speed: found 0"),
        ({"by": "time", "motion": {"spede": 1}}, "spede"),
    ],
)
def test_bad_limits_are_named(scene: cdpr.Scene, options: dict[str, object], said: str) -> None:
    with pytest.raises(cdpr.InputError, match=said):
        cdpr.tour(scene, **options)  # type: ignore[arg-type]
