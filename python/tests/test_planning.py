"""Planning, rewinding, checking, files, distances, Ctrl-C."""

import json
import math
import os
import warnings
import pickle
import signal
import subprocess
import sys
import threading
import time
from contextlib import nullcontext

import numpy as np
import pytest
from conftest import ROOT, TESTDATA

import cdpr

AT_ONCE = 0.1  # s
LOST = 10.0  # s


def test_planning_is_reproducible_and_the_path_is_valid(hard1):
    result = cdpr.plan(hard1, "modified-rrt", seed=3)
    assert result.solved and result.status == "solved" and result.reason is None
    assert result.waypoints.shape[1] == 3 and result.waypoints.dtype == np.float64
    assert result.waypoints[0].tolist() == [0.3, 1.0, 0.3] and result.waypoints[-1].tolist() == [1.7, 1.0, 1.7]
    length = np.linalg.norm(np.diff(result.waypoints, axis=0), axis=1).sum()
    assert length == pytest.approx(result.cost) and result.cost <= result.raw_cost
    assert hard1.motions_valid(result.waypoints[:-1], result.waypoints[1:]).all()
    assert set(result.stats) >= {"nodes", "motion_checks", "planning_seconds", "post_seconds"}
    assert (cdpr.plan(hard1, "modified-rrt", seed=3).waypoints == result.waypoints).all()
    assert cdpr.plan(hard1, "modified-rrt", seed=4).cost != result.cost
    raw = cdpr.plan(hard1, "modified-rrt", seed=3, post="none")
    assert raw.cost == raw.raw_cost == result.raw_cost


def test_the_search_tree_is_kept(hard1):
    for planner in ("modified-rrt", "rrt", "rrt-star"):
        found = cdpr.plan(hard1, planner, seed=3, keep_going=True, max_nodes=300)
        states, parents = found.tree
        assert (states.shape, states.dtype) == ((found.stats["nodes"], 3), np.float64)
        assert (parents.shape, parents.dtype) == (states.shape[:1], np.int64)
        assert np.flatnonzero(parents == np.arange(len(parents))).tolist() == [0]  # one root, the start
        assert hard1.motions_valid(states[parents], states).all()
        way, node = [], len(parents) - 1  # the goal
        while node not in way:
            way.append(node)
            node = parents[node]
        assert (states[way[::-1]] == found.raw_waypoints).all()
    assert cdpr.plan(hard1, seed=3, max_samples=5).tree.states.shape[1] == 3  # unsolved, but with a tree
    assert len(cdpr.plan(hard1, start=[1, 1, 0.5]).tree.states) == 0
    again = pickle.loads(pickle.dumps(found))
    assert (again.tree.states == states).all() and (again.tree.parents == parents).all()
    assert again.cost == found.cost and "tree" not in json.loads(found._json)


def test_rewinding_by_hand_is_what_the_plan_does(hard1):
    raw = cdpr.plan(hard1, "modified-rrt", seed=8, post="none")
    both = cdpr.rewind(hard1, raw, step=0.1)
    assert (both.waypoints == cdpr.plan(hard1, "modified-rrt", seed=8).waypoints).all()
    backward = cdpr.rewind(hard1, raw.waypoints, order="backward").cost
    forward = cdpr.rewind(hard1, raw.waypoints, order="forward").cost
    assert both.cost == min(backward, forward)
    alone = cdpr.rewind(hard1, raw, order="backward-only")
    for order in ("Backward", "taut", "none"):
        with pytest.raises(cdpr.InputError, match=f'^order: found "{order}", expected one of both, backward, forward, backward-only'):
            cdpr.rewind(hard1, raw, order=order)
    assert cdpr.rewind(hard1, alone, order="forward-only").cost == backward < alone.cost <= raw.cost
    assert cdpr.plan(hard1, "modified-rrt", seed=8, post="backward-only").cost == alone.cost
    assert cdpr.rewind(hard1, raw, step=0.02, repeats=3).cost <= raw.cost


