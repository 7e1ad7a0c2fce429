"""Scenes and robots made from arrays accept all keys of their files, key by key of the JSON Schema."""

import inspect

import numpy as np
import pytest
from conftest import TESTDATA

import cdpr

SCENE, ROBOT = cdpr.schema("scene"), cdpr.schema("robot")
DEFINED = SCENE["$defs"]
CUBE = [[x, y, z] for x in (0.0, 0.2) for y in (0.0, 0.2) for z in (0.0, 0.2)]

# Keys of a file that are not named after an argument, and why.
NO_ARGUMENT = {"version", "query"}  # there is one version; the parts of a query are separate arguments
OF_CABLES = {
    "name": "cable_names", "outlet": "outlets", "attachment": "attachments", "tension": "tensions", "diameter": "diameters",
    "length": "lengths", "linear_density": "linear_densities", "sag_tension": "sag_tensions", "outlet_error": "outlet_errors",
    "pulley": "pulleys", "stiffness": "stiffnesses", "drum": "drums",
}  # fmt: skip


def parameters(call):
    return {name for name in inspect.signature(call).parameters if name != "self"}


def keys(definition):
    return set(definition["properties"])


@pytest.fixture
def robot():
    return cdpr.Robot.load(TESTDATA / "robots/cogiro.toml")


def test_every_key_of_a_scene_is_an_argument_of_scene_and_replace():
    wanted = (keys(SCENE) - NO_ARGUMENT) | keys(DEFINED["QuerySpec"])
    assert wanted == parameters(cdpr.Scene.__init__) == parameters(cdpr.Scene.replace)
    assert all(isinstance(getattr(cdpr.Scene, key), property) for key in wanted - {"clearance"})
    assert isinstance(cdpr.Scene.required_clearance, property)  # `clearance` measures


def test_every_key_of_a_robot_and_its_cables_is_an_argument_of_robot_and_replace():
    wanted = (keys(ROBOT) - {"version", "cables"}) | {OF_CABLES[key] for key in keys(DEFINED["CableSpec"])}
    assert wanted == parameters(cdpr.Robot.__init__) == parameters(cdpr.Robot.replace)
    assert all(isinstance(getattr(cdpr.Robot, key), property) for key in wanted - {"platform"})


SCENE_VALUES = {
    "name": "a hall",
    "gravity": [0.0, 0.5, -1.62],
    "clearance": 0.01,
    "clearances": {"platform_obstacle": 0.02, ("cable 1", "crate"): 0.03},
    "touch": [("platform", "crate")],
    "ignore": [("cable 2", "crate")],
    "workspace": [[-7.0, -5.0, 0.0], [7.0, 5.0, 5.5]],
    "orientations": {"level": [1.0, 0.0, 0.0, 0.0], "tilted": {"rpy_degrees": [0.0, 0.0, 5.0]}},
    "obstacles": {"crate": CUBE, "box": {"box": [1.0, 1.0, 1.0], "position": [3.0, 0.0, 0.5], "rpy": [0.0, 0.0, 0.1]}},
    "wrench": {"force": 10.0, "moment": 1.0, "load": np.zeros(6), "margin": "projected", "characteristic_length": 0.5},
    "motion": {"speed": 1.0, "acceleration": 2.0, "blend": 0.05},
    "stations": {"rack": [0.0, 0.0, 2.0], "bench": {"position": [1.0, 0.0, 2.0], "orientation": [1.0, 0.0, 0.0, 0.0]}},
    "payloads": {"sack": {"body": {"box": [0.1, 0.1, 0.1], "position": [0.0, 0.0, -1.0]}, "mass": 2.0, "at": "bench"}},
    "task": [{"pick": "sack"}, {"via": "bench"}, {"go": "bench"}, {"place": "sack"}],
    "start": [0.0, 0.0, 2.0],
    "goal": [1.0, 0.0, 2.0],
    "orientation": "tilted",
    "turning": {"axis": [0.0, 0.0, 1.0], "max_tilt": 10.0, "weight": 0.5},
    "start_orientation": [1.0, 0.0, 0.0, 0.0],
    "goal_orientation": [0.6, 0.0, 0.0, 0.8],
}


