"""Experiments with planners of the user: rows like those of other methods, from the same scenes, checked by cdpr."""

import functools
import json
import multiprocessing
import pickle
import warnings
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor

import numpy as np
import pytest
import scipy.stats
from conftest import TESTDATA

import cdpr

SCENARIOS = [
    {"name": "hard1", "scene": str(TESTDATA / "scenes/hard1.toml")},
    {"name": "drawn", "scene": str(TESTDATA / "scenes/empty.toml"), "random": {"count": 3}},
]
EXPERIMENT = {"version": 1, "name": "own", "seed": 7, "trials": 6, "scenarios": SCENARIOS}
RRT = {"name": "built-in", "planner": "rrt"}


def detour(scene, *, seed):
    """Over one of a hundred random points."""
    over = np.random.default_rng(seed).uniform(*scene.workspace, size=(100, 3))
    paths = np.stack([np.broadcast_to(scene.start, over.shape), over, np.broadcast_to(scene.goal, over.shape)], axis=1)
    valid = scene.motions_valid(paths[:, 0], paths[:, 1]) & scene.motions_valid(paths[:, 1], paths[:, 2])
    return paths[valid][0] if valid.any() else None


def planned(scene, *, seed):
    return cdpr.plan(scene, "rrt", seed=seed, post="none", proof=False)


def run(*methods, **keys):
    return cdpr.run_batch({**EXPERIMENT, "methods": list(methods), **keys})


def rows(batch, method, scenario=None):
    trials = batch.trials[batch.trials["method"] == method]
    return trials if scenario is None else trials[trials["scenario"] == scenario]


def test_a_function_that_plans_as_a_planner_of_cdpr_gives_the_same_rows():
    tests = [{"group": "A", "measure": "cost", "a": ["drawn", "same"], "b": ["drawn", "other"]}]
    methods = [{"name": "same", "planner": planned, "post": "both"}, {"name": "other", "planner": "two-trees"}]
    mine = cdpr.run_batch({**EXPERIMENT, "methods": methods, "t_tests": tests})
    known = cdpr.run_batch({**EXPERIMENT, "methods": [{"name": "same", "planner": "rrt"}, methods[1]], "t_tests": tests})
    for name in ("scenario", "method", "trial", "seed", "status", "raw_cost", "cost", "raw_waypoints", "waypoints"):
        np.testing.assert_array_equal(mine.trials[name], known.trials[name])
    assert mine.t_tests == known.t_tests and mine.pairs == known.pairs and mine.t_tests[0]["paired"]["n"] > 2
    assert rows(mine, "other").equals(rows(known, "other"))
    assert rows(mine, "same")["nodes"].isna().all() and rows(mine, "same")["motion_checks"].isna().all()
    assert ((mine.timings["planning_seconds"] > 0) | (mine.trials["status"] == "no_path")).all()


def test_all_methods_plan_in_the_scene_of_the_trial():
    seen = {}

    def noted(scene, *, seed):
        seen[scene.name, seed] = scene.to_dict()
        return detour(scene, seed=seed)

    batch = run({"name": "noted", "planner": noted}, RRT, scenarios=SCENARIOS[1:])
    experiment = {**EXPERIMENT, "methods": [{"name": "noted", "planner": noted}, RRT]}
    scenes = [cdpr.trial_scene(experiment, "drawn", trial) for trial in range(6)]
    mine, built_in = rows(batch, "noted"), rows(batch, "built-in")
    undecided = [trial for trial, status in zip(mine["trial"], mine["status"], strict=True) if status != "no_path"]
    assert list(seen.values()) == [scenes[trial].to_dict() for trial in undecided] and len(undecided) > 2
    assert len({json.dumps(scene.to_dict()) for scene in scenes}) == 6
    for scene, row in zip(scenes, built_in.to_dict("records"), strict=True):
        assert scene.start is not None and scene.goal is not None
        if row["status"] == "solved":
            assert cdpr.plan(scene, "rrt", seed=row["seed"], proof=False).cost == row["cost"]
    for scene, row in zip(scenes, mine.to_dict("records"), strict=True):
        path = detour(scene, seed=row["seed"]) if row["status"] != "no_path" else None
        assert (row["status"] == "solved") == (path is not None)
        assert path is None or row["cost"] == pytest.approx(cdpr.check(scene, path).length, rel=1e-15)
    assert cdpr.trial_scene(experiment, "hard1", 3) == cdpr.Scene.load(TESTDATA / "scenes/hard1.toml")


