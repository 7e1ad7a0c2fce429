"""Any value passed to any parameter of the public API: only exceptions of our hierarchy are raised, and nothing hangs.

Strings, booleans and masked entries are never accepted as numbers.
"""

import functools
import inspect
import warnings

import matplotlib
import numpy as np
import pytest
from conftest import TESTDATA
from matplotlib import pyplot

import cdpr
import cdpr.figures
import cdpr.ompl

matplotlib.use("Agg")

CUBE = [[x, y, z] for x in (0.0, 0.2) for y in (0.0, 0.2) for z in (0.0, 0.2)]
HERE, THERE = [0.3, 1.0, 0.3], [1.7, 1.0, 1.7]
TURNED = [0.6, 0.0, 0.0, 0.8]
EXPERIMENT = {"version": 1, "trials": 1, "scenarios": [{"name": "a", "scene": str(TESTDATA / "scenes/empty.toml")}]}
EXPERIMENT["methods"] = [{"name": "RRT", "planner": "rrt"}]
WEIGHTED = {"version": 1, "vertices": [[1.0, 0, 0, 0, 0, 0]]}

# Created by functions; users who create them directly get no checks.
RESULTS = {"AvailableSet", "BatchResult", "Distance", "Exemption", "Mesh", "Milestone", "Report", "Result", "SearchTree"}
RESULTS |= {"Corner", "Limiting", "MotionState", "PoseEstimate", "Proof", "Settling", "Tensions", "Trajectory", "Violation", "View", "WrenchMap", "WrenchReport", "Workspace", "WorkspacePart", "Share", "Bounds", "Station", "Tour", "Task", "TaskLeg"}

CALLBACKS = {"on_improvement", "progress"}  # their exceptions are passed on unchanged


class Strange:
    """Neither a number, a string nor an array."""


def nested(depth):
    value = []
    for _ in range(depth):
        value = [value]
    return value


def within_itself():
    value = []
    value.append(value)
    return value


def hostile(scene):
    """Values by name."""
    values = {
        "None": None, "text": "abc", "number in a text": "5", "5": 5, "-1": -1, "0": 0, "nan": float("nan"),
        "inf": float("inf"), "True": True, "[]": [], "[[]]": [[]], "object": Strange(), "surrogate": "\ud800",
        "bytes": b"x", "large": 10**400, "very large": 10**5000, "masked": np.ma.array([1.0, 1.0, 1.0], mask=[False, True, False]),
        "masked scalar": np.ma.masked, "texts": np.array(["a", "b", "c"]), "list of texts": ["1", "2", "3"],
        "truths": [True, False, True], "mixed truths": [1.0, True, 0.5], "flags": np.array([True, False]),
        "complex": 1j, "ragged": [[1, 2], [3]], "deep": nested(100), "very deep": nested(5000), "within itself": within_itself(),
        "mapping": {"a": 1}, "odd keys": {5: 1}, "mapping of nan": {"a": float("nan")}, "surrogates": ["\ud800", "a"],
        "function": lambda *_: 1, "generator": (x for x in "ab"), "class": int, "scene": scene, "robot": scene.robot,
        "objects": np.array([None, Strange()], dtype=object), "zero byte": "a\0b", "empty": "", "nan array": np.full((2, 3), np.nan),
        "integers": np.array([2**63], dtype=np.uint64), "ones": np.ones((2, 3)), "one point": np.ones(3),
    }  # fmt: skip
    return values


@pytest.fixture(scope="module")
def batch():
    return cdpr.run_batch(EXPERIMENT)


