"""Experiments from Python: any executor, the same bytes as from the shell, tables with and without pandas."""

import json
import multiprocessing
import pickle
import signal
import subprocess
import sys
import time
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor

import numpy as np
import pandas as pd
import pytest
import scipy.stats
from conftest import ROOT, TESTDATA, program
from test_planning import assert_ctrl_c_is_answered_at_once

import cdpr

EXPERIMENT = {
    "version": 1,
    "name": "small",
    "seed": 5,
    "trials": 70,  # more than there are ranges: some have one trial, the last one fewer than the others
    "scenarios": [
        {"name": "hard1", "scene": TESTDATA / "scenes/hard1.toml"},
        {"name": "drawn", "scene": str(TESTDATA / "scenes/empty.toml"), "random": {"count": 2}},
    ],
    "methods": [
        {"name": "swept, <both>", "sweep": {"post": ["backward", "forward"], "repeats": [1, 2]}},
        {"name": "few samples", "planner": "rrt", "options": {"max_samples": np.int64(1000)}},
    ],
    "t_tests": [{"group": "A", "measure": "raw_cost", "a": ["hard1", "few samples"], "b": ["drawn", "few samples"]}],
}


@pytest.fixture(scope="module")
def one_thread():
    return cdpr.run_batch(EXPERIMENT, threads=1)


def test_tables_of_a_run(one_thread):
    trials, summary = one_thread.trials, one_thread.summary
    assert list(trials.columns[:5]) == ["scenario", "method", "trial", "seed", "status"]
    assert len(trials) == 70 * 2 * 5 and trials["seed"].dtype == np.uint64
    assert set(trials["status"]) == {"solved", "budget_spent", "no_path"}
    assert trials.loc[trials["status"] != "solved", "cost"].isna().all()
    for (scenario, method), rows in trials.groupby(["scenario", "method"]):
        entry = summary[(summary["scenario"] == scenario) & (summary["method"] == method)].iloc[0]
        assert (entry["n"], entry["solved"]) == (70, rows["cost"].count())
        for name, value in (("mean", rows["cost"].mean()), ("sd", rows["cost"].std()), ("q25", rows["cost"].quantile(0.25))):
            assert entry[f"cost_{name}"] == pytest.approx(value, rel=1e-12)
        assert entry["cost_low"] < entry["cost_mean"] < entry["cost_high"]
    assert one_thread.t_tests[0]["group"] == "A" and 0 <= one_thread.t_tests[0]["p"] <= 1
    assert len(one_thread.timings) == len(trials) and (one_thread.timings["planning_seconds"] > 0).all()
    scene = cdpr.Scene.load(TESTDATA / "scenes/hard1.toml")
    row = trials[(trials["scenario"] == "hard1") & (trials["method"] == "few samples")].iloc[3]
    again = cdpr.plan(scene, "rrt", seed=int(row["seed"]), max_samples=1000, proof=False)
    assert again.status == row["status"] and (again.cost == row["cost"] or not again.solved)


@pytest.mark.parametrize("welch", [True, False])
def test_t_tests_are_those_of_scipy(welch):
    measures = ["raw_cost", "cost", "planning_seconds", "post_seconds"]
    pair = {"a": ["hard1", "modified"], "b": ["hard1", "plain"], "variances": "welch" if welch else "pooled"}
    tests = [{"group": measure, "measure": measure, **pair} for measure in measures]
    methods = [{"name": "modified"}, {"name": "plain", "planner": "rrt", "options": {"goal_bias": 0.1}}]
    experiment = {**EXPERIMENT, "scenarios": EXPERIMENT["scenarios"][:1], "methods": methods, "t_tests": tests}
    found = cdpr.run_batch(experiment)
    rows = found.trials.merge(found.timings, on=["scenario", "method", "trial"])
    for test in found.t_tests:
        samples = [rows.loc[rows["method"] == method, test["measure"]].dropna() for method in ("modified", "plain")]
        known = scipy.stats.ttest_ind(*samples, equal_var=not welch)
        for key, value in (("t", known.statistic), ("df", known.df), ("p", known.pvalue)):
            assert test[key] == pytest.approx(value, rel=1e-9), (test["group"], key)


