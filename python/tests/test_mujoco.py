"""Models for MuJoCo: the simulator finds the lengths, speeds, forces and resting poses that cdpr says."""

from __future__ import annotations

import json
import re
import subprocess
import sys
import warnings
import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest
from conftest import ROOT, program
from elastic import lengths_at
from scipy.spatial.transform import Rotation
from test_winch import UP, stretching, turn_of

import cdpr

mujoco = pytest.importorskip("mujoco")

pytestmark = pytest.mark.filterwarnings("ignore::cdpr.CdprWarning")

ROBOTS = ["cogiro", "caroca", "ipanema2"]


def exported(folder, scene, motion=None, **options):
    """The model of a scene, its state, and the arrays of the motion."""
    cdpr.save_mjcf(folder / "model.xml", scene, motion, **options)
    model = mujoco.MjModel.from_xml_path(str(folder / "model.xml"))
    rows = None if motion is None else dict(np.load(folder / "model.npz"))
    return model, mujoco.MjData(model), rows


def bare(name, **options):
    return stretching(name, **options).replace(obstacles=None, touch=None, ignore=None, wrench=None)


def at_rest_near(scene, random, turn):
    """A pose near the middle of a scene that the cables can hold, turned by at most an angle (rad) from its orientation."""
    while True:
        share = random.uniform(0, 1)
        position = share * scene.start + (1 - share) * scene.goal + random.uniform(-0.3, 0.3, 3)
        turned = (Rotation.from_rotvec(turn * random.uniform(-1, 1, 3)) * turn_of(scene.orientation)).as_quat()
        orientation = np.roll(turned, 1)
        report = cdpr.wrench_at(scene.replace(orientation=orientation), position)
        if report.feasible and report.capacity_margin > 0.1 * 9.81 * scene.robot.mass:
            return position, orientation


def motions(scene, random, count):
    """Motions between random poses: straight on with odd numbers, turning with even ones."""
    found = []
    while len(found) < count:
        turning = len(found) % 2 == 0
        ends = [at_rest_near(scene, random, 0.15 if turning else 0.0) for _ in range(2)]
        positions, turns = (np.array(rows) for rows in zip(*ends, strict=True))
        limits = {"speed": 1.0, "acceleration": 2.0, "turn_speed": 0.5, "turn_acceleration": 1.0}
        try:
            found.append(cdpr.trajectory(scene, positions, turns if turning else None, rate=20, **limits))
        except cdpr.InputError:
            continue  # the cables cannot hold the platform on the way
    return found


@pytest.mark.parametrize("name", ROBOTS)
def test_inverse_dynamics_lengths_and_speeds_are_those_of_the_motion(name, tmp_path):
    random = np.random.default_rng(5)
    scene = bare(name)
    load = [7.0, -5.0, 11.0, 2.0, 1.0, -3.0]
    checked = turning = 0
    for number, motion in enumerate(motions(scene, random, 18)):
        if number == 17:
            scene = scene.replace(wrench={"load": load})
            motion = cdpr.trajectory(scene, motion.waypoints, speed=1, acceleration=2, rate=20)
        model, data, rows = exported(tmp_path, scene, motion)
        weight = 9.81 * scene.robot.mass
        turning += motion.turns
        assert (rows["lengths"] == motion.cable_lengths).all() and (rows["ctrl"][:, :8] == motion.tensions).all()
        for k in range(0, len(motion.times), 3):
            data.qpos, data.qvel, data.qacc, data.ctrl = (rows[key][k] for key in ("qpos", "qvel", "qacc", "ctrl"))
            mujoco.mj_inverse(model, data)
            needed = data.qfrc_inverse[:6].copy()
            assert np.abs(data.ten_length - rows["tendon_leads"] - motion.cable_lengths[k]).max() < 1e-9
            assert np.abs(data.ten_velocity - motion.cable_speeds[k]).max() < 1e-9
            mujoco.mj_fwdActuation(model, data)
            assert np.abs(data.actuator_force[:8] - motion.tensions[k]).max() < 1e-12
            assert np.abs(needed - data.qfrc_actuator[:6]).max() < 1e-6 * weight
            assert np.abs(data.qfrc_actuator[6:]).max(initial=0) < 1e-9 * weight  # the cables do not turn the wheels
            checked += 1
    assert checked > 100 and turning >= 8


