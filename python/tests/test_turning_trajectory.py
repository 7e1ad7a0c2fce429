"""Timed motions of a platform that turns."""

from __future__ import annotations

import copy
import pickle
from pathlib import Path

import numpy as np
import pytest

import cdpr

LIMITS = {"speed": 1.0, "acceleration": 2.0, "turn_speed": 1.5, "turn_acceleration": 4.0}
CORNER = [0.6, 1.6, 1.2]
SIXTY = [[1.0, 0.0, 0.0, 0.0], [np.cos(np.pi / 6), 0.0, 0.0, np.sin(np.pi / 6)]]


@pytest.fixture(scope="module")
def scene() -> cdpr.Scene:
    return cdpr.Scene.load("testdata/scenes/turn.toml")


@pytest.fixture(scope="module")
def spin(scene: cdpr.Scene) -> cdpr.Trajectory:
    return cdpr.trajectory(scene, [CORNER, [0.8, 1.6, 1.2]], SIXTY, **LIMITS)


def test_samples_and_states_have_orientations_and_angular_rates(spin: cdpr.Trajectory) -> None:
    count = len(spin.times)
    assert spin.turns and spin.orientations.shape == (count, 4)
    assert spin.angular_velocities.shape == spin.angular_accelerations.shape == (count, 3)
    assert np.allclose(np.linalg.norm(spin.orientations, axis=1), 1)
    assert np.allclose(spin.orientations[[0, -1]], SIXTY) and np.allclose(spin.waypoint_orientations, SIXTY)
    assert np.linalg.norm(spin.angular_velocities, axis=1).max() <= 1.5 * (1 + 1e-9)
    # Half the angle of a rotation about z.
    half = np.arctan2(spin.orientations[:, 3], spin.orientations[:, 0])
    assert np.allclose(np.gradient(2 * half, spin.times)[2:-2], spin.angular_velocities[2:-2, 2], atol=0.03)
    state = spin.at([0.1, 0.2])
    assert state.orientation.shape == (2, 4) and state.angular_velocity.shape == (2, 3)
    again = spin.at(float(spin.times[7]))
    assert np.allclose(again.orientation, spin.orientations[7]) and np.allclose(again.cable_lengths, spin.cable_lengths[7])


def test_cable_speeds_are_those_of_turned_attachments(scene: cdpr.Scene, spin: cdpr.Trajectory) -> None:
    h = 1e-6
    for time in (0.2, 0.5, 0.8):
        before, now, after = (spin.at(time + step) for step in (-h, 0.0, h))
        assert np.allclose((after.cable_lengths - before.cable_lengths) / (2 * h), now.cable_speeds, atol=1e-6)


def test_a_planned_turning_path_is_timed(scene: cdpr.Scene) -> None:
    motion = cdpr.trajectory(scene, cdpr.plan(scene), **LIMITS | {"turn_acceleration": 1.0})
    assert any(corner.turn and corner.kind == "stop" for corner in motion.corners)
    assert {"acceleration", "turn_acceleration"} <= {entry.limit for entry in motion.limiting}


def test_ends_of_turns_are_passed_on_bends(scene: cdpr.Scene, tmp_path: Path) -> None:
    path = cdpr.plan(scene)
    stopping, motion = (cdpr.trajectory(scene, path, **LIMITS, blend=blend) for blend in (0, 0.02))
    passed = [corner for corner in motion.corners if corner.turn and corner.kind == "rounded"]
    stops = [sum(corner.kind == "stop" for corner in one.corners) for one in (stopping, motion)]
    assert len(passed) >= 2 and all(0 < corner.deviation <= 0.02 for corner in passed)
    assert 2 * stops[1] < stops[0] == len(stopping.corners) == 3
    assert motion.duration < 0.9 * stopping.duration
    for corner in passed:
        assert np.linalg.norm(motion.at(corner.time).angular_velocity) > 0 or np.linalg.norm(motion.at(corner.time).velocity) > 0
    motion.save(tmp_path / "motion.json")
    assert cdpr.load_trajectory(tmp_path / "motion.json", scene) == motion


@pytest.mark.parametrize("name", ["motion.json", "motion.csv"])
def test_files_keep_the_turn(scene: cdpr.Scene, spin: cdpr.Trajectory, tmp_path: Path, name: str) -> None:
    spin.save(tmp_path / name)
    again = cdpr.load_trajectory(tmp_path / name, scene)
    assert np.array_equal(again.orientations, spin.orientations)
    assert np.array_equal(again.angular_velocities, spin.angular_velocities)
    if name.endswith("json"):
        assert again == spin and again.at(0.3) == spin.at(0.3)
        assert pickle.loads(pickle.dumps(spin)) == spin == copy.deepcopy(spin)
    page = tmp_path / "motion.html"
    cdpr.save_view(page, scene, again)
    assert '"turn_speed":' in page.read_text()