def test_threads_and_executors_of_any_kind_give_the_same_bytes(one_thread):
    assert cdpr.run_batch(EXPERIMENT, threads=2).trials_csv == one_thread.trials_csv
    told = []
    with ThreadPoolExecutor(3) as pool:
        result = cdpr.run_batch(EXPERIMENT, pool, progress=lambda done, total: told.append((done, total)))
    assert result.trials_csv == one_thread.trials_csv
    assert told == sorted(told) and told[-1] == (70 * 4, 70 * 4)
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn")) as pool:
        assert cdpr.run_batch(EXPERIMENT, pool, threads=2).trials_csv == one_thread.trials_csv


@pytest.mark.long
def test_a_dask_cluster_of_two_processes_gives_the_same_bytes(one_thread):
    distributed = pytest.importorskip("distributed")
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):
        assert len(client.scheduler_info()["workers"]) == 2
        assert cdpr.run_batch(EXPERIMENT, client.get_executor()).trials_csv == one_thread.trials_csv


def test_the_same_bytes_as_from_the_shell_and_a_folder_that_goes_on(one_thread, tmp_path):
    result = cdpr.run_batch(ROOT / "experiments/fig8.toml", trials=3)
    result.save(tmp_path / "run")
    assert {path.name for path in (tmp_path / "run").iterdir()} == {
        *("rows", "run.json", "trials.csv", "timings.csv", "summary.json")
    }
    assert (tmp_path / "run/trials.csv").read_bytes() == result.trials_csv
    parts = [cdpr.run_batch(ROOT / "experiments/fig8.toml", trials=part) for part in (range(2), range(2, 3))]
    assert b"".join(sorted(b"".join(part.trials_csv for part in parts).splitlines(keepends=True))).count(b"\n") == 62
    assert [list(part.trials["trial"].unique()) for part in parts] == [[0, 1], [2]]
    with pytest.raises(cdpr.FileError, match="not empty"):
        result.save(tmp_path / "run")
    pickle.loads(pickle.dumps(one_thread)).save(tmp_path / "again")
    assert (tmp_path / "again/trials.csv").read_bytes() == one_thread.trials_csv


def test_a_history_is_the_same_on_an_executor_and_in_a_folder(one_thread, tmp_path, monkeypatch):
    assert one_thread.history is None
    keep_going = {"name": "on", "options": {"keep_going": True, "max_samples": 3000}}
    never = {"name": "never", "planner": "rrt", "options": {"max_samples": 1}}
    experiment = {
        "version": 1,
        "trials": 5,
        "history": True,
        "scenarios": [{"name": "pillar", "scene": str(TESTDATA / "scenes/hard1.toml")}],
        "methods": [keep_going, never],
    }
    result = cdpr.run_batch(experiment)
    history = result.history
    assert list(history) == ["scenario", "method", "trial", "seconds", "samples", "cost"]
    assert history["samples"].dtype == np.int64 and (history["samples"] <= 3000).all() and len(history) > 10
    assert set(history["method"]) == {"on"}
    best = history.groupby("trial")["cost"].min().to_numpy()
    assert (best == result.trials[result.trials["method"] == "on"]["raw_cost"].to_numpy()).all()
    with ThreadPoolExecutor(2) as pool:
        again = cdpr.run_batch(experiment, pool)
    assert again.trials_csv == result.trials_csv
    untimed = ["scenario", "method", "trial", "samples", "cost"]
    assert (again.history[untimed] == history[untimed]).to_numpy().all()
    result.save(tmp_path / "run")
    lines = (tmp_path / "run/history.csv").read_text().splitlines()
    assert lines[0] == ",".join(history) and len(lines) == len(history) + 1
    monkeypatch.setitem(sys.modules, "pandas", None)
    nothing = cdpr.run_batch({**experiment, "methods": [never]})
    assert len(nothing.history) == 0 and nothing.history["cost"].dtype == np.float64


def test_a_summary_says_what_is_swept(one_thread):
    summary = cdpr.run_batch(ROOT / "experiments/fig8.toml", trials=1).summary
    assert set(summary["of"]) == {"modified RRT"} and "step" not in summary
    swept = [(order, k) for order in ("backward", "forward") for k in range(1, 11)]
    assert list(zip(summary["post"], summary["repeats"])) == swept
    assert set(one_thread.summary["of"].dropna()) == {"swept, <both>"} and one_thread.summary["of"].isna().any()


