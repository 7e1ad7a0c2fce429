"""Pulleys, weight and uncertain outlets together with everything else: turns, orientations, pipes, Ctrl-C, batches, `replace`."""

from __future__ import annotations

import contextlib
import json
import signal
import subprocess
import time

import numpy as np
import pytest
from conftest import program
from pulleys import leaves, rotation

import cdpr

pytestmark = pytest.mark.filterwarnings("ignore::cdpr.CdprWarning")

CUBE = [[x, y, z] for z in (0.0, 3.0) for x in (0.0, 4.0) for y in (0.0, 4.0)]
TURN = [float(np.cos(np.pi / 12)), 0.0, 0.0, float(np.sin(np.pi / 12))]
DENSITY, LEAST, ERROR, RADIUS, GRAVITY = 0.1, 60.0, 0.003, 0.1, 9.81
BEAM = {"box": [0.2, 0.2, 0.9], "position": [1.0, 1.0, 2.45]}


def spec(kind):
    """A platform that passes a beam, 27 mm above a straight cable: a translation, a turn by 30 degrees, or two orientations."""
    cables = [
        {
            "outlet": outlet,
            "attachment": [0.15 if x else -0.15 for x in outlet[:2]] + [0.1 if outlet[2] else -0.1],
            "tension": [LEAST, 2000.0],
            "pulley": {"radius": RADIUS, "axis": [0.0, 0.0, 1.0 if outlet[2] else -1.0]},
        }
        for outlet in CUBE
    ]
    common = {"linear_density": DENSITY, "outlet_error": ERROR, "stiffness": 1e5}
    query = {"start": [2.0, 1.3, 1.0], "goal": [2.0, 3.1, 1.0]}
    return {
        "version": 1,
        "robot": {"mass": 20.0, "platform": [{"box": [0.3, 0.3, 0.2]}], "cables": cables, "cable": common},
        "workspace": {"min": [0.6, 0.6, 0.4], "max": [3.4, 3.4, 2.6]},
        "obstacles": [{"name": "beam"} | BEAM],
        "query": query | ({"goal_orientation": TURN} if kind == "turn" else {}),
        **({"turning": {"axis": [0, 0, 1]}} if kind == "turn" else {}),
        **({"orientations": [{"name": "as is"}, {"name": "yawed", "rpy_degrees": [0, 0, 10]}]} if kind == "orientations" else {}),
    }


KINDS = ["translation", "turn", "orientations"]


@pytest.fixture(params=KINDS)
def file(request, tmp_path):
    path = tmp_path / "scene.json"
    path.write_text(json.dumps(spec(request.param)))
    return path


def run(folder, *arguments, text=None):
    command = [program(), *arguments]
    return subprocess.run(command, cwd=folder, input=text, capture_output=True, text=True, timeout=60, check=False)


def straight(scene):
    """The scene with weightless cables from fixed points."""
    return scene.replace(robot=scene.robot.replace(pulleys=None, cable=None))


def hits(scene, path, seed=0):
    """Deepest point of the real cables inside the beam along a path, m, for random tensions and outlets."""
    generator = np.random.default_rng(seed)
    robot, along = scene.robot, cdpr.tensions_along(scene, path, step=0.02)
    turns = along.orientations if along.orientations is not None else [[1.0, 0.0, 0.0, 0.0]] * len(along.positions)
    share = np.linspace(0.0, 1.0, 101)[:, None]
    deepest = -np.inf
    for position, turn in zip(along.positions, turns, strict=True):
        ends = position + robot.attachments @ rotation(np.broadcast_to(turn, 4)).T
        for outlet, end, nominal in zip(robot.outlets, ends, CUBE, strict=True):
            axis = [0.0, 0.0, 1.0 if nominal[2] else -1.0]
            off = generator.normal(size=3)
            start, _, possible = leaves(outlet + ERROR * off / np.linalg.norm(off), axis, RADIUS, end)
            assert possible
            chord = end - start
            across = np.hypot(*chord[:2])
            weight = DENSITY * GRAVITY
            middle = LEAST * generator.choice([1.0, 1.0, 5.0]) - weight * chord[2] / 2
            # The sag of a parabola: w a b / (2 T), a and b along the chord; the catenary hangs a little lower.
            sag = weight * share * (1 - share) * (across**2 + chord[2] ** 2) / (2 * middle)
            points = start + share * chord - sag * [0.0, 0.0, 1.0]
            inside = np.array(BEAM["box"]) / 2 - np.abs(points - BEAM["position"])
            deepest = max(deepest, inside.min(axis=1).max())
    return deepest


