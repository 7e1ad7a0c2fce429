"""What winches are commanded, against a platform on elastic cables that is computed independently (`elastic`)."""

import json
import subprocess

import numpy as np
import pytest
from conftest import program
from elastic import lengths_at, settled
from scipy.spatial.transform import Rotation

import cdpr

DRUM = {"radius": 0.1, "gear": 20.0, "zero": 5.0, "lead": 3.0}
UP = {"radius": 0.05, "axis": [0.0, 0.0, 1.0]}


def stretching(name, *, pulleys=True):
    """An example whose cables stretch, with drums, and with pulleys at every other outlet that is above."""
    scene = cdpr.example(name)
    outlets = scene.robot.outlets
    wheels = [UP if pulleys and k % 2 and outlet[2] >= outlets[:, 2].mean() - 1e-9 else None for k, outlet in enumerate(outlets)]
    return scene.replace(robot=scene.robot.replace(stiffnesses=7e5, drums=DRUM, pulleys=wheels))


def turn_of(quaternion):
    return Rotation.from_quat(np.roll(quaternion, -1))


@pytest.fixture(scope="module", params=["cogiro", "caroca", "ipanema2"])
def moving(request):
    scene = stretching(request.param)
    bare = scene.replace(obstacles=None, touch=None, ignore=None, wrench=None)
    path = np.array([bare.start, 0.5 * (bare.start + bare.goal), bare.goal])
    return bare, cdpr.trajectory(bare, path, speed=1.0, acceleration=2.0)


def test_a_platform_commanded_with_the_stretch_rests_where_it_is_planned(moving):
    scene, motion = moving
    robot, turn = scene.robot, turn_of(motion.orientation)
    along = cdpr.tensions_along(scene, [scene.start, scene.goal], step=0.3)
    for position, commands in zip(along.positions, along.commands, strict=True):
        away, turned = settled(robot, position, commands, turn=turn)
        assert np.linalg.norm(away) < 1e-6 and np.degrees(np.linalg.norm(turned)) < 1e-4
    # In motion, the inertia of the platform pulls as a force at its centre of mass.
    for k in range(0, len(motion.times), 40):
        force = -robot.mass * motion.accelerations[k]
        away, turned = settled(robot, motion.positions[k], motion.commands[k], turn=turn, force=force)
        assert np.linalg.norm(away) < 1e-6 and np.degrees(np.linalg.norm(turned)) < 1e-4
        lengths = lengths_at(robot, motion.positions[k], turn)
        assert np.abs(lengths - motion.cable_lengths[k]).max() < 1e-9
        away, _ = settled(robot, motion.positions[k], lengths, turn=turn, force=force)
        assert np.linalg.norm(away) > 1e-3  # the stretch matters


def test_settling_is_that_of_an_independent_computation(moving):
    scene, motion = moving
    for position in (scene.start, 0.3 * scene.start + 0.7 * scene.goal, scene.goal):
        turn = turn_of(motion.orientation)
        away, turned = settled(scene.robot, position, lengths_at(scene.robot, position, turn), turn=turn)
        found = cdpr.wrench_at(scene, position).settling
        assert found.displacement == pytest.approx(np.linalg.norm(away), rel=1e-6)
        assert found.rotation == pytest.approx(np.linalg.norm(turned), rel=1e-5, abs=1e-9)