def spelled_out(scene, key):
    spec = scene.to_dict()
    return spec["query"][key] if key in keys(DEFINED["QuerySpec"]) else spec[key]


def test_scene_and_replace_write_the_same_for_every_key(robot, tmp_path):
    assert set(SCENE_VALUES) | {"robot"} == parameters(cdpr.Scene.__init__)
    whole = cdpr.Scene(robot, **SCENE_VALUES)
    bare = cdpr.Scene(robot.replace(name="other"), workspace=[[-9, -9, -9], [9, 9, 9]])
    assert bare.replace(robot=robot, **SCENE_VALUES) == whole
    assert spelled_out(whole, "clearances")["pairs"] == [{"between": ["cable 1", "crate"], "clearance": 0.03}]
    assert spelled_out(whole, "wrench")["load"] == [0.0] * 6 and spelled_out(whole, "orientation") == "tilted"
    assert spelled_out(whole, "gravity") == [0.0, 0.5, -1.62]
    assert whole.gravity.tolist() == [0.0, 0.5, -1.62] and whole.wrench["force"] == 10.0
    assert set(whole.obstacles) == {"crate", "box", "sack"} and list(whole.orientations) == ["level", "tilted"]
    assert list(whole.stations) == ["rack", "bench"] and whole.stations["bench"].orientation.tolist() == [1, 0, 0, 0]
    whole.save(tmp_path / "hall.toml")
    assert cdpr.Scene.load(tmp_path / "hall.toml") == whole
    optional = {"name", "gravity", "clearances", "touch", "ignore", "obstacles", "wrench", "motion", "turning", "stations"}
    optional |= {"payloads", "task"}
    for key in optional | keys(DEFINED["QuerySpec"]):
        taken = {"touch": None, "ignore": None, "clearances": None} if key == "obstacles" else {}
        taken |= {"task": None} if key in ("payloads", "stations") else {}
        taken |= {"payloads": None} if key == "stations" else {}
        without = whole.replace(**taken | {key: None}).to_dict()
        assert key not in without and key not in without.get("query", {}), key
    assert whole.replace(orientation=None, orientations=None).orientations == {}


def test_properties_can_be_given_back(robot):
    whole = cdpr.Scene(robot, **SCENE_VALUES)
    given = {key: getattr(whole, key) for key in SCENE_VALUES if key not in ("clearance", "orientation")}
    given["obstacles"] = {name: parts for name, parts in whole.obstacles.items() if name not in whole.payloads}
    again = cdpr.Scene(whole.robot, clearance=whole.required_clearance, orientation="tilted", **given)
    assert (again.gravity == whole.gravity).all() and again.wrench == whole.wrench
    assert again.clearances == whole.clearances and again.touch == whole.touch
    other = cdpr.Robot(
        robot.outlets, robot.attachments, [CUBE], tensions=robot.tensions, diameters=robot.diameters,
        cable_names=robot.cable_names, mass=robot.mass, center_of_mass=robot.center_of_mass, name=robot.name,
    )  # fmt: skip
    assert (other.tensions == robot.tensions).all() and other.cable_names == robot.cable_names