def test_invalid_start_and_goal_are_reported_in_the_result(hard1):
    result = cdpr.plan(hard1, start=[1, 1, 0.5])
    assert not result.solved and result.status == "start_invalid"
    assert result.waypoints.shape == (0, 3) and math.isnan(result.cost) and math.isnan(result.raw_cost)
    assert result.reason.kind in ("platform-obstacle", "cable-obstacle") and "pillar" in result.reason.culprits
    assert cdpr.plan(hard1, goal=[9, 1, 0.5]).status == "goal_invalid"
    assert cdpr.plan(hard1, max_samples=0).status == "budget_spent"


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"step": -0.1}, "step: found -0.1"),
        ({"step": float("nan")}, "step"),
        ({"budget": 0.0}, "budget"),
        ({"budget": -1.0}, "budget"),
        ({"seed": -1}, "seed"),
        ({"seed": 1.5}, "seed"),
        ({"planner": "rrt", "goal_bias": 2.0}, "goal_bias: found 2, expected a probability"),
        ({"near_radius": 0.3}, "near_radius: found 0.3, but the planner anytime has no such setting"),
        ({"planner": "rrt-connect", "gap": 0.01}, "gap: found 0.01, but the planner rrt-connect has no such setting"),
        ({"gap": -0.01}, "gap: found -0.01"),
        ({"gap": math.nan}, "gap: found nan"),
        ({"planner": "rrt-star", "near_radius": math.nan}, "near_radius: found nan"),
        ({"near_cap": 4.0}, "near_cap: found 4, but the planner anytime has no such setting; only rrt-star has it"),
        ({"planner": "rrt-star", "near_cap": 4.0, "near_radius": 0.3}, "near_cap: found 4 m with near_radius, which"),
        ({"check_goal": True}, "check_goal: found true, but the planner anytime has no such setting; only rrt has it"),
        ({"planner": "rrt", "check_goal": True, "goal_bias": 0.1}, "goal_bias: found 0.1 with check_goal, expected one"),
        ({"planner": "rrt", "check_goal": 1}, "check_goal"),
        ({"planner": "rrt-star", "extend_step": -1.0}, "extend_step: found -1 m"),
        ({"max_nodes": -3}, "max_nodes: found -3"),
        ({"planner": "magic"}, "planner: found \"magic\""),
        ({"post": "sideways"}, "post: found \"sideways\""),
        ({"start": [0, 0]}, "start: found an array of shape"),
        ({"goal": [0, 0, math.inf]}, r"goal\[2\]"),
    ],
)
def test_bad_options_are_refused(hard1, options, message):
    with pytest.raises(cdpr.InputError, match=message):
        cdpr.plan(hard1, **options)


@pytest.mark.parametrize(
    ("options", "found"),
    [
        ({"step": 0.1}, 'step: found with planner="anytime" and post="none"'),
        ({"repeats": 1}, 'repeats: found with planner="anytime" and post="none"'),
        ({"planner": "two-trees", "step": 0.1}, 'step: found with planner="two-trees" and post="taut"'),
        ({"planner": "rrt", "post": "taut", "repeats": 2}, 'repeats: found with planner="rrt" and post="taut"'),
        ({"planner": "rrt", "post": "none", "step": 0.1, "extend_step": 0.2}, 'step: found with planner="rrt" and post="none"'),
    ],
)
def test_options_without_effect_are_refused(hard1, options, found):
    with pytest.raises(cdpr.InputError, match=f"^{found}, where it has no effect; expected "):
        cdpr.plan(hard1, **options)


