"""Reprs, equality, hashing, pickling and copying of all objects that the package returns."""

import concurrent.futures
import copy
import multiprocessing
import pickle
import warnings

import numpy as np
import pytest
from conftest import TESTDATA

import cdpr

EXPERIMENT = {
    "version": 1,
    "trials": 3,
    "scenarios": [{"name": "pillar", "scene": str(TESTDATA / "scenes/hard1.toml")}],
    "methods": [{"name": "RRT", "planner": "rrt"}],
}
# The complete repr of each class, which must stay short.
REPRS = {
    "Robot": "Robot('paper', 8 cables)",
    "Scene": "Scene('hard1', 8 cables, 1 obstacle)",
    "Path": "Path(2.4352 m, 3 waypoints)",
    "Result": "Result('solved', 2.4352 m, 3 waypoints)",
    "Report": "Report(9 violations, 1.9799 m)",
    "Violation": "Violation('cable-obstacle', cable 1 / pillar, at 0.2668 of segment 0, margin -0.0750 m)",
    "Exemption": "Exemption(pair=('platform', 'pillar'), reason='touch', demanded=0.0, attainable=None, gap=0.0)",
    "Milestone": "Milestone(seconds=0.5, samples=3, cost=2.5)",
    "SearchTree": "SearchTree(2 nodes)",
    "Mesh": "Mesh('cable 0 / pillar', cable-obstacle, 26 triangles, 1.53 m³)",
    "AvailableSet": "AvailableSet(rank 3, margin 1561, 14 vertices)",
    "Trajectory": "Trajectory(1.500 s, 1.0000 m, 151 samples)",
    "MotionState": "MotionState(0.75 s, at [1.0, 1.0, 1.0] m, 1.0000 m/s)",
    "Corner": "Corner(waypoint=1, kind='stop', deviation=0.0, time=0.5, turn=False)",
    "Limiting": "Limiting(start=0.0, end=0.5, limit='cable_speed', cable='cable 3')",
    "Settling": "Settling(displacement=0.013, rotation=0.001)",
    "Tensions": "Tensions(3 rows, 8 cables, 0.2000 m)",
    "WrenchReport": "WrenchReport(not feasible, rank 5 of 6, underconstrained)",
    "PoseEstimate": "PoseEstimate(at [1.0, 0.9, 1.0] m, rank 3 of 3, residuals up to 0.000 mm)",
    "Distance": "2.0",
    "WrenchMap": "WrenchMap(3 x 3 x 3 nodes of 0.9 m, 0.0 % feasible)",
    "Workspace": "Workspace(2.145 to 2.145 m³, 100.00 % decided, 1 part)",
    "Station": "Station(position=array([1.7, 1. , 0.5]), orientation=None)",
    "Tour": "Tour(1.0000 m, 2 stations)",
    "Task": "Task(1.0000 m, 1 leg)",
    "TaskLeg": "TaskLeg((position) to (position), 1.0000 m)",
    "WorkspacePart": "WorkspacePart(1.613, 2096 boxes, start, goal)",
    "Share": "Share(67.86 %, 8 pairs)",
    "Bounds": "Bounds(min=1.0, max=2.0)",
    "BatchResult": "BatchResult('experiment', 3 rows)",
    "View": "View(1 kB)",
    "Proof": "Proof(cable 1 and south, cable 3 and north; 799 boxes)",
}