@pytest.mark.parametrize("test", ["paired", "pairs"])
def test_own_planners_are_compared_in_the_trials_that_both_solved(test):
    tests = [{"group": "A", "measure": "cost", "a": ["hard1", "built-in"], "b": ["hard1", "mine"]}]
    batch = run({"name": "mine", "planner": detour}, RRT, trials=15, t_tests=tests)
    a, b = (rows(batch, name, "hard1")["cost"].to_numpy() for name in ("built-in", "mine"))
    both = np.isfinite(a) & np.isfinite(b)
    found = batch.t_tests[0]["paired"] if test == "paired" else next(p["cost"] for p in batch.pairs if p["scenario"] == "hard1")
    expected = scipy.stats.ttest_rel(a[both], b[both])
    assert 2 < found["n"] == both.sum()
    assert [found["t"], found["df"], found["p"]] == pytest.approx([expected.statistic, expected.df, expected.pvalue])


def test_answers_other_than_a_valid_path_are_never_solved():
    def through(scene, *, seed):
        return [scene.start, scene.goal]

    def elsewhere(scene, *, seed):
        return [scene.start, scene.start + [0, 0, 0.1]]

    def broken(scene, *, seed):
        raise ZeroDivisionError("oh")

    functions = {
        "invalid_path": through,
        "invalid_path ": elsewhere,
        "failed": broken,
        "unsolved": lambda scene, *, seed: None,
        "budget_spent": lambda scene, *, seed: cdpr.plan(scene, max_samples=0),
    }
    with pytest.warns(cdpr.CdprWarning) as told:
        batch = run(*({"name": name, "planner": f} for name, f in functions.items()), scenarios=SCENARIOS[:1])
    assert [status.strip() == method.strip() for status, method in zip(batch.trials["status"], batch.trials["method"], strict=True)]
    assert set(batch.trials["status"]) == {name.strip() for name in functions} and batch.trials["cost"].isna().all()
    words = [str(warning.message) for warning in told]
    seed = rows(batch, "failed")["seed"].iloc[0]
    assert f"failed: hard1, failed, trial 0 (seed {seed}): ZeroDivisionError: oh (and 5 more trials of this method)" in words
    assert any("not valid: hard1, invalid_path, trial 0" in w and "meets pillar" in w for w in words), words
    assert any("the path ends at [0.3, 1, 0.4], expected [1.7, 1, 1.7]" in w for w in words), words
    assert len(words) == 3


def test_a_scene_without_a_path_is_decided_first_as_for_other_methods():
    called = []

    def counted(scene, *, seed):
        called.append(seed)

    scenarios = [{"name": "closed", "scene": str(TESTDATA / "scenes/closed.toml")}]
    batch = run({"name": "a", "planner": counted}, {"name": "b", "planner": counted, "proof": False}, scenarios=scenarios)
    assert set(rows(batch, "a")["status"]) == {"no_path"} and set(rows(batch, "b")["status"]) == {"unsolved"}
    assert len(called) == 6 and batch.timings["planning_seconds"].isna().sum() == 6
    blocked = cdpr.Scene.load(TESTDATA / "scenes/hard1.toml").replace(start=[1.0, 1.0, 1.0])
    batch = run({"name": "a", "planner": counted}, scenarios=[{"name": "blocked", "scene": blocked}])
    assert set(batch.trials["status"]) == {"start_invalid"} and len(called) == 6


