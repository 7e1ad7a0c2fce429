"""Tasks: a walk along every leg with an intersection test of its own, against scenes written by hand, and what is refused.

The walk reads the files that ``cdpr task`` wrote, and uses NumPy only.
"""

import json
import signal
import subprocess
import time
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from conftest import TESTDATA, program

import cdpr

TOWER = TESTDATA / "tasks/tower.toml"
SAMPLES = 200  # of each straight piece
ALONG = np.linspace(0, 1, 400)[:, None]
ROUNDING = 1e-8


def box(body: dict[str, Any], at: np.ndarray) -> np.ndarray:
    """Smallest and largest coordinates of a box at a position of its frame."""
    middle, half = np.add(body.get("position", [0.0] * 3), at), np.array(body["box"]) / 2
    return np.array([middle - half, middle + half])


def box_gap(a: np.ndarray, b: np.ndarray) -> float:
    """Distance between two boxes; negative if they overlap."""
    apart = np.maximum(a[0] - b[1], b[0] - a[1])
    return float(np.linalg.norm(np.maximum(apart, 0))) if (apart > 0).any() else float(apart.max())


def point_gap(points: np.ndarray, other: np.ndarray) -> float:
    """Smallest distance of points from a box; negative inside it."""
    apart = np.maximum(other[0] - points, points - other[1])
    outside = np.linalg.norm(np.maximum(apart, 0), axis=1)
    return float(np.where((apart > 0).any(axis=1), outside, apart.max(axis=1)).min())


