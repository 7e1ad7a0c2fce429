"""The known answers of testdata/cases; Rust and the command line run the same list."""

import math
import tomllib
from types import SimpleNamespace

import numpy as np
import pytest
from conftest import TESTDATA

import cdpr

CASES = tomllib.loads((TESTDATA / "cases/cases.toml").read_text())
TOLERANCE = 1e-6  # unless the case has its own

pytestmark = pytest.mark.filterwarnings("ignore::cdpr.CdprWarning")


def each(kind):
    return pytest.mark.parametrize("case", CASES[kind], ids=[case["name"] for case in CASES[kind]])


def scene_of(case):
    return cdpr.Scene.load(TESTDATA / "cases" / case["scene"])


def assert_agrees(found, expected, tolerance=TOLERANCE):
    """Asserts that every expected key is an attribute of the result, with numbers within the tolerance."""
    for key, value in expected.items():
        actual = getattr(found, key)
        if isinstance(value, float):
            assert actual == pytest.approx(value, rel=0, abs=tolerance), key
        else:
            assert (list(actual) if isinstance(value, list) else actual) == value, key


def assert_violation(found, case):
    """Asserts that the violation is that of the case, or None if it has none."""
    assert (found is None) == ("violation" not in case)
    if found is not None:
        assert_agrees(found, case["violation"])


@each("motion")
def test_motion(case):
    scene, rule = scene_of(case), case.get("interference", "exact")
    start, end = np.array([case["from"]]), np.array([case["to"]])
    valid = "violation" not in case
    assert scene.motions_valid(start, end, interference=rule).tolist() == [valid]
    assert_violation(scene.explain_motion(start[0], end[0], interference=rule), case)
    assert cdpr.check(scene, np.vstack([start, end]), interference=rule).valid == valid


@each("plan")
def test_plan(case):
    given = {key: case[key] for key in ("planner", "seed", "start", "goal", "max_samples") if key in case}
    found = cdpr.plan(scene_of(case), **given)
    assert found.status == case["status"]
    assert_violation(found.reason, case)
    if "length" in case:
        assert found.cost == pytest.approx(case["length"], rel=0, abs=case.get("tolerance", TOLERANCE))
    else:
        assert math.isnan(found.cost)


@each("check")
@pytest.mark.parametrize("engine", ["cspace", "gjk"])
def test_check(case, engine):
    report = cdpr.check(scene_of(case), case["waypoints"], engine=engine)
    assert report.valid == ("violation" not in case)
    assert_violation(next(iter(report.violations), None), case)
    if "nearest" in case:
        assert_agrees(SimpleNamespace(**report.min_clearance), case["nearest"])


@each("wrench")
def test_wrench(case):
    found = cdpr.wrench_at(scene_of(case), case["position"], force=case.get("force"))
    assert (found.feasible, found.balanced, found.rank) == (case["feasible"], case["balanced"], case["rank"])
    if "margin" in case:
        assert found.capacity_margin == pytest.approx(case["margin"], rel=0, abs=case.get("tolerance", TOLERANCE))


def test_a_crossing_pair_is_told_when_the_scene_is_loaded():
    with pytest.warns(cdpr.CdprWarning, match="cable 0 and cable 1 cross at every position"):
        cdpr.Scene.load(TESTDATA / "cases/always_crossing.toml")