def settled(model, data, position, orientation, controls, seconds=2.0):
    """Where the platform comes to rest under these controls, from a pose beside the given one: distance (m) and angle (rad) from it."""
    mujoco.mj_resetData(model, data)
    data.qpos[:3] = position + np.array([0.004, -0.003, -0.005])
    data.qpos[3:7] = orientation
    data.ctrl = controls
    mujoco.mj_step(model, data, nstep=int(seconds / model.opt.timestep))
    assert np.abs(data.qvel).max() < 1e-3
    angle = (Rotation.from_quat(np.roll(data.qpos[3:7], -1)) * turn_of(orientation).inv()).magnitude()
    return np.linalg.norm(data.qpos[:3] - position), angle


@pytest.mark.parametrize("name", ROBOTS)
def test_elastic_cables_hold_the_platform_where_commands_say(name, tmp_path):
    scene = bare(name)
    model, data, _ = exported(tmp_path, scene, control="length")
    # Friction of the air, so that it comes to rest: it changes nothing at rest.
    model.dof_damping[:6] = 40 * np.append([scene.robot.mass] * 3, model.body("platform").inertia)
    path = [scene.start, scene.goal]
    along = cdpr.tensions_along(scene, path, step=np.linalg.norm(scene.goal - scene.start) / 99)
    leads = np.array([drum["lead"] for drum in scene.robot.drums])
    for k, position in enumerate(along.positions):
        # The wheels begin at the angles of the start, and the cables turn them.
        away, turned = settled(model, data, position, scene.orientation, 1 / (leads + along.commands[k]))
        assert away < 1e-6 and np.degrees(turned) < 1e-4
        if k % 20 == 0:
            report = cdpr.wrench_at(scene, position)
            away, turned = settled(model, data, position, scene.orientation, 1 / (leads + report.lengths))
            assert away == pytest.approx(report.settling.displacement, rel=1e-3) and away > 1e-3
            assert np.degrees(turned) == pytest.approx(np.degrees(report.settling.rotation), rel=1e-3, abs=1e-4)


def test_wheels_of_any_axis_have_the_lengths_of_their_cables(tmp_path):
    """Also in a motion that is a table of positions and tensions alone."""
    random = np.random.default_rng(11)
    plain = cdpr.example("cogiro").replace(obstacles=None, touch=None, ignore=None, wrench=None)
    for _ in range(5):
        axes = random.normal(size=(8, 3)) + np.where(plain.robot.outlets[:, 2:] > 2, [[0, 0, 2.0]], [[0, 0, -2.0]])
        robot = plain.robot.replace(pulleys=[{"radius": random.uniform(0.02, 0.2), "axis": list(axis)} for axis in axes])
        times = np.arange(40) / 10
        positions = random.uniform(-1, 1, 3) + [0, 0, 2] + random.uniform(-2, 2, (2, 3))[np.newaxis, 0] * np.sin(times)[:, None]
        assert np.isfinite(lengths := robot.cable_lengths(positions)).all()
        scene = plain.replace(robot=robot)
        header = ["t", "x", "y", "z", *(f"tension:cable {k}" for k in range(8))]
        rows = np.column_stack([times, positions, np.full((40, 8), 100.0)])
        np.savetxt(tmp_path / "motion.csv", rows, delimiter=",", header=",".join(header), comments="", fmt="%.17g")
        motion = cdpr.load_trajectory(tmp_path / "motion.csv", scene)
        model, data, rows = exported(tmp_path, scene, motion)
        for k in range(40):
            data.qpos, data.qvel = rows["qpos"][k], rows["qvel"][k]
            mujoco.mj_forward(model, data)
            assert np.abs(data.ten_length - rows["tendon_leads"] - lengths[k]).max() < 1e-9
            assert np.abs(data.ten_velocity - rows["speeds"][k]).max() < 1e-9
        # Rates of the wheels, against differences.
        slopes = np.gradient(rows["qpos"][:, 7:], times, axis=0)
        assert np.abs(slopes - rows["qvel"][:, 6:])[1:-1].max() < 0.05 * np.abs(slopes).max()
        assert model.nq == 15


