"""Motions on which the platform turns, against results by hand."""

import dataclasses
import json
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import TESTDATA
from test_planning import AT_ONCE, interrupted_after

import cdpr

HALF = 0.1  # half the side of the platform
PLACE = [0.0, 0.0, 1.0]
LEVEL = [1.0, 0.0, 0.0, 0.0]
FLAT = {"max_tilt": 1.0, "weight": 0.1}


def yaw(angle: Any) -> Any:
    """Quaternions of turns about the vertical, rad."""
    half = np.asarray(angle) / 2
    return np.stack([np.cos(half), 0 * half, 0 * half, np.sin(half)], axis=-1)


def reach(angle: Any) -> Any:
    """How far a square platform that is turned by 0 to 90° extends along x."""
    return HALF * (np.cos(angle) + np.sin(angle))


def touching(wall: float) -> float:
    """The angle up to 45° at which a corner of the platform touches a wall at x = `wall`."""
    return float(np.arcsin(wall / (HALF * np.sqrt(2))) - np.pi / 4)


def hall(wall: float | None = None, **options: Any) -> cdpr.Scene:
    """A square platform on four cables that meet above its centre, so that yaw does not move them."""
    outlets = [[x, y, 3.0] for x in (-2.0, 2.0) for y in (-2.0, 2.0)]
    box = [[x, y, z] for x in (-HALF, HALF) for y in (-HALF, HALF) for z in (-0.05, 0.05)]
    robot = cdpr.Robot(outlets, np.tile([0.0, 0.0, 0.05], (4, 1)), box)
    corners = [] if wall is None else [[x, y, z] for x in (wall, wall + 0.1) for y in (-1.0, 1.0) for z in (0.0, 1.0)]
    obstacles = {"wall": corners} if corners else None
    return cdpr.Scene(robot, obstacles, workspace=[[-2, -2, 0], [2, 2, 3]], **options)


@pytest.fixture
def beside() -> cdpr.Scene:
    return hall(wall=0.12)


def random_poses(count: int, seed: int) -> tuple[Any, Any]:
    rng = np.random.default_rng(seed)
    turns = rng.normal(size=(count, 4)) * [0.2, 0.1, 0.1, 0.1] + [1.0, 0.0, 0.0, 0.0]
    return rng.uniform(0.15, 1.85, (count, 3)), turns / np.linalg.norm(turns, axis=1, keepdims=True)


def test_a_platform_turns_beside_a_wall_until_a_corner_touches_it(beside: cdpr.Scene) -> None:
    angle = touching(0.12)
    assert reach(angle) == pytest.approx(0.12)
    turns = yaw(np.array([0.5 * angle, angle - 2e-4, angle + 1e-6, 2 * angle, -angle + 2e-4, -angle - 1e-6]))
    expected = [True, True, False, False, True, False]
    assert beside.motions_valid(PLACE, PLACE, LEVEL, turns).tolist() == expected
    assert beside.motions_valid(PLACE, PLACE, turns, LEVEL).tolist() == expected
    assert beside.states_valid(PLACE, turns).tolist() == expected
    violation = beside.explain_motion(PLACE, PLACE, None, yaw(2 * angle))
    assert violation is not None and (violation.kind, violation.culprits) == ("platform-obstacle", ("platform", "wall"))
    assert violation.at == pytest.approx(0.5, abs=2e-3)
    assert violation.gap == pytest.approx(0.12 - reach(2 * angle), abs=1e-6)


def test_corners_that_pass_a_wall_between_two_free_poses_are_found(beside: cdpr.Scene) -> None:
    assert beside.states_valid(PLACE, yaw(np.array([0.0, np.pi / 2, np.pi]))).all()
    assert not beside.motions_valid(PLACE, PLACE, LEVEL, yaw(np.pi / 2))
    away = [-0.1, 0.0, 1.0]  # the largest reach is 0.141 m
    assert beside.motions_valid(away, away, LEVEL, yaw(np.pi / 2))
    # While it moves away, it may turn.
    assert beside.motions_valid(PLACE, away, LEVEL, yaw(np.pi / 6))