def make(name):
    """An object of each kind; always the same."""
    scene = cdpr.Scene.load(TESTDATA / "scenes/hard1.toml")
    empty = cdpr.Scene.load(TESTDATA / "scenes/empty.toml")
    along = [[0.3, 1, 0.3], [0.3, 1, 0.5]]
    match name:
        case "Robot":
            return scene.robot
        case "Scene":
            return scene
        case "Path":
            return cdpr.refine(scene, cdpr.plan(scene))
        case "Result":
            return cdpr.plan(scene)
        case "Report":
            return cdpr.check(scene, [[0.3, 1, 0.3], [1.7, 1, 1.7]])
        case "Violation":
            return cdpr.check(scene, [[0.3, 1, 0.3], [1.7, 1, 1.7]]).violations[0]
        case "Exemption":
            return cdpr.Exemption(("platform", "pillar"), "touch", 0.0, None, 0.0)
        case "Milestone":
            return cdpr.Milestone(0.5, 3, 2.5)
        case "SearchTree":
            return cdpr.SearchTree(np.eye(2, 3), np.array([0, 0]))
        case "Mesh":
            return scene.shadows()["cable 0 / pillar"]
        case "AvailableSet":
            return cdpr.force_set(empty.robot, [1, 1, 1])
        case "Trajectory":
            return cdpr.trajectory(empty, [[0.5, 1, 1], [1.5, 1, 1]], speed=1, acceleration=2)
        case "MotionState":
            return make("Trajectory").at(0.75)
        case "Corner":
            return cdpr.Corner(1, "stop", 0.0, 0.5)
        case "Limiting":
            return cdpr.Limiting(0.0, 0.5, "cable_speed", "cable 3")
        case "Settling":
            return cdpr.Settling(0.013, 0.001)
        case "Tensions":
            return cdpr.tensions_along(empty, along, step=0.1)
        case "WrenchReport":
            return cdpr.wrench_at(empty, [1, 1, 1])
        case "PoseEstimate":
            lengths = empty.robot.cable_lengths([1, 0.9, 1])
            return cdpr.pose_from_lengths(empty.robot, lengths, orientation=[1, 0, 0, 0])
        case "Distance":
            return cdpr.distance([[0, 0, 0]], [[0, 0, 2]])
        case "WrenchMap":
            return cdpr.wrench_map(empty, step=0.9)
        case "Workspace":
            return cdpr.workspace(scene, resolution=0.1)
        case "WorkspacePart":
            return make("Workspace").parts[0]
        case "Share":
            return make("Workspace").shares["cable-obstacle"]
        case "Station":
            return scene.replace(stations={"rack": [1.7, 1, 0.5]}).stations["rack"]
        case "Tour":
            return cdpr.tour(scene.replace(stations={"rack": [1.7, 1, 0.5], "dock": [1.7, 1, 1.5]}))
        case "Task":
            return cdpr.task(scene.replace(start=None, task=[{"go": [1.7, 1, 0.5]}, {"go": [1.7, 1, 1.5]}]))
        case "TaskLeg":
            return make("Task").legs[0]
        case "Bounds":
            return cdpr.Bounds(1.0, 2.0)
        case "BatchResult":
            return cdpr.run_batch(EXPERIMENT)
        case "View":
            return cdpr.View("x" * 1000)
        case "Proof":
            return cdpr.plan(cdpr.Scene.load(TESTDATA / "scenes/closed.toml")).proof
    raise KeyError(name)


# Times differ from run to run.
MEASURED = ("Result", "BatchResult")


def test_every_public_class_has_an_example_here():
    classes = {name for name in cdpr.__all__ if isinstance(getattr(cdpr, name), type)}
    errors = {"AnotherSceneWarning", "CdprError", "CdprWarning", "FileError", "InputError", "InternalError"}
    assert classes - errors == set(REPRS)


@pytest.mark.parametrize("name", REPRS)
def test_every_object_has_a_short_repr(name):
    assert repr(make(name)) == REPRS[name] and len(REPRS[name]) < 100


@pytest.mark.parametrize("name", REPRS)
def test_objects_compare_by_value(name):
    one, other = make(name), make(name)
    assert (one == one) is True and (one != one) is False
    if name not in MEASURED:
        assert (one == other) is True and (one != other) is False
    for stranger in (None, 5, "text", object(), make("Milestone" if name != "Milestone" else "Distance")):
        assert (one == stranger) is False and (one != stranger) is True
    if name in ("Robot", "Scene", "Violation", "Exemption", "Milestone", "Distance", "View", "Corner", "Limiting", "Settling", "Bounds"):
        assert hash(one) == hash(other) and len({one, other}) == 1
    else:
        with pytest.raises(TypeError, match="unhashable"):
            hash(one)


@pytest.mark.parametrize("name", REPRS)
def test_objects_can_be_pickled_and_copied(name):
    one = make(name)
    with warnings.catch_warnings():
        warnings.simplefilter("error")  # a copy has nothing new to report
        copies = [pickle.loads(pickle.dumps(one, protocol)) for protocol in range(pickle.HIGHEST_PROTOCOL + 1)]
        copies += [copy.copy(one), copy.deepcopy(one), copy.deepcopy([one])[0]]
    for again in copies:
        assert type(again) is type(one) and again == one and repr(again) == repr(one)


def test_pickles_keep_arrays_out_of_band():
    result = cdpr.plan(cdpr.Scene.load(TESTDATA / "scenes/hard1.toml"))
    buffers = []
    text = pickle.dumps(result, 5, buffer_callback=buffers.append)
    assert len(buffers) >= 3 and pickle.loads(text, buffers=buffers) == result