def test_a_motion_is_followed_with_feed_forward_and_springs(tmp_path):
    scene = bare("cogiro")
    motion = cdpr.trajectory(scene, [scene.start, scene.goal], speed=2, acceleration=4, rate=1000)
    model, data, rows = exported(tmp_path, scene, motion)
    mujoco.mj_resetDataKeyframe(model, data, model.key("start").id)
    assert (data.qpos == rows["qpos"][0]).all() and (data.ctrl == rows["ctrl"][0]).all()
    away = []
    for k in range(len(rows["t"])):
        mujoco.mj_step1(model, data)
        error = data.ten_length - rows["tendon_leads"] - rows["lengths"][k]
        data.ctrl = rows["ctrl"][k] + 1e4 * error + 1e3 * (data.ten_velocity - rows["speeds"][k])
        mujoco.mj_step2(model, data)
        away.append(np.linalg.norm(data.qpos[:3] - rows["positions"][min(k + 1, len(rows["t"]) - 1)]))
    assert max(away) < 1e-3
    assert np.abs(data.qpos[7:] - rows["qpos"][-1, 7:]).max() < 0.01  # the wheels turned by themselves


def test_elastic_cables_follow_a_motion_that_is_commanded(tmp_path):
    scene = bare("caroca")
    motion = cdpr.trajectory(scene, [scene.start, scene.goal], speed=1, acceleration=1, jerk=4, rate=1000)
    model, data, rows = exported(tmp_path, scene, motion, control="length")
    leads = np.array([drum["lead"] for drum in scene.robot.drums])
    assert np.abs(rows["ctrl"] - 1 / (leads + motion.commands)).max() < 1e-12
    mujoco.mj_resetDataKeyframe(model, data, 0)
    away = []
    for k in range(len(rows["t"])):
        data.ctrl = rows["ctrl"][k]
        mujoco.mj_step(model, data)
        away.append(np.linalg.norm(data.qpos[:3] - rows["positions"][min(k + 1, len(rows["t"]) - 1)]))
    assert max(away) < 1e-3


def noted(scene, path, *rest, **options):
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        cdpr.save_mjcf(path, scene, *rest, **options)
    return "; ".join(str(each.message) for each in caught)


def test_names_are_those_of_the_scene_whatever_they_contain(tmp_path):
    scene = cdpr.example("cogiro")
    names = ["a & b", "<c>", '"d"', "e'", "load", "load (2)", "é ☃ --", "world"]
    box = np.array([[x, y, z] for x in (0, 0.1) for y in (0, 0.1) for z in (0, 0.1)])
    parts = {"wheel a & b": [box, box + 0.05], 'wheel "d"': box, "<&>": box + 3, "wheel a & b part 2": box}
    robot = scene.robot.replace(cable_names=names, pulleys=UP)
    scene = scene.replace(robot=robot, obstacles=parts, touch=None, ignore=[["platform", "<&>"]], wrench={"load": [1, 2, 3, 0, 0, 0]})
    model, data, _ = exported(tmp_path, scene)
    assert [model.tendon(k).name for k in range(model.ntendon)] == names
    assert [model.actuator(k).name for k in range(8)] == names and model.actuator(8).name == "load (3)"
    for name in parts:
        assert model.geom(name).bodyid == 0
        assert bool(model.geom(name).contype) == (name != "<&>")
    assert ElementTree.parse(tmp_path / "model.xml").getroot().get("model") == "cogiro"
    mujoco.mj_forward(model, data)
    assert np.allclose(data.qfrc_actuator[:3], [1, 2, 3])