def test_half_turns_are_the_same_both_ways() -> None:
    free, narrow = hall(wall=0.1415), hall(wall=0.1414)
    for turn in (yaw(np.pi), -yaw(np.pi), yaw(-np.pi)):
        assert free.motions_valid(PLACE, PLACE, LEVEL, turn) and free.motions_valid(PLACE, PLACE, turn, LEVEL)
        assert not narrow.motions_valid(PLACE, PLACE, LEVEL, turn)
        assert not narrow.motions_valid(PLACE, PLACE, turn, LEVEL)
    upside_down = [0.0, 1.0, 0.0, 0.0]  # the cables would pass through the platform
    found = free.explain_motion(PLACE, PLACE, LEVEL, upside_down)
    assert found is not None and found.kind == "cable-platform"


def test_both_signs_of_a_quaternion_are_the_same_rotation(hard1: cdpr.Scene) -> None:
    (starts, before), (ends, after) = random_poses(200, 1), random_poses(200, 2)
    ends = starts + 0.1 * (ends - 1.0)
    answers = hard1.motions_valid(starts, ends, before, after)
    assert 10 < answers.sum() < 190
    for one, two in ((-before, after), (before, -after), (-before, -after)):
        assert (hard1.motions_valid(starts, ends, one, two) == answers).all()
    assert (hard1.motions_valid(ends, starts, after, before) == answers).all()
    # To the opposite sign there is nothing to turn.
    assert (hard1.motions_valid(starts, starts, before, -before) == hard1.states_valid(starts, before)).all()


def test_the_orientation_of_the_scene_gives_the_answers_without_orientations(hard1: cdpr.Scene) -> None:
    rng = np.random.default_rng(3)
    starts, ends = rng.uniform(0.0, 2.0, (2, 3000, 3))
    own = hard1.orientation
    assert (hard1.motions_valid(starts, ends, own, own) == hard1.motions_valid(starts, ends)).all()
    assert (hard1.motions_valid(starts, ends, end_orientations=-own) == hard1.motions_valid(starts, ends)).all()
    assert (hard1.states_valid(starts, own) == hard1.states_valid(starts)).all()
    assert np.allclose(hard1.clearance(starts[:200], own), hard1.clearance(starts[:200]), rtol=0, atol=1e-12)
    for start, end in zip(starts[:20], ends[:20], strict=True):
        assert hard1.violations(start, end, own, own) == hard1.violations(start, end)
        assert hard1.explain_motion(start, end, own) == hard1.explain_motion(start, end)
    path = np.array([[0.3, 1.0, 0.3], [0.3, 1.0, 1.7], [1.7, 1.0, 1.7]])
    with_own, without = cdpr.check(hard1, path, own), cdpr.check(hard1, path)
    assert with_own.valid and with_own.length == pytest.approx(without.length, abs=1e-12)
    assert with_own.min_clearance is not None and without.min_clearance is not None
    assert with_own.min_clearance["value"] == pytest.approx(without.min_clearance["value"], abs=1e-6)


def test_a_turned_scene_gives_the_same_answers_as_the_orientations(hard1: cdpr.Scene) -> None:
    starts, turns = random_poses(30, 4)
    for position, turn in zip(starts, turns, strict=True):
        there = hard1.replace(orientation=turn)
        assert bool(hard1.states_valid(position, turn)) == bool(there.states_valid(position))
        assert hard1.clearance(position, turn) == pytest.approx(float(there.clearance(position)), abs=1e-9)


def test_clearance_at_an_orientation(beside: cdpr.Scene) -> None:
    angles = np.radians([0.0, 5.0, 10.0, 45.0])
    found = beside.clearance(PLACE, yaw(angles))
    assert found[:3] == pytest.approx(0.12 - reach(angles[:3]), abs=1e-9)
    assert found[3] == pytest.approx(0.12 - reach(angles[3]), abs=1e-9)  # overlaps
    assert beside.clearance([PLACE, PLACE], yaw(angles[1])).shape == (2,)