def test_without_pandas_there_are_arrays(one_thread, monkeypatch):
    with monkeypatch.context() as patch:
        patch.setitem(sys.modules, "pandas", None)
        result = cdpr.run_batch(EXPERIMENT)
    assert result.trials.dtype.names == tuple(one_thread.trials.columns)
    assert result.summary["methods"][0]["n"] == 70
    pd.testing.assert_frame_equal(pd.DataFrame(result.trials).astype(object), one_thread.trials.astype(object))


def test_bad_input_to_figures_is_refused():
    scenario, method = EXPERIMENT["scenarios"][0], EXPERIMENT["methods"][1]
    bad = (
        ({**EXPERIMENT, "trails": 3}, {}, "trails.*did you mean `trials`"),
        ({**EXPERIMENT, "methods": [{**method, "planner": "rtt"}]}, {}, r"methods\[0\].*\"rtt\".*did you mean \"rrt\""),
        ({**EXPERIMENT, "scenarios": [{**scenario, "scene": {"versoin": 1}}]}, {}, "versoin"),
        ({**EXPERIMENT, "seed": {1, 2}}, {}, "found a set"),
        (EXPERIMENT, {"trials": 0}, "found 0"),
        (EXPERIMENT, {"trials": range(3, 3)}, r"range\(3, 3\)"),
        (EXPERIMENT, {"trials": range(0, 4, 2)}, "steps of 1"),
        (EXPERIMENT, {"threads": 0}, "threads: found 0"),
    )
    for experiment, options, message in bad:
        with pytest.raises(cdpr.InputError, match=message):
            cdpr.run_batch(experiment, **options)
    with pytest.raises(cdpr.FileError, match=r"none\.toml"):
        cdpr.run_batch("none.toml")
    with pytest.raises(cdpr.FileError, match=r"none\.toml"):
        cdpr.run_batch({**EXPERIMENT, "scenarios": [{**scenario, "scene": "none.toml"}]})
    with ThreadPoolExecutor(1) as pool, pytest.raises(cdpr.InputError, match="threads: found 0"):
        cdpr.run_batch(EXPERIMENT, pool, threads=0)


def test_what_progress_raises_ends_the_run_and_ctrl_c_too():
    def stop(done, total):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        cdpr.run_batch(EXPERIMENT, progress=stop)
    with ThreadPoolExecutor(1) as pool, pytest.raises(RuntimeError, match="enough"):
        cdpr.run_batch(EXPERIMENT, pool, progress=stop)
    endless = {
        **EXPERIMENT,
        "scenarios": [{"name": "hard1", "scene": str(TESTDATA / "scenes/hard1.toml")}],
        "methods": [{"name": "long", "options": {"max_samples": 10**12, "keep_going": True}}],
        "t_tests": [],
    }
    assert_ctrl_c_is_answered_at_once(lambda: cdpr.run_batch(endless, threads=2), threads=2)
    # On an executor, waiting work is cancelled and running work finishes.
    brief = {**endless, "methods": [{"name": "brief", "options": {"max_samples": 10**12, "keep_going": True}, "budget_ms": 300.0}]}
    with ThreadPoolExecutor(1) as pool:
        began = time.perf_counter()
        assert_ctrl_c_is_answered_at_once(lambda: cdpr.run_batch(brief, pool), threads=2)
    assert time.perf_counter() - began < 5.0  # of 21 s


def test_methods_are_compared_in_the_trials_that_both_solved():
    methods = [{"name": "all", "planner": "two-trees"}, {"name": "few", "options": {"max_samples": 60}}]
    tests = [{"group": "A", "measure": "cost", "a": ["drawn", "all"], "b": ["drawn", "few"]}]
    found = cdpr.run_batch({**EXPERIMENT, "scenarios": EXPERIMENT["scenarios"][1:], "methods": methods, "t_tests": tests, "trials": 40})
    costs = {name: {} for name in ("all", "few")}
    for row in found.trials.to_records() if hasattr(found.trials, "to_records") else found.trials:
        if row["status"] == "solved":
            costs[row["method"]][row["trial"]] = row["cost"]
    both = sorted(costs["all"].keys() & costs["few"].keys())
    assert 2 < len(both) < len(costs["all"])
    a, b = (np.array([costs[name][trial] for trial in both]) for name in ("all", "few"))
    (pair,) = found.pairs
    assert (pair["scenario"], pair["a"], pair["b"], pair["cost"]) == ("drawn", "all", "few", found.t_tests[0]["paired"])
    assert pair["cost"]["n"] == len(both) and pair["cost"]["mean_difference"] == pytest.approx((a - b).mean())
    expected = scipy.stats.ttest_rel(a, b)
    assert [pair["cost"][key] for key in ("t", "df", "p")] == pytest.approx([expected.statistic, expected.df, expected.pvalue])