def test_robot_and_replace_write_the_same_for_every_key(robot):
    values = {
        "platform": {"box": [1.0, 1.0, 0.5], "name": "frame"},
        "tensions": [[10.0 + k, 900.0] for k in range(8)],
        "mass": 42.0,
        "center_of_mass": [0.0, 0.0, 0.1],
        "inertia": [3.0, 4.0, 5.0],
        "cable_names": [f"winch {k + 1}" for k in range(8)],
        "diameters": 0.004,
        "lengths": [0.5, 30.0],
        "linear_densities": 0.06,
        "sag_tensions": 50.0,
        "outlet_errors": [0.001 * k for k in range(8)],
        "pulleys": [{"radius": 0.05, "axis": [0.0, 0.0, 1.0]}, None] * 4,
        "stiffnesses": 7e5,
        "drums": {"radius": 0.1, "gear": -20, "zero": 5.0, "lead": 3.0},
        "cable": {"linear_density": 0.1, "pulley": {"radius": 0.1, "axis": [0.0, 0.0, 1.0]}, "drum": {"radius": 0.2}},
        "tension_distribution": "least",
        "name": "mine",
    }
    ends = {"outlets": robot.outlets, "attachments": np.tile([[0.5, 0.5, 0.25], [-0.5, -0.5, 0.25]], (4, 1))}
    assert set(values) | set(ends) == parameters(cdpr.Robot.__init__)
    whole = cdpr.Robot(**ends, **values)
    assert robot.replace(**ends, **values) == whole
    cable = whole.to_dict()["cables"][2]
    assert cable == {
        "name": "winch 3", "outlet": robot.outlets[2].tolist(), "attachment": [0.5, 0.5, 0.25], "tension": [12.0, 900.0],
        "diameter": 0.004, "length": [0.5, 30.0], "linear_density": 0.06, "sag_tension": 50.0, "outlet_error": 0.002,
        "pulley": {"radius": 0.05, "axis": [0.0, 0.0, 1.0]}, "stiffness": 7e5,
        "drum": {"radius": 0.1, "gear": -20.0, "zero": 5.0, "lead": 3.0},
    }  # fmt: skip
    assert (whole.linear_densities == 0.06).all() and (whole.sag_tensions == 50.0).all() and whole.outlet_errors[3] == 0.003
    assert [pulley["radius"] for pulley in whole.pulleys[:3]] == [0.05, 0.1, 0.05] and (whole.stiffnesses == 7e5).all()
    assert whole.cable == values["cable"]
    assert whole.drums[5] == values["drums"]
    common = whole.replace(linear_densities=None, pulleys=None, sag_tensions=None, drums=[None] * 7 + [{"radius": 0.3}])
    assert [drum["radius"] for drum in common.drums[-2:]] == [0.2, 0.3]
    assert (common.linear_densities == 0.1).all() and common.pulleys[0]["radius"] == 0.1 and common.sag_tensions[2] == 12.0
    assert (whole.diameters == 0.004).all() and whole.lengths.tolist() == [[0.5, 30.0]] * 8
    assert whole.to_dict()["platform"] == [{"name": "frame", "box": [1.0, 1.0, 0.5]}]
    assert whole.inertia.tolist() == np.diag([3.0, 4.0, 5.0]).tolist()
    bare = whole.replace(
        tensions=None, mass=None, center_of_mass=None, inertia=None, cable_names=None, diameters=None, lengths=None, name=None,
        linear_densities=None, sag_tensions=None, outlet_errors=None, pulleys=None, stiffnesses=None, drums=None, cable=None,
        tension_distribution=None,
    )  # fmt: skip
    assert whole.tension_distribution == "least" and bare.tension_distribution is None
    assert bare.pulleys == bare.drums == (None,) * 8 and bare.cable is None and np.isinf(bare.stiffnesses).all()
    assert set(bare.to_dict()) == {"platform", "cables"} and set(bare.to_dict()["cables"][0]) == {"outlet", "attachment"}
    assert bare.cable_names[:2] == ("cable 0", "cable 1") and np.isnan(bare.tensions).all() and np.isinf(bare.lengths[:, 1]).all()
    with pytest.raises(cdpr.InputError, match="outlets: found 7, expected 8, one for each cable"):
        robot.replace(outlets=robot.outlets[:7])
    with pytest.raises(cdpr.InputError, match="cable_names: found 2, expected 8"):
        robot.replace(cable_names=["a", "b"])