def test_options_that_have_an_effect_are_accepted(hard1):
    cdpr.plan(hard1, post="both", step=0.2, repeats=2)
    cdpr.plan(hard1, "rrt", post="none", step=0.2, max_samples=100)
    for option in ({"strict": True}, {"interference": "swept"}):
        with pytest.raises(cdpr.InputError, match=f"^{next(iter(option))}: found without a path, where it has no effect"):
            cdpr.show(hard1, **option)
    for option in ({"cable_set": "original"}, {"bodies": "bodies.xml"}):
        with pytest.raises(cdpr.InputError, match=f"^{next(iter(option))}: found with a YAML file, where it has no effect"):
            cdpr.import_robot(TESTDATA / "gazebo/caroca.yaml", **option)


@pytest.mark.parametrize(("planner", "options"), [("rrt", {"goal_bias": 0.1}), ("rrt-star", {"near_radius": 0.3})])
def test_other_planners_accept_their_options(hard1, planner, options):
    found = cdpr.plan(hard1, planner, seed=1, **options)
    assert found.solved and cdpr.check(hard1, found).valid
    assert (np.linalg.norm(np.diff(found.raw_waypoints, axis=0), axis=1) < 0.3 + 1e-9).all()
    far = cdpr.plan(hard1, planner, seed=1, **options, extend_step=0.5)
    assert np.linalg.norm(np.diff(far.raw_waypoints, axis=0), axis=1).max() > 0.3  # steps longer than those above
    assert min(found.raw_cost, far.raw_cost) > 2.4


def test_options_of_the_papers_planners_change_the_path(hard1):
    straight = hard1.without("pillar")
    direct = cdpr.plan(straight, "rrt", check_goal=True, post="none")
    assert len(direct.waypoints) == 21 and direct.cost == pytest.approx(1.4 * 2**0.5)
    assert cdpr.plan(straight, "modified-rrt", goal_bias=0.0, max_samples=30, proof=False).status == "budget_spent"
    for planner, options in (("modified-rrt", {"goal_bias": 0.1}), ("rrt", {"check_goal": True}), ("rrt-star", {"near_cap": 4.0})):
        found = cdpr.plan(hard1, planner, seed=1, **options)
        assert found.solved and cdpr.check(hard1, found).valid
        assert found.cost != cdpr.plan(hard1, planner, seed=1, max_samples=500_000).cost


def test_keep_going_shortens_the_path_and_ends(hard1):
    first = cdpr.plan(hard1, "modified-rrt", seed=2)
    longer = cdpr.plan(hard1, "modified-rrt", seed=2, keep_going=True, max_samples=5000)
    assert longer.stats["samples"] == 5000 and longer.raw_cost < first.raw_cost
    reached = cdpr.plan(hard1, "modified-rrt", seed=2, target_cost=first.raw_cost - 1e-3)
    assert reached.raw_cost <= first.raw_cost - 1e-3
    assert cdpr.plan(hard1, "modified-rrt", seed=2, keep_going=True, max_nodes=50).stats["nodes"] in (50, 51)


def test_a_scene_without_a_query_needs_its_ends(hard1):
    spec = hard1.to_dict()
    del spec["query"]
    with pytest.raises(cdpr.InputError, match="query.start"):
        cdpr.plan(cdpr.Scene.from_dict(spec))


def test_check_reports_violations_and_nearest_approach(hard1):
    report = cdpr.check(hard1, [[0.3, 1, 0.3], [0.3, 1, 0.4], [1.7, 1, 1.7]])
    assert not report.valid and report.length == pytest.approx(0.1 + math.hypot(1.4, 1.3))
    assert all(violation.segment == 1 for violation in report.violations)
    platform = next(v for v in report.violations if v.kind == "platform-obstacle")
    assert platform.at == pytest.approx(0.475 / 1.4) and platform.culprits == ("platform", "pillar")
    good = cdpr.check(hard1, cdpr.plan(hard1))
    assert good.valid and good.violations == () and good.min_clearance["value"] > 0