@pytest.fixture
def calls(tmp_path, monkeypatch, batch):
    """All public callables by name, with valid arguments."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("webbrowser.open_new_tab", lambda url: True)
    scene = cdpr.Scene.load(TESTDATA / "scenes/hard1.toml")
    held = cdpr.Scene.load(TESTDATA / "scenes/cogiro.toml")
    crate = {"body": {"box": [0.1, 0.1, 0.1], "position": [0, 0, -0.1]}, "mass": 2, "at": HERE}
    laden = scene.replace(payloads={"crate": crate}, task=[{"go": [0.3, 1.0, 0.5]}, {"pick": "crate"}], start=HERE)
    robot, path = held.robot, cdpr.Path([HERE, [0.3, 1.0, 0.4]], 0.1)
    grid = cdpr.wrench_map(held, step=2.0)
    grid.save("map.npz")
    proved = cdpr.workspace(scene, resolution=0.5)
    path.save("path.json")
    scene.save("scene.toml")
    robot.save("robot.toml")
    points = {"positions": [[0, 0, 2.0]]}
    loads = {"load": [0.0] * 6, "gravity": [0, 0, -9.81], "orientation": [1.0, 0, 0, 0]}
    threads = {"threads": 1}
    judges = {"engine": "cspace", "interference": "exact"}
    along = {"scene": scene, "waypoints": [HERE, [0.3, 1.0, 0.4]], "strict": False}
    turns = {"start_orientation": [1.0, 0, 0, 0], "end_orientation": TURNED}
    many_turns = {"start_orientations": [1.0, 0, 0, 0], "end_orientations": [TURNED]}
    level = {"start_orientation": [1.0, 0, 0, 0], "goal_orientation": [1.0, 0, 0, 0]}
    regions = {"space": "attachment", "all_regions": False, "cables": "cable 1", "obstacles": ["pillar"]}
    end = {"start": HERE, "goal": THERE}
    cables = {
        "outlets": robot.outlets, "attachments": robot.attachments, "platform": [CUBE], "tensions": [1.0, 100.0], "mass": 5.0,
        "center_of_mass": [0.0, 0.0, 0.0], "inertia": [1.0, 1.0, 1.0], "cable_names": list("abcdefgh"), "diameters": 0.01, "lengths": [0.1, 50.0], "name": "r",
        "linear_densities": 0.001, "sag_tensions": 5.0, "outlet_errors": 0.001, "pulleys": {"radius": 0.01, "axis": [0, 0, 1.0]},
        "stiffnesses": 1e5, "drums": {"radius": 0.1}, "cable": {"outlet_error": 0.001}, "tension_distribution": "p4",
    }  # fmt: skip
    said = {
        "workspace": [[0.0, 0, 0], [2, 2, 2]], **end, **level, "orientation": [1.0, 0, 0, 0], "orientations": {"level": [1.0, 0, 0, 0]}, "stations": {"rack": HERE},
        "clearance": 0.0, "clearances": {"cable_cable": 0.0}, "touch": [("platform", "crate")],
        "ignore": [("cable 1", "crate")], "gravity": [0.0, 0, -9.81], "wrench": None, "motion": {"speed": 1.0}, "turning": {"weight": 1.0},
        "name": "s", "obstacles": {"crate": CUBE}, "payloads": {"sack": crate}, "task": [{"pick": "sack"}],
    }  # fmt: skip
    closed = cdpr.Scene.load(TESTDATA / "scenes/closed.toml").replace(**end)
    proof = cdpr.plan(cdpr.Scene.load(TESTDATA / "scenes/closed.toml")).proof
    proof.save("proof.json")
    motion = cdpr.trajectory(scene, path, acceleration=2.0)
    motion.save("motion.json")
    information = cdpr.ompl.simple_setup(scene).getSpaceInformation()
    experiment = {"experiment": EXPERIMENT, "executor": None, "progress": None, "trials": 1, "threads": 1}
    figure = {"view": (20.0, -60.0), "ax": None}
    limits = {
        "speed": 1.0, "acceleration": 2.0, "jerk": 20.0, "cable_speed": 1.0, "cable_acceleration": 5.0, "blend": 0.02,
        "clearance": 0.0, "wrench_margin": None, "rate": 50.0, "turn_speed": 1.0, "turn_acceleration": 2.0, "orientations": None,
    }  # fmt: skip
    plan = {
        "planner": "rrt", "seed": 0, **end, "step": 0.1, "post": "none", "budget": 5.0, "repeats": 1, "max_samples": 500,
        "max_nodes": 500, "keep_going": False, "target_cost": 9.0, "gap": None, "extend_step": 0.1, "goal_bias": 0.1,
        "check_goal": False, "near_radius": None, "near_cap": None, "orientation": None, **level, **judges, "proof": False, "on_improvement": None,
        "minimise": "time", "motion": {"speed": 1.0, "acceleration": 1.0}, "maximise": None,
        "via": [end["start"]], "goals": (), "goal_box": None, "within": None,
    }  # fmt: skip
    return {
        "Robot": (cdpr.Robot, cables),
        "Robot.replace": (robot.replace, cables),
        "Robot.from_dict": (cdpr.Robot.from_dict, {"spec": robot.to_dict()}),
        "Robot.load": (cdpr.Robot.load, {"path": "robot.toml"}),
        "Robot.save": (robot.save, {"path": "robot.json"}),
        "Robot.to_dict": (robot.to_dict, {}),
        "Robot.cable_lengths": (robot.cable_lengths, points | {"orientation": [1.0, 0, 0, 0]}),
        "pose_from_lengths": (
            cdpr.pose_from_lengths,
            {"robot": robot, "lengths": robot.cable_lengths([0, 0, 2.0]), "joints": "command", "tensions": [100.0] * 8}
            | {"guess": [0.1, 0, 2.0], "orientation": [1.0, 0, 0, 0]},
        ),
        "Scene": (cdpr.Scene, {"robot": scene.robot} | said),
        "Scene.replace": (scene.replace, {"robot": scene.robot} | said),
        "Scene.from_dict": (cdpr.Scene.from_dict, {"spec": scene.to_dict()}),
        "Scene.load": (cdpr.Scene.load, {"path": "scene.toml"}),
        "Scene.save": (scene.save, {"path": "scene.json"}),
        "Scene.to_dict": (scene.to_dict, {}),
        "Scene.with_obstacle": (
            scene.with_obstacle,
            {"name": "crate", "obstacle": CUBE, "position": [0.0, 0, 0], "rpy": [0.0, 0, 0], "rpy_degrees": None, "quaternion": None},
        ),
        "Scene.moved": (scene.moved, {"name": "pillar", "position": HERE}),
        "Scene.without": (scene.without, {"names": "pillar"}),
        "Scene.carrying": (laden.carrying, {"name": "crate"}),
        "Scene.placed": (laden.placed, {"name": "crate", "at": HERE}),
        "Scene.states_valid": (scene.states_valid, {"points": [HERE], "orientations": TURNED} | judges | threads),
        "Scene.motions_valid": (scene.motions_valid, {"starts": [HERE], "ends": [THERE]} | many_turns | judges | threads),
        "Scene.clearance": (scene.clearance, {"points": [HERE], "orientations": TURNED} | threads),
        "Scene.nearest_valid": (
            scene.nearest_valid, {"position": HERE, "orientation": [1.0, 0, 0, 0], "margin": 0.01} | judges,
        ),
        "Scene.violations": (scene.violations, {"start": HERE, "end": THERE} | turns | judges),
        "Scene.explain_motion": (scene.explain_motion, {"start": HERE, "end": THERE} | turns | judges),
        "Path": (
            cdpr.Path,
            {"waypoints": [HERE, THERE], "cost": 1.0, "orientation": [1.0, 0, 0, 0], "orientations": [TURNED, TURNED]},
        ),
        "Path.save": (path.save, {"path": "path.csv"}),
        "Path.to_pandas": (path.to_pandas, {}),
        "Proof.save": (proof.save, {"path": "proof.json"}),
        "check_proof": (cdpr.check_proof, {"scene": closed, "path": "proof.json"} | end),
        "View.save": (cdpr.View("<html>").save, {"path": "view.html"}),
        "Workspace.save": (proved.save, {"path": "inside.npz"}),
        "workspace": (
            cdpr.workspace,
            {"scene": held, "orientation": None, "orientations": [[1.0, 0, 0, 0]], "valid_at": "any", "resolution": 5.0, "budget": 0.1}
            | threads,
        ),
        "WrenchMap.save": (grid.save, {"path": "map.vti"}),
        "WrenchMap.load": (cdpr.WrenchMap.load, {"path": "map.npz", "scene": held, "force": None, "moment": None}),
        "BatchResult.save": (batch.save, {"folder": "run"}),
        "capacity_margin": (
            cdpr.capacity_margin,
            {"robot": robot, "force": 1.0, "moment": 1.0, "vertices": [[1.0, 0, 0, 0, 0, 0]], "characteristic_length": 1.0}
            | points | loads | threads,
        ),
        "force_margin": (cdpr.force_margin, {"robot": robot} | points | loads | threads),
        "moment_margin": (cdpr.moment_margin, {"robot": robot} | points | loads | threads),
        "force_set": (cdpr.force_set, {"robot": robot, "position": [0, 0, 2.0]} | loads),
        "moment_set": (cdpr.moment_set, {"robot": robot, "position": [0, 0, 2.0]} | loads),
        "tension_distribution": (
            cdpr.tension_distribution,
            {"robot": robot, "tensions": None, "reference": [100.0] * 8, "characteristic_length": 1.0} | points | loads | threads,
        ),
        "wrench_matrix": (cdpr.wrench_matrix, {"robot": robot, "orientation": [1.0, 0, 0, 0]} | points),
        "wrench_at": (cdpr.wrench_at, {"scene": held, "position": [0, 0, 2.0], "force": 1.0, "moment": 1.0, "tensions": "least"}),
        "wrench_map": (
            cdpr.wrench_map,
            {"scene": held, "step": 2.0, "force": 1.0, "moment": 1.0, "projected": False} | threads,
        ),
        "tensions_along": (
            cdpr.tensions_along,
            {"scene": held, "waypoints": [[0, 0, 2.0], [1, 0, 2]], "step": 0.5, "tensions": None, "reference": [100.0] * 8}
            | {"strict": False},
        ),
        "trajectory": (cdpr.trajectory, {"scene": scene, "path": path, "tensions": "p4", "strict": False} | limits),
        "load_trajectory": (cdpr.load_trajectory, {"file": "motion.json", "scene": scene, "strict": False}),
        "Trajectory.at": (motion.at, {"time": [0.0, 0.1]}),
        "Trajectory.save": (motion.save, {"file": "motion.json", "joints": None, "effort": False}),
        "distance": (cdpr.distance, {"a": CUBE, "b": [[1.0, 1, 1]]}),
        "plan": (cdpr.plan, {"scene": scene} | plan),
        "tour": (
            cdpr.tour,
            {"scene": scene.replace(stations={"a": HERE, "b": THERE}), "stations": ["a", "b"], "start": "a", "returns": False, "order": "best"}
            | {"by": "time", "motion": {"speed": 1.0, "acceleration": 2.0}}
            | {"gap": 0.01, "budget": 1.0, "seed": 0, "orientation": None, "progress": None} | judges | threads,
        ),
        "task": (
            cdpr.task,
            {"scene": laden, "motion": {"speed": 1.0, "acceleration": 2.0}, "rate": 50.0, "gap": 0.01, "budget": 1.0, "seed": 0, "orientation": None, "progress": None} | judges | threads,
        ),
        "Task.save": (cdpr.task(laden).save, {"folder": "task"}),
        "plan_many": (
            cdpr.plan_many,
            {"scene": scene, "starts": [HERE, HERE], "goals": THERE, "planner": "rrt", "orientation": None, "progress": None}
            | {"executor": None} | level | threads,
        ),
        "replan": (
            cdpr.replan,
            {"scene": scene, "waypoints": [HERE, THERE], "orientations": None, "planner": "two-trees"},
        ),
        "rewind": (cdpr.rewind, along | judges | {"step": 0.1, "order": "both", "repeats": 1}),
        "refine": (cdpr.refine, along | judges | {"orientations": TURNED}),
        "check": (cdpr.check, along | judges | {"orientations": TURNED}),
        "lower_bound": (cdpr.lower_bound, {"scene": scene, "gap": 0.5, "budget": 5.0, "certificate": "bound.json"} | end),
        "load_path": (cdpr.load_path, {"path": "path.json", "scene": scene, "strict": False}),
        "schema": (cdpr.schema, {"of": "scene"}),
        "import_robot": (
            cdpr.import_robot,
            {"path": TESTDATA / "caspr/CoGiRo", "bodies": None, "cable_set": None, "platform": None, "units": "m"},
        ),
        "Scene.shadows": (scene.shadows, regions),
        "Scene.save_shadows": (scene.save_shadows, {"path": "s.obj"} | regions),
        "Scene.example": (cdpr.Scene.example, {"name": "hard1"}),
        "example": (cdpr.example, {"name": "hard1"}),
        "save_example_files": (cdpr.save_example_files, {"folder": "examples", "overwrite": False}),
        "trial_scene": (cdpr.trial_scene, {"experiment": EXPERIMENT, "scenario": EXPERIMENT["scenarios"][0]["name"], "trial": 1}),
        "shadows": (cdpr.shadows, {"scene": scene}),
        "save_shadows": (cdpr.save_shadows, {"path": "s.obj", "scene": scene}),
        "show": (cdpr.show, along | {"orientations": None, "interference": "exact", "live": True}),
        "save_mjcf": (cdpr.save_mjcf, {"path": "m.xml", "scene": held, "motion": None, "control": "tension", "strict": False}),
        "save_view": (cdpr.save_view, along | {"path": "v.html", "orientations": None, "interference": "exact", "live": True}),
        "run_batch": (cdpr.run_batch, experiment),
        "figures.scene": (
            cdpr.figures.scene,
            {"scene": scene, "path": path, "at": HERE, "poses": None, "shadows": "cable 1", "robot": True, "labels": True} | figure,
        ),
        "figures.along": (cdpr.figures.along, {"scene": scene, "path": path, "ax": None}),
        "figures.paths": (cdpr.figures.paths, {"scene": scene, "paths": {"a": path}, "robot": False} | figure),
        "figures.model": (cdpr.figures.model, {"scene": scene, "cable": "cable 1", "at": HERE} | figure),
        "figures.rewinding": (
            cdpr.figures.rewinding,
            {"scene": scene, "waypoints": path, "direction": "backward", "step": 0.1} | figure,
        ),
        "figures.available_set": (
            cdpr.figures.available_set,
            {"robot": robot, "position": [0, 0, 2.0], "kind": "force"} | loads | figure,
        ),
        "figures.workspace": (
            cdpr.figures.workspace,
            {"workspace": cdpr.workspace(scene, resolution=0.5), "axis": "z", "at": 1.0, "ax": None},
        ),
        "figures.boxes": (
            cdpr.figures.boxes,
            {"data": {"a": [1.0, 2.0]}, "measure": "cost", "scenario": None, "methods": None, "label": "length", "ax": None},
        ),
        "figures.step_sweep": (cdpr.figures.step_sweep, {"batch": sweep("step"), "measure": "reduction", "ax": None}),
        "figures.repeats": (cdpr.figures.repeats, {"batch": sweep("repeats"), "measure": "reduction", "ax": None}),
        "figures.convergence": (
            cdpr.figures.convergence,
            {"batch": sweep("history"), "scenario": "a", "methods": ["RRT"], "best": 1.0, "ax": None},
        ),
        "figures.trajectory": (cdpr.figures.trajectory, {"trajectory": motion, "ax": None}),
        "figures.style": (cdpr.figures.style, {}),
        "ompl.simple_setup": (cdpr.ompl.simple_setup, {"scene": scene} | end | level | judges),
        "ompl.PoseSpace": (cdpr.ompl.PoseSpace, {"scene": scene}),
        "ompl.solve": (cdpr.ompl.solve, {"setup": solved(scene), "seconds": 0.01}),
        "ompl.path": (cdpr.ompl.path, {"setup": solved(scene)}),
        "ompl.StateSpace": (cdpr.ompl.StateSpace, {"scene": scene}),
        "ompl.StateValidityChecker": (cdpr.ompl.StateValidityChecker, {"information": information, "scene": scene} | judges),
        "ompl.MotionValidator": (cdpr.ompl.MotionValidator, {"information": information, "scene": scene} | judges),
    }


def solved(scene):
    setup = cdpr.ompl.simple_setup(scene)
    assert cdpr.ompl.solve(setup, 10.0)
    return setup


@functools.cache
def sweep(what):
    """A run that can be drawn."""
    swept = {"step": {"step": [0.1, 0.2]}, "repeats": {"repeats": [1, 2]}}.get(what)
    method = {"name": "RRT", "planner": "rrt"} | ({} if swept is None else {"sweep": swept})
    return cdpr.run_batch(EXPERIMENT | {"history": what == "history", "methods": [method]})


def called(call, arguments):
    if "names" in arguments:
        return call(arguments["names"])
    return call(**arguments)


def outcome(call, arguments):
    """What went wrong if anything but our exceptions was raised; None otherwise."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", cdpr.CdprWarning)
        try:
            called(call, arguments)
        except cdpr.InternalError as bug:
            return f"InternalError: {bug}"
        except cdpr.CdprError:
            return None
        except BaseException as other:  # noqa: BLE001 (PanicException is not an Exception)
            return f"{type(other).__name__}: {other!a}"[:300]
        finally:
            pyplot.close("all")
    return None