def test_no_shape_of_a_cable_meets_the_beam(file):
    scene = cdpr.Scene.load(file)
    found = cdpr.plan(scene, seed=1)
    assert found.solved and cdpr.check(scene, found).valid
    deepest = hits(scene, found)
    ideal = cdpr.plan(straight(scene), seed=1)
    assert deepest < 0.0
    # Without the keys the path is shorter, but real cables would meet the beam there.
    assert ideal.cost < found.cost and not cdpr.check(scene, ideal).valid
    assert hits(scene, ideal) > 0.02


def test_pipes_and_quiet_change_nothing(file):
    text, folder = file.read_text(), file.parent
    named = run(folder, "plan", "scene.json", "-o", "path.json", "--seed", "1")
    piped = run(folder, "plan", "-", "-o", "-", "--seed", "1", "-q", text=text)
    assert (named.returncode, piped.returncode) == (0, 0), named.stderr + piped.stderr
    assert "assumes that the controller keeps at least 60 N" in named.stderr and "note" not in piped.stderr
    stored = json.loads((folder / "path.json").read_text())
    assert json.loads(piped.stdout)["waypoints"] == stored["waypoints"]
    assert (cdpr.plan(cdpr.Scene.load(file), seed=1).waypoints == cdpr.load_path(folder / "path.json").waypoints).all()
    for arguments, given in [(("-", "path.json"), text), (("scene.json", "-"), piped.stdout)]:
        checked = run(folder, "check", *arguments, "--format", "json", text=given)
        assert checked.returncode == 0 and json.loads(checked.stdout)["valid"], checked.stderr


def test_ctrl_c_leaves_a_path_that_keeps_the_keys(file):
    command = [program(), "plan", "scene.json", "-o", "path.json", "--keep-going", "--max-samples", "100000000"]
    for seconds in (3.0, 12.0, 48.0):  # on a busy machine, the first path may take longer
        running = subprocess.Popen(command, cwd=file.parent, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        with contextlib.suppress(subprocess.TimeoutExpired):
            running.wait(seconds)
        running.send_signal(signal.SIGINT)
        _, err = running.communicate(timeout=30)
        assert running.returncode == 130, err
        if (file.parent / "path.json").exists():
            break
    assert run(file.parent, "check", "scene.json", "path.json").returncode == 0


def test_replacing_other_parts_keeps_the_keys(file):
    scene = cdpr.Scene.load(file)
    moved = scene.replace(goal=[2.0, 3.0, 0.9])
    assert moved.to_dict()["robot"] == scene.to_dict()["robot"]
    lighter = scene.robot.replace(mass=10.0)
    assert lighter.pulleys == scene.robot.pulleys and (lighter.linear_densities == DENSITY).all()
    assert scene.replace(robot=lighter).robot == lighter
    bare = straight(scene).robot
    assert bare.pulleys == (None,) * 8 and (bare.linear_densities == 0.0).all() and (bare.outlet_errors == 0.0).all()


def test_an_interrupted_batch_ends_as_a_whole_one(tmp_path):
    kinds = KINDS[:2]  # all methods plan at the same orientation
    for kind in kinds:
        (tmp_path / f"{kind}.json").write_text(json.dumps(spec(kind)))
    experiment = {
        "version": 1,
        "name": "cables",
        "seed": 3,
        "trials": 10,
        "scenarios": [{"name": kind, "scene": f"{kind}.json"} for kind in kinds],
        "methods": [{"name": "two-trees", "planner": "two-trees"}],
    }
    (tmp_path / "cables.json").write_text(json.dumps(experiment))
    assert run(tmp_path, "batch", "cables.json", "-o", "whole").returncode == 0
    running = subprocess.Popen([program(), "batch", "cables.json", "-o", "run"], cwd=tmp_path, stderr=subprocess.PIPE)
    while running.poll() is None and not any(file.stat().st_size for file in tmp_path.glob("run/rows/*")):
        time.sleep(0.01)
    running.send_signal(signal.SIGINT)
    running.communicate(timeout=30)
    assert running.returncode == 130
    resumed = run(tmp_path, "batch", "cables.json", "-o", "run", "--resume")
    assert resumed.returncode == 0, resumed.stderr
    assert (tmp_path / "run/trials.csv").read_text() == (tmp_path / "whole/trials.csv").read_text()