def test_all_arguments_broadcast(beside: cdpr.Scene) -> None:
    turns = yaw(np.radians([[0.0, 5.0, 40.0]]))
    assert beside.states_valid(PLACE, turns).shape == (1, 3)
    places = np.tile(PLACE, (2, 1, 1))
    assert beside.states_valid(places, turns).tolist() == [[True, True, False]] * 2
    assert beside.motions_valid(places, PLACE, LEVEL, turns).tolist() == [[True, True, False]] * 2
    assert beside.motions_valid(PLACE, PLACE, LEVEL, LEVEL).shape == ()
    assert beside.states_valid(np.empty((0, 3)), LEVEL).shape == (0,)
    assert beside.motions_valid(PLACE, PLACE, np.empty((0, 4))).shape == (0,)


@pytest.mark.parametrize("threads", [1, 2, 5, None])
def test_answers_do_not_depend_on_threads(hard1: cdpr.Scene, threads: int | None) -> None:
    (starts, before), (_, after) = random_poses(300, 5), random_poses(300, 6)
    ask = partial(hard1.motions_valid, starts, starts[::-1], before, after)
    assert (ask(threads=threads) == ask(threads=1)).all()
    gaps = hard1.clearance(starts[:40], before[:40], threads=threads)
    assert (gaps == hard1.clearance(starts[:40], before[:40], threads=1)).all()


def test_ctrl_c_ends_checks_at_once(hard1: cdpr.Scene) -> None:
    starts, turns = random_poses(200_000, 7)
    hard1.states_valid(starts[:2], turns[:2])  # compiles the engine
    ask = partial(hard1.motions_valid, starts, starts[::-1], turns, turns[::-1], threads=1)
    assert min(interrupted_after(0.3, ask)[0] for _ in range(3)) < AT_ONCE


ZERO, LONG, NAN = [0.0] * 4, [1.0, 1.0, 0.0, 0.0], [float("nan"), 0.0, 0.0, 1.0]


@pytest.mark.parametrize(
    ("turns", "problem"),
    [
        (ZERO, r": found a quaternion of length 0\.0, expected length 1 within 1e-06 \(w x y z\)"),
        ([LEVEL, LONG], r"\[1\]: found a quaternion of length 1\.414\d*, expected length 1"),
        ([[LEVEL, LEVEL], [LEVEL, NAN]], r"\[1\]\[1\]: found a quaternion of length nan, expected length 1"),
        ([LEVEL, [1e200, 1e200, 0, 0]], r"\[1\]: found a quaternion of length inf"),
        ([1.0, 0.0, 0.0], r": found an array of shape \(3,\), expected \(\.\.\., 4\)"),
        (1.0, r": found an array of shape \(\), expected \(\.\.\., 4\)"),
        (np.tile(LEVEL, (3, 1)), r": found an array of shape \(3, 4\), expected \(2, 4\), one for each"),
        ("level", r": found the text 'level', expected a number"),
        ([True, False, False, False], r": found True, expected numbers"),
    ],
)
def test_bad_orientations_are_named(beside: cdpr.Scene, turns: Any, problem: str) -> None:
    places = np.tile(PLACE, (2, 1))
    for name, ask in [
        ("orientations", lambda: beside.states_valid(places, turns)),
        ("orientations", lambda: beside.clearance(places, turns)),
        ("start_orientations", lambda: beside.motions_valid(places, places, turns)),
        ("end_orientations", lambda: beside.motions_valid(places, places, LEVEL, turns)),
        ("orientations", lambda: cdpr.check(beside, places, turns)),
    ]:
        with pytest.raises(cdpr.InputError, match=f"^{name}{problem}"):
            ask()


