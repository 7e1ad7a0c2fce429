"""Scenes derived from others: edited, saved and loaded."""

import warnings

import numpy as np
import pytest
import trimesh
from conftest import TESTDATA
from test_model import BOX, CUBE, PILLAR, robot

import cdpr


@pytest.fixture
def hard3() -> cdpr.Scene:
    return cdpr.Scene.load(TESTDATA / "scenes/hard3.toml")


def test_obstacles_are_a_read_only_mapping_of_corners(hard3):
    assert list(hard3.obstacles) == ["west", "south", "north"] and "west" in hard3.obstacles
    (west,) = hard3.obstacles["west"]
    assert west.shape == (8, 3) and west.max() == pytest.approx(1.2)
    assert west.min(axis=0) == pytest.approx([0.6, 0.9, 0])
    with pytest.raises(ValueError, match="read-only"):
        west[0, 0] = 5.0
    with pytest.raises(TypeError):
        hard3.obstacles["west"] = west
    again = cdpr.Scene(hard3.robot, hard3.obstacles, workspace=hard3.workspace, start=hard3.start, goal=hard3.goal)
    points = np.random.default_rng(0).uniform(0.1, 1.9, (2000, 3))
    assert (again.states_valid(points) == hard3.states_valid(points)).all()
    concave = cdpr.Scene(robot(), {"two": [PILLAR, PILLAR + [0.4, 0, 0]]}, workspace=BOX)
    assert [len(part) for part in concave.obstacles["two"]] == [8, 8]


def test_replacing_leaves_the_original_and_changes_only_what_is_said(hard3):
    before = hard3.to_dict()
    half = np.sqrt(0.5)
    made = hard3.replace(
        robot=robot(name="other"), workspace=[[0, 0, 0], [2, 2, 1.9]], start=[0.4, 1, 0.3], goal=None,
        orientation=[half, 0, 0, half], clearance=0.01, name="edited",
    )  # fmt: skip
    assert hard3.to_dict() == before
    assert made.robot == robot(name="other") and made.workspace.tolist() == [[0, 0, 0], [2, 2, 1.9]]
    assert made.start.tolist() == [0.4, 1, 0.3] and made.goal is None and made.name == "edited"
    assert made.orientation == pytest.approx([half, 0, 0, half]) and made.required_clearance == 0.01
    assert list(made.obstacles) == list(hard3.obstacles)
    assert hard3.replace() == hard3
    back = made.replace(orientation=None, name=None)
    assert back.orientation.tolist() == [1, 0, 0, 0] and back.name == "scene"
    assert hard3.replace(clearance=0.05).to_dict() | {"clearance": 0.0} == before | {"clearance": 0.0}


def test_a_scene_with_named_orientations_takes_one_by_name(hard3):
    half = np.sqrt(0.5)
    named = [{"name": "level", "rpy": [0, 0, 0]}, {"name": "turned", "rpy": [0, 0, np.pi / 2]}]
    scene = cdpr.Scene.from_dict(hard3.to_dict() | {"orientations": named})
    assert scene.orientation == pytest.approx([1, 0, 0, 0])
    turned = scene.replace(orientation="turned")
    assert turned.orientation == pytest.approx([half, 0, 0, half])
    assert turned.replace(orientation=None) == scene
    with pytest.raises(cdpr.InputError, match='orientation: found "trned".*did you mean "turned"'):
        scene.replace(orientation="trned")


def test_wrench_demands_and_gravity_stay(hard3):
    spec = hard3.to_dict() | {"wrench": {"force": 1.0}, "gravity": [0, 0, -3.7]}
    made = cdpr.Scene.from_dict(spec).without("west").replace(start=[0.3, 1, 0.4])
    assert made.to_dict()["wrench"]["force"] == 1.0 and made.to_dict()["gravity"] == [0, 0, -3.7]


def test_obstacles_come_and_go(hard3):
    box = CUBE + [0, 0, 0.1]
    more = hard3.with_obstacle("crate", box, position=[1.7, 0.3, 0.0], rpy=[0, 0, np.pi / 4])
    (corners,) = more.obstacles["crate"]
    assert corners.mean(axis=0) == pytest.approx([1.7, 0.3, 0.1])
    assert corners[:, 0].max() == pytest.approx(1.7 + 0.1 * np.sqrt(2))
    assert more.without("crate").obstacles.keys() == hard3.obstacles.keys()
    assert len(hard3.obstacles) == 3
    free = hard3.without("west", "north", "south")
    assert len(free.obstacles) == 0 and cdpr.plan(free).cost == pytest.approx(np.hypot(1.4, 1.4))
    ring = trimesh.creation.annulus(r_min=0.2, r_max=0.3, height=0.1)
    with warnings.catch_warnings():
        warnings.simplefilter("error")  # the parts fill it exactly: nothing to report
        ringed = free.with_obstacle("ring", ring, position=[1, 1, 1])
    assert any("convex parts, which fill it exactly" in note for note in ringed.notes)
    assert len(ringed.obstacles["ring"]) > 4