def test_path_files_round_trip_and_belong_to_their_scene(hard1, empty, tmp_path):
    result = cdpr.plan(hard1)
    for name in ("path.json", "path.csv"):
        result.save(tmp_path / name)
        assert (cdpr.load_path(tmp_path / name, hard1).waypoints == result.waypoints).all()
    assert json.loads((tmp_path / "path.json").read_text())["status"] == "solved"
    with pytest.raises(cdpr.InputError, match="path.json: scene: found a path planned for another scene"):
        cdpr.load_path(tmp_path / "path.json", empty, strict=True)
    with pytest.warns(cdpr.AnotherSceneWarning, match='path.json: the path was planned for another scene: "hard1"'):
        assert (cdpr.load_path(tmp_path / "path.json", empty).waypoints == result.waypoints).all()
    with pytest.raises(cdpr.FileError, match="expected .json or .csv"):
        result.save(tmp_path / "path.txt")
    with pytest.raises(cdpr.FileError, match="cannot be written"):
        result.save(tmp_path / "nofolder" / "path.json")
    cdpr.rewind(hard1, result).save(tmp_path / "rewound.json")
    assert sorted(os.listdir(tmp_path)) == ["path.csv", "path.json", "rewound.json"]


@pytest.mark.parametrize("waypoints", [[], np.empty((0, 3)), [[0.3, 1, 0.3]], [[0, 0], [1, 1]]])
def test_arrays_that_are_no_paths_are_refused(hard1, waypoints):
    for ask in (cdpr.rewind, cdpr.check):
        with pytest.raises(cdpr.InputError, match="waypoints"):
            ask(hard1, waypoints)


def test_rewinding_a_path_in_collision_says_where(hard1):
    with pytest.raises(cdpr.InputError, match=r"waypoints\[0\]: the segment that starts here is not valid: .* pillar"):
        cdpr.rewind(hard1, [[0.3, 1, 0.3], [1.7, 1, 1.7]])


def test_a_page_is_written(hard1, tmp_path):
    for name, what in (("plain", None), ("planned", cdpr.plan(hard1)), ("bad", [[0.3, 1, 0.3], [1.7, 1, 1.7]])):
        cdpr.save_view(tmp_path / f"{name}.html", hard1, what)
        page = (tmp_path / f"{name}.html").read_text()
        assert page.startswith("<!doctype html>") and "https://" not in page.split('id="cdpr-data">')[1].split("</script>")[0]


def test_distances_of_any_two_dimensions():
    point, segment = [[0, 0, 3]], [[-1, 0, 2], [1, 0, 2]]
    triangle = [[-1, -1, 0], [1, -1, 0], [0, 2, 0]]
    square = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]
    cube = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * 0.5
    assert cdpr.distance(point, segment) == pytest.approx(1.0)
    assert cdpr.distance(point, triangle) == pytest.approx(3.0)
    assert cdpr.distance(segment, square) == pytest.approx(2.0)
    found = cdpr.distance(segment, cube)
    assert found == pytest.approx(1.5) and not found.intersects and found.depth == 0
    assert found.points[:, 2] == pytest.approx([2.0, 0.5])
    inside = cdpr.distance(square, cube)
    assert inside == 0.0 and inside.intersects and inside.depth == pytest.approx(0.5)
    touching = cdpr.distance(cube, cube + [1.0, 0, 0])
    assert touching == 0.0 and touching.intersects and touching.depth == pytest.approx(0, abs=1e-12)
    again = pickle.loads(pickle.dumps(found))
    assert again == found and (again.points == found.points).all()
    with pytest.raises(cdpr.InputError, match="a: found"):
        cdpr.distance([], cube)
    with pytest.raises(cdpr.InputError, match=r"b\[0\]\[0\]"):
        cdpr.distance(cube, [[math.nan, 0, 0]])


def walled():
    """A scene whose wall blocks the platform but not the cables."""
    spec = cdpr.Scene.load(TESTDATA / "scenes/hard1.toml").to_dict()
    spec["obstacles"] = [{"name": "wall", "box": [0.05, 2.0, 2.0], "position": [1, 1, 1]}]
    spec["ignore"] = [[f"cable {k}", "wall"] for k in range(8)]
    return cdpr.Scene.from_dict(spec)