def test_bodies_are_those_of_the_scene(tmp_path):
    for name in ("cogiro", "forest", "caroca"):
        scene = cdpr.example(name)
        scene = scene if scene.robot.mass else scene.replace(robot=scene.robot.replace(mass=10.0))
        model, data, _ = exported(tmp_path, scene)
        mujoco.mj_forward(model, data)
        platform = model.body("platform")
        assert platform.mass == scene.robot.mass and np.abs(platform.ipos - scene.robot.center_of_mass).max() < 1e-12
        # Distances from MuJoCo's collision detection, with meshes in single precision.
        random, found = np.random.default_rng(3), 0
        parts = [k for k in range(model.ngeom) if model.geom(k).bodyid == platform.id]
        for position in random.uniform(*scene.workspace, (30, 3)):
            data.qpos[:3], data.qpos[3:7] = position, scene.orientation
            mujoco.mj_kinematics(model, data)
            of = [k for k in range(model.ngeom) if model.geom(k).bodyid == 0 and model.geom(k).contype]
            gap = min(mujoco.mj_geomDistance(model, data, a, b, 100.0, None) for a in parts for b in of)
            expected = platform_gap(scene, position)
            if gap > 1e-3:
                found += 1
                assert gap == pytest.approx(expected, abs=1e-4)
        assert found > 5


def platform_gap(scene, position):
    def corners(tables):
        return [np.array(table["vertices"]) if "vertices" in table else boxes(table) for table in tables]

    turn = turn_of(scene.orientation)
    platform = [turn.apply(part) + position for part in corners(scene.robot._spec["platform"])]
    obstacles = corners(scene._spec["obstacles"])
    return min(float(cdpr.distance(a, b)) for a in platform for b in obstacles)


def boxes(table):
    half = 0.5 * np.array(table["box"])
    rotation = Rotation.identity()
    if "quaternion" in table:
        rotation = turn_of(table["quaternion"])
    elif "rpy" in table or "rpy_degrees" in table:
        rotation = Rotation.from_euler("xyz", table.get("rpy") or np.radians(table["rpy_degrees"]))
    signs = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    return rotation.apply(signs * half) + table.get("position", 0)


def test_what_is_left_out_or_assumed_is_said(tmp_path):
    scene = cdpr.example("cogiro")
    said = noted(scene, tmp_path / "model.xml")
    assert said == "the robot gives no inertia: that of its parts at uniform density is assumed"
    inertia = np.diag([10.0, 11.0, 12.0])
    scene = scene.replace(robot=scene.robot.replace(inertia=inertia))
    assert noted(scene, tmp_path / "model.xml") == ""
    keys = {"linear_densities": 0.06, "outlet_errors": 0.001, "stiffnesses": 7e5, "drums": {"radius": 0.1, "lead": 1.0}, "pulleys": UP}
    whole = scene.replace(robot=scene.robot.replace(**keys), wrench={"payload": 5.0, "loads": [[0] * 6, [1] * 6]}, obstacles=None)
    whole = whole.replace(touch=None, ignore=None)
    said = noted(whole, tmp_path / "model.xml")
    for words in ("linear_density", "outlet_error", "stiffness", "drum", "no payload", "of 2 loads, the first", "wheels of pulleys swivel"):
        assert words in said, words
    said = noted(whole, tmp_path / "model.xml", control="length")
    assert "`stiffness`" not in said and "only the `lead`" in said
    # A cable that arrives nearly in the direction in which it leaves.
    towards = scene.start + scene.robot.attachments[2] - scene.robot.outlets[2] + [0, 0.2, 0]
    wheels = [UP, None, {"radius": 0.02, "axis": list(towards)}, *[None] * 5]
    said = noted(scene.replace(robot=scene.robot.replace(pulleys=wheels)), tmp_path / "model.xml")
    assert "cable 2: wraps its wheel so little" in said and "cable 0" not in said


