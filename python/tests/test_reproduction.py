"""The tables of docs/reproduction.md are those of their experiments."""

import importlib.util
import json
import subprocess
import sys
import tomllib

import numpy as np
import pytest
from conftest import ROOT, TESTDATA, program

import cdpr

SPEC = importlib.util.spec_from_file_location("reproduction", ROOT / "docs/reproduction/make.py")
make = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(make)
recording = sys.modules["recording"]  # beside it

RESULTS = {file.stem: json.loads(file.read_text()) for file in sorted(make.RESULTS.glob("*.json"))}


def test_the_page_shows_the_numbers_of_the_results():
    page = make.PAGE.read_text()
    assert make.filled(page, make.tables()) == page


def test_the_page_names_every_experiment_that_it_uses():
    page = make.PAGE.read_text()
    assert all(f"`{name}`" in page for name in RESULTS)


@pytest.mark.parametrize("name", RESULTS)
def test_the_first_trials_of_an_experiment_are_those_of_its_results(name, tmp_path):
    file = ROOT / f"experiments/{name}.toml"
    trials = ["--trials", str(recording.FIRST)]
    subprocess.run([program(), "batch", file, "-o", tmp_path / name, "-q", *trials], check=True, capture_output=True)
    again, kept = recording.recorded(tmp_path / name), RESULTS[name]
    assert again["fingerprint"] == kept["fingerprint"], "the experiment has changed since its results: `make reproduction`"
    assert again["first"] == kept["first"]
    assert {entry["n"] for entry in kept["methods"]} == {tomllib.loads(file.read_text())["trials"]}
    places = [[(entry["scenario"], entry["method"]) for entry in found["methods"]] for found in (again, kept)]
    assert places[0] == places[1]
    if "accepted" in kept:
        assert again["accepted"] == kept["accepted"]


@pytest.mark.long
@pytest.mark.parametrize("name", ["table2", "fig7", "fig8", "table2_rank6", "wrench_rank6"])  # the others take minutes
def test_a_whole_experiment_gives_its_results(name, tmp_path):
    command = [program(), "batch", ROOT / f"experiments/{name}.toml", "-o", tmp_path / name, "-q"]
    subprocess.run(command, check=True, capture_output=True)
    again, kept = recording.recorded(tmp_path / name), json.loads(json.dumps(RESULTS[name]))
    seconds = ("planning_seconds", "post_seconds", "compile_seconds")
    for found in (again, kept):
        found["methods"] = [{key: value for key, value in method.items() if key not in seconds} for method in found["methods"]]
        del found["p"]  # some are of times
    assert again == kept


def test_statistics_are_worked_out_as_by_hand(tmp_path):
    head = "scenario,method,trial,status,raw_cost,cost\n"
    rows = [(trial, order, cost) for trial, costs in enumerate([(1.8, 1.6), (1.0, 1.5)]) for order, cost in zip(("backward", "forward"), costs, strict=True)]
    (tmp_path / "trials.csv").write_text(head + "".join(f'a,"m, {order}, repeats 01",{trial},solved,2.0,{cost}\n' for trial, order, cost in rows))
    gaps = recording.order_gaps(recording.rows_of(tmp_path / "trials.csv"))
    backward, forward, apart, largest, one, five, best, difference, _, differ = gaps["1"]
    # Gains 10 and 20 in the first trial, 50 and 25 in the second.
    assert (backward, forward, apart, largest, one, five) == (30.0, 22.5, 17.5, 25.0, 100.0, 100.0)
    assert (best, difference, differ) == (35.0, 7.5, 100.0)
    value, half = make.ratio({"mean": 3.0, "sd": 0.3}, 100, {"mean": 2.0, "sd": 0.4}, 100)
    assert value == 1.5 and half == pytest.approx(1.96 * 1.5 * (0.01**2 + 0.02**2) ** 0.5)
    sides = [("a", {"mean": 199.0, "sd": 28.0}), ("b", {"mean": 200.0, "sd": 28.0})]
    made = make.Run.__new__(make.Run)
    made.of = {("scene", name): {"cost": described, "solved": 100} for name, described in sides}
    across = make.less(*((made, "scene", name, "cost") for name, _ in sides))
    assert across.startswith("0.50 % (−") and " to 4." in across
    assert make.less((made, "scene", "b", "cost"), (made, "scene", "a", "cost")).startswith("0.50 % longer (−")
    history = [{"scenario": "a", "method": "m", "trial": str(k // 2), "samples": str(10 * k)} for k in range(6)]
    assert recording.samples_to_first_path(history) == {"a | m": 20}
    assert [make.digits(x) for x in (0.0, 0.012345, 1.0, 1234.5)] == ["0", "0.0123", "1.00", "1234"]


@pytest.mark.parametrize("name", ["paper", "paper_rank6"])
def test_cables_meet_on_some_motions_of_the_robot_of_full_rank_only(name):
    scene = cdpr.Scene.load(TESTDATA / f"scenes/{'empty' if name == 'paper' else 'empty_rank6'}.toml")
    low, high = scene.workspace
    places = np.random.default_rng(0).uniform(low, high, (20_000, 3))
    starts, goals = places[scene.states_valid(places)][:4000].reshape(2, 2000, 3)
    blocked, swept = (~scene.motions_valid(starts, goals, interference=rule) for rule in ("exact", "swept"))
    ranks = {cdpr.wrench_at(scene, place).rank for place in starts[:50]}
    if name == "paper":
        assert ranks == {5} and not blocked.any()
        return
    assert ranks == {6} and 0.04 < blocked.mean() < 0.08 and 0.8 < swept.mean() < 0.9
    kinds = {scene.explain_motion(start, goal).kind for start, goal in zip(starts[blocked], goals[blocked], strict=True)}
    assert kinds == {"cable-cable"}


@pytest.mark.parametrize("name", ["hard1", "hard3"])
def test_rrt_star_with_the_radius_of_a_step_has_the_nodes_of_rrt(name):
    scene = cdpr.Scene.load(TESTDATA / f"scenes/{name}.toml")
    options = {"post": "none", "proof": False, "max_samples": 500_000}
    for seed in range(1, 5):
        plain, star = (cdpr.plan(scene, planner, seed=seed, **options) for planner in ("rrt", "rrt-star"))
        assert (plain.tree.states == star.tree.states).all() and 0 <= 1 - star.cost / plain.cost < 0.13


@pytest.mark.long
def test_samples_far_apart_miss_cables_that_touch():
    spec = importlib.util.spec_from_file_location("sampled", ROOT / "python/examples/sampled_interference.py")
    sampled = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(sampled)
    rng = np.random.default_rng(1)
    p, u, q, v = rng.normal(size=(4, 500, 3))
    v[:50] = 2 * u[:50]  # parallel
    q[50:100] = p[50:100] + 0.3 * u[50:100] - 0.7 * v[50:100]  # crossing
    found = sampled.segment_distances(p, u, q, v)
    for k in range(500):
        ends = [[p[k], p[k] + u[k]], [q[k], q[k] + v[k]]]
        assert found[k] == pytest.approx(cdpr.distance(*ends), abs=1e-9)
    run = subprocess.run(
        [sys.executable, ROOT / "python/examples/sampled_interference.py"], capture_output=True, text=True, check=True
    )
    page = make.PAGE.read_text()
    assert run.stdout.strip() in page
