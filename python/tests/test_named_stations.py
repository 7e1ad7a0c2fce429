"""Stations: named positions of the platform, wherever a start or a goal is asked for."""

from pathlib import Path

import numpy as np
import pytest

import cdpr

YAWED = [np.sqrt(0.5), 0.0, 0.0, np.sqrt(0.5)]
STATIONS = {"dock": [0.3, 1.0, 0.3], "rack": [1.7, 1.0, 1.7], "low": [1.7, 1.0, 0.3]}


@pytest.fixture
def scene() -> cdpr.Scene:
    return cdpr.example("hard1").replace(stations=STATIONS, start="dock", goal="rack")


def same(path: cdpr.Result, other: cdpr.Result) -> None:
    np.testing.assert_array_equal(path.waypoints, other.waypoints)
    assert (path.status, path.cost) == (other.status, other.cost)


def test_names_stand_for_positions(scene: cdpr.Scene) -> None:
    bare = cdpr.example("hard1")
    assert {name: station.position.tolist() for name, station in scene.stations.items()} == STATIONS
    same(cdpr.plan(scene), cdpr.plan(bare))
    by_name = cdpr.plan(bare.replace(stations=STATIONS), start="rack", goal="low")
    same(by_name, cdpr.plan(bare, start=STATIONS["rack"], goal=STATIONS["low"]))
    assert cdpr.lower_bound(scene, goal="low") == cdpr.lower_bound(bare, goal=STATIONS["low"])
    assert scene.to_dict()["query"]["goal"] == "rack"
    assert cdpr.Scene.from_dict(scene.to_dict()) == scene
    assert scene.replace(stations=scene.stations) == scene
    with pytest.raises(cdpr.InputError, match="query.start: found"):
        scene.replace(stations=None)
    assert not cdpr.check(scene, cdpr.plan(scene)).violations


def test_many_paths_between_stations(scene: cdpr.Scene) -> None:
    starts, goals = ["dock", "rack", "low"], ["rack", "low", "dock"]
    by_name = cdpr.plan_many(scene, starts, goals, "two-trees", threads=2)
    by_place = cdpr.plan_many(scene, [STATIONS[s] for s in starts], [STATIONS[g] for g in goals], "two-trees")
    for path, other, start, goal in zip(by_name, by_place, starts, goals):
        same(path, other)
        same(path, cdpr.plan(scene, "two-trees", start=start, goal=goal))
    mixed = cdpr.plan_many(scene, "dock", ["low", [1.7, 1.0, 1.7]], "two-trees")
    assert [path.waypoints[-1].tolist() for path in mixed] == [STATIONS["low"], STATIONS["rack"]]
    with pytest.raises(cdpr.InputError, match=r'paths\[1\]\.goal: found "lo", .* did you mean "low"\?'):
        cdpr.plan_many(scene, "dock", ["rack", "lo"])
    with pytest.raises(cdpr.InputError, match=r"goals\[1\]: found an array of shape \(2,\)"):
        cdpr.plan_many(scene, "dock", ["rack", [1.0, 2.0]])


def test_a_station_may_have_an_orientation() -> None:
    turned = {name: {"position": place, "orientation": YAWED} for name, place in STATIONS.items()}
    scene = cdpr.example("hard1").replace(stations=turned, goal="low", start="dock")
    assert scene.orientation.tolist() == pytest.approx(YAWED)
    assert scene.stations["low"].orientation is not None
    path = cdpr.plan(scene)
    assert path.solved and path.orientations is None and path.orientation.tolist() == pytest.approx(YAWED)
    bare = cdpr.example("hard1")
    given = cdpr.plan(bare, orientation=YAWED, start=STATIONS["dock"], goal=STATIONS["low"])
    np.testing.assert_array_equal(path.waypoints, given.waypoints)
    # The same by names in the call, alone and among many.
    level = bare.replace(stations=turned)
    assert level.orientation.tolist() == [1, 0, 0, 0]
    [one] = cdpr.plan_many(level, "dock", ["low"])
    np.testing.assert_array_equal(cdpr.plan(level, start="dock", goal="low").waypoints, one.waypoints)
    np.testing.assert_array_equal(one.waypoints, path.waypoints)
    # From a station with an orientation to a position without one, the platform turns.
    turning = cdpr.plan(level, start="dock", goal=[0.3, 1.0, 0.6], seed=1)
    assert turning.orientations is not None
    np.testing.assert_allclose(turning.orientations[0], YAWED)
    np.testing.assert_allclose(turning.orientations[-1], [1, 0, 0, 0])


def test_certificates_of_paths_between_stations(scene: cdpr.Scene, tmp_path: Path) -> None:
    proof = tmp_path / "bound.json"
    bound = cdpr.lower_bound(scene, goal="low", certificate=proof)
    assert bound > 3.0
    assert cdpr.check_proof(scene, proof, goal="low")
    assert cdpr.check_proof(scene.replace(goal="low"), proof)
    with pytest.raises(cdpr.FileError, match="goal"):
        cdpr.check_proof(scene, proof)


def test_scene_files_keep_stations(scene: cdpr.Scene, tmp_path: Path) -> None:
    for name in ("hall.toml", "hall.json"):
        scene.save(tmp_path / name)
        assert cdpr.Scene.load(tmp_path / name) == scene


@pytest.mark.parametrize(
    ("stations", "problem"),
    [
        ({"rack": [1, 2]}, r"stations\['rack'\]: found an array of shape \(2,\)"),
        ({"rack": {"position": [1, 2, 3], "at": 1}}, "unknown field `at`"),
        ({"": [1, 2, 3]}, r"stations\[0\].name"),
        ({"rack": {"position": [1, 2, 3], "orientation": "side"}}, r'stations\[0\].orientation: found "side"'),
        ([1, 2, 3], "stations: found"),
        ({"rack": {}}, "position"),
    ],
)
def test_bad_stations_are_named(stations: object, problem: str) -> None:
    with pytest.raises(cdpr.InputError, match=problem):
        cdpr.example("hard1").replace(stations=stations)