def test_importing_does_not_import_pandas():
    code = "import sys, cdpr; print('pandas' in sys.modules, 'distributed' in sys.modules)"
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "False False" and signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_a_method_can_leave_the_decision_out():
    methods = [{"name": name, "options": {"max_samples": 200}, **keys} for name, keys in
               (("decided", {}), ("searched", {"proof": False}))]  # fmt: skip
    scenarios = [{"name": "closed", "scene": str(TESTDATA / "scenes/closed.toml")}]
    found = cdpr.run_batch({**EXPERIMENT, "scenarios": scenarios, "methods": methods, "t_tests": [], "trials": 1})
    assert dict(zip(found.trials["method"], found.trials["status"], strict=True)) == {
        "decided": "no_path", "searched": "budget_spent"
    }  # fmt: skip


@pytest.mark.long
def test_the_examples_run(tmp_path):
    cluster = [sys.executable, ROOT / "python/examples/cluster.py", "", "4"]
    run = subprocess.run(cluster, cwd=tmp_path, capture_output=True, text=True, check=True)
    assert "A: p = " in run.stdout and (tmp_path / "table2/summary.json").exists()
    winding = [sys.executable, ROOT / "python/examples/winding.py", tmp_path / "table2"]
    run = subprocess.run(winding, capture_output=True, text=True, check=True)
    assert len(run.stdout.splitlines()) == 8 and "hard3, modified RRT: " in run.stdout
    order = [sys.executable, ROOT / "python/examples/rewinding_order.py", "300"]
    run = subprocess.run(order, cwd=ROOT, capture_output=True, text=True, check=True)
    assert len(run.stdout.splitlines()) == 7 and "running both orders gains " in run.stdout


STATIONS = {"low": [0.3, 1.0, 0.3], "high": [1.7, 1.0, 1.7], "back": [1.7, 1.0, 0.3]}


def pairs_of_stations(tmp_path, **changes):
    """An experiment whose scenario lists pairs, with its scene in a file."""
    cdpr.example("hard1").replace(stations=STATIONS).save(tmp_path / "hall.toml")
    queries = [["low", "high"], ["high", "back"], ["back", [0.3, 1.0, 0.8]]]
    scenario = {"name": "hall", "scene": str(tmp_path / "hall.toml"), "queries": queries}
    return {"version": 1, "trials": 3, "seed": 5, "scenarios": [scenario], "methods": [{"name": "m", "planner": "two-trees"}]} | changes


def test_a_scenario_may_list_pairs_of_stations(tmp_path):
    experiment = pairs_of_stations(tmp_path)
    found = cdpr.run_batch(experiment)
    names = ["hall: low to high", "hall: high to back", "hall: back to (0.3, 1, 0.8)"]
    assert set(found.trials["scenario"]) == set(names) and len(found.trials) == 9
    # Each is a scenario with a start and a goal of its own.
    scene = cdpr.Scene.load(tmp_path / "hall.toml")
    ends = [("low", "high"), ("high", "back"), ("back", [0.3, 1.0, 0.8])]
    single = [{"name": name, "scene": scene.replace(start=start, goal=goal)} for name, (start, goal) in zip(names, ends, strict=True)]
    assert cdpr.run_batch({**experiment, "scenarios": single}).trials_csv == found.trials_csv
    trial = cdpr.trial_scene(experiment, names[1], 0)
    np.testing.assert_allclose([trial.start, trial.goal], [STATIONS["high"], STATIONS["back"]])
    (row,) = (row for _, row in found.trials.iterrows() if (row["scenario"], row["trial"]) == (names[1], 0))
    assert cdpr.plan(trial, "two-trees", seed=int(row["seed"]), proof=False).cost == row["cost"]
    with ThreadPoolExecutor(2) as pool:
        assert cdpr.run_batch(experiment, pool).trials_csv == found.trials_csv