def test_a_table_has_the_columns_of_the_file(spin: cdpr.Trajectory, tmp_path: Path) -> None:
    pytest.importorskip("pandas")
    spin.save(tmp_path / "motion.csv")
    header = (tmp_path / "motion.csv").read_text().partition("\n")[0].strip()
    assert list(spin.to_pandas()) == header.split(",")


def test_a_motion_without_a_turn_has_one_orientation(scene: cdpr.Scene) -> None:
    motion = cdpr.trajectory(scene, [CORNER, [0.8, 1.6, 1.2]], **LIMITS)
    assert not motion.turns and motion.waypoint_orientations is None
    assert np.array_equal(motion.orientations, np.tile(motion.orientation, (len(motion.times), 1)))
    assert not motion.angular_velocities.any() and not motion.at(0.1).angular_velocity.any()


def test_what_is_wrong_is_said(scene: cdpr.Scene) -> None:
    path = [CORNER, [0.8, 1.6, 1.2]]
    with pytest.raises(cdpr.InputError, match="expected a turn_acceleration"):
        cdpr.trajectory(scene, path, SIXTY, speed=1, acceleration=2)
    with pytest.raises(cdpr.InputError, match="turn_speed: found 0"):
        cdpr.trajectory(scene, path, SIXTY, **{**LIMITS, "turn_speed": 0})
    with pytest.raises(cdpr.InputError, match="orientations"):
        cdpr.trajectory(scene, path, [*SIXTY, SIXTY[1]], **LIMITS)
    with pytest.raises(cdpr.InputError, match="length 1"):
        cdpr.trajectory(scene, path, [[2, 0, 0, 0], SIXTY[1]], **LIMITS)


def test_inertia_of_a_robot_matters_for_a_turn(scene: cdpr.Scene) -> None:
    cogiro = cdpr.Scene.load("testdata/scenes/cogiro.toml")
    path = [[-2.0, 0.0, 2.5], [-2.0, 0.0, 2.5]]
    turn = [[1, 0, 0, 0], [np.cos(0.05), 0, 0, np.sin(0.05)]]
    assumed = cdpr.trajectory(cogiro, path, turn)
    assert assumed.tensions is not None and "uniform density" in assumed.note
    heavy = cogiro.replace(robot=cogiro.robot.replace(inertia=[900, 900, 900]))
    slow = cdpr.trajectory(heavy, path, turn)
    assert "uniform density" not in slow.note and slow.duration > assumed.duration
    assert np.array_equal(heavy.robot.inertia, np.diag([900, 900, 900])) and cogiro.robot.inertia is None
    with pytest.raises(cdpr.InputError, match="sum of the other two"):
        cogiro.robot.replace(inertia=[1, 1, 3])
    with pytest.raises(cdpr.InputError, match="shape"):
        cogiro.robot.replace(inertia=[1, 1])


def test_the_figure_shows_the_angular_speed(spin: cdpr.Trajectory) -> None:
    pytest.importorskip("matplotlib")
    import cdpr.figures

    titles = [chart.get_title("left") for chart in cdpr.figures.trajectory(spin)]
    assert titles == ["speed (m/s)", "acceleration (m/s²)", "angular speed (rad/s)", "cable speeds (m/s)", "limited by"]


def test_quaternions_of_a_path_change_least_from_one_to_the_next(tmp_path) -> None:
    scene = cdpr.Scene.load("testdata/scenes/turn.toml")
    # A quarter turn, given by quaternions of alternating signs.
    yaws = np.linspace(0.0, 0.5 * np.pi, 7)
    turns = np.array([[np.cos(yaw / 2) * (-1) ** k, 0, 0, np.sin(yaw / 2) * (-1) ** k] for k, yaw in enumerate(yaws)])
    place = np.tile([0.6, 1.6, 1.2], (len(yaws), 1))
    motion = cdpr.trajectory(scene, place, turns, turn_speed=1, turn_acceleration=2)
    for quaternions in (motion.orientations, motion.waypoint_orientations):
        assert (np.sum(quaternions[1:] * quaternions[:-1], axis=1) >= 0).all()


def test_the_cost_of_a_csv_path_includes_its_turns(tmp_path) -> None:
    scene = cdpr.Scene.load("testdata/scenes/turn.toml")
    path = cdpr.plan(scene)
    path.save(tmp_path / "path.csv")
    path.save(tmp_path / "path.json")
    found = [cdpr.load_path(tmp_path / name, scene).cost for name in ("path.csv", "path.json")]
    assert found == pytest.approx([path.cost, path.cost], abs=1e-12)
    assert cdpr.check(scene, cdpr.load_path(tmp_path / "path.csv", scene)).length == pytest.approx(path.cost, abs=1e-12)