def interrupted_after(seconds, call, raises=KeyboardInterrupt):
    """Run a call, send Ctrl-C after a while, and return the response time: wall-clock and processor time, s.

    Python drops an exception that a signal raises inside a finalizer or a callback of the garbage collector. So if the call
    has not ended after LOST seconds, Ctrl-C is sent again; the response time counts from the first.
    """
    sent, answered = [], threading.Event()

    def send():
        sent.append((time.perf_counter(), time.process_time()))
        os.kill(os.getpid(), signal.SIGINT)
        while not answered.wait(LOST):
            os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(seconds, send)
    try:
        with pytest.raises(raises) if raises else nullcontext():
            timer.start()  # on a busy machine, Ctrl-C may come before the call begins
            call()
        ended = time.perf_counter(), time.process_time()
    finally:
        answered.set()
        timer.join()
    return ended[0] - sent[0][0], ended[1] - sent[0][1]


def assert_ctrl_c_is_answered_at_once(call, threads):
    """A busy machine increases the wall-clock time, so the best of three counts there, but not the processor time."""
    waited, worked = zip(*(interrupted_after(0.2, call) for _ in range(3)), strict=True)
    assert min(waited) < AT_ONCE and max(worked) < AT_ONCE * threads, (waited, worked)


def test_ctrl_c_is_answered_at_once():
    scene = walled()
    # Seconds of work, so that nothing finishes before it is interrupted; prepared before the clock starts, since NumPy
    # does not respond to Ctrl-C.
    points = np.random.default_rng(0).uniform(0.1, 1.9, (3_000_000, 3))
    back = points[::-1].copy()
    assert_ctrl_c_is_answered_at_once(lambda: cdpr.plan(scene, max_samples=10**12, proof=False), threads=1)
    assert_ctrl_c_is_answered_at_once(lambda: scene.motions_valid(points, back, engine="gjk", threads=1), threads=1)
    assert_ctrl_c_is_answered_at_once(lambda: scene.states_valid(points, engine="gjk", threads=2), threads=2)


def crowded(count=300):
    """A hall with many boxes on its floor below a robot suspended from its ceiling, and 2 cm of clearance."""
    rng = np.random.default_rng(7)
    spec = cdpr.Scene.load(TESTDATA / "scenes/forest.toml").to_dict()
    low, high = np.array(spec["workspace"]["min"]), np.array(spec["workspace"]["max"])
    places = low + rng.uniform(0.05, 0.95, (count, 3)) * (high - low)
    places[:, 2] = low[2] + 0.1
    spec["obstacles"] = [{"name": f"box {k}", "box": [0.1, 0.1, 0.2], "position": p.tolist()} for k, p in enumerate(places)]
    spec["clearance"] = 0.02
    return cdpr.Scene.from_dict(spec)


def test_ctrl_c_ends_every_long_call_at_once(tmp_path):
    scene, large = crowded(), crowded(1000)
    middle = scene.workspace.mean(axis=0)
    waypoints = middle + np.random.default_rng(0).uniform(-0.01, 0.01, (200_000, 3))
    sphere = np.random.default_rng(0).normal(size=(300_000, 3))
    sphere /= np.linalg.norm(sphere, axis=1)[:, None]

    def again_and_again(call):
        def calls():
            while True:
                call()

        return calls

    # Each takes a while; calls that take less than the time until Ctrl-C are repeated.
    calls = (
        lambda: cdpr.check(large, waypoints, engine="gjk"),
        lambda: cdpr.save_view(tmp_path / "view.html", scene, waypoints),
        lambda: large.shadows(all_regions=True),
        lambda: cdpr.lower_bound(scene),
        lambda: cdpr.distance(sphere, sphere + 3.0),
    )
    for call in calls:
        waited = [interrupted_after(0.2, again_and_again(call))[0] for _ in range(3)]
        assert min(waited) < 2 * AT_ONCE, waited
    assert not any(tmp_path.iterdir())