def test_thin_bodies_can_be_simulated(tmp_path):
    corners = {"point": [[0, 0, 0]], "rod": [[0, 0, -0.1], [0, 0, 0.1]], "plate": [[-0.1, -0.1, 0], [0.1, -0.1, 0], [0, 0.1, 0]]}
    outlets = np.array([[x, y, 3.0] for x in (0, 4) for y in (0, 4)])
    for name, part in corners.items():
        robot = cdpr.Robot(outlets, np.zeros((4, 3)), [part], tensions=[1, 1000], mass=5.0)
        scene = cdpr.Scene(robot, workspace=[[0, 0, 0], [4, 4, 3]], start=[2, 2, 1])
        said = noted(scene, tmp_path / f"{name}.xml")
        assert "flat parts of the platform are 0.1 mm thick" in said and ("a point has no inertia" in said) == (name == "point")
        model = mujoco.MjModel.from_xml_path(str(tmp_path / f"{name}.xml"))
        data = mujoco.MjData(model)
        data.ctrl = cdpr.wrench_at(scene, [2, 2, 1]).tensions
        mujoco.mj_step(model, data, nstep=100)
        assert np.abs(data.qpos[:3] - [2, 2, 1]).max() < 1e-6


def test_what_cannot_be_exported_is_refused(tmp_path):
    path = tmp_path / "model.xml"
    light = cdpr.example("hard1")
    light = light.replace(robot=light.robot.replace(mass=None), wrench=None)
    with pytest.raises(cdpr.InputError, match="robot.mass: found none, expected the mass of the platform"):
        cdpr.save_mjcf(path, light)
    motion = cdpr.trajectory(light, [light.start, light.start + [0, 0, 0.1]], speed=1, acceleration=1)
    with pytest.raises(cdpr.InputError, match="tension: found none in the motion"):
        cdpr.save_mjcf(path, cdpr.example("hard1"), motion)
    scene = cdpr.example("cogiro")
    with pytest.raises(cdpr.InputError, match='control: found "length", but cable 0 has no `stiffness`'):
        cdpr.save_mjcf(path, scene, control="length")
    with pytest.raises(cdpr.InputError, match="strict: found without a motion"):
        cdpr.save_mjcf(path, scene, strict=True)
    with pytest.raises(cdpr.InputError, match='control: found "force", expected one of tension, length'):
        cdpr.save_mjcf(path, scene, control="force")
    with pytest.raises(cdpr.FileError, match=r"found the extension .mjcf, expected .xml"):
        cdpr.save_mjcf(tmp_path / "model.mjcf", scene)
    (tmp_path / "model.npz").mkdir()
    moving = cdpr.trajectory(scene.replace(obstacles=None), [scene.start, scene.goal], speed=1, acceleration=2)
    with pytest.raises(cdpr.FileError, match="model.npz"):
        cdpr.save_mjcf(path, scene.replace(obstacles=None), moving)
    assert not path.exists()


