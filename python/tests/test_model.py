"""Robots and scenes from arrays and files."""

import json
import pickle
import re
import tomllib
import warnings

import jsonschema
import numpy as np
import pytest
import trimesh
from conftest import TESTDATA
from elastic import lengths_at, settled
from scipy.spatial.transform import Rotation

import cdpr

CUBE = np.array([[x, y, z] for x in (-0.1, 0.1) for y in (-0.1, 0.1) for z in (-0.1, 0.1)])
CORNERS = np.array([[x, y, z] for x in (0.0, 2.0) for y in (0.0, 2.0) for z in (0.0, 2.0)])
PILLAR = np.array([[x, y, z] for x in (0.9, 1.1) for y in (0.9, 1.1) for z in (0.0, 1.2)])
BOX = [[0, 0, 0], [2, 2, 2]]


def robot(**options):
    return cdpr.Robot(CORNERS, CUBE, [CUBE], **options)


def test_a_robot_from_arrays_has_what_it_was_given():
    made = robot(tensions=[1, 100], mass=5, center_of_mass=[0, 0, 0.01], name="cube")
    assert (made.outlets == CORNERS).all() and (made.attachments == CUBE).all()
    assert made.mass == 5.0 and made.name == "cube" and repr(made) == "Robot('cube', 8 cables)"
    assert made.to_dict()["cables"][3]["tension"] == [1.0, 100.0]
    assert made == robot(tensions=np.tile([1, 100], (8, 1)), mass=5, center_of_mass=[0, 0, 0.01], name="cube")
    assert made != robot()
    assert cdpr.Robot.from_dict(made.to_dict()) == made


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: cdpr.Robot(CORNERS, CUBE[:7], [CUBE]), "attachments: found 7 rows, expected 8"),
        (lambda: cdpr.Robot(CORNERS[:, :2], CUBE, [CUBE]), r"outlets: found an array of shape \(8, 2\)"),
        (lambda: cdpr.Robot(CORNERS, CUBE * 0.5, [CUBE]), r"cables\[0\].attachment: found a point .* inside platform\[0\]"),
        (lambda: cdpr.Robot(CORNERS, CUBE, []), "platform: found no parts"),
        (lambda: cdpr.Robot(CORNERS, CUBE, [[]]), r"platform\[0\]"),
        (lambda: robot(tensions=[5, 1]), r"cables\[0\].tension: found \[5, 1\]"),
        (lambda: robot(tensions=[1, 2, 3]), r"tensions: found an array of shape \(3,\)"),
        (lambda: robot(mass=-1), "mass: found -1"),
        (lambda: robot(mass=float("nan")), "mass: found nan, expected a finite number"),
        (lambda: robot(center_of_mass=[0, 0]), "center_of_mass"),
        (lambda: cdpr.Scene(robot(), {"p": PILLAR[:4]}, workspace=BOX), r"obstacles\[0\]: found a body without volume"),
        (lambda: cdpr.Scene(robot(), {"p": np.vstack([PILLAR, [1, 1, 1]])}, workspace=BOX), "vertex 8 lies .* inside the hull"),
        (lambda: cdpr.Scene(robot(), {"p": []}, workspace=BOX), "obstacles.*found"),
        (lambda: cdpr.Scene(robot(), {"p": PILLAR - 0.95}, workspace=BOX), "outlet: found a point .* inside obstacle"),
        (lambda: cdpr.Scene(robot(), {}, workspace=[[0, 0, 0], [0, 2, 2]]), "workspace: found min 0 and max 0 along x"),
        (lambda: cdpr.Scene(robot(), {}, workspace=[0, 2]), "workspace"),
        (lambda: cdpr.Scene(robot(), {}, workspace=BOX, clearance=-1), "clearance: found -1"),
        (lambda: cdpr.Scene(robot(), {}, workspace=BOX, start=[0, np.nan, 0]), r"start\[1\]: found nan"),
        (lambda: cdpr.Scene(robot(), {}, workspace=BOX, orientation=[1, 1, 0, 0]), "orientation: found a quaternion of length 1.41"),
        (lambda: cdpr.Scene.from_dict({"version": 1, "wrkspace": {}}), "unknown field `wrkspace`.*did you mean `workspace`"),
    ],
)
def test_models_that_make_no_sense_are_refused(make, message):
    with pytest.raises(cdpr.InputError, match=message):
        make()


def test_a_scene_from_arrays_answers_like_the_same_scene_from_a_file():
    loaded = cdpr.Scene.load(TESTDATA / "scenes/hard3.toml")
    boxes = {}
    for part in loaded.to_dict()["obstacles"]:
        half, middle = np.array(part["box"]) / 2, np.array(part["position"])
        boxes[part["name"]] = middle + half * np.sign(CUBE)
    made = cdpr.Scene(loaded.robot, boxes, workspace=BOX, start=loaded.start, goal=loaded.goal)
    points = np.random.default_rng(3).uniform(0.1, 1.9, (2000, 3))
    assert (made.states_valid(points) == loaded.states_valid(points)).all()
    assert cdpr.plan(made).cost == pytest.approx(cdpr.plan(loaded).cost)