def test_columns_are_those_worked_by_hand_and_the_same_everywhere(tmp_path):
    scene = stretching("cogiro").replace(obstacles=None, wrench=None)
    path = [scene.start, scene.goal]
    along, motion = cdpr.tensions_along(scene, path, step=0.5), cdpr.trajectory(scene, path, speed=1, acceleration=2)
    for rows, lengths in ((along, along.lengths), (motion, motion.cable_lengths)):
        commands = (3.0 + lengths) / (1 + rows.tensions / 7e5) - 3.0
        assert np.abs(rows.commands - commands).max() < 1e-12
        assert np.abs(rows.angles - 20.0 * (commands - 5.0) / 0.1).max() < 1e-8
        assert np.abs(rows.torques - rows.tensions * 0.1 / 20.0).max() < 1e-12
    state = motion.at(motion.times)
    for name in ("commands", "angles", "torques"):
        assert np.allclose(getattr(state, name), getattr(motion, name), rtol=1e-9, atol=1e-9)
    assert motion.at([]).commands.shape == (0, 8)
    tables = along.to_pandas(), motion.to_pandas()
    for name, columns in (("command", "commands"), ("angle", "angles"), ("torque", "torques")):
        for table, rows in zip(tables, (along, motion), strict=True):
            assert (table[f"{name}:cable 3"] == getattr(rows, columns)[:, 3]).all()
    for file in ("motion.json", "motion.csv"):
        motion.save(tmp_path / file)
        again = cdpr.load_trajectory(tmp_path / file, scene)
        assert (again.commands == motion.commands).all() and (again.angles == motion.angles).all()
        assert (again.cable_accelerations == motion.cable_accelerations).all() and (again.torques == motion.torques).all()
    header = (tmp_path / "motion.csv").read_text().split("\n", 1)[0].split(",")
    assert header == list(tables[1])
    scene.save(tmp_path / "scene.toml")
    np.savetxt(tmp_path / "path.csv", path, delimiter=",", header="x,y,z", comments="")
    asked = [program(), "wrench", "scene.toml", "--along", "path.csv", "--step", "0.5"]
    csv = subprocess.run(asked, cwd=tmp_path, check=True, capture_output=True, text=True).stdout
    assert csv.split("\n", 1)[0].split(",") == list(tables[0])
    rows = json.loads(subprocess.run([*asked, "--format", "json"], cwd=tmp_path, check=True, capture_output=True).stdout)["rows"]
    assert np.allclose([row["angles"] for row in rows], along.angles, rtol=1e-12)


def test_columns_are_absent_without_what_they_need():
    scene = cdpr.example("cogiro").replace(obstacles=None, wrench=None)
    path = [scene.start, scene.goal]

    def known(**keys):
        changed = scene.replace(robot=scene.robot.replace(**keys))
        motion, along = cdpr.trajectory(changed, path, speed=1, acceleration=2), cdpr.tensions_along(changed, path, step=1.0)
        found = [[getattr(rows, name) is not None for name in ("commands", "angles", "torques")] for rows in (motion, along)]
        assert found[0] == found[1]
        return found[0]

    assert known() == [False, False, False]
    assert known(stiffnesses=7e5) == [True, False, False]
    assert known(drums=DRUM) == [False, True, True]
    with pytest.warns(cdpr.CdprWarning, match="cable 0 has a `drum` and cable 7 has none"):
        assert known(drums=[DRUM] * 7 + [None], stiffnesses=7e5) == [True, False, False]
    report = cdpr.wrench_at(scene, scene.start)
    assert report.settling is None


def test_a_turning_motion_has_its_commands():
    scene = cdpr.example("cogiro").replace(obstacles=None, wrench=None)
    scene = scene.replace(robot=scene.robot.replace(stiffnesses=7e5, drums=DRUM))
    turned = [np.cos(0.1), 0.0, 0.0, np.sin(0.1)]
    motion = cdpr.trajectory(scene, [scene.start, scene.start], [[1.0, 0, 0, 0], turned], turn_speed=0.2, turn_acceleration=0.4)
    assert motion.turns
    away, angle = settled(scene.robot, motion.positions[-1], motion.commands[-1], turn=turn_of(motion.orientations[-1]))
    assert np.linalg.norm(away) < 1e-6 and np.degrees(np.linalg.norm(angle)) < 1e-4


def test_check_finds_commands_that_do_not_fit(tmp_path):
    scene = stretching("cogiro").replace(obstacles=None, wrench=None)
    motion = cdpr.trajectory(scene, [scene.start, scene.goal], speed=1, acceleration=2)
    motion.save(tmp_path / "motion.csv")
    scene.save(tmp_path / "scene.toml")

    def checked(file, scene="scene.toml"):
        done = subprocess.run([program(), "check", scene, file], cwd=tmp_path, capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr

    assert checked("motion.csv")[0] == 0
    table = motion.to_pandas()
    for column, by, words in [
        ("command:cable 2", 1e-4, "cable 2: commanded length"),
        ("angle:cable 5", 0.01, "cable 5: angle of the motor"),
        ("torque:cable 0", 0.1, "cable 0: torque of the motor"),
    ]:
        wrong = table.copy()
        wrong.loc[7, column] += by
        wrong.to_csv(tmp_path / "wrong.csv", index=False)
        status, said = checked("wrong.csv")
        assert status == 1 and words in said and "expected" in said, said
    bare = scene.replace(robot=scene.robot.replace(drums=None, stiffnesses=None))
    bare.save(tmp_path / "bare.toml")
    status, said = checked("motion.csv", "bare.toml")
    assert status == 0 and said.count("is not checked: that takes") == 3, said