def test_names_that_are_not_there_or_are_taken(hard3):
    expected = "without: found no obstacle 'wset', expected one of west, south, north; did you mean 'west'"
    with pytest.raises(cdpr.InputError, match=expected):
        hard3.without("wset")
    with pytest.raises(cdpr.InputError, match="expected one of west, south, north$"):
        hard3.without("west", "zzz")
    with pytest.raises(cdpr.InputError, match=r"found no obstacle 'west', expected one of \(there are none\)"):
        hard3.without("west", "south", "north").without("west")
    with pytest.raises(cdpr.InputError, match="name: found 'west', which is already the name of an obstacle"):
        hard3.with_obstacle("west", PILLAR)


@pytest.mark.parametrize(
    ("edit", "message"),
    [
        (lambda scene: scene.replace(start=[0, 0]), r"start: found an array of shape \(2,\)"),
        (lambda scene: scene.replace(orientation=[1, 0]), r"orientation: found an array of shape \(2,\)"),
        (lambda scene: scene.replace(orientation=[1, 1, 0, 0]), "orientation: found a quaternion of length"),
        (lambda scene: scene.replace(workspace=[[0, 0, 0]]), "workspace: found an array of shape"),
        (lambda scene: scene.replace(clearance=-1), "clearance: found -1"),
        (lambda scene: scene.replace(clearance=float("nan")), "clearance: found nan, expected a finite number"),
        (lambda scene: scene.with_obstacle("a", PILLAR, position=[0, 0]), "position: found an array of shape"),
        (lambda scene: scene.with_obstacle("a", PILLAR[:4]), "found a body without volume"),
        (lambda scene: scene.with_obstacle("a", PILLAR, position=[-0.95, -0.95, -0.5]), "outlet: .* inside obstacle"),
    ],
)
def test_edits_that_make_no_sense_are_refused(hard3, edit, message):
    with pytest.raises(cdpr.InputError, match=message):
        edit(hard3)


def test_allowed_contacts_go_with_their_obstacle(hard3):
    made = cdpr.Scene.from_dict(hard3.to_dict() | {"ignore": [["cable 0", "west"], ["cable 1", "north"]]})
    assert made.without("west").to_dict()["ignore"] == [["cable 1", "north"]]


def test_obstacles_without_a_name_keep_theirs(hard3):
    spec = hard3.to_dict()
    for part in spec["obstacles"][:2]:
        del part["name"]
    made = cdpr.Scene.from_dict(spec)
    assert list(made.obstacles) == ["obstacle 0", "obstacle 1", "north"]
    assert list(made.without("obstacle 0").obstacles) == ["obstacle 1", "north"]


@pytest.mark.parametrize("extension", ["toml", "json"])
def test_scenes_and_robots_are_saved_and_loaded(hard3, tmp_path, extension):
    for scene in (hard3, hard3.with_obstacle("crate", CUBE + [1.7, 0.3, 0.2]).replace(clearance=0.01, start=None)):
        scene.save(tmp_path / f"scene.{extension}")
        assert cdpr.Scene.load(tmp_path / f"scene.{extension}") == scene
    hard3.replace(name=None).save(tmp_path / f"hall.{extension}")
    assert cdpr.Scene.load(tmp_path / f"hall.{extension}") == hard3.replace(name="hall")
    hard3.robot.save(tmp_path / f"robot.{extension}")
    assert cdpr.Robot.load(tmp_path / f"robot.{extension}") == hard3.robot
    for thing in (hard3, hard3.robot):
        with pytest.raises(cdpr.FileError, match="expected .toml or .json"):
            thing.save(tmp_path / "thing.txt")


def test_every_shipped_scene_survives_saving(tmp_path):
    for path in sorted((TESTDATA / "scenes").glob("*.toml")):
        scene = cdpr.Scene.load(path)
        for extension in ("toml", "json"):
            scene.save(tmp_path / f"again.{extension}")
            assert cdpr.Scene.load(tmp_path / f"again.{extension}") == scene