def test_concave_bodies_and_clearance_and_orientation_reach_the_core():
    scene = cdpr.Scene(robot(), {"two": [PILLAR, PILLAR + [0.4, 0, 0]]}, workspace=BOX, clearance=0.05)
    assert repr(scene) == "Scene('scene', 8 cables, 1 obstacle)"
    near = [[0.76, 1.0, 0.5]]
    assert scene.explain_motion(near[0], near[0]) is not None
    half = np.sqrt(0.5)
    turned = cdpr.Scene(robot(), {}, workspace=BOX, orientation=[half, 0, 0, half])
    assert turned.to_dict()["query"]["orientation"] == pytest.approx([half, 0, 0, half])


def test_scenes_survive_dict_json_and_pickle(hard1):
    again = cdpr.Scene.from_dict(json.loads(json.dumps(hard1.to_dict())))
    assert again == hard1 and pickle.loads(pickle.dumps(hard1)) == hard1
    assert again != cdpr.Scene.load(TESTDATA / "scenes/hard3.toml")
    assert hard1.start.tolist() == [0.3, 1.0, 0.3] and hard1.name == "hard1"


def test_files_that_are_not_there(tmp_path):
    with pytest.raises(cdpr.FileError, match="nowhere.toml: cannot be read") as caught:
        cdpr.Scene.load(tmp_path / "nowhere.toml")
    assert isinstance(caught.value, OSError) and isinstance(caught.value, cdpr.CdprError)
    with pytest.raises(cdpr.FileError, match="expected .toml or .json"):
        cdpr.Scene.load(tmp_path / "scene.yaml")
    with pytest.raises(cdpr.FileError):
        cdpr.Robot.load(tmp_path / "robot.toml")


def test_built_robots_load():
    for path in sorted((TESTDATA / "robots").glob("*.toml")):
        assert len(cdpr.Robot.load(path).outlets) == 8



def test_the_schema_accepts_every_shipped_file_and_refuses_what_the_program_refuses():
    scene, robot = cdpr.schema("scene"), cdpr.schema("robot")
    files = [path for path in TESTDATA.glob("*/*.toml") if path.name != "cases.toml"]
    for path in files:
        jsonschema.validate(tomllib.loads(path.read_text()), robot if path.parent.name == "robots" else scene)
    assert len(files) > 15
    spec = tomllib.loads((TESTDATA / "scenes/hard1.toml").read_text())
    for slip in ({"clearence": 0.1}, {"workspace": {"min": [0, 0], "max": [1, 1, 1]}}, {"robot": 5}, {"version": "one"}):
        with pytest.raises(jsonschema.ValidationError):
            jsonschema.validate(spec | slip, scene)
        with pytest.raises(cdpr.InputError):
            cdpr.Scene.from_dict(spec | slip)
    jsonschema.validate({"waypoints": [[0, 0, 0], [1, 1, 1]]}, cdpr.schema("path"))


def test_meshes_of_trimesh_are_obstacles_and_platforms():
    ring = trimesh.creation.annulus(r_min=0.5, r_max=0.7, height=0.2)
    ring.apply_translation([1, 1, 1])
    with warnings.catch_warnings():
        warnings.simplefilter("error")  # nothing to report
        scene = cdpr.Scene(robot(), {"ring": ring}, workspace=BOX)
    assert re.search(r"obstacles\[0\]: .* triangles in .* convex parts, which fill it exactly", scene.notes[0])
    torus = trimesh.creation.torus(0.4, 0.1)
    torus.apply_translation([1, 1, 1])
    with pytest.warns(cdpr.CdprWarning, match=r"convex parts?, which reach at most"):
        cdpr.Scene(robot(), {"torus": torus}, workspace=BOX)
    assert len(scene.to_dict()["obstacles"]) > 4
    through = scene.motions_valid([[1, 1, 0.9]], [[1, 1, 1.1]])
    assert through.all()
    rng = np.random.default_rng(3)
    inside = [(platform + CUBE[k]) for platform in rng.uniform(0.2, 1.8, (200, 3)) for k in range(8)]
    offset = np.array(inside) - [1, 1, 1]
    radius = np.hypot(offset[:, 0], offset[:, 1])
    hits = ((radius > 0.51) & (radius < 0.69) & (abs(offset[:, 2]) < 0.1)).reshape(200, 8).any(axis=1)
    states = (np.array(inside).reshape(200, 8, 3) - CUBE)[:, 0]
    assert not scene.states_valid(states[hits]).any() and hits.sum() > 3
    assert cdpr.Scene.from_dict(scene.to_dict()) == scene
    coarse = trimesh.creation.torus(0.4, 0.1, major_sections=20, minor_sections=12)
    coarse.apply_translation([1, 1, 1])
    with pytest.warns(cdpr.CdprWarning) as told:
        many = cdpr.Scene(robot(), {f"torus {k}": coarse for k in range(5)}, workspace=BOX)
    (brief,) = [str(warning.message) for warning in told if "which reach at most" in str(warning.message)]
    assert brief.startswith("5 meshes have a note like this one, which states the largest length: obstacles[0]: ")
    assert sum("which reach at most" in note for note in many.notes) == 5
    block = trimesh.creation.box(extents=[0.2, 0.2, 0.2])
    assert cdpr.Robot(CORNERS, CUBE, [block]).to_dict()["platform"][0]["vertices"]


