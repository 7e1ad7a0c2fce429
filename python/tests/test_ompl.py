"""Planners of OMPL on our checker."""

import gc
import json
import os
import shutil
import signal
import subprocess
import sys
import threading
import weakref
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from conftest import ROOT, TESTDATA
from test_planning import walled

import cdpr
import cdpr.ompl
from ompl import base, geometric

EVERY = ["AORRTC", "BFMT", "BITstar", "BKPIECE1", "FMT", "InformedRRTstar", "KPIECE1", "LBKPIECE1", "PRM", "PRMstar"]
EVERY += ["RRT", "RRTConnect", "RRTstar", "SORRTstar"]


@pytest.fixture
def hard3() -> cdpr.Scene:
    return cdpr.Scene.load(TESTDATA / "scenes/hard3.toml")


def planned(scene, planner, seconds, **options):
    setup = cdpr.ompl.simple_setup(scene, **options)
    setup.setPlanner(getattr(geometric, planner)(setup.getSpaceInformation()))
    cdpr.ompl.solve(setup, seconds)
    return setup


def program():
    """The command `cdpr` as last built, otherwise as installed, if at all."""
    built = [path for path in (ROOT / "target").glob("*/cdpr") if path.is_file()]
    return max(built, key=lambda path: path.stat().st_mtime, default=shutil.which("cdpr"))


def test_rrt_connect_plans_hard3_and_the_path_is_valid(hard3, tmp_path):
    path = cdpr.ompl.path(planned(hard3, "RRTConnect", 20.0))
    assert path.waypoints[0].tolist() == hard3.start.tolist() and path.waypoints[-1].tolist() == hard3.goal.tolist()
    for engine in ("cspace", "gjk"):
        assert cdpr.check(hard3, path, engine=engine).valid
    assert path.cost == pytest.approx(np.linalg.norm(np.diff(path.waypoints, axis=0), axis=1).sum())
    assert cdpr.refine(hard3, path).cost < cdpr.rewind(hard3, path).cost + 1e-3 < path.cost + 1e-3
    path.save(tmp_path / "path.json")
    assert (cdpr.load_path(tmp_path / "path.json", hard3).waypoints == path.waypoints).all()
    if (command := program()) is not None:
        arguments = [command, "check", TESTDATA / "scenes/hard3.toml", tmp_path / "path.json"]
        subprocess.run(arguments, check=True, capture_output=True)


@pytest.mark.parametrize("planner", EVERY)
def test_every_planner_finds_valid_paths(hard1, planner):
    path = cdpr.ompl.path(planned(hard1, planner, 0.5))
    assert cdpr.check(hard1, path).valid and path.cost > 2.435167 - 1e-6  # the shortest known path


@pytest.mark.parametrize("planner", ["BITstar", "RRTstar", "InformedRRTstar"])
def test_an_optimising_planner_goes_on_until_the_path_is_short_enough(hard1, planner):
    setup = cdpr.ompl.simple_setup(hard1)
    objective = base.PathLengthOptimizationObjective(setup.getSpaceInformation())
    objective.setCostThreshold(base.Cost(1.1 * 2.435167))  # of the shortest known path
    setup.setOptimizationObjective(objective)
    setup.setPlanner(getattr(geometric, planner)(setup.getSpaceInformation()))
    cdpr.ompl.solve(setup, 60.0)
    assert 2.435167 - 1e-6 < cdpr.ompl.path(setup).cost <= 1.1 * 2.435167
    assert setup.getLastPlanComputationTime() < 30.0


def test_conditions_of_ompl_and_of_python_end_a_search(hard1):
    setup = cdpr.ompl.simple_setup(hard1)
    setup.setPlanner(geometric.RRTstar(setup.getSpaceInformation()))
    asked = []
    enough = base.PlannerTerminationCondition(lambda: bool(asked.append(1)) or len(asked) > 10_000)
    exact = base.exactSolnPlannerTerminationCondition(setup.getProblemDefinition())
    assert setup.solve(base.plannerOrTerminationCondition(enough, exact))
    assert 0 < len(asked) <= 10_001 and cdpr.check(hard1, cdpr.ompl.path(setup)).valid


def test_simplifying_asks_our_validator_too(hard3):
    setup = planned(hard3, "RRTConnect", 20.0)
    raw = cdpr.ompl.path(setup)
    setup.simplifySolution(1.0)
    shorter = cdpr.ompl.path(setup)
    assert shorter.cost < raw.cost and cdpr.check(hard3, shorter).valid


def test_validity_is_that_of_the_scene_and_exact(hard1):
    setup = cdpr.ompl.simple_setup(hard1)
    information = setup.getSpaceInformation()
    space, states = information.getStateSpace(), information.getStateValidityChecker()
    rng = np.random.default_rng(1)
    points = rng.uniform(0.05, 1.95, (2000, 3))
    ends = points + rng.normal(0.0, 0.1, points.shape)
    made = [space.state(point) for point in points]
    assert [states.isValid(state) for state in made] == hard1.states_valid(points).tolist()
    assert [information.isValid(state) for state in made] == hard1.states_valid(points).tolist()
    found = [information.checkMotion(state, space.state(end)) for state, end in zip(made, ends, strict=True)]
    assert found == hard1.motions_valid(points, ends).tolist() and 200 < sum(found) < 1800
    assert states.clearance(made[0]) == hard1.clearance(points[:1])[0]
    # A thin wall between two samples of any resolution is detected.
    thin = hard1.with_obstacle("foil", [[x, y, z] for x in (0.5, 0.5001) for y in (0.9, 1.1) for z in (0.25, 0.35)])
    near = cdpr.ompl.simple_setup(thin).getSpaceInformation()
    a, b = space.state([0.3, 1.0, 0.3]), space.state([0.7, 1.0, 0.3])
    assert not near.checkMotion(a, b)
    with pytest.raises(cdpr.InputError, match=r"position: found an array of shape \(2,\)"):
        space.state([0.3, 1.0])