@pytest.mark.parametrize("budget", [0.001, 0.005, 0.05])
def test_a_budget_counts_from_the_call(budget):
    def late(planner):
        time.sleep(0.1)  # lets other tests use the processors first
        scene = crowded()
        began = time.perf_counter()
        cdpr.plan(scene, planner, budget=budget)
        return time.perf_counter() - began - budget

    for planner in ("anytime", "two-trees", "rrt-connect", "modified-rrt", "rrt", "rrt-star"):
        lateness = (late(planner) for _ in range(20))  # milliseconds are soon lost on a busy machine
        assert any(late < 0.02 for late in lateness), planner


def test_a_long_path_is_checked_in_less_than_seconds(hard1):
    waypoints = np.linspace([0.3, 1.0, 0.3], [0.3, 1.0, 1.3], 60_001)
    began = time.perf_counter()
    report = cdpr.check(hard1, waypoints)
    assert report.valid and time.perf_counter() - began < 10.0  # of 40 s if every condition of every segment is tested
    whole = cdpr.check(hard1, waypoints[[0, -1]])
    assert report.min_clearance["value"] == pytest.approx(whole.min_clearance["value"], abs=1e-9)


def test_ctrl_c_ends_anytime_with_its_best_path(hard1):
    found = []
    interrupted_after(0.3, lambda: found.append(cdpr.plan(hard1, budget=20.0)), raises=None)
    assert found[0].solved and found[0].stats["planning_seconds"] < 10
    assert found[0].cost < 2.44 and cdpr.check(hard1, found[0]).valid


@pytest.mark.parametrize("planner", ["two-trees", "rrt-connect", "modified-rrt", "rrt", "rrt-star"])
def test_ctrl_c_keeps_the_best_path_of_every_planner(hard1, planner):
    bias = {"goal_bias": 0.1} if planner in ("rrt", "rrt-star") else {}
    first = cdpr.plan(hard1, planner, **bias).stats["planning_seconds"]
    found = []
    after = 0.5 + 5 * first
    endless = {"keep_going": True, "max_samples": 10**9}
    interrupted_after(after, lambda: found.append(cdpr.plan(hard1, planner, **bias, **endless)), raises=None)
    assert found[0].solved and cdpr.check(hard1, found[0]).valid


def soonest(call, within, tries=20):
    """The result of a call and its time in seconds: the first that takes less than `within`, since the machine may be busy."""
    for _ in range(tries):
        began = time.perf_counter()
        result = call()
        taken = time.perf_counter() - began
        if taken < within:
            break
        time.sleep(0.1)
    return result, taken


@pytest.mark.parametrize("planner", ["anytime", "two-trees", "rrt-connect", "modified-rrt", "rrt", "rrt-star"])
def test_a_time_budget_ends_the_search(planner):
    scene = walled()  # the proof that there is no path takes some 60 ms
    result, taken = soonest(lambda: cdpr.plan(scene, planner, max_samples=10**12, budget=0.02), within=0.5)
    assert result.status == "budget_spent" and result.history == () and math.isnan(result.cost)
    assert 0.02 <= taken < 0.5 and result.stats["planning_seconds"] <= taken


def test_the_default_planner_finds_the_best_known_paths(hard1):
    hard3 = cdpr.Scene.load(TESTDATA / "scenes/hard3.toml")
    for scene, best in ((hard1, 2.435167), (hard3, 2.656139)):
        result = cdpr.plan(scene)
        assert result.cost == pytest.approx(best, rel=1e-3) and result.cost > best - 1e-5
        assert cdpr.check(scene, result, engine="gjk").valid
        assert (cdpr.plan(scene, "anytime", seed=0).waypoints == result.waypoints).all()
        assert (result.raw_waypoints == result.waypoints).all()  # already taut: nothing is changed


