"""The widest path: `plan(maximise="clearance")`."""

import copy
import itertools
import json
import pickle
import warnings
from dataclasses import replace

import pytest
from conftest import TESTDATA

import cdpr

MILLIMETRE = 1e-3


def scene_of(name):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", cdpr.CdprWarning)
        return cdpr.Scene.load(TESTDATA / f"scenes/{name}.toml")


def box(low, high):
    return list(itertools.product(*zip(low, high, strict=True)))


@pytest.fixture(scope="module")
def gate():
    """Two walls 0.5 m apart, from floor to ceiling, and a platform 0.2 m wide; cables do not count."""
    outlets = [[x, y, 2.0] for x in (0, 2) for y in (0, 2)]
    attachments = [[x, y, 0.1] for x in (-0.1, 0.1) for y in (-0.1, 0.1)]
    robot = cdpr.Robot(outlets=outlets, attachments=attachments, platform=[box([-0.1] * 3, [0.1] * 3)])
    walls = {"left": box([0.95, 0, 0], [1.05, 0.75, 1.79]), "right": box([0.95, 1.25, 0], [1.05, 2, 1.79])}
    ends = {"start": [0.4, 1.0, 1.0], "goal": [1.6, 1.0, 1.0]}
    pairs = [(f"cable {k}", wall) for k in range(4) for wall in walls]
    return cdpr.Scene(robot, walls, workspace=[[0, 0, 0], [2, 2, 1.8]], ignore=pairs, **ends)


def widened(scene, clearance):
    """Return the scene that the documentation describes."""
    own = scene.to_dict().get("clearance", 0.0)
    return scene.replace(clearance=clearance, clearances={"cable_cable": own, "cable_platform": own})


def test_half_of_what_the_platform_leaves_of_a_gate_is_the_answer(gate):
    found = cdpr.plan(gate, maximise="clearance")
    kept, none_above = found.widest["clearance"], found.widest["none_above"]
    assert kept - 1e-8 <= 0.15 <= none_above <= kept + MILLIMETRE
    assert found.min_clearance["value"] == cdpr.check(gate, found, strict=True).min_clearance["value"] <= kept
    assert cdpr.check(widened(gate, kept - 1e-8), found.waypoints).valid
    assert cdpr.plan(gate).widest is None


def test_the_proof_is_that_of_the_scene_with_this_clearance(gate, tmp_path):
    none_above = cdpr.plan(gate, maximise="clearance").widest["none_above"]
    scene = widened(gate, none_above)
    proof = cdpr.plan(scene).proof
    assert set(proof.blocking) == {"left", "right"}
    proof.save(tmp_path / "proof.json")
    cdpr.check_proof(scene, tmp_path / "proof.json")
    with pytest.raises(cdpr.CdprError):
        cdpr.check_proof(widened(gate, 0.14), tmp_path / "proof.json")


def test_no_path_keeps_more_than_its_start(gate):
    near = cdpr.plan(gate, start=[1.0, 0.9, 1.0], maximise="clearance").widest
    assert near["clearance"] == pytest.approx(0.05, abs=1e-8) and near["none_above"] == pytest.approx(0.05, abs=1e-5)


def test_all_answers_agree(gate):
    once, again = (cdpr.plan(gate, "rrt-connect", seed=4, maximise="clearance") for _ in range(2))
    assert once.waypoints.tolist() == again.waypoints.tolist() and once.widest == again.widest
    assert copy.deepcopy(once) == once == pickle.loads(pickle.dumps(once))
    assert once != cdpr.plan(gate, "rrt-connect", seed=4)


def test_files_have_the_answer(gate, tmp_path):
    found = cdpr.plan(gate, maximise="clearance")
    found.save(tmp_path / "path.json")
    assert json.loads((tmp_path / "path.json").read_text())["widest"] == found.widest
    assert cdpr.check(gate, cdpr.load_path(tmp_path / "path.json", gate, strict=True)).valid


def test_every_wider_path_is_reported(gate):
    seen = []
    found = cdpr.plan(gate, maximise="clearance", on_improvement=lambda *said: seen.append(said))
    least = [cdpr.check(gate, waypoints).min_clearance["value"] for _, _, waypoints in seen]
    assert least and least == sorted(least) and least[-1] <= found.widest["none_above"]


def test_a_budget_keeps_the_widest_path_so_far():
    scene = scene_of("hard1")
    for budget in (0.02, 0.1, 0.4):
        found = cdpr.plan(scene, budget=budget, maximise="clearance")
        if found.solved:
            assert cdpr.check(scene, found, strict=True).valid
            assert found.widest["none_above"] is None or found.widest["clearance"] < found.widest["none_above"]


@pytest.mark.parametrize("name", ["closed"])
def test_without_a_path_the_answer_is_the_usual_one(name):
    found = cdpr.plan(scene_of(name), maximise="clearance")
    assert (found.status, found.widest) == ("no_path", None) and found.proof.blocking == ("south", "north")


@pytest.mark.parametrize(
    ("name", "options", "words"),
    [
        ("turn", {}, "maximise: found a platform that may turn"),
        ("empty", {}, "maximise: found no pair with an obstacle"),
        ("hard1", {"proof": False}, "maximise: found a search without proofs"),
        ("hard1", {"minimise": "time", "motion": {"speed": 1, "acceleration": 2}}, 'maximise: found with minimise="time"'),
        ("hard1", {"maximise": "speed"}, "expected one of clearance"),
        ("hard1", {"maximise": 3}, "maximise: found 3"),
    ],
)
def test_questions_without_an_answer_are_refused_by_name(name, options, words):
    with pytest.raises(cdpr.InputError, match=words):
        cdpr.plan(scene_of(name), **{"maximise": "clearance"} | options)


def test_motions_keep_the_width(tmp_path):
    scene = scene_of("hard3")
    found = cdpr.plan(scene, maximise="clearance")
    found.save(tmp_path / "wide.json")
    loaded = cdpr.load_path(tmp_path / "wide.json")
    loaded.save(tmp_path / "again.json")
    again = cdpr.load_path(tmp_path / "again.json", scene)
    wide = widened(scene, found.widest["clearance"] - 2e-6)
    limits = {"speed": 1, "acceleration": 1, "blend": 0.3}
    kept, plain = (cdpr.trajectory(scene, path, **limits) for path in (found, found.waypoints))
    assert wide.states_valid(kept.positions).all() and not wide.states_valid(plain.positions).all()
    for path in (loaded, again):
        assert cdpr.trajectory(scene, path, **limits) == kept
    # Other waypoints have another width, and so have other scenes.
    changed = replace(loaded, waypoints=found.waypoints[::-1])
    assert not wide.states_valid(cdpr.trajectory(scene, changed, **limits).positions).all()
    other = scene.replace(clearance=1e-3)
    with pytest.warns(cdpr.AnotherSceneWarning):
        assert not wide.states_valid(cdpr.trajectory(other, loaded, **limits).positions).all()
    # The width is that of the scene in which the path was planned, and says nothing about another one.
    moved = scene.moved("west", [0.699, 1.0, 0.6])
    with pytest.warns(cdpr.AnotherSceneWarning):
        other = cdpr.trajectory(moved, found, **limits)
    assert other == cdpr.trajectory(moved, found.waypoints, **limits)


def test_the_best_orientation_is_chosen():
    found = cdpr.plan(scene_of("plank"), maximise="clearance")
    assert found.orientation_name == "along" and found.widest["clearance"] == pytest.approx(0.225)