def test_bad_orientations_of_single_motions_are_named(beside: cdpr.Scene) -> None:
    with pytest.raises(cdpr.InputError, match=r"^start_orientation: found a quaternion of length 0\.0"):
        beside.explain_motion(PLACE, PLACE, ZERO)
    with pytest.raises(cdpr.InputError, match=r"^end_orientation: found an array of shape \(1, 4\), expected \(4,\)"):
        beside.violations(PLACE, PLACE, LEVEL, [LEVEL])
    with pytest.raises(cdpr.InputError, match=r"^goal_orientation: found a quaternion of length 1\.4"):
        cdpr.plan(beside, start=PLACE, goal=PLACE, goal_orientation=LONG)
    with pytest.raises(cdpr.InputError, match=r'^start_orientation: found "up"'):
        cdpr.plan(beside, start=PLACE, goal=PLACE, start_orientation="up")
    with pytest.raises(cdpr.InputError, match=r'interference: found "swept".*expected "exact" if the platform turns'):
        beside.motions_valid(PLACE, PLACE, LEVEL, yaw(0.1), interference="swept")


def test_planning_turns_away_from_a_wall(beside: cdpr.Scene) -> None:
    scene = beside.replace(turning=FLAT, start=PLACE, goal=PLACE)
    result = cdpr.plan(scene, goal_orientation=yaw(np.pi / 2), seed=1, budget=5.0)
    assert result.solved and result.orientations is not None
    assert result.orientations.shape == (len(result.waypoints), 4) and len(result.waypoints) > 2
    ends = np.abs(result.orientations[[0, -1]] @ np.array([LEVEL, yaw(np.pi / 2)]).T)
    assert np.diag(ends) == pytest.approx([1.0, 1.0], abs=1e-12)
    report = cdpr.check(scene, result)
    assert report.valid and report.length == pytest.approx(result.cost, rel=1e-12)
    # At 45° it is at least 0.0214 m from where it starts.
    shortest = 0.1 * np.pi / 2 + 2 * (HALF * np.sqrt(2) - 0.12)
    assert result.cost >= shortest - 1e-9
    assert cdpr.lower_bound(scene.replace(goal_orientation=yaw(np.pi / 2))) == pytest.approx(0.1 * np.pi / 2)
    with pytest.raises(cdpr.InputError, match="^gap: .*may turn"):
        cdpr.lower_bound(scene, gap=0.01)


def test_orientations_by_name_and_by_scene_are_the_same(beside: cdpr.Scene) -> None:
    turns = {"level": LEVEL, "yawed": yaw(0.1)}
    scene = beside.replace(orientations=turns, orientation="level", start=PLACE, goal=[-0.5, 0.0, 1.0])
    named = cdpr.plan(scene, goal_orientation="yawed", seed=2, budget=1.0)
    given = cdpr.plan(scene.replace(goal_orientation="yawed"), seed=2, budget=1.0)
    assert named.orientations is not None and given.orientations is not None
    assert np.allclose(named.orientations[-1], yaw(0.1)) and np.allclose(given.orientations[-1], yaw(0.1))
    assert np.allclose(scene.replace(goal_orientation="yawed").goal_orientation, yaw(0.1))


def test_a_platform_that_keeps_its_orientation_has_no_orientations(hard1: cdpr.Scene) -> None:
    assert cdpr.plan(hard1).orientations is None
    own = cdpr.plan(hard1, start_orientation=LEVEL, goal_orientation=[-1.0, 0.0, 0.0, 0.0])
    assert own.orientations is None and own.cost == cdpr.plan(hard1).cost


def test_ctrl_c_ends_planning_with_the_best_path(beside: cdpr.Scene) -> None:
    scene = beside.replace(turning=FLAT, start=PLACE, goal=PLACE, goal_orientation=yaw(np.pi / 2))
    found: list[cdpr.Result] = []
    interrupted_after(0.5, lambda: found.append(cdpr.plan(scene, budget=30.0)), raises=None)
    assert cdpr.check(scene, found[0]).valid


def test_start_and_goal_that_are_not_valid_are_explained(beside: cdpr.Scene) -> None:
    scene = beside.replace(start=PLACE, goal=[-0.5, 0.0, 1.0])
    result = cdpr.plan(scene, start_orientation=yaw(np.pi / 4))
    assert result.status == "start_invalid" and result.orientations is None
    assert result.reason is not None and result.reason.kind == "platform-obstacle"