def test_a_function_is_found_wrong_at_once():
    def path(*waypoints):
        return {"name": "mine", "planner": lambda scene, *, seed: waypoints[0] if waypoints else None}

    turning = str(TESTDATA / "scenes/turn.toml")
    bad = (
        ([{"name": "mine", "planner": lambda scene: None}], {}, r"methods\[0\].planner: found .*<lambda>\(scene\), expected a function of"),
        ([RRT, path("ab")], {}, r"hard1, mine, trial 0 \(seed \d+\): found the text 'ab', expected waypoints \(n, 3\), a path or None"),
        ([path([[1, 2]])], {}, r"mine, trial 0 .*shape \(1, 2\)"),
        ([path([[1, 1, 1]])], {}, "found 1 waypoints, expected at least two"),
        ([path([[1, 1, np.nan], [1, 1, 1]])], {}, "mine, trial 0 .*nan"),
        ([{**path(), "options": {"max_samples": 3}}], {}, r"methods\[0\].options: found options for the function"),
        ([{**path(), "budget_ms": 3.0}], {}, r"methods\[0\].budget_ms: found a time limit for the function"),
        ([path()], {"scenarios": [{"name": "turns", "scene": turning}]}, r"methods\[0\].planner: found a function.*may turn"),
        ([{"name": "mine", "planner": "python:module.function"}], {}, r"methods\[0\].planner: found the name of a function"),
        ([{"name": "mine", "planner": 3}], {}, "planner"),
    )  # fmt: skip
    for methods, keys, message in bad:
        with pytest.raises(cdpr.InputError, match=message):
            run(*methods, **keys)
    experiment = {**EXPERIMENT, "methods": [RRT]}
    for arguments, message in ((("hard2", 0), "expected one of hard1, drawn"), (("hard1", -1), "trial: found -1"), ((3, 0), "scenario: found 3")):
        with pytest.raises(cdpr.InputError, match=message):
            cdpr.trial_scene(experiment, *arguments)


def test_what_a_function_raises_to_end_the_run_ends_it():
    def stop(scene, *, seed):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run({"name": "mine", "planner": stop}, scenarios=SCENARIOS[:1])
    told = []
    cdpr.run_batch(
        {**EXPERIMENT, "methods": [{"name": "mine", "planner": detour}, RRT]},
        progress=lambda done, total: told.append((done, total)),
    )
    assert told == sorted(told) and told[-1] == (24, 24)


def test_executors_and_ranges_of_trials_give_the_same_bytes(tmp_path):
    experiment = {**EXPERIMENT, "methods": [{"name": "mine", "planner": detour}, {"name": "half", "planner": functools.partial(planned)}, RRT]}
    whole = cdpr.run_batch(experiment)
    with ThreadPoolExecutor(3) as pool:
        assert cdpr.run_batch(experiment, pool).trials_csv == whole.trials_csv
    local = {**experiment, "methods": [{"name": "mine", "planner": lambda scene, *, seed: None}]}
    with ProcessPoolExecutor(2, mp_context=multiprocessing.get_context("spawn")) as pool:
        assert cdpr.run_batch(experiment, pool).trials_csv == whole.trials_csv
        with pytest.raises(cdpr.InputError, match="<lambda>, which the executor cannot send to its workers"):
            cdpr.run_batch(local, pool)
    pickle.loads(pickle.dumps(whole)).save(tmp_path / "whole")
    assert (tmp_path / "whole/trials.csv").read_bytes() == whole.trials_csv
    assert {path.name for path in (tmp_path / "whole").iterdir()} == {"rows", "run.json", "trials.csv", "timings.csv", "summary.json"}
    rules = json.loads((tmp_path / "whole/run.json").read_text())["rules"]
    assert [rule["planner"] for rule in rules] == [f"{__name__}.detour", "functools.partial", "rrt"]
    assert [rule["post"] for rule in rules] == ["none", "none", "both"]
    for part in (range(2), range(2, 6)):
        cdpr.run_batch(experiment, trials=part).save(tmp_path / f"from {part.start}")


def test_the_history_of_a_result_is_recorded():
    batch = run({"name": "mine", "planner": planned}, {"name": "rows", "planner": detour}, RRT, history=True, scenarios=SCENARIOS[:1])
    history = batch.history[batch.history["method"] == "mine"]
    assert history.groupby("trial")["cost"].min().tolist() == rows(batch, "mine")["raw_cost"].dropna().tolist()
    assert set(batch.history["method"]) == {"mine", "built-in"}


@pytest.mark.long
def test_a_dask_cluster_gives_the_same_bytes():
    distributed = pytest.importorskip("distributed")
    # Dask sends functions by value.
    experiment = {**EXPERIMENT, "methods": [{"name": "mine", "planner": lambda scene, *, seed: [scene.start, scene.goal]}, RRT]}
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
        warnings.catch_warnings(),
    ):
        warnings.simplefilter("ignore", cdpr.CdprWarning)
        assert cdpr.run_batch(experiment, client.get_executor()).trials_csv == cdpr.run_batch(experiment).trials_csv
