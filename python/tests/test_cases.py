"""The known answers of testdata/cases; Rust and the command line run the same list."""

import tomllib

import numpy as np
import pytest
from conftest import TESTDATA

import cdpr

CASES = tomllib.loads((TESTDATA / "cases/cases.toml").read_text())["motion"]


@pytest.mark.filterwarnings("ignore::cdpr.CdprWarning")
@pytest.mark.parametrize("case", CASES, ids=[case["name"] for case in CASES])
def test_known_answer(case):
    scene = cdpr.Scene.load(TESTDATA / "cases" / case["scene"])
    rule = case.get("interference", "exact")
    start, end = np.array([case["from"]]), np.array([case["to"]])
    assert scene.motions_valid(start, end, interference=rule).tolist() == [case["valid"]]
    found = scene.explain_motion(start[0], end[0], interference=rule)
    assert (found is None) == case["valid"]
    if found is not None:
        assert (found.kind, list(found.culprits)) == (case["kind"], case["culprits"])
        if "at" in case:
            assert found.at == pytest.approx(case["at"], abs=1e-6)
        if "margin" in case:
            assert found.margin == pytest.approx(case["margin"], abs=1e-6)
    report = cdpr.check(scene, np.vstack([start, end]), interference=rule)
    assert report.valid == case["valid"]


def test_a_crossing_pair_is_told_when_the_scene_is_loaded():
    with pytest.warns(cdpr.CdprWarning, match="cable 0 and cable 1 cross at every position"):
        cdpr.Scene.load(TESTDATA / "cases/always_crossing.toml")