def test_the_forest_has_a_way_that_is_not_straight():
    forest = cdpr.Scene.load(TESTDATA / "scenes/forest.toml")
    query = forest.to_dict()["query"]
    assert not forest.motions_valid([query["start"]], [query["goal"]]).any()
    for planner in ("anytime", "rrt-connect", "modified-rrt"):
        for engine in ("cspace", "gjk"):
            assert cdpr.check(forest, cdpr.plan(forest, planner), engine=engine).valid
    way = cdpr.tensions_along(forest, cdpr.plan(forest, "rrt-connect"))
    assert (way.capacity_margin > 0).all()  # the robot can carry its platform there


def test_anytime_uses_its_budget_and_its_targets(hard1):
    spent, taken = soonest(lambda: cdpr.plan(hard1, budget=0.1), within=1.0)
    assert 0.1 <= taken < 1.0 and spent.stats["planning_seconds"] <= taken
    far = cdpr.plan(hard1, target_cost=2.6, budget=20.0)
    assert far.cost <= 2.6 and far.stats["planning_seconds"] < 10
    assert cdpr.plan(hard1, gap=0.5, budget=20.0).stats["planning_seconds"] < 10
    again = [cdpr.plan(hard1, seed=5, max_samples=3000, keep_going=True) for _ in range(2)]
    assert (again[0].waypoints == again[1].waypoints).all() and again[0].stats["samples"] == 3000


def test_every_improvement_is_reported_and_recorded(hard1):
    for seed in range(5):
        told = []
        result = cdpr.plan(hard1, seed=seed, on_improvement=lambda *improvement, told=told: told.append(improvement))
        seconds, costs, paths = zip(*told, strict=True)
        assert len(costs) >= 2 and list(costs) == sorted(set(costs), reverse=True) and list(seconds) == sorted(seconds)
        assert costs[-1] == result.cost and (paths[-1] == result.waypoints).all()
        for cost, path in zip(costs, paths, strict=True):
            assert path.dtype == np.float64 and cost == pytest.approx(np.linalg.norm(np.diff(path, axis=0), axis=1).sum())
            assert cdpr.check(hard1, path).valid
        assert [milestone.cost for milestone in result.history] == list(costs)
        assert [milestone.seconds for milestone in result.history] == list(seconds)
        assert result.history[-1].samples <= result.stats["samples"]


def test_an_exception_in_a_callback_is_raised(hard1):
    calls = []

    def refuse(seconds, cost, waypoints):
        calls.append(cost)
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        cdpr.plan(hard1, budget=20.0, on_improvement=refuse)
    assert len(calls) == 1


def test_planners_of_the_paper_keep_their_history_too(hard1):
    for planner, options in (("modified-rrt", {}), ("rrt-star", {"near_radius": 0.3})):
        first = cdpr.plan(hard1, planner, seed=1, post="none", **options)
        assert [milestone.cost for milestone in first.history] == [pytest.approx(first.cost)]
        told = []
        options |= {"keep_going": True, "max_samples": 10_000, "on_improvement": lambda *better, told=told: told.append(better)}
        longer = cdpr.plan(hard1, planner, seed=1, post="none", **options)
        costs = [milestone.cost for milestone in longer.history]
        assert [cost for _, cost, _ in told] == costs and (told[-1][2] == longer.waypoints).all()
        assert len(costs) > 1 and costs == sorted(set(costs), reverse=True)
        assert costs[-1] == pytest.approx(longer.cost, rel=1e-12)