def public():
    """Names of functions, of classes that users create, and of the methods of all."""
    for name in cdpr.__all__:
        thing = getattr(cdpr, name)
        if inspect.isfunction(thing) or (inspect.isclass(thing) and not issubclass(thing, Exception) and name not in RESULTS):
            yield name
        if not inspect.isclass(thing) or issubclass(thing, Exception):
            continue
        for key, member in vars(thing).items():
            if not key.startswith("_") and isinstance(member, (classmethod, staticmethod, type(public))):
                yield f"{name}.{key}"


# Methods without parameters besides `self`.
WITHOUT_ARGUMENTS = {"Report.to_pandas", "Result.history_to_pandas", "SearchTree.to_pandas", "Tensions.to_pandas", "View.open"}
WITHOUT_ARGUMENTS |= {"Trajectory.to_pandas", "Workspace.to_pandas", "WrenchMap.to_pandas"}


def test_every_public_function_is_called_with_all_its_parameters(calls):
    drawn = {f"figures.{name}" for name in cdpr.figures.__all__ if callable(getattr(cdpr.figures, name))}
    others = {f"ompl.{name}" for name in cdpr.ompl.__all__}
    assert (set(public()) - WITHOUT_ARGUMENTS) | drawn | others == set(calls)
    for name, (call, arguments) in calls.items():
        parameters = inspect.signature(call).parameters.values()
        known = [p.name for p in parameters if not p.name.startswith("_") and p.kind is not p.VAR_KEYWORD]
        assert sorted(known) == sorted(arguments), name
        if name == "plan":
            arguments = arguments | {"target_cost": None}
        assert outcome(call, arguments) is None, name


