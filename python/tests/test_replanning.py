"""Obstacles that move, and paths that are kept as far as they are still valid."""

import time

import numpy as np
import pytest

import cdpr

PATH = [[0.3, 1, 0.3], [0.3, 1, 1.7], [1.7, 1, 1.7]]


@pytest.fixture(scope="module")
def scene() -> cdpr.Scene:
    return cdpr.example("hard3")


def test_a_moved_obstacle_is_that_of_a_scene_with_another_position(scene: cdpr.Scene) -> None:
    moved = scene.moved("west", [0.55, 1.05, 0.4])
    spec = scene.to_dict()
    (west,) = (body for body in spec["obstacles"] if body["name"] == "west")
    west["position"] = [0.55, 1.05, 0.4]
    assert moved == cdpr.Scene.from_dict(spec)
    assert scene == cdpr.example("hard3")


def test_what_is_compiled_of_a_scene_serves_the_moved_one(scene: cdpr.Scene) -> None:
    scene.states_valid([[0.3, 1, 0.3]])
    moved, chained = scene.moved("west", [0.55, 1.05, 0.4]), scene.moved("west", [0.9, 1, 0.4]).moved("west", [0.55, 1.05, 0.4])
    fresh = cdpr.Scene.from_dict(moved.to_dict())
    positions = np.random.default_rng(0).uniform(0.2, 1.8, (2000, 3))
    expected = fresh.states_valid(positions)
    assert 100 < expected.sum() < 1900
    for again in (moved, chained):
        np.testing.assert_array_equal(again.states_valid(positions), expected)
        np.testing.assert_array_equal(again.clearance(positions[:50]), fresh.clearance(positions[:50]))


@pytest.mark.parametrize(
    ("name", "position", "message"),
    [
        ("wets", [1, 1, 1], "moved: found no obstacle 'wets', expected one of .*; did you mean 'west'"),
        ("west", [1, 1], "position: "),
        ("west", [1, 1, float("nan")], r"position\[2\]: found nan"),
        ("west", "rack", "position: "),
        ("west", [0, 0, 2], "inside obstacle \"west\""),
        (3, [1, 1, 1], "name: "),
    ],
)
def test_moves_that_cannot_be(scene: cdpr.Scene, name: str, position: object, message: str) -> None:
    with pytest.raises(cdpr.InputError, match=message):
        scene.moved(name, position)


@pytest.mark.parametrize("planner", ["two-trees", "anytime", "modified-rrt"])
def test_paths_are_kept_or_repaired(scene: cdpr.Scene, planner: str) -> None:
    path, found = cdpr.plan(scene), set()
    rng = np.random.default_rng(1)
    places = {name: np.array(scene.to_dict()["obstacles"][k]["position"]) for k, name in enumerate(scene.obstacles)}
    for _ in range(20):
        name = rng.choice(list(places))
        moved = scene.moved(name, places[name] + [*rng.uniform(-0.05, 0.05, 2), 0])
        again = cdpr.replan(moved, path, planner=planner, seed=1)
        if not again.solved:
            assert not cdpr.plan(moved).solved
            continue
        assert cdpr.check(moved, again).valid
        np.testing.assert_array_equal(again.waypoints[[0, -1]], path.waypoints[[0, -1]])
        assert (again.found_by == "kept") == cdpr.check(moved, path.waypoints).valid
        if again.found_by != "kept" and planner != "modified-rrt":  # which rewinds: not taut
            assert again.cost < 1.03 * cdpr.plan(moved).cost
        found.add(again.found_by)
    assert {"kept", "repaired"} <= found


def test_a_result_is_written_and_read(scene: cdpr.Scene, tmp_path) -> None:
    moved = scene.moved("west", [0.6, 1.0, 0.4])
    again = cdpr.replan(moved, cdpr.plan(scene))
    again.save(tmp_path / "path.json")
    np.testing.assert_array_equal(cdpr.load_path(tmp_path / "path.json", moved).waypoints, again.waypoints)
    assert f'"found_by": "{again.found_by}"' in (tmp_path / "path.json").read_text()


def test_paths_from_elsewhere_turning_and_bad_ones(scene: cdpr.Scene) -> None:
    hard1 = cdpr.example("hard1")
    kept = cdpr.replan(hard1, cdpr.plan(hard1).waypoints.tolist(), post="none")
    assert (kept.found_by, round(kept.cost, 3)) == ("kept", 2.435)
    assert cdpr.replan(hard1, PATH).solved
    inside = cdpr.replan(hard1, [[1, 1, 0.5], [1.7, 1, 1.7]])
    assert inside.status == "start_invalid" and inside.reason is not None
    yawed = [0.9961946980917455, 0.0, 0.0, 0.08715574274765817]
    turning = cdpr.plan(hard1, goal_orientation=yawed, goal=[0.3, 1.0, 0.8], seed=1)
    again = cdpr.replan(hard1, turning)
    assert again.found_by == "kept" and again.orientations is not None
    with pytest.raises(cdpr.InputError, match="waypoints: found 1 waypoints, expected at least two"):
        cdpr.replan(hard1, PATH[:1])
    with pytest.raises(TypeError, match=r"replan\(\) got an unexpected keyword argument 'start'"):
        cdpr.replan(hard1, PATH, start=[1, 1, 1])
    assert cdpr.replan(hard1, PATH, budget=1e-9).status == "budget_spent"


def test_a_moved_scene_keeps_its_warnings_to_itself(recwarn: pytest.WarningsRecorder, scene: cdpr.Scene) -> None:
    cdpr.replan(scene.moved("west", [0.6, 1.0, 0.4]), cdpr.plan(scene))
    assert not [str(warning.message) for warning in recwarn]


@pytest.mark.long
def test_a_crowded_hall_is_replanned_soon() -> None:
    forest = cdpr.example("forest")
    path = cdpr.plan(forest)
    rng, first = np.random.default_rng(2), forest
    for body in rng.choice(list(forest.obstacles), 30, replace=False):
        (place,) = (b["position"] for b in forest.to_dict()["obstacles"] if b.get("name") == body)
        first = first.moved(body, np.array(place) + [*rng.uniform(-0.05, 0.05, 2), 0])
    began = time.perf_counter()
    again = cdpr.replan(first, path)
    assert again.solved and cdpr.check(first, again).valid and time.perf_counter() - began < 5
