"""Clearances by kind and by pair, pairs that may touch, and exempt pairs."""

import json
import warnings

import pytest
from conftest import TESTDATA

import cdpr


@pytest.fixture
def hard1() -> cdpr.Scene:
    return cdpr.Scene.load(TESTDATA / "scenes/hard1.toml")


def test_clearances_go_in_and_out(hard1: cdpr.Scene, tmp_path) -> None:
    given = {"platform_obstacle": 0.05, ("cable 1", "pillar"): 0.03}
    pairs = [("platform", "pillar")]
    made = cdpr.Scene(
        hard1.robot,
        {"pillar": hard1.obstacles["pillar"][0]},
        workspace=hard1.workspace,
        clearance=0.01,
        clearances=given,
        touch=pairs,
        ignore=[("cable 2", "pillar")],
    )
    edited = hard1.replace(clearance=0.01, clearances=given, touch=pairs, ignore=[["cable 2", "pillar"]])
    for scene in (made, edited):
        scene.save(tmp_path / "scene.toml")
        for same in (scene, cdpr.Scene.load(tmp_path / "scene.toml"), cdpr.Scene.from_dict(scene.to_dict())):
            assert dict(same.clearances) == given and same.required_clearance == 0.01
            assert same.touch == (("platform", "pillar"),) and same.ignore == (("cable 2", "pillar"),)
    plain = edited.replace(clearances=None, touch=None, ignore=None)
    assert (dict(plain.clearances), plain.touch, plain.ignore) == ({}, (), ())
    bare = edited.without("pillar")
    assert (dict(bare.clearances), bare.touch, bare.ignore) == ({"platform_obstacle": 0.05}, (), ())
    with pytest.raises(TypeError):
        edited.clearances["cable_cable"] = 0.1  # type: ignore[index]


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"clearances": {"cabel_cable": 0.1}}, "clearances.*cabel_cable.*cable_cable"),
        ({"clearances": {"cable_cable": -0.1}}, "clearances.cable_cable: found -0.1"),
        ({"clearances": {"cable_cable": float("nan")}}, "clearances.*cable_cable.*: found nan, expected a finite number"),
        ({"clearances": {"cable_cable": "wide"}}, "clearances.*found the text 'wide', expected a number"),
        ({"clearances": {("cable 1", "piller"): 0.1}}, 'did you mean "pillar"'),
        ({"clearances": {("cable 1",): 0.1}}, "expected two names"),
        ({"clearances": {5: 0.1}}, "expected two names"),
        ({"clearances": 0.1}, "clearances: found 0.1, expected a mapping"),
        ({"touch": "platform"}, "touch: found the text 'platform', expected pairs of names"),
        ({"touch": ["platform"]}, r"touch\[0\]: found 'platform', expected two names"),
        ({"touch": [("platform", "pilar")]}, r'touch\[0\].*did you mean "pillar"'),
        ({"ignore": [("platform", 5)]}, r"ignore\[0\].*expected two names"),
        ({"ignore": [("cable 1", "pillar")], "touch": [("pillar", "cable 1")]}, r"touch\[0\].*is listed in ignore already"),
    ],
)
def test_slips_are_told(hard1: cdpr.Scene, given, words) -> None:
    with pytest.raises(cdpr.InputError, match=words):
        hard1.replace(**given)


def test_what_is_exempt_is_measured_and_listed(hard1: cdpr.Scene) -> None:
    path = [[0.3, 1, 0.3], [0.3, 1, 1.8], [1.7, 1, 1.8]]
    free = cdpr.check(hard1, path)
    assert free.exempt == () and free.min_clearance_not_exempt is None and free.min_clearance["required"] == 0
    with pytest.warns(cdpr.CdprWarning, match="can be 50.000 mm apart at most, 60.000 mm are demanded; they must still not"):
        wide = hard1.replace(clearances={"cable_cable": 0.06})
    report = cdpr.check(wide, path)
    assert report.min_clearance["value"] == free.min_clearance["value"]
    assert report.min_clearance["value"] == min(exemption.gap for exemption in report.exempt)
    assert report.min_clearance_not_exempt["value"] > report.min_clearance["value"]
    first = report.exempt[0]
    assert first.pair == ("cable 0", "cable 4") and first.reason == "unattainable" and first.demanded == 0.06
    assert first.attainable == pytest.approx(0.05) and first.gap < first.attainable
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        touching = hard1.replace(touch=[("platform", "pillar")], ignore=[("cable 2", "pillar")])
        planned = cdpr.plan(touching)
    assert {exemption.reason: exemption.gap is None for exemption in planned.exempt} == {"touch": False, "ignore": True}
    assert json.loads(planned._json)["exempt"][0]["pair"] == list(planned.exempt[0].pair)
    assert (hard1.clearance(path) == wide.clearance(path)).all()


def test_a_pair_is_held_to_its_own_clearance(hard1: cdpr.Scene) -> None:
    near = [0.76, 1.0, 0.5]  # 15 mm beside the pillar
    assert hard1.states_valid([near])[0] == cdpr.check(hard1, [near, near]).valid
    for clearances, valid in [
        ({"platform_obstacle": 0.014}, True),
        ({"platform_obstacle": 0.016}, False),
        ({"platform_obstacle": 0.016, ("pillar", "platform"): 0.014}, True),
        ({"cable_platform": 0.016}, True),
    ]:
        scene = hard1.replace(clearances=clearances)
        broken = [v.kind for v in cdpr.check(scene, [near, near]).violations if v.kind == "platform-obstacle"]
        assert (not broken) == valid, clearances