def test_a_refused_motion_says_how_far_it_is_valid(hard1):
    motions = cdpr.ompl.simple_setup(hard1).getSpaceInformation()
    space, validator = motions.getStateSpace(), motions.getMotionValidator()
    rng = np.random.default_rng(2)
    points = rng.uniform(0.1, 1.9, (2000, 3))
    starts = points[hard1.states_valid(points)][:300]
    seen = 0
    for start, end in zip(starts, np.roll(starts, 1, axis=0), strict=True):
        last = space.state([0.0, 0.0, 0.0])
        valid, fraction = validator.checkMotionWithLastValid(space.state(start), space.state(end), last)
        assert valid == hard1.motions_valid([start], [end])[0]
        if valid:
            assert fraction == 1.0 and last[0] == 0.0  # not touched
            continue
        seen += 1
        place = np.array([last[0], last[1], last[2]])
        assert place == pytest.approx(start + fraction * (end - start), abs=1e-12)
        assert hard1.motions_valid([start], [place])[0]
        assert not hard1.motions_valid([start], [start + min(fraction + 1e-4, 1.0) * (end - start)])[0]
    assert seen > 50
    assert validator.checkMotionWithLastValid(space.state(starts[0]), space.state([1.0, 1.0, 0.5]), None)[0] is False


def test_bounds_are_where_the_platform_fits(hard1):
    bounds = cdpr.ompl.StateSpace(hard1).getBounds()
    assert list(bounds.low) == pytest.approx([0.075, 0.075, 0.025])
    assert list(bounds.high) == pytest.approx([1.925, 1.925, 1.975])
    with pytest.raises(cdpr.InputError, match="workspace: found one that the platform does not fit into along z"):
        cdpr.ompl.StateSpace(hard1.replace(workspace=[[0, 0, 0], [2, 2, 0.04]]))


def test_what_cannot_be_planned_is_told(hard1):
    bare = hard1.replace(start=None)
    with pytest.raises(cdpr.InputError, match="query.start: found none, expected a position"):
        cdpr.ompl.simple_setup(bare)
    path = cdpr.ompl.path(planned(bare, "RRTConnect", 5.0, start=[0.3, 1.0, 0.4]))
    assert path.waypoints[0].tolist() == [0.3, 1.0, 0.4]
    setup = planned(walled(), "RRTConnect", 0.2)
    with pytest.raises(cdpr.InputError, match="setup: found no path from start to goal"):
        cdpr.ompl.path(setup)
    inside = cdpr.ompl.simple_setup(hard1, start=[1.0, 1.0, 0.5])
    assert not cdpr.ompl.solve(inside, 0.2)
    with pytest.raises(cdpr.InputError, match="seconds: found 0"):
        cdpr.ompl.solve(inside, 0)
    space = base.RealVectorStateSpace(3)
    with pytest.raises(cdpr.InputError, match="expected a setup with a cdpr.ompl.MotionValidator"):
        cdpr.ompl.path(geometric.SimpleSetup(base.SpaceInformation(space)))


def test_a_setup_keeps_what_it_needs_and_no_more(hard1):
    setup = cdpr.ompl.simple_setup(hard1)
    validator = weakref.ref(setup.getSpaceInformation().getMotionValidator())
    gc.collect()
    assert cdpr.ompl.solve(setup, 5.0) and validator() is not None
    del setup
    gc.collect()
    assert validator() is None


@pytest.mark.parametrize("planner", ["RRTConnect", "PRM", "BITstar"])
def test_ctrl_c_ends_any_planner(planner):
    setup = cdpr.ompl.simple_setup(walled())
    setup.setPlanner(getattr(geometric, planner)(setup.getSpaceInformation()))
    timer = threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT))
    with pytest.raises(KeyboardInterrupt):
        timer.start()
        cdpr.ompl.solve(setup, 30.0)
    timer.join()
    assert setup.getLastPlanComputationTime() < 5.0
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_threads_plan_beside_each_other(hard1):
    with ThreadPoolExecutor(3) as pool:
        found = list(pool.map(lambda _: cdpr.ompl.path(planned(hard1, "PRM", 0.5)), range(3)))
    assert all(cdpr.check(hard1, path).valid for path in found)


def test_without_ompl_the_package_says_what_to_install():
    code = """
import sys
sys.modules["ompl"] = None
import cdpr
try:
    import cdpr.ompl
except ImportError as problem:
    print(problem)
"""
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "cdpr.ompl needs the bindings of OMPL 2: pip install 'cdpr[ompl]'"


def test_the_example_runs(tmp_path):
    example = ROOT / "python/examples/ompl_hard3.py"
    run = subprocess.run([sys.executable, example], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert "valid: True" in run.stdout and "leaked" not in run.stderr
    found = json.loads((tmp_path / "path.json").read_text())
    scene = cdpr.Scene.load(TESTDATA / "scenes/hard3.toml")
    assert cdpr.check(scene, found["waypoints"]).valid
