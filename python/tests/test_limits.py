"""Budgets, threads and internal failures: clear limits, and no panic that crosses into Python."""

from __future__ import annotations

import itertools
import math
import time

import numpy as np
import pytest

import cdpr
from cdpr import _core
from conftest import TESTDATA


@pytest.mark.parametrize("budget", [1e19, 9.3e18, 1e10, float("inf"), float("-inf"), float("nan"), -1.0, 0.0, 1e-12])
def test_budgets_have_limits(hard1: cdpr.Scene, budget: float) -> None:
    with pytest.raises(cdpr.InputError, match=r"budget: found .* s, expected a positive number of at most 1e9"):
        cdpr.plan(hard1, budget=budget)


def many_cables(count: int) -> cdpr.Scene:
    """A robot whose wrenches take long to prove: some 50 ms per motion with 20 cables."""
    cables = []
    for k in range(count):
        turn, top = 2 * math.pi * k / count, k % 3 > 0
        around = turn + (0.9 if k % 2 else -0.9)
        cables.append({
            "outlet": [1 + math.cos(turn), 1 + math.sin(turn), 2.0 if top else 0.0],
            "attachment": [0.07 * math.cos(around), 0.07 * math.sin(around), 0.025 if top else -0.025],
            "tension": [1.0, 2000.0],
        })  # fmt: skip
    names = [f"cable {k}" for k in range(count)]
    return cdpr.Scene.from_dict({
        "version": 1,
        "workspace": {"min": [0, 0, 0], "max": [2, 2, 2]},
        "robot": {"mass": 10.0, "platform": [{"box": [0.15, 0.15, 0.05]}], "cables": cables},
        "ignore": [*map(list, itertools.combinations(names, 2)), *([name, "platform"] for name in names)],
        "obstacles": [{"name": "crate", "box": [0.2, 0.2, 0.3], "position": [1.0, 1.0, 0.15]}],
        "wrench": {},
        "query": {"start": [0.8, 1.0, 1.0], "goal": [1.2, 1.1, 1.1]},
    })  # fmt: skip


@pytest.mark.parametrize("planner", ["anytime", "two-trees", "rrt-connect", "modified-rrt", "rrt", "rrt-star"])
def test_budgets_are_kept_where_a_motion_check_takes_long(planner: cdpr._search.Planner) -> None:
    scene, budget = many_cables(20), 0.2
    late = math.inf
    for _ in range(3):
        start = time.perf_counter()
        cdpr.plan(scene, planner, budget=budget)
        late = min(late, time.perf_counter() - start - budget)
    assert late < 1.0  # a few motion checks, on a busy machine


@pytest.mark.parametrize("threads", [-1, 0, 1025, 100_000, 2**63, 2**70, 1.5, "2", True])
def test_threads_have_limits(hard1: cdpr.Scene, threads: object) -> None:
    point, robot = [[1.0, 1.0, 0.3]], cdpr.Scene.load(TESTDATA / "scenes/cogiro.toml").robot
    experiment = {
        "version": 1,
        "trials": 1,
        "scenarios": [{"name": "s", "scene": hard1.to_dict()}],
        "methods": [{"name": "m"}],
    }
    calls = [
        lambda: hard1.states_valid(point, threads=threads),
        lambda: hard1.motions_valid(point, point, threads=threads),
        lambda: hard1.clearance(point, threads=threads),
        lambda: cdpr.capacity_margin(robot, point, threads=threads),
        lambda: cdpr.force_margin(robot, point, threads=threads),
        lambda: cdpr.moment_margin(robot, point, threads=threads),
        lambda: cdpr.tension_distribution(robot, point, threads=threads),
        lambda: cdpr.run_batch(experiment, threads=threads),
    ]
    for call in calls:
        with pytest.raises(cdpr.InputError, match="threads: found"):
            call()


def test_answers_do_not_depend_on_many_threads(hard1: cdpr.Scene) -> None:
    points = np.random.default_rng(0).uniform(0.2, 1.8, (100, 3))
    assert (hard1.states_valid(points, threads=1024) == hard1.states_valid(points, threads=1)).all()


@pytest.mark.parametrize("thread", ["this", "other", "abandonable"])
def test_a_bug_inside_is_an_error_of_this_package(thread: str) -> None:
    with pytest.raises(cdpr.InternalError, match="internal error: this is a test; this is a bug in cdpr") as caught:
        _core.panic(thread)
    assert isinstance(caught.value, cdpr.CdprError) and isinstance(caught.value, Exception)