def segments_hit(starts: np.ndarray, ends: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Which of many segments enter the inside of a box."""
    lines = ends - starts
    with np.errstate(divide="ignore", invalid="ignore"):
        cuts = np.sort((other[:, None] - starts) / lines, axis=0)
    level = lines == 0
    first, last = np.where(level, 0.0, cuts[0]).max(axis=1), np.where(level, 1.0, cuts[1]).min(axis=1)
    beside = (level & ((starts <= other[0]) | (starts >= other[1]))).any(axis=1)
    return ~beside & (np.maximum(first, 0.0) + ROUNDING < np.minimum(last, 1.0))


class Cell:
    """A cell of boxes, cables and payloads, as its file says."""

    def __init__(self, spec: dict[str, Any]) -> None:
        robot = spec["robot"]
        self.clearance = spec["clearance"]
        self.floor = np.array([spec["workspace"]["min"], spec["workspace"]["max"]])
        self.platform = robot["platform"]
        self.outlets, self.attachments = (np.array([cable[key] for cable in robot["cables"]]) for key in ("outlet", "attachment"))
        self.obstacles = {body["name"]: box(body, np.zeros(3)) for body in spec["obstacles"]}
        self.payloads = {payload["name"]: payload["body"] for payload in spec["payloads"]}
        stations = {station["name"]: np.array(station["position"]) for station in spec["stations"]}
        self.stands: dict[str, np.ndarray | None] = {p["name"]: stations[p["at"]] for p in spec["payloads"]}

    def standing(self) -> dict[str, np.ndarray]:
        there = {name: box(self.payloads[name], at) for name, at in self.stands.items() if at is not None}
        return self.obstacles | there

    def problems(self, at: np.ndarray, touch: set[str]) -> set[tuple[str, str]]:
        """Pairs that overlap or come too close with the platform at a position; some obstacles may be touched."""
        found = set()
        carried = [self.payloads[name] for name, stands in self.stands.items() if stands is None]
        parts = [box(body, at) for body in [*self.platform, *carried]]
        if any((part[0] < self.floor[0] - ROUNDING).any() or (part[1] > self.floor[1] + ROUNDING).any() for part in parts):
            found.add(("platform", "workspace"))
        starts = at + self.attachments
        for name, other in self.standing().items():
            demanded = 0.0 if name in touch else self.clearance
            if min(box_gap(part, other) for part in parts) < demanded - ROUNDING:
                found.add(("platform", name))
            near = self.near(starts, other)
            samples = starts[near, None] + ALONG * (self.outlets - starts)[near, None]
            if segments_hit(starts, self.outlets, other).any() or (
                near.any() and point_gap(samples.reshape(-1, 3), other) < self.clearance - 1e-4
            ):
                found.add(("cable", name))
        if any(segments_hit(starts, self.outlets, part).any() for part in parts[len(self.platform) :]):
            found.add(("cable", "payload"))
        return found

    def near(self, starts: np.ndarray, other: np.ndarray) -> np.ndarray:
        """Which cables have a bounding box that is within the clearance of a box along every axis."""
        low, high = np.minimum(starts, self.outlets), np.maximum(starts, self.outlets)
        return (np.maximum(other[0] - high, low - other[1]) <= self.clearance).all(axis=1)

    def act(self, actions: list[dict[str, str]], here: np.ndarray) -> set[str]:
        """Pick and place, and return what is touched by that."""
        touched = set()
        for action in actions:
            [(kind, name)] = action.items()
            if kind == "pick":
                stands = self.stands[name]
                assert stands is not None and np.allclose(stands, here, atol=1e-9)
                touched |= self.ground(name, here)
                self.stands[name] = None
            else:
                assert self.stands[name] is None
                touched.add(name)
                self.stands[name] = here
        return touched

    def ground(self, name: str, at: np.ndarray) -> set[str]:
        """What a payload touches if it stands there."""
        own = box(self.payloads[name], at)
        return {other for other, bounds in self.standing().items() if other != name and abs(box_gap(own, bounds)) < 1e-7}


def walk(spec: dict[str, Any], folder: Path, samples: int = SAMPLES) -> list[set[tuple[str, str]]]:
    """Walk along all legs and return the problems of each."""
    cell, task = Cell(spec), json.loads((folder / "task.json").read_text())
    here, problems = np.array(task["legs"][0]["from"]["position"]), []
    for leg, after in zip(task["legs"], [*(leg["before"] for leg in task["legs"][1:]), task["after"]], strict=True):
        points = np.array(json.loads((folder / leg["path"]).read_text())["waypoints"])
        assert np.allclose(points[0], here, atol=1e-9) and np.allclose(points[-1], leg["to"]["position"], atol=1e-9)
        touch = cell.act(leg["before"], here)
        assert leg["carried"] == [name for name, stands in cell.stands.items() if stands is None]
        here = points[-1]
        # What is picked or placed at the end: it, or what it then stands on.
        for action in after:
            [(kind, name)] = action.items()
            touch |= {name} if kind == "pick" else cell.ground(name, here)
        found = set()
        for start, end in zip(points, points[1:]):
            for share in np.linspace(0, 1, samples):
                found |= cell.problems(start + share * (end - start), touch)
        problems.append(found)
    cell.act(task["after"], here)
    return problems


def run(folder: Path, *line: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([program(), *line], cwd=folder, capture_output=True, text=True)


def test_an_independent_walk_finds_nothing(tmp_path: Path) -> None:
    made = run(tmp_path, "task", str(TOWER), "-o", "task")
    assert made.returncode == 0, made.stderr
    assert run(tmp_path, "check", str(TOWER), "task/task.json", "--strict").returncode == 0
    spec = tomllib.loads(TOWER.read_text())
    assert walk(spec, tmp_path / "task") == [set()] * 7
    # The walk sees what is wrong: a taller tower, a table in the way, a larger clearance.
    spec["payloads"][0]["body"]["box"][0] = 0.9
    assert ("platform", "north wall") in walk(spec, tmp_path / "task", 20)[1]
    spec = tomllib.loads(TOWER.read_text())
    spec["obstacles"][2]["box"][2] = 0.11
    assert walk(spec, tmp_path / "task", 20)[3] == {("platform", "table")}
    spec = tomllib.loads(TOWER.read_text())
    spec["clearance"] = 0.05
    assert any(walk(spec, tmp_path / "task", 20))


def test_the_crate_cannot_pass_where_the_tower_stands(tmp_path: Path) -> None:
    scene = cdpr.Scene.load(TOWER)
    task = cdpr.task(scene.replace(task=scene.task[3:6]))
    assert [leg.status for leg in task.legs] == ["solved", "no_path"]
    assert task.status == "no_path" and task.cost == np.inf and "without tower" in str(task.legs[1].reason)
    # The walk agrees: on the way that is free without the tower, the crate meets it.
    whole = cdpr.task(scene)
    whole.save(tmp_path / "task")
    spec = tomllib.loads(TOWER.read_text())
    cell = Cell(spec)
    cell.act([{"pick": "crate"}], np.array([0.25, 0.4, 0.225]))
    points = whole.legs[3].waypoints
    on_the_way = (a + share * (b - a) for a, b in zip(points, points[1:]) for share in np.linspace(0, 1, SAMPLES))
    assert ("platform", "tower") in set.union(*(cell.problems(at, {"table"}) for at in on_the_way))
    assert run(tmp_path, "check", str(TOWER), "task/task.json", "--strict").returncode == 0


def test_a_task_is_what_the_command_writes(tmp_path: Path) -> None:
    scene, told = cdpr.Scene.load(TOWER), []
    task = cdpr.task(scene, progress=lambda done, total: told.append((done, total)))
    task.save(tmp_path / "python")
    assert run(tmp_path, "task", str(TOWER), "-o", "command").returncode == 0
    assert told[-1] == (7, 7) and repr(task) == f"Task({task.cost:.4f} m, 7 legs)"
    one, other = ((tmp_path / name / "task.json").read_text() for name in ("python", "command"))
    assert json.loads(one) == json.loads(other)
    for leg in task.legs:
        assert cdpr.check(leg.scene, leg, strict=True).valid
    assert task.legs[1].carried == ("tower",) and task.legs[1].start == "tower" and task.legs[1].goal == "corner"
    assert task.legs[4].touch == (("platform", "crate"), ("platform", "chest"))
    assert task == cdpr.task(scene, threads=1)
    timed = cdpr.trajectory(task.legs[1].scene, task.legs[1], speed=1, acceleration=1)
    assert timed.duration > task.legs[1].cost


def test_ctrl_c_keeps_what_is_planned(tmp_path: Path) -> None:
    command = [program(), "task", str(TOWER), "-o", "task", "--gap", "1e-9"]
    with subprocess.Popen(command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as running:
        time.sleep(2.0)
        running.send_signal(signal.SIGINT)
        _, told = running.communicate(timeout=30)
    assert running.returncode == 130, told
    task = json.loads((tmp_path / "task/task.json").read_text())
    statuses = [leg["status"] for leg in task["legs"]]
    assert "interrupted; no path for" in told and set(statuses) <= {"solved", "interrupted"} and "solved" in statuses
    assert len(list((tmp_path / "task").glob("leg-*.json"))) == 7
    problems = walk(tomllib.loads(TOWER.read_text()), tmp_path / "task") if "interrupted" not in statuses else []
    assert not any(problems)


def by_hand(name: str, sides: list[float], at: list[float]) -> dict[str, Any]:
    return {"name": name, "box": sides, "position": at}


def test_payloads_are_obstacles_or_parts_of_the_platform() -> None:
    scene = cdpr.Scene.load(TOWER).replace(task=None)
    spec = scene.to_dict()
    assert scene.replace() == scene and cdpr.Scene.from_dict(spec) == scene
    del spec["payloads"]
    spec["obstacles"] += [
        by_hand("tower", [0.3, 0.3, 0.7], [1.0, 1.0, 0.725 - 0.375]),
        by_hand("crate", [0.15, 0.15, 0.2], [0.25, 0.4, 0.225 - 0.125]),
        by_hand("chest", [0.15, 0.15, 0.2], [0.25, 1.0, 0.225 - 0.125]),
    ]
    hand = cdpr.Scene.from_dict(spec)
    ends = {"start": [0.6, 1.0, 0.7], "goal": [1.5, 1.4, 0.5]}
    found, expected = cdpr.plan(scene, **ends), cdpr.plan(hand, **ends)
    assert found.waypoints.tobytes() == expected.waypoints.tobytes()
    assert json.loads(found._json)["scene"] == json.loads(expected._json)["scene"]
    spec["obstacles"].pop(3)
    spec["robot"]["platform"].append(by_hand("tower", [0.3, 0.3, 0.7], [0.0, 0.0, -0.375]))
    spec["robot"] |= {"mass": 13.0, "center_of_mass": [0.0, 0.0, -0.375 * 3 / 13]}
    hand, carrying = cdpr.Scene.from_dict(spec), scene.carrying("tower")
    assert list(hand.obstacles) == list(carrying.obstacles)
    assert (hand.robot.mass, hand.robot.center_of_mass.tolist()) == (carrying.robot.mass, carrying.robot.center_of_mass.tolist())
    ends = {"start": [0.6, 1.0, 0.8], "goal": [0.6, 1.5, 0.8]}
    assert cdpr.plan(hand, **ends).waypoints.tobytes() == cdpr.plan(carrying, **ends).waypoints.tobytes()
    assert carrying.placed("tower", "gap") == scene
    assert repr(scene) == "Scene('tower', 4 cables, 6 obstacles)" and repr(carrying) == "Scene('tower', 4 cables, 5 obstacles)"
    assert list(scene.without("crate").obstacles) == ["south wall", "north wall", "table", "tower", "chest"]
    assert list(scene.without("crate").payloads) == ["tower", "chest"] and scene.payloads["crate"]["at"] == "west"
    with pytest.raises(cdpr.InputError, match="already the name of an obstacle"):
        scene.with_obstacle("crate", {"box": [0.1, 0.1, 0.1]})


def test_tensions_while_carrying_are_those_worked_out_by_hand() -> None:
    # Four cables to one point, in the middle between their outlets: each holds a quarter of the weight over the cosine of its angle.
    scene = cdpr.Scene.load(TOWER).replace(task=None, wrench={})
    robot = scene.robot.replace(attachments=[[0.0, 0.0, 0.025]] * 4)
    scene = scene.replace(robot=robot).without("south wall", "north wall")
    for held, mass in ((scene, 10.0), (scene.carrying("tower"), 13.0)):
        found = cdpr.wrench_at(held, [1.0, 1.0, 0.775])
        np.testing.assert_allclose(found.tensions, mass * 9.81 / 4 * np.hypot(1.2, 2**0.5) / 1.2, rtol=1e-9)


CRATE = {"body": {"box": [0.1, 0.1, 0.1], "position": [0, 0, -0.1]}, "mass": 2, "at": [1.7, 1, 0.3]}


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"payloads": {"crate": {**CRATE, "at": "rack"}}}, r'payloads\[0\].at: found "rack"'),
        ({"payloads": {"crate": {**CRATE, "mass": -1}}}, r"payloads\[0\].mass: found -1"),
        ({"payloads": {"crate": {**CRATE, "name": "box"}}}, "found a table with a name of its own"),
        ({"payloads": {"crate": 3}}, "found 3, expected a table"),
        ({"payloads": {"crate": {**CRATE, "weight": 3}}}, "weight"),
        ({"payloads": {"pillar": CRATE}}, r'payloads\[0\].name: found "pillar", which is already'),
        ({"task": [{"pick": "crate"}]}, r'task\[0\].pick: found "crate", expected one of'),
        ({"task": [{"fetch": "crate"}]}, "fetch"),
        ({"task": "crate"}, "task: found"),
        ({"task": [3]}, r"task\[0\]: found 3, expected a mapping"),
    ],
)
def test_bad_payloads_and_tasks_are_named(hard1: cdpr.Scene, changes: dict[str, Any], said: str) -> None:
    with pytest.raises(cdpr.InputError, match=said):
        hard1.replace(**changes)


def test_meshes_and_corners_are_bodies(hard1: cdpr.Scene) -> None:
    corners = [[x, y, z] for x in (-0.05, 0.05) for y in (-0.05, 0.05) for z in (-0.15, -0.05)]
    of_table, of_corners = (hard1.replace(payloads={"crate": {**CRATE, "body": body}}) for body in (CRATE["body"], corners))
    assert np.allclose(np.sort(of_table.obstacles["crate"][0], axis=0), np.sort(of_corners.obstacles["crate"][0], axis=0))
    two = hard1.replace(payloads={"crate": {**CRATE, "body": [corners, {"box": [0.1, 0.1, 0.1], "position": [0.1, 0, -0.1]}]}})
    assert len(two.obstacles["crate"]) == 2
    assert two.carrying("crate").robot.center_of_mass.tolist() == pytest.approx([2 * 0.05 / 12, 0.0, -2 * 0.1 / 12])


def test_bad_options_are_named(hard1: cdpr.Scene) -> None:
    with pytest.raises(cdpr.InputError, match="task: found none"):
        cdpr.task(hard1)
    scene = hard1.replace(payloads={"crate": CRATE}, task=[{"pick": "crate"}])
    for options, said in (({"gap": -1.0}, "gap: found -1"), ({"threads": 0}, "threads: found 0"), ({"progress": 1}, "progress: found 1")):
        with pytest.raises(cdpr.InputError, match=said):
            cdpr.task(scene, **options)  # type: ignore[arg-type]
    with pytest.raises(cdpr.InputError, match='payloads: found "crat"'):
        scene.carrying("crat")
    with pytest.raises(cdpr.InputError, match="found \"rack\""):
        scene.placed("crate", "rack")
    with pytest.raises(cdpr.FileError):
        cdpr.task(scene).save(TOWER)