def test_a_small_difference_makes_objects_unequal():
    scene, result = make("Scene"), make("Result")
    assert scene.replace(clearance=1e-9) != scene and scene.replace(name="other") != scene
    assert scene.replace(clearance=0.0) == scene.replace(clearance=-0.0)
    assert hash(scene.replace(clearance=0.0)) == hash(scene.replace(clearance=-0.0))
    assert cdpr.Path(np.zeros((2, 3)), 0.0) != cdpr.Path(np.zeros((3, 3)), 0.0)
    assert cdpr.Path(np.zeros((2, 3)), 0.0) != result
    unsolved = [cdpr.Result(np.empty((0, 3)), float("nan"), status="budget_spent") for _ in range(2)]
    assert unsolved[0] == unsolved[1]  # NaN equals NaN
    tree = make("SearchTree")
    assert tree != cdpr.SearchTree(tree.states, np.array([0, 1])) and tree != tuple(tree)


def test_copying_an_immutable_object_returns_the_object():
    scene = make("Scene")
    assert copy.copy(scene) is scene and copy.deepcopy(scene) is scene and copy.deepcopy(scene.robot) == scene.robot


def work(scene, path):
    """In another process: check a path, and return all kinds of objects."""
    report, result = cdpr.check(scene, path), cdpr.plan(scene, "modified-rrt", seed=4)
    return scene, report, result, scene.shadows(), make("WrenchMap")


def test_objects_are_sent_to_spawned_processes_and_back():
    scene, path = make("Scene"), make("Path")
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        again, report, result, shadows, map_ = pool.apply(work, (scene, path))
    assert again == scene and report == cdpr.check(scene, path) and shadows == scene.shadows()
    assert (result.waypoints == cdpr.plan(scene, "modified-rrt", seed=4).waypoints).all()
    assert map_ == make("WrenchMap")


@pytest.mark.parametrize(
    ("what", "shown"),
    [
        (lambda scene: cdpr.plan(scene, max_samples=0), "Result('budget_spent')"),
        (lambda scene: cdpr.plan(scene, goal=[9, 1, 0.5]), "Result('goal_invalid', Violation('workspace', platform,"),
        (lambda scene: cdpr.check(scene, cdpr.plan(scene)), "Report(valid, 2.4352 m)"),
        (lambda scene: cdpr.plan(scene, "modified-rrt").tree, "SearchTree("),
    ],
)
def test_reprs_say_what_is_missing(what, shown):
    assert repr(what(make("Scene"))).startswith(shown)


def fail(how):
    """In another process: an error or a warning of each kind."""
    match how:
        case "InputError":
            cdpr.Scene.from_dict({"version": 1})
        case "FileError":
            cdpr.Scene.load("nowhere.toml")
        case _:
            raise getattr(cdpr, how)("a message")


@pytest.mark.parametrize("how", ["CdprError", "FileError", "InputError", "InternalError", "CdprWarning"])
def test_errors_keep_their_class_across_processes(how, executor):
    with pytest.raises(getattr(cdpr, how)) as problem:
        executor.submit(fail, how).result(timeout=60)
    assert type(problem.value) is getattr(cdpr, how) and len(problem.value.args) == 1 and str(problem.value)


@pytest.fixture(scope="module")
def executor():
    with concurrent.futures.ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn")) as executor:
        yield executor


@pytest.mark.parametrize("name", REPRS)
def test_objects_pass_through_executors(name, executor):
    one = make(name)
    assert executor.submit(copy.copy, one).result(timeout=60) == one


def everything(scene):
    """One call of every kind of long work, on all threads."""
    points = np.random.default_rng(0).uniform(0.3, 1.7, (2, 20_000, 3))
    result = cdpr.plan(scene)
    return [
        scene.motions_valid(*points).sum(),
        scene.clearance(points[0, :500]).sum(),
        cdpr.wrench_map(scene, step=0.4),
        cdpr.tensions_along(scene, result, step=0.1),
        cdpr.check(scene, result),
        scene.shadows(),
        cdpr.lower_bound(scene),
        cdpr.trajectory(scene, result, acceleration=2),
        result.waypoints.tolist(),
    ]


def everything_twice(scene):
    """In a forked process and in a process forked from it."""
    with multiprocessing.get_context("fork").Pool(1) as pool:
        return [everything(scene), pool.apply_async(everything, (scene,)).get(timeout=60)]


@pytest.mark.skipif("fork" not in multiprocessing.get_all_start_methods(), reason="no fork here")
@pytest.mark.filterwarnings("ignore:.*fork:DeprecationWarning")
def test_forked_processes_start_their_own_threads():
    scene = make("Scene")
    expected = everything(scene)  # rayon's threads exist from now on, and a fork does not copy them
    pool = concurrent.futures.ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("fork"))
    try:
        found = pool.submit(everything_twice, scene).result(timeout=120)
    finally:
        for process in pool._processes.values():
            process.kill()
        pool.shutdown(wait=False, cancel_futures=True)
    assert found == [expected, expected]
