"""Budgets, threads and failures inside: clear limits, and no panic that crosses into Python."""

from __future__ import annotations

import numpy as np
import pytest

import cdpr
from cdpr import _core
from conftest import TESTDATA


@pytest.mark.parametrize("budget", [1e19, 9.3e18, 1e10, float("inf"), float("-inf"), float("nan"), -1.0, 0.0, 1e-12])
def test_budgets_have_limits(hard1: cdpr.Scene, budget: float) -> None:
    with pytest.raises(cdpr.InputError, match=r"budget: found .* s, expected a positive number of at most 1e9"):
        cdpr.plan(hard1, budget=budget)


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