def test_the_command_writes_the_same_files(tmp_path):
    scene = stretching("cogiro").replace(obstacles=None, wrench=None)
    motion = cdpr.trajectory(scene, [scene.start, scene.goal], speed=1, acceleration=2)
    scene.save(tmp_path / "hall.toml")
    motion.save(tmp_path / "motion.json")
    motion.save(tmp_path / "motion.csv")

    def run(*line, status=0, **options):
        done = subprocess.run([program(), "export", *line], cwd=tmp_path, capture_output=True, text=True, **options)
        assert done.returncode == status, done.stderr
        return done

    for control in ("tension", "length"):
        cdpr.save_mjcf(tmp_path / "python.xml", scene, motion, control=control)
        for file in ("motion.json", "motion.csv"):
            run("hall.toml", file, "-o", "command.xml", "--control", control)
            for kind in ("xml", "npz"):
                assert (tmp_path / f"command.{kind}").read_bytes() == (tmp_path / f"python.{kind}").read_bytes()
    # Streams, JSON and quiet.
    hall, again = (tmp_path / "hall.toml").read_text(), run("hall.toml", "-o", "alone.xml")
    assert "wrote alone.xml" in again.stderr and not (tmp_path / "alone.npz").exists()
    alone = (tmp_path / "alone.xml").read_text()
    done = run("-", "-o", "-", "--format", "json", input=hall)
    assert done.stdout == alone.replace('model="hall"', 'model="scene"') and '"wheels": 2' in done.stderr
    found = json.loads(run("hall.toml", "motion.csv", "-o", "model.xml", "--format", "json").stdout)
    assert (found["model"], found["motion"], found["control"], found["cables"]) == ("model.xml", "model.npz", "tension", 8)
    assert found["samples"] == len(motion.times) and "stiffness" in " ".join(found["notes"])
    done = run("hall.toml", "-", "-o", "model.xml", "--quiet", input=(tmp_path / "motion.json").read_text())
    assert not done.stderr and "8 cables round 2 wheels" in done.stdout
    for line, words in [
        (["hall.toml", "motion.json", "-o", "-"], "--output: found no file, expected one named .xml"),
        (["hall.toml", "-o", "model"], "found the extension (none), expected .xml"),
        (["hall.toml", "-o", "hall.toml"], "is an input of this command"),
        (["hall.toml", "-o", "motion.npz"], "found the extension .npz, expected .xml"),
        (["hall.toml", "motion.json", "-o", "motion.npz"], "is the name of two outputs"),
        (["-", "-", "-o", "model.xml"], "found - for both scene and path"),
        (["hall.toml", "-o", "model.xml", "--strict"], "--strict: found without a motion"),
        (["hall.toml", "hall.toml", "-o", "model.xml"], "hall.toml"),
        (["hall.toml", "path.csv", "-o", "model.xml"], "path.csv: found a path without times, expected a trajectory"),
        (["light.toml", "-o", "light.xml"], "light.toml: robot.mass: found none"),
        (["stiff.toml", "-o", "model.xml", "--control", "length"], '--control: found "length", but cable 0 has no `stiffness`'),
    ]:
        np.savetxt(tmp_path / "path.csv", [scene.start, scene.goal], delimiter=",", header="x,y,z", comments="")
        scene.replace(robot=scene.robot.replace(mass=None)).save(tmp_path / "light.toml")
        scene.replace(robot=scene.robot.replace(stiffnesses=None)).save(tmp_path / "stiff.toml")
        assert words in (told := run(*line, status=2).stderr), told
    other = scene.replace(robot=scene.robot.replace(mass=90.0))
    other.save(tmp_path / "other.toml")
    assert "warning: " in run("other.toml", "motion.json", "-o", "model.xml").stderr
    assert "motion.json" in run("other.toml", "motion.json", "-o", "model.xml", "--strict", status=2).stderr


def test_the_example_simulates_both_kinds_of_models(tmp_path):
    scene = bare("caroca")
    motion = cdpr.trajectory(scene, [scene.start, 0.5 * (scene.start + scene.goal)], speed=1, acceleration=1, jerk=4, rate=1000)
    cdpr.save_mjcf(tmp_path / "tension.xml", scene, motion)
    cdpr.save_mjcf(tmp_path / "length.xml", scene, motion, control="length")
    for line in (["tension.xml"], ["tension.xml", "--gains", "20000", "2000", "--push", "100", "0", "0"], ["length.xml"]):
        asked = [sys.executable, ROOT / "python/examples/simulate.py", *line, "-o", f"{line[0]}.png"]
        done = subprocess.run(asked, cwd=tmp_path, capture_output=True, text=True, check=True)
        away, turned = map(float, re.match(r"away at most ([\d.]+) mm, turned at most ([\d.]+)°", done.stdout).groups())
        assert away < (10 if "--push" in line else 1) and turned < 0.1, done.stdout
        assert (away > 1) == ("--push" in line)
        assert (tmp_path / f"{line[0]}.png").read_bytes().startswith(b"\x89PNG")
