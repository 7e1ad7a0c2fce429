"""Via points, several goals, and boxes of goals."""

import json
import subprocess

import numpy as np
import pytest
from conftest import TESTDATA, program

import cdpr
from cdpr import InputError

HARD1 = TESTDATA / "scenes/hard1.toml"
OVER = [1.0, 1.0, 1.8]
BESIDE = [[1.5, 0.8, 0.2], [1.9, 1.2, 0.4]]


def cdpr_command(*arguments):
    command = [str(word) for word in (program(), *arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)


@pytest.fixture(scope="module")
def scene():
    return cdpr.example("hard1").replace(stations={"over": OVER, "dock": [0.3, 1, 0.3], "low": [0.3, 1, 1.0]})


@pytest.mark.parametrize("via", [[OVER], np.array([OVER]), ["over"], ("over",)])
def test_a_path_passes_its_via_points(scene, via):
    path = cdpr.plan(scene, via=via)
    assert path.solved and path.route == {"via": [path.route["via"][0]]}
    assert path.waypoints[path.route["via"][0]] == pytest.approx(OVER, abs=0)
    assert path.cost > cdpr.plan(scene).cost and cdpr.check(scene, path).valid
    legs = [cdpr.plan(scene, goal=OVER), cdpr.plan(scene, start=OVER)]
    assert path.cost == pytest.approx(sum(leg.cost for leg in legs), rel=1e-12)


def test_the_nearest_of_several_goals_is_reached(scene):
    path = cdpr.plan(scene, goals=[scene.goal, "low"])
    assert path.route == {"via": [], "goal": 1} and path.cost == pytest.approx(0.7)
    assert cdpr.plan(scene, goals=["low"]).route == {"via": []}
    far = cdpr.plan(scene, via=["over"], goals=[scene.goal, "dock"])
    assert far.route["goal"] == 0


def test_a_path_ends_anywhere_in_a_box(scene):
    path = cdpr.plan(scene, goal_box=BESIDE)
    assert np.all(path.waypoints[-1] >= BESIDE[0]) and np.all(path.waypoints[-1] <= BESIDE[1])
    assert path.cost <= cdpr.plan(scene, goal=[1.7, 1, 0.3]).cost
    assert path.route == {"via": []} and cdpr.plan(scene).route is None
    raw = cdpr.plan(scene, "rrt", goal_box=BESIDE, post="none")
    assert raw.cost == raw.raw_cost > path.cost  # nothing is shortened: the end stays where the planner found it


def test_the_fastest_motion_passes_via_points(scene):
    limits = {"speed": 1, "acceleration": 2, "blend": 0.01}
    path = cdpr.plan(scene, via=["over"], minimise="time", motion=limits)
    assert path.waypoints[path.route["via"][0]] == pytest.approx(OVER, abs=0)
    nearest = np.linalg.norm(path.trajectory.positions - OVER, axis=1).min()
    assert nearest < 0.01 + 0.02  # rounded by at most the blend, and sampled every 10 ms


def test_a_saved_path_keeps_its_route(scene, tmp_path):
    path = cdpr.plan(scene, via=["over"], goals=["dock", "low"])
    path.save(tmp_path / "path.json")
    assert json.loads((tmp_path / "path.json").read_text())["route"] == path.route


@pytest.mark.parametrize(
    ("given", "message"),
    [
        ({"via": "over"}, "via: found the text 'over', expected a list of positions and stations"),
        ({"via": 3}, "via: found 3"),
        ({"via": [1, 1, 1.8]}, r"via\[0\]"),
        ({"via": ["ovre"]}, "did you mean"),
        ({"goals": ["low"], "goal": "dock"}, "goals: found with goal, expected one of the two"),
        ({"goal_box": BESIDE, "goal": "dock"}, "goal_box: found with goal"),
        ({"goal_box": BESIDE, "goals": ["low"]}, "goal_box: found with a goal"),
        ({"goal_box": BESIDE[::-1]}, "goal_box: found .* expected the smaller coordinates first"),
        ({"goal_box": BESIDE[:1]}, "goal_box: found 1 rows, expected 2"),
        ({"goal_box": [[0, 0, np.nan], [1, 1, 1]]}, "goal_box"),
        ({"via": ["over"], "maximise": "clearance"}, "maximise: found with via"),
        ({"via": ["over"], "target_cost": 3}, "target_cost: found with via points"),
    ],
)
def test_what_makes_no_route_is_refused(scene, given, message):
    with pytest.raises(InputError, match=message):
        cdpr.plan(scene, **given)


def test_the_command_plans_routes(tmp_path):
    done = cdpr_command("plan", HARD1, "--via", *OVER, "--via", 1.5, 1, 1.9, "--format", "json", "-o", tmp_path / "path.json")
    answer = json.loads(done.stdout)
    passed = [answer["waypoints"][k] for k in answer["route"]["via"]]
    assert passed == [OVER, [1.5, 1, 1.9]] and answer["lower_bound"] <= answer["cost"]
    assert json.loads((tmp_path / "path.json").read_text())["route"] == answer["route"]
    assert cdpr_command("check", HARD1, tmp_path / "path.json").returncode == 0
    nearest = cdpr_command("plan", HARD1, "--goal", 1.7, 1, 1.7, "--goal", 0.3, 1, 1.0, "--format", "json")
    assert json.loads(nearest.stdout)["route"] == {"via": [], "goal": 1}
    anywhere = cdpr_command("plan", HARD1, "--goal-box", *BESIDE[0], *BESIDE[1], "-q")
    assert anywhere.returncode == 0 and not anywhere.stderr


def test_the_page_of_a_route_does_not_plan_again(tmp_path):
    pages = {"direct": [], "route": ["--via", *OVER]}
    for name, options in pages.items():
        assert cdpr_command("plan", HARD1, *options, "--html", tmp_path / f"{name}.html").returncode == 0
    start, goal = [0.3, 1, 0.3], [1.7, 1, 1.7]
    task = cdpr.example("hard1").replace(task=[{"go": start}, {"via": OVER}, {"go": goal}, {"go": start}])
    task.save(tmp_path / "task.toml")
    assert cdpr_command("task", tmp_path / "task.toml", "-o", tmp_path / "task", "--html").returncode == 0
    sizes = {page.stem: page.stat().st_size for page in tmp_path.rglob("*.html")}
    for route, direct in [("route", "direct"), ("leg-1", "leg-2")]:
        assert sizes[route] < sizes[direct] - 500_000  # it has no planner, which knows no via points


def test_the_command_says_what_it_does_not_write_or_combine(tmp_path):
    proof = tmp_path / "proof.json"
    done = cdpr_command("plan", HARD1, "--via", *OVER, "--proof", proof)
    assert done.returncode == 0 and not proof.exists() and "was not written" in done.stderr
    for options, message in [
        (["--via", 1, 1], "--via: found 1 1, expected X Y Z"),
        (["--via", *OVER, "--maximise", "clearance"], "cannot be used with"),
        (["--goal", *OVER, "--goal", 1.7, 1, 1.7, "--maximise", "clearance"], "--goal: found 2 with --maximise"),
        (["--goal-box", 1, 1, 1, 0, 0, 0], "--goal-box: found"),
        (["--goal-box", *BESIDE[0], *BESIDE[1], "--goal", *OVER], "cannot be used with"),
        (["--via", *OVER, "--target-cost", 3], "--target-cost: found with via points"),
    ]:
        refused = cdpr_command("plan", HARD1, *options)
        assert refused.returncode == 2 and message in refused.stderr
    invalid = cdpr_command("plan", HARD1, "--via", 1, 1, 1)
    assert invalid.returncode == 1 and "via point 1 is not valid: the platform meets pillar" in invalid.stdout