BODIES = {
    "box": {"box": [0.2, 0.2, 0.2]},
    "vertices": {"vertices": CUBE},
    "prism": {"prism": {"base": [[0, 0], [1, 0], [0, 1]], "height": 0.5}},
    "mesh": {"mesh": {"vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], "triangles": [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]}},
    "units": {"mesh": str(TESTDATA / "meshes/machine.stl"), "units": "cm"},
    "scale": {"mesh": str(TESTDATA / "meshes/machine.stl"), "scale": 0.5},
    "tolerance": {"mesh": str(TESTDATA / "meshes/machine.stl"), "tolerance": 0.1},
    "position": {"box": [0.2, 0.2, 0.2], "position": np.array([1.0, 0.0, 1.0])},
    "rpy": {"box": [0.2, 0.2, 0.2], "rpy": (0.0, 0.0, 0.1)},
    "rpy_degrees": {"box": [0.2, 0.2, 0.2], "rpy_degrees": [0.0, 0.0, 10.0]},
    "quaternion": {"box": [0.2, 0.2, 0.2], "quaternion": [1.0, 0.0, 0.0, 0.0]},
    "name": None,  # for obstacles, the key of the mapping
}


def test_every_key_of_a_body_is_taken(robot):
    assert set(BODIES) == keys(DEFINED["BodySpec"])
    scene = cdpr.Scene(robot, workspace=SCENE_VALUES["workspace"])
    for key, body in BODIES.items():
        if body is None:
            continue
        held = scene.with_obstacle("body", body)
        assert held == scene.replace(obstacles={"body": body}) and len(held.obstacles["body"]) >= 1, key
    with pytest.raises(cdpr.InputError, match="name of its own"):
        scene.with_obstacle("body", {"box": [1, 1, 1], "name": "other"})
    with pytest.raises(cdpr.InputError, match="position: also found in the table"):
        scene.with_obstacle("body", BODIES["position"], position=[0, 0, 0])
    with pytest.raises(cdpr.InputError, match="unknown|colour"):
        scene.with_obstacle("body", {"box": [1, 1, 1], "colour": "red"})


def test_every_key_of_a_turn_a_demand_and_a_motion_is_taken(robot):
    for key in keys(DEFINED["OrientationSpec"]) - {"name"}:
        turn = {key: [1.0, 0.0, 0.0, 0.0] if key == "quaternion" else [0.0, 0.0, 0.1]}
        scene = cdpr.Scene(robot, workspace=SCENE_VALUES["workspace"], orientations={"turned": turn})
        assert list(scene.orientations) == ["turned"]
    demands = {
        "force": 1.0, "moment": 1.0, "vertices": np.ones((1, 6)), "load": np.ones(6), "loads": np.ones((2, 6)),
        "payload": 3.0, "margin": "capacity", "rule": "grid", "grid": 0.5, "membership": "nearest", "characteristic_length": 2.0,
    }  # fmt: skip
    assert set(demands) == keys(DEFINED["WrenchSpec"])
    for key, value in demands.items():
        scene = cdpr.Scene(robot, workspace=SCENE_VALUES["workspace"], wrench={key: value})
        assert set(scene.wrench) == {key}
    limits = {
        "speed": 1.0, "acceleration": 2.0, "jerk": 20.0, "cable_speed": 1.0, "cable_acceleration": 5.0, "blend": 0.02,
        "clearance": 0.0, "wrench_margin": 1.0, "turn_speed": 1.0, "turn_acceleration": 3.0,
    }  # fmt: skip
    assert set(limits) == keys(DEFINED["MotionSpec"])
    scene = cdpr.Scene(robot, workspace=SCENE_VALUES["workspace"], motion=limits)
    assert scene.motion == limits
    assert set(limits) < parameters(cdpr.trajectory)
    kinds = keys(DEFINED["ClearancesSpec"]) - {"pairs"}
    scene = cdpr.Scene(robot, workspace=SCENE_VALUES["workspace"], clearances=dict.fromkeys(kinds, 0.01))
    assert set(scene.clearances) == kinds