def test_refining_makes_a_path_taut_and_never_longer(hard1):
    for seed in range(20):
        for planner in ("modified-rrt", "rrt-connect"):
            raw = cdpr.plan(hard1, planner, seed=seed, post="none")
            taut = cdpr.refine(hard1, raw)
            assert taut.cost <= raw.cost and cdpr.check(hard1, taut).valid
            assert (taut.waypoints[[0, -1]] == raw.waypoints[[0, -1]]).all()
            assert cdpr.refine(hard1, taut.waypoints).cost <= taut.cost
            assert (cdpr.plan(hard1, planner, seed=seed, post="taut").waypoints == taut.waypoints).all()
    assert taut.cost < cdpr.rewind(hard1, raw, step=0.1).cost - 1e-3
    with pytest.raises(cdpr.InputError, match=r"waypoints\[0\]: the segment that starts here is not valid: .* pillar"):
        cdpr.refine(hard1, [[0.3, 1, 0.3], [1.7, 1, 1.7]])


def test_import_needs_numpy_alone():
    code = "import sys, cdpr; print([m for m in sys.modules if m.split('.')[0] in ('matplotlib', 'pandas', 'scipy', 'dask', 'ompl')])"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.strip() == "[]"


def test_the_example_runs(tmp_path):
    example = ROOT / "python/examples/plan_one.py"
    run = subprocess.run([sys.executable, example], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert "valid: True" in run.stdout
    assert (tmp_path / "path.json").exists() and (tmp_path / "view.html").exists()


def test_algorithm_2_as_printed_may_not_end():
    example = ROOT / "python/examples/algorithm_2.py"
    run = subprocess.run([sys.executable, example], capture_output=True, text=True, check=True)
    assert [line.split()[-1] for line in run.stdout.splitlines()] == ["True", "False", "None", "None"]


def test_a_path_of_another_scene_causes_a_warning(hard1, tmp_path):
    path = cdpr.plan(hard1)
    edited = hard1.without("pillar")
    asks = [
        lambda **strict: cdpr.check(edited, path, **strict),
        lambda **strict: cdpr.refine(edited, path, **strict),
        lambda **strict: cdpr.rewind(edited, path, **strict),
        lambda **strict: cdpr.save_view(tmp_path / "view.html", edited, path, **strict),
    ]
    for ask in asks:
        with pytest.warns(cdpr.AnotherSceneWarning, match="planned for another scene") as told:
            ask()
        assert [warning.filename for warning in told] == [__file__]
        with pytest.raises(cdpr.InputError, match="planned for another scene"):
            ask(strict=True)
    with pytest.warns(cdpr.AnotherSceneWarning):
        assert len(cdpr.tensions_along(edited, path, step=0.1).positions) > 10
    # No warning without data that depends on the scene, or if only irrelevant properties differ.
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert cdpr.check(edited, path.waypoints).valid
        assert cdpr.check(hard1.replace(name="other", start=None), path, strict=True).valid
        assert cdpr.check(edited, cdpr.Path(path.waypoints, path.cost)).valid


def test_a_lower_bound_reaches_the_gap_that_is_asked_for(hard1):
    hard3 = cdpr.Scene.load(TESTDATA / "scenes/hard3.toml")
    for scene, cost in ((hard1, 2.435167), (hard3, 2.656138)):
        bound = cdpr.lower_bound(scene, gap=0.001)
        assert cost / 1.0011 < bound <= cost + 1e-6
        assert cdpr.lower_bound(scene) <= bound
        assert cdpr.lower_bound(scene, gap=0.001, start=scene.goal, goal=scene.start) == pytest.approx(bound, rel=1e-3)
    with pytest.raises(cdpr.InputError, match="gap"):
        cdpr.lower_bound(hard1, gap=-1.0)
    with pytest.raises(cdpr.InputError, match="budget"):
        cdpr.lower_bound(hard1, budget=0.0)
    assert cdpr.lower_bound(walled(), gap=0.01) == math.inf


def test_a_gap_is_reached_and_the_lower_bound_confirms_it():
    hard3 = cdpr.Scene.load(TESTDATA / "scenes/hard3.toml")
    result = cdpr.plan(hard3, "anytime", gap=0.001)
    assert result.cost <= 1.0011 * cdpr.lower_bound(hard3, gap=0.001)