def test_tilt_is_limited() -> None:
    scene = hall(turning={"max_tilt": 10.0})
    roll = np.radians([9.9, 10.1])
    turns = np.stack([np.cos(roll / 2), np.sin(roll / 2), 0 * roll, 0 * roll], axis=-1)
    assert scene.states_valid(PLACE, turns).tolist() == [True, False]
    found = scene.explain_motion(PLACE, PLACE, LEVEL, turns[1])
    assert found is not None and (found.kind, found.culprits, found.margin) == ("tilt", ("platform",), None)
    assert dict(scene.turning or {}) == {"max_tilt": 10.0} and hall().turning is None


def turning_path() -> cdpr.Path:
    return cdpr.Path([PLACE, [-0.5, 0.0, 1.0]], 0.55, LEVEL, orientations=yaw(np.array([0.0, 0.5])))


def test_paths_keep_their_orientations_in_files(beside: cdpr.Scene, tmp_path: Path) -> None:
    scene = beside.replace(start=PLACE, goal=[-0.5, 0.0, 1.0], goal_orientation=yaw(0.4))
    result = cdpr.plan(scene, budget=1.0)
    for path in (result, turning_path()):
        path.save(tmp_path / "path.json")
        loaded = cdpr.load_path(tmp_path / "path.json", scene)
        assert loaded.orientations is not None and path.orientations is not None
        assert np.array_equal(loaded.orientations, path.orientations) and np.array_equal(loaded.waypoints, path.waypoints)
        assert loaded.cost == path.cost and cdpr.check(scene, loaded) == cdpr.check(scene, path)
        loaded.save(tmp_path / "again.json")
        assert json.loads((tmp_path / "again.json").read_text())["orientations"] == path.orientations.tolist()
        path.save(tmp_path / "path.csv")
        table = cdpr.load_path(tmp_path / "path.csv", scene)
        assert table.orientations is not None and np.array_equal(table.orientations, path.orientations)
        assert np.array_equal(table.waypoints, path.waypoints) and cdpr.check(scene, table).valid == cdpr.check(scene, path).valid
    changed = dataclasses.replace(result, orientations=-result.orientations)
    assert changed != result
    changed.save(tmp_path / "changed.json")
    assert np.array_equal(cdpr.load_path(tmp_path / "changed.json").orientations, -result.orientations)


def test_paths_that_touch_their_limits_are_valid_as_planned_and_as_read(tmp_path: Path) -> None:
    # Quaternions that are normalized anew differ in their last digits: shortened paths were then refused.
    scene = cdpr.Scene.load(TESTDATA / "scenes/cogiro.toml")
    for seed in range(6):
        result = cdpr.plan(scene, "rrt-connect", goal_orientation=yaw(np.radians(5.0)), seed=seed)
        assert result.solved and cdpr.check(scene, result).valid
        result.save(tmp_path / "path.json")
        assert cdpr.check(scene, cdpr.load_path(tmp_path / "path.json", scene)).valid


@pytest.mark.parametrize(
    ("turns", "problem"),
    [
        ([LEVEL], "orientations: found 1, expected one for each of the 2 waypoints"),
        ([LEVEL, LONG], r"orientations\[1\]: found a quaternion of length 1.41"),
    ],
)
def test_bad_orientations_in_files_are_named(tmp_path: Path, turns: Any, problem: str) -> None:
    file = tmp_path / "path.json"
    file.write_text(json.dumps({"waypoints": [PLACE, [-0.5, 0.0, 1.0]], "orientations": turns}))
    with pytest.raises(cdpr.InputError, match=f"path.json.*{problem}"):
        cdpr.load_path(file)