def test_pairs_of_stations_meet_random_obstacles_own_planners_and_resuming(tmp_path):
    experiment = pairs_of_stations(tmp_path)
    experiment["scenarios"][0]["random"] = {"count": 2}
    experiment["methods"].append({"name": "direct", "planner": lambda scene, *, seed: [scene.start, scene.goal]})
    found = cdpr.run_batch(experiment)
    assert set(found.trials["scenario"]) == {"hall: low to high", "hall: high to back", "hall: back to (0.3, 1, 0.8)"}
    assert set(found.trials["status"][found.trials["method"] == "direct"]) <= {"solved", "invalid_path", "no_path"}
    del experiment["methods"][1]
    (tmp_path / "pairs.json").write_text(json.dumps(experiment))
    for trials in ("2", "3"):
        subprocess.run([program(), "batch", "pairs.json", "-o", "run", "--trials", trials, "--resume", "-q"], cwd=tmp_path, check=True)
    assert (tmp_path / "run/trials.csv").read_bytes() == cdpr.run_batch(experiment).trials_csv


@pytest.mark.parametrize(
    ("queries", "message"),
    [
        ([["low", "hihg"]], r'scenarios\[0\]\.queries\[0\]\.goal: found "hihg".*did you mean "high"'),
        ([["low", "high"], [[0, 0], "high"]], r"scenarios\[0\]\.queries"),
        ([["low"]], r"scenarios\[0\]\.queries"),
        ([["low", "high"], ["low", "high"]], 'scenarios: found the name "hall: low to high" twice'),
    ],
)
def test_pairs_that_cannot_be(tmp_path, queries, message):
    experiment = pairs_of_stations(tmp_path)
    experiment["scenarios"][0]["queries"] = queries
    with pytest.raises(cdpr.InputError, match=message):
        cdpr.run_batch(experiment)


BEND = [1.0, 1.0, 1.8]
BOX = [[1.2, 0.9, 1.5], [1.8, 1.1, 1.8]]
ROUTES = {"via": ["bend"]}, {"goals": ["back", "high"]}, {"goal_box": BOX}, {"via": [BEND], "goals": ["high", "back"]}


def routes(tmp_path, **changes):
    """An experiment with a scenario for each route, whose scene has a start only."""
    cdpr.example("hard1").replace(stations={**STATIONS, "bend": BEND}).save(tmp_path / "hall.toml")
    scenarios = [{"name": str(k), "scene": str(tmp_path / "hall.toml"), **route} for k, route in enumerate(ROUTES)]
    methods = [{"name": "m", "planner": "two-trees"}, {"name": "raw", "post": "none"}, {"name": "anytime", "planner": "anytime"}]
    return {"version": 1, "trials": 2, "seed": 5, "scenarios": scenarios, "methods": methods} | changes


def test_trials_with_via_points_several_goals_and_a_goal_box(tmp_path):
    experiment = routes(tmp_path)
    found = cdpr.run_batch(experiment)
    assert len(found.trials) == 2 * 3 * len(ROUTES) and set(found.trials["status"]) == {"solved"}
    planners = {"m": ("two-trees", None), "raw": ("modified-rrt", "none"), "anytime": ("anytime", None)}
    for _, row in found.trials.iterrows():
        scene = cdpr.trial_scene(experiment, row["scenario"], row["trial"])
        planner, post = planners[row["method"]]
        route = ROUTES[int(row["scenario"])]
        path = cdpr.plan(scene, planner, seed=int(row["seed"]), proof=False, **route, **({} if post is None else {"post": post}))
        assert (path.cost, path.raw_cost, len(path.waypoints)) == (row["cost"], row["raw_cost"], row["waypoints"])
        assert cdpr.check(scene, path.waypoints).valid
        if "via" in route:
            np.testing.assert_array_equal(path.waypoints[path.route["via"][0]], BEND)
        if "goal_box" in route:
            assert (path.waypoints[-1] >= BOX[0]).all() and (path.waypoints[-1] <= BOX[1]).all()
            assert row["cost"] == row["raw_cost"] or row["method"] != "raw"  # as the planner left it
    with ThreadPoolExecutor(2) as pool:
        assert cdpr.run_batch(experiment, pool).trials_csv == found.trials_csv