@pytest.mark.long
def test_bad_arguments_raise_only_exceptions_of_the_package(calls, hard1):
    found = []
    for name, (call, arguments) in calls.items():
        for key in arguments:
            for what, value in hostile(hard1).items():
                if key in CALLBACKS and callable(value):
                    continue
                wrong = outcome(call, arguments | {key: value})
                if wrong is not None:
                    found.append(f"{name}({key}={what}): {wrong}")
    assert not found, "\n".join(found)


def numeric(value):
    """Whether a valid argument is a number or an array of numbers."""
    if isinstance(value, (bool, str)) or value is None:
        return False
    try:
        return np.asarray(value).dtype.kind in "if" and np.asarray(value).size > 0
    except ValueError:
        return False


def disguised(value):
    """Values that NumPy would silently accept as the number or array."""
    array = np.asarray(value, dtype=np.float64)
    yield "text", array.astype(str).tolist()
    yield "array of texts", array.astype(str)
    yield "truth", array.astype(bool).tolist()
    yield "array of truths", array.astype(bool)
    mask = np.zeros(array.shape, dtype=bool)
    mask.flat[-1] = True
    yield "masked", np.ma.array(array, mask=mask)


def test_texts_booleans_and_masked_entries_are_not_accepted_as_numbers(calls):
    taken = []
    for name, (call, arguments) in calls.items():
        for key in filter(lambda key: numeric(arguments[key]), arguments):  # noqa: B023
            for what, value in disguised(arguments[key]):
                try:
                    called(call, arguments | {key: value})
                except cdpr.InputError:
                    continue
                taken.append(f"{name}({key}={what})")
    assert not taken, "\n".join(taken)