def test_checking_a_path_of_poses(beside: cdpr.Scene) -> None:
    angle = touching(0.12)
    positions = [PLACE, PLACE, [-0.5, 0.0, 1.0]]
    turns = yaw(np.array([0.0, 2 * angle, 2 * angle]))
    for report in (
        cdpr.check(beside, positions, turns),
        cdpr.check(beside, cdpr.Path(positions, 0.5, orientations=turns)),
        cdpr.check(beside, cdpr.Path(positions, 0.5), turns),
    ):
        assert not report.valid and report.violations[0].segment == 0
        assert report.violations[0].at == pytest.approx(0.5, abs=2e-3)
        weight = np.sqrt(2 * HALF**2 + 0.05**2)  # the distance of a corner
        assert report.length == pytest.approx(0.5 + weight * 2 * angle)
        assert report.min_clearance is not None
        assert report.min_clearance["value"] == pytest.approx(0.12 - reach(2 * angle), abs=1e-6)
    assert cdpr.check(beside, PLACE, yaw(0.9 * angle)).valid and not cdpr.check(beside, PLACE, yaw(1.1 * angle)).valid
    with pytest.raises(cdpr.InputError, match="^orientations: found some for a path that has its own, expected none"):
        cdpr.check(beside, turning_path(), turns[:2])
    with pytest.raises(cdpr.InputError, match=r"^orientations: found an array of shape \(3, 4\), expected \(2, 4\)"):
        cdpr.Path([PLACE, PLACE], 0.0, orientations=turns)