def test_meshes_of_wrong_shapes_are_refused():
    class Mesh:
        vertices = CUBE
        faces = [[0, 1, 2]]

    def scene(faces):
        mesh = Mesh()
        mesh.faces = np.array(faces)
        return cdpr.Scene(robot(), {"mesh": mesh}, workspace=BOX)

    for faces, message in [
        ([[0, 1, 2, 3]], r"obstacles\['mesh'\]\[0\].faces: found int64 of shape \(1, 4\)"),
        ([[0.0, 1.0, 2.0]], "found float64 of shape"),
        ([[0, 1, -1]], "found -1, expected indices from 0"),
        ([[0, 1, 8]], r"obstacles\[0\].mesh: triangle 0 has a corner"),
    ]:
        with pytest.raises(cdpr.InputError, match=message):
            scene(faces)


def test_an_imported_robot_is_the_stored_one():
    with pytest.warns(cdpr.CdprWarning, match="not carried over: joint SPATIAL_EULER_XYZ"):
        made = cdpr.import_robot(TESTDATA / "caspr" / "CoGiRo")
    stored = cdpr.Robot.load(TESTDATA / "robots" / "cogiro.toml")
    assert (made.outlets == stored.outlets).all() and (made.attachments == stored.attachments).all()
    assert made.mass == stored.mass and made.inertia[0].tolist() == [36.598, -0.453, 3.012]
    with pytest.raises(cdpr.InputError, match="no cable set \"orignal\", expected one of original; did you mean"):
        cdpr.import_robot(TESTDATA / "caspr" / "CoGiRo", cable_set="orignal")


def test_example_files_are_those_of_the_tests_and_never_replace_others(tmp_path):
    files = cdpr.save_example_files(tmp_path / "new/examples")
    for file in files:
        origin = TESTDATA / file.relative_to(tmp_path / "new/examples")
        assert file.read_bytes() == origin.read_bytes()
    assert {file.parent.name for file in files} >= {"CoGiRo", "gazebo", "meshes", "robots"}
    files[0].write_text("mine")
    with pytest.raises(cdpr.exceptions.FileError, match="differs from the example"):
        cdpr.save_example_files(tmp_path / "new/examples")
    assert files[0].read_text() == "mine"
    assert cdpr.save_example_files(tmp_path / "new/examples", overwrite=True) == files
    assert files[0].read_text() != "mine"


def test_a_platform_on_elastic_cables_settles_as_the_documentation_says():
    scene = cdpr.Scene.load(TESTDATA / "scenes/cogiro.toml")
    robot = scene.robot.replace(stiffnesses=700e3)

    def rest(position):
        away, turned = settled(robot, position, lengths_at(robot, position, Rotation.identity()))
        moved = away + Rotation.from_rotvec(turned).apply(robot.attachments) - robot.attachments
        return away, np.degrees(np.linalg.norm(turned)), np.linalg.norm(moved, axis=1).max()

    (start, start_turned, at_start), (goal, goal_turned, at_goal) = rest(scene.start), rest(scene.goal)
    told = " ".join((TESTDATA.parent / "docs/model.md").read_text().split())
    assert f"comes to rest {-1e3 * start[2]:.0f} mm lower and turned by {start_turned:.2f}°" in told
    moved = f"at the goal {1e3 * np.linalg.norm(goal):.0f} mm away and turned by {goal_turned:.2f}°"
    assert moved in told and f"no attachment moves by more than {1e3 * at_goal:.1f} mm" in told
    assert 1e3 * at_start < 14


def test_cables_have_the_names_that_answers_use(hard1):
    assert hard1.robot.cable_names == tuple(f"cable {k}" for k in range(8))
    spec = hard1.robot.to_dict()
    spec["cables"][3]["name"] = "hoist"
    robot = cdpr.Robot.from_dict(spec)
    assert robot.cable_names[2:5] == ("cable 2", "hoist", "cable 4")
    report = cdpr.check(hard1.replace(robot=robot), [[0.3, 1, 0.3], [1.7, 1, 1.7]])
    culprits = {name for violation in report.violations for name in violation.culprits}
    assert {"hoist", "cable 2"} <= culprits <= {*robot.cable_names, "platform", "pillar"}


@pytest.mark.parametrize("file", sorted((TESTDATA / "scenes").glob("*.toml")), ids=lambda file: file.stem)
def test_an_example_is_the_scene_of_its_file(file):
    scene = cdpr.example(file.stem)
    assert scene == cdpr.Scene.load(file) == cdpr.Scene.example(file.stem)


def test_an_unknown_example_is_refused_with_the_names_of_all():
    with pytest.raises(cdpr.InputError, match='example: found "hard2", expected one of acrobot, .*, turn$'):
        cdpr.example("hard2")