def test_a_scene_given_as_a_robot_or_a_robot_as_a_scene_is_refused(hard1):
    with pytest.raises(cdpr.InputError, match=r"robot: found a Scene, expected a Robot; its robot is scene\.robot"):
        cdpr.capacity_margin(hard1, [1, 1, 1])
    with pytest.raises(cdpr.InputError, match=r"robot: found a Scene"):
        hard1.replace(robot=hard1)
    with pytest.raises(cdpr.InputError, match=r"scene: found a Robot, expected a Scene; cdpr\.Scene\(robot, workspace=\.\.\.\)"):
        cdpr.plan(hard1.robot)
    with pytest.raises(cdpr.InputError, match="scene: found a Robot"):
        cdpr.save_view("view.html", hard1.robot)


def test_messages_name_what_was_found(hard1):
    for call, words in [
        (lambda: cdpr.Robot([[0, 0, 1]], [[0, 0, 0]], [[[0, 0, 0]]], tensions="abc"), "tensions: found the text 'abc'"),
        (lambda: cdpr.Scene.from_dict("abc"), "scene: found the text 'abc', expected a mapping"),
        (lambda: hard1.save(5), "path: found 5, expected the name of a file"),
        (lambda: cdpr.plan(hard1, planner="\ud800"), r"planner: found '\\ud800', half of a surrogate pair"),
        (lambda: cdpr.plan(hard1, keep_going=np.ones(3)), "keep_going: found an array of shape \\(3,\\), expected True or False"),
        (lambda: cdpr.plan(hard1, planner=np.ones(3)), "planner: found an array of shape \\(3,\\), expected a text"),
        (lambda: hard1.states_valid(np.ma.masked_less([[1.0, 1, 0]], 0.5)), "points: found masked entries"),
        (lambda: hard1.replace(clearances={("cable 1", "pillar"): np.nan}), r"clearances\[.*\]: found nan, expected a finite"),
        (lambda: cdpr.Scene.from_dict({"obstacles": [{"box": [1, float("inf"), 1]}]}), r"obstacles\[0\]\.box\[1\]: found inf"),
        (lambda: cdpr.check(hard1, [["0", "1", "0"]]), "waypoints: found the text '0'"),
    ]:
        with pytest.raises(cdpr.InputError, match=words):
            call()