def test_tensions_along_a_path_with_turns_are_those_at_each_orientation() -> None:
    scene = cdpr.Scene.load(TESTDATA / "scenes/cogiro.toml")
    path = cdpr.Path([[0, 0, 2], [0.5, 0, 2]], 1.0, LEVEL, orientations=yaw(np.array([0.0, 0.2])))
    along = cdpr.tensions_along(scene, path, step=0.05)
    assert along.orientations is not None and along.orientations.shape == (len(along.s), 4)
    assert np.allclose(along.orientations[0], LEVEL) and np.allclose(along.positions[0], [0, 0, 2])
    assert along.s[-1] > 0.5 and list(along.to_pandas())[4:8] == ["qw", "qx", "qy", "qz"]
    for k in (0, len(along.s) // 2, -1):
        there = cdpr.wrench_at(scene.replace(orientation=along.orientations[k]), along.positions[k])
        assert np.allclose(along.lengths[k], there.lengths) and np.allclose(along.tensions[k], there.tensions, atol=1e-6)
        assert np.isclose(along.capacity_margin[k], there.capacity_margin)
    level = cdpr.tensions_along(scene, [[0, 0, 2], [0.5, 0, 2]])
    assert level.orientations is None


def test_what_cannot_turn_refuses_paths_that_do(beside: cdpr.Scene) -> None:
    path = turning_path()
    figures = pytest.importorskip("cdpr.figures")
    for call in (cdpr.rewind, figures.rewinding):
        with pytest.raises(cdpr.InputError, match=r"^waypoints.orientations: .*turns, expected one .*keeps.*cdpr\.refine"):
            call(beside, path)
    assert path.to_pandas()["qw"].tolist() == path.orientations[:, 0].tolist()


def test_refining_shortens_positions_and_orientations_together(beside: cdpr.Scene, tmp_path: Path) -> None:
    away, behind, half = [-0.1, 0.0, 1.0], [-0.5, 0.3, 1.0], yaw(np.pi / 2)
    positions, turns = [PLACE, behind, away, PLACE], [LEVEL, yaw(-0.3), half, half]
    weight = float(np.sqrt(2 * HALF**2 + 0.05**2))
    by_arrays = cdpr.refine(beside, positions, turns)
    by_path = cdpr.refine(beside, cdpr.Path(positions, 1.0, orientations=turns))
    for path in (by_arrays, by_path):
        assert path.orientations is not None and np.array_equal(path.waypoints, by_arrays.waypoints)
        assert np.array_equal(path.waypoints[[0, -1]], [PLACE, PLACE])
        assert np.abs(np.diag(path.orientations[[0, -1]] @ np.array([LEVEL, half]).T)) == pytest.approx([1.0, 1.0])
        report = cdpr.check(beside, path)
        assert report.valid and report.length == pytest.approx(path.cost)
        # It must leave the wall by 0.0214 m to turn, and come back.
        shortest = weight * np.pi / 2 + 2 * (HALF * np.sqrt(2) - 0.12)
        assert shortest < path.cost < 1.2 * shortest < 0.5 * cdpr.check(beside, positions, turns).length
    by_path.save(tmp_path / "path.json")
    assert np.array_equal(cdpr.load_path(tmp_path / "path.json", beside).orientations, by_path.orientations)
    with pytest.raises(cdpr.InputError, match=r"^waypoints\[0\]: the segment that starts here is not valid: .*wall"):
        cdpr.refine(beside, [PLACE, PLACE], [LEVEL, half])
    with pytest.raises(cdpr.InputError, match="^orientations: found some for a path that has its own"):
        cdpr.refine(beside, by_path, half)
    level = cdpr.refine(beside, [away, behind, [-0.9, 0.0, 1.0]])
    assert level.orientations is None and len(level.waypoints) == 2


def study(scene: cdpr.Scene | str, **method: Any) -> dict[str, Any]:
    methods = [{"name": "two trees", "planner": "two-trees"}, {"name": "raw", "planner": "rrt-connect", "post": "none", **method}]
    return {"version": 1, "seed": 3, "trials": 8, "scenarios": [{"name": "bar", "scene": scene}], "methods": methods}


def test_trials_of_an_experiment_are_the_plans_of_their_seeds() -> None:
    scene = cdpr.Scene.load(TESTDATA / "scenes/turn.toml")
    batch = cdpr.run_batch(study(scene), threads=1)
    assert batch.trials_csv == cdpr.run_batch(study(str(TESTDATA / "scenes/turn.toml")), threads=2).trials_csv
    trials = batch.trials
    assert list(trials["status"]) == ["solved"] * 16 and (trials["cost"] > 2**0.5).all()
    for method, options in (("two trees", {"planner": "two-trees"}), ("raw", {"planner": "rrt-connect", "post": "none"})):
        for _, row in trials[trials["method"] == method].iloc[:3].iterrows():
            again = cdpr.plan(scene, seed=int(row["seed"]), proof=False, **options)
            assert (again.cost, again.raw_cost, len(again.waypoints)) == (row["cost"], row["raw_cost"], row["waypoints"])
            assert cdpr.check(scene, again).valid and again.cost == pytest.approx(cdpr.check(scene, again).length)
        assert (trials[trials["method"] == method]["cost"] < trials[trials["method"] == method]["raw_cost"]).all() == (method != "raw")


def test_an_experiment_prefers_paths_without_turns_if_they_are_shorter(hard1: cdpr.Scene) -> None:
    may, never = (cdpr.run_batch(study(scene)) for scene in (hard1.replace(turning={}), hard1))
    assert list(may.trials["status"]) == ["solved"] * 16
    trees = [batch.trials[batch.trials["method"] == "two trees"]["cost"].to_numpy() for batch in (may, never)]
    assert (trees[0] <= trees[1] + 1e-12).all() and (trees[0] == trees[1]).any()


@pytest.mark.parametrize(
    ("method", "problem"),
    [
        ({"sweep": {"repeats": [1, 2]}}, r"methods\[1\]\.sweep: found a sweep of rewinding, expected none, since .*scenarios\[0\]"),
        ({"interference": "swept"}, r'methods\[1\]\.interference: found "swept", expected "exact", since .*may turn'),
    ],
)
def test_what_an_experiment_cannot_do_where_the_platform_turns_is_refused(method: dict[str, Any], problem: str) -> None:
    with pytest.raises(cdpr.InputError, match=problem):
        cdpr.run_batch(study(str(TESTDATA / "scenes/turn.toml"), **method))


def test_the_page_takes_positions_and_orientations_apart(tmp_path: Path) -> None:
    bar = cdpr.Scene.load(TESTDATA / "scenes/turn.toml")
    path = cdpr.plan(bar, "rrt-connect")
    assert path.orientations is not None
    files = [tmp_path / "path.html", tmp_path / "apart.html"]
    cdpr.save_view(files[0], bar, cdpr.Path(path.waypoints, path.cost, orientations=path.orientations))
    cdpr.save_view(files[1], bar, path.waypoints, orientations=path.orientations)
    texts = [file.read_text().split('id="cdpr-data">')[1].split("</script>")[0] for file in files]
    whole, apart = map(json.loads, texts)
    assert whole["path"]["orientations"] == apart["path"]["orientations"] == path.orientations.tolist()
    assert whole["motion"] == apart["motion"]
    motion = cdpr.trajectory(bar, path, speed=1, acceleration=1, turn_speed=1, turn_acceleration=1)
    for given, found in ((path, "a path"), (motion, "a Trajectory"), (None, "no path")):
        with pytest.raises(cdpr.InputError, match=f"orientations: found some for {found}"):
            cdpr.save_view(files[1], bar, given, orientations=path.orientations)


def test_the_page_shows_what_a_turn_breaks(beside: cdpr.Scene) -> None:
    angle = touching(0.12)
    path = cdpr.Path([PLACE, PLACE], 0.0, LEVEL, orientations=yaw(np.array([0.0, 2 * angle])))
    assert "platform-obstacle" in cdpr._view.view(beside, path).html


def test_ompl_plans_poses(beside: cdpr.Scene, tmp_path: Path) -> None:
    adapter = pytest.importorskip("cdpr.ompl")
    from ompl import geometric

    scene = beside.replace(turning={"weight": 0.1}, start=PLACE, goal=PLACE)
    setup = adapter.simple_setup(scene, goal_orientation=yaw(np.pi / 2))
    setup.setPlanner(geometric.RRTConnect(setup.getSpaceInformation()))
    assert adapter.solve(setup, 20.0)
    path = adapter.path(setup)
    assert path.orientations is not None and len(path.waypoints) > 2
    assert np.allclose(path.orientations[[0, -1]], [LEVEL, yaw(np.pi / 2)])
    report = cdpr.check(scene.replace(goal_orientation=yaw(np.pi / 2)), path)
    assert report.valid and report.length == path.cost
    path.save(tmp_path / "path.json")
    assert np.array_equal(cdpr.load_path(tmp_path / "path.json").orientations, path.orientations)


def test_ompl_checks_motions_with_a_turn(beside: cdpr.Scene) -> None:
    adapter = pytest.importorskip("cdpr.ompl")
    angle = touching(0.12)
    scene = beside.replace(turning={"weight": 0.1}, start=PLACE, goal=PLACE)
    information = adapter.simple_setup(scene).getSpaceInformation()
    space, motions = information.getStateSpace(), information.getMotionValidator()
    states = information.getStateValidityChecker()
    level, free, across = (space.state(PLACE, yaw(turn)) for turn in (0.0, 0.9 * angle, 2 * angle))
    assert states.isValid(free) and not states.isValid(across)
    assert states.clearance(free) == pytest.approx(0.12 - reach(0.9 * angle), abs=1e-9)
    assert space.distance(level, free) == pytest.approx(0.1 * 0.9 * angle)
    assert motions.checkMotion(level, free) and not motions.checkMotion(level, space.state(PLACE, yaw(np.pi / 2)))
    until = space.allocState()
    valid, fraction = motions.checkMotionWithLastValid(level, across, until)
    assert not valid and fraction == pytest.approx(0.5, abs=3e-3) and states.isValid(until)
    assert 2 * np.arctan2(until.rotation().z, until.rotation().w) == pytest.approx(fraction * 2 * angle)
    with pytest.raises(cdpr.InputError, match="^turning.axis: found one axis"):
        adapter.simple_setup(scene.replace(turning={"axis": [0, 0, 1]}))


def test_scene_files_with_turning_are_kept(tmp_path: Path) -> None:
    scene = cdpr.Scene.load(TESTDATA / "scenes/hard1.toml").replace(turning={"axis": [0, 0, 1]}, goal_orientation=yaw(0.3))
    scene.save(tmp_path / "scene.toml")
    loaded = cdpr.Scene.load(tmp_path / "scene.toml")
    assert loaded == scene and np.allclose(loaded.goal_orientation, yaw(0.3)) and loaded.turning == scene.turning
    assert loaded.replace(turning=None, goal_orientation=None) == cdpr.Scene.load(TESTDATA / "scenes/hard1.toml")
