"""Many paths in one scene."""

import json
import multiprocessing
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor

import numpy as np
import pytest
from conftest import TESTDATA
from test_planning import AT_ONCE, interrupted_after

import cdpr


def without_times(path):
    """Everything of a result but how long it took."""
    written = json.loads(path._json)
    for times in (written["stats"], *written["history"]):
        [times.pop(key) for key in list(times) if key.endswith("seconds")]
    return written


def questions(scene, count):
    """Starts and goals anywhere in the workspace, of which some are not valid."""
    low, high = scene.position_box
    return np.random.default_rng(4).uniform(low, high, (2, count, 3))


@pytest.mark.parametrize("planner", ["anytime", "two-trees", "modified-rrt"])
def test_results_are_those_of_single_calls_on_any_number_of_threads(planner):
    scene = cdpr.example("hard3")
    starts, goals = questions(scene, 12)
    alone = [cdpr.plan(scene, planner, start=start, goal=goal, seed=3) for start, goal in zip(starts, goals, strict=True)]
    assert len({path.status for path in alone}) > 1
    for threads in (None, 1, 2, 3):
        together = cdpr.plan_many(scene, starts, goals, planner, seed=3, threads=threads)
        assert [without_times(path) for path in together] == [without_times(path) for path in alone]
        assert [path.tree.states.tolist() for path in together] == [path.tree.states.tolist() for path in alone]


def test_one_position_is_that_of_all_paths():
    scene = cdpr.example("hard1")
    goals = [scene.goal, [1.7, 1, 0.3]]
    there, back = cdpr.plan_many(scene, scene.start, goals), cdpr.plan_many(scene, goals, scene.start)
    assert [path.cost for path in there] == pytest.approx([path.cost for path in back], rel=1e-3)
    assert [len(cdpr.plan_many(scene, *ends)) for ends in ((scene.start, scene.goal), (np.empty((0, 3)), scene.goal))] == [1, 0]


def test_orientations_are_those_of_plan():
    plank = cdpr.example("plank")
    starts, goals = [plank.start] * 2, [plank.goal, plank.start + [0.01, 0, 0]]
    open_ = cdpr.plan_many(plank, starts, goals)
    assert open_[0].orientation_name == cdpr.plan(plank).orientation_name
    across = cdpr.plan_many(plank, starts, goals, orientation="across")
    assert [path.orientation_name for path in across] == ["across"] * 2
    scene, yawed = cdpr.example("hard1"), [0.9961946980917455, 0.0, 0.0, 0.08715574274765817]
    (turning,) = cdpr.plan_many(scene, scene.start, [0.3, 1.0, 0.8], goal_orientation=yawed, seed=1)
    assert np.abs(turning.orientations[-1] - yawed).max() < 1e-12


def test_proofs_that_there_is_no_path_come_along(tmp_path):
    walled = cdpr.Scene.load(TESTDATA / "scenes/closed.toml")
    (found,) = cdpr.plan_many(walled, walled.start, walled.goal)
    assert found.status == "no_path" and found.proof is not None
    found.proof.save(tmp_path / "proof.json")
    assert cdpr.check_proof(walled, tmp_path / "proof.json")


def test_progress_is_told_and_may_end_the_work():
    scene = cdpr.example("hard1")
    told = []
    cdpr.plan_many(scene, [scene.start] * 50, scene.goal, progress=lambda done, total: told.append((done, total)))
    assert told[-1] == (50, 50) and told == sorted(told)

    def refuse(_done, _total):
        raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        cdpr.plan_many(scene, [scene.start] * 50, scene.goal, progress=refuse)


def test_ctrl_c_keeps_what_is_done():
    scene = cdpr.example("hard3")
    scene.motions_valid([scene.start], [scene.goal])  # compiled
    found = []

    def ask():
        found[:] = cdpr.plan_many(scene, [scene.start] * 200, scene.goal, budget=0.05)

    assert min(interrupted_after(0.6, ask, raises=None)[0] for _ in range(3)) < AT_ONCE
    statuses = [path.status for path in found]
    assert len(statuses) == 200 and set(statuses) == {"solved", "interrupted"}