def test_routes_meet_the_shell_resuming_and_random_obstacles(tmp_path):
    experiment = routes(tmp_path)
    for scenario in experiment["scenarios"]:
        scenario["random"] = {"count": 2, "redraw_straight": "goal_box" not in scenario}
    found = cdpr.run_batch(experiment)
    (tmp_path / "routes.json").write_text(json.dumps(experiment))
    for trials in ("1", "2"):
        subprocess.run([program(), "batch", "routes.json", "-o", "run", "--trials", trials, "--resume", "-q"], cwd=tmp_path, check=True)
    assert (tmp_path / "run/trials.csv").read_bytes() == found.trials_csv
    scene = cdpr.trial_scene(experiment, "3", 1)
    free = [cdpr.check(scene, [place, place]).valid for place in (scene.start, BEND, STATIONS["high"], STATIONS["back"])]
    assert len(scene.obstacles) == 3 and all(free)
    # Another route is another experiment.
    experiment["scenarios"][0]["via"] = ["bend", "high"]
    (tmp_path / "routes.json").write_text(json.dumps(experiment))
    other = subprocess.run([program(), "batch", "routes.json", "-o", "run", "--resume", "-q"], cwd=tmp_path, capture_output=True, text=True)
    assert other.returncode == 2 and "another experiment" in other.stderr


def test_a_leg_without_a_path_is_decided_before_the_trials(tmp_path):
    scene = cdpr.Scene.load(TESTDATA / "scenes/closed.toml")
    keys = {"version": 1, "trials": 1, "methods": [{"name": "m", "options": {"max_samples": 300}}]}
    scenarios = {
        "on the way": {"via": [scene.goal], "goals": [scene.start]},
        "all goals": {"goals": [scene.goal, scene.goal]},
        "one goal": {"goals": [scene.goal, scene.start]},
    }
    scenarios = [{"name": name, "scene": scene, **route} for name, route in scenarios.items()]
    found = cdpr.run_batch({**keys, "scenarios": scenarios}).trials
    assert dict(zip(found["scenario"], found["status"], strict=True)) == {
        "on the way": "no_path", "all goals": "no_path", "one goal": "solved"
    }  # fmt: skip


@pytest.mark.parametrize(
    ("keys", "method", "message"),
    [
        ({"via": ["bned"]}, {}, r'scenarios\[0\].*found "bned".*did you mean "bend"'),
        ({"goals": [[0, 0]]}, {}, r"scenarios\[0\]\.goals"),
        ({"goal_box": BOX[::-1]}, {}, r"scenarios\[0\]\.goal_box: .*expected the smaller coordinates first"),
        ({"goal_box": BOX, "goals": ["low"]}, {}, r"scenarios\[0\]\.goal_box: found with a goal"),
        ({"goals": ["low"], "queries": [["low", "high"]]}, {}, r"scenarios\[0\]\.queries: found with goals or goal_box"),
        ({"via": ["bend"], "history": True}, {}, r"history: found true, expected false, since scenarios\[0\] has via points"),
        ({"via": ["bend"]}, {"sweep": {"repeats": [1, 2]}}, r"methods\[0\]\.sweep: .*since scenarios\[0\] has via points"),
        ({"via": ["bend"]}, {"options": {"target_cost": 3}}, r"methods\[0\]\.options\.target_cost: found with via points"),
        ({"goals": ["low"]}, {"planner": lambda scene, *, seed: None}, r"methods\[0\]\.planner: found a function"),
        ({"goal_box": BOX, "random": {"count": 1, "redraw_straight": True}}, {}, r"random\.redraw_straight: found with a box of goals"),
        ({"via": [[1.0, 1.0, 0.5]], "random": {"count": 1}}, {}, r"scenarios\[0\]\.random\.scene: via point 1 is not valid"),
    ],
)
def test_routes_that_cannot_be(tmp_path, keys, method, message):
    experiment = routes(tmp_path, methods=[{"name": "m", **method}])
    experiment["history"] = keys.pop("history", False)
    experiment["scenarios"] = [{"name": "hall", "scene": str(tmp_path / "hall.toml"), **keys}]
    with pytest.raises(cdpr.InputError, match=message):
        cdpr.run_batch(experiment)