@pytest.mark.parametrize(
    ("ends", "options", "said"),
    [
        (([[0, 0, 0]] * 2, [[1, 1, 1]] * 3), {}, "goals: found 2 starts and 3 goals, expected as many, or one position"),
        (([0, 0], [1, 1, 1]), {}, r"starts: found an array of shape \(2,\), expected"),
        (([0, 0, 0], [np.nan, 1, 1]), {}, r"paths\[0\]\.goal: found NaN"),
        (([0, 0, 0], [1, 1, 1]), {"threads": 0}, "threads: found 0"),
        (([0, 0, 0], [1, 1, 1]), {"budget": -1.0}, "budget: found -1"),
        (([0, 0, 0], [1, 1, 1]), {"step": 0.1}, "step: found with planner"),
        (([0, 0, 0], [1, 1, 1]), {"progress": 3}, "progress: found 3, expected a function"),
        (([0, 0, 0], [1, 1, 1]), {"planner": "best"}, "planner: found"),
    ],
)
def test_errors_say_what_was_found(ends, options, said):
    with pytest.raises(cdpr.InputError, match=said):
        cdpr.plan_many(cdpr.example("hard1"), *ends, **options)


def test_an_unknown_keyword_is_named():
    scene = cdpr.example("hard1")
    with pytest.raises(TypeError, match=r"plan_many\(\) got an unexpected keyword argument 'minimise'"):
        cdpr.plan_many(scene, scene.start, scene.goal, minimise="time")


@pytest.fixture(scope="module")
def workers():
    """Two processes, started anew rather than forked."""
    with ProcessPoolExecutor(2, multiprocessing.get_context("spawn")) as pool:
        yield pool


@pytest.mark.parametrize("name", ["hard3", "plank", "closed"])
def test_results_on_an_executor_are_the_same(name, workers):
    scene = cdpr.example(name)
    starts, goals = questions(scene, 70)
    here = cdpr.plan_many(scene, starts, goals, "two-trees", seed=3, max_samples=500)
    there = cdpr.plan_many(scene, starts, goals, "two-trees", seed=3, max_samples=500, executor=workers)
    # How far a search was when a proof ended it depends on the clock.
    kept = [[without_times(path) | ({"stats": None} if path.proof else {}) for path in paths] for paths in (there, here)]
    assert kept[0] == kept[1]
    assert [path.proof is None for path in there] == [path.proof is None for path in here]
    assert cdpr.plan_many(scene, np.empty((0, 3)), scene.goal, executor=workers) == []


def test_a_dask_cluster_gives_the_same_results():
    from distributed import Client, LocalCluster

    scene = cdpr.example("hard3").replace(stations={"low": [0.3, 1.0, 0.3]})
    goals, turns = questions(scene, 20)[1], {"orientation": [0.9961946980917455, 0.0, 0.0, 0.08715574274765817]}
    here = cdpr.plan_many(scene, "low", goals, **turns)
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
        there = cdpr.plan_many(scene, "low", goals, executor=client.get_executor(), **turns)
    assert [without_times(path) for path in there] == [without_times(path) for path in here]


def test_ctrl_c_on_an_executor_keeps_finished_tasks():
    scene, told = cdpr.example("hard3"), []
    with ThreadPoolExecutor(2) as pool:

        def progress(done, total):
            told.append((done, total))
            if done > total / 3:
                raise KeyboardInterrupt  # as the interpreter does while it waits

        found = cdpr.plan_many(scene, [scene.start] * 128, scene.goal, "two-trees", executor=pool, progress=progress)
    statuses = [path.status for path in found]
    assert len(statuses) == 128 and {"solved", "interrupted"} == set(statuses)
    assert statuses.count("solved") >= told[-1][0] > 128 / 3 and told[-1][1] == 128
    lost = next(path for path in found if path.status == "interrupted")
    assert len(lost.waypoints) == 0 and np.isnan(lost.cost) and not lost.solved


def test_a_failing_task_ends_the_work():
    class Failing(ThreadPoolExecutor):
        def submit(self, *_):
            return super().submit(lambda: 1 / 0)

    scene = cdpr.example("hard1")
    with Failing(1) as pool, pytest.raises(ZeroDivisionError):
        cdpr.plan_many(scene, [scene.start] * 3, scene.goal, executor=pool)
    with pytest.raises(cdpr.InputError, match="executor: found 3, expected an executor"):
        cdpr.plan_many(scene, scene.start, scene.goal, executor=3)
