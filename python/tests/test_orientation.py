"""Orientations: named in scenes, chosen by planning, kept by paths."""

import dataclasses
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cdpr

TESTDATA = Path(__file__).parents[2] / "testdata"
LEVEL = [1.0, 0.0, 0.0, 0.0]
ACROSS = [np.sqrt(0.5), 0.0, 0.0, np.sqrt(0.5)]


@pytest.fixture
def plank() -> cdpr.Scene:
    with pytest.warns(cdpr.CdprWarning, match='selects none; using "across", the first'):
        return cdpr.Scene.load(TESTDATA / "scenes/plank.toml")


def test_planning_chooses_and_everything_else_follows_the_path(plank: cdpr.Scene, tmp_path: Path) -> None:
    result = cdpr.plan(plank)
    assert result.solved and result.orientation_name == "along" and result.orientation.tolist() == LEVEL
    assert np.allclose(plank.orientation, ACROSS)  # the first one if nothing selects another
    assert cdpr.check(plank, result).valid
    with pytest.raises(cdpr.InputError, match="selects none of across, along; select one"):
        cdpr.check(plank, result.waypoints)  # bare positions have no orientation
    assert cdpr.check(plank.replace(orientation="along"), result.waypoints).valid
    assert cdpr.refine(plank, result).orientation.tolist() == LEVEL
    assert '"orientation":[1.0,0.0,0.0,0.0]' in cdpr._view.view(plank, result).html
    result.save(tmp_path / "path.json")
    loaded = cdpr.load_path(tmp_path / "path.json", plank)
    assert cdpr.check(plank, loaded).valid and np.array_equal(np.asarray(loaded), result.waypoints)


def test_figures_show_the_orientation_of_the_path(plank: cdpr.Scene) -> None:
    figures = pytest.importorskip("cdpr.figures")
    drawn = figures.scene(plank, cdpr.plan(plank))
    told = figures.scene(plank.replace(orientation="along"), cdpr.plan(plank))
    across = figures.scene(plank)
    corners = [sorted(line.get_gid() or "" for line in ax.get_children()) for ax in (drawn, told)]
    assert corners[0] == corners[1]
    ends = [_ends_of(ax, "cable 1") for ax in (drawn, told, across)]
    assert np.array_equal(ends[0], ends[1]) and not np.array_equal(ends[0], ends[2])


def test_what_a_path_is_made_of_is_what_is_saved(plank: cdpr.Scene, tmp_path: Path) -> None:
    result = cdpr.plan(plank)
    for changed, expected in [
        (dataclasses.replace(result, orientation=ACROSS), (result.waypoints, ACROSS)),
        (cdpr.Path([[0.45, 1, 0.5], [0.6, 1, 0.5]], 0.15, LEVEL), ([[0.45, 1, 0.5], [0.6, 1, 0.5]], LEVEL)),
    ]:
        changed.save(tmp_path / "path.json")
        loaded = cdpr.load_path(tmp_path / "path.json")
        assert np.array_equal(loaded.waypoints, expected[0]) and np.allclose(loaded.orientation, expected[1])
        assert cdpr.check(plank, loaded).valid == (expected[1] is LEVEL)
    # Data about the waypoints is not saved with other waypoints.
    aside = dataclasses.replace(result, waypoints=[[0.45, 1, 0.5], [1.0, 1, 0.9], [1.55, 1, 0.5]])
    for path, known in [(result, True), (aside, False)]:
        path.save(tmp_path / "path.json")
        said = json.loads((tmp_path / "path.json").read_text())
        assert ("min_clearance" in said) == known and said["scene"]["name"] == "plank"
    result.save(tmp_path / "path.json")
    cdpr.load_path(tmp_path / "path.json", plank).save(tmp_path / "again.json")
    with pytest.warns(cdpr.AnotherSceneWarning, match="another scene"):
        cdpr.load_path(tmp_path / "again.json", plank.without("left"))
    # If the scene no longer has the orientation, there is no answer.
    spec = plank.to_dict()
    spec["orientations"] = [turn for turn in spec["orientations"] if turn["name"] != "along"]
    spec["orientations"].append({"name": "askew", "rpy": [0.0, 0.0, 0.3]})
    with pytest.warns(cdpr.CdprWarning):
        without = cdpr.Scene.from_dict(spec)
    for ask in (lambda: cdpr.load_path(tmp_path / "again.json", without), lambda: cdpr.check(without, result)):
        with pytest.raises(cdpr.InputError, match="not one of the scene's orientations"):
            ask()
    with pytest.raises(cdpr.InputError, match="orientation"):
        cdpr.Path(result.waypoints, 1.1, [1, 0, 0])


def test_planners_of_others_need_an_orientation(plank: cdpr.Scene) -> None:
    ompl = pytest.importorskip("cdpr.ompl")
    with pytest.raises(cdpr.InputError, match="select one"):
        ompl.simple_setup(plank)
    setup = ompl.simple_setup(plank.replace(orientation="along"))
    assert ompl.solve(setup, 5.0) and ompl.path(setup).orientation.tolist() == LEVEL


def test_the_lower_bound_of_an_open_scene_holds_for_all_orientations(plank: cdpr.Scene) -> None:
    assert cdpr.lower_bound(plank) <= cdpr.plan(plank).cost


def test_several_paths_are_drawn_at_one_orientation(plank: cdpr.Scene) -> None:
    figures = pytest.importorskip("cdpr.figures")
    along = cdpr.plan(plank)
    drawn = figures.paths(plank, {"along": along}, robot=True)
    told = figures.paths(plank.replace(orientation="along"), {"along": along}, robot=True)
    assert np.array_equal(_ends_of(drawn, "cable 1"), _ends_of(told, "cable 1"))
    across = dataclasses.replace(along, orientation=ACROSS)
    with pytest.raises(cdpr.InputError, match="several orientations"):
        figures.paths(plank, {"along": along, "across": across})


def _ends_of(ax: Any, name: str) -> Any:
    return np.concatenate([np.asarray(line.get_data_3d()).ravel() for line in ax.lines if line.get_gid() == name])


def test_planning_can_be_told(plank: cdpr.Scene) -> None:
    assert cdpr.plan(plank, orientation="across", max_samples=200).status != "solved"
    assert cdpr.plan(plank, orientation=[-1.0, 0.0, 0.0, 0.0]).orientation_name == "along"
    fixed = plank.replace(orientation="across")
    with pytest.raises(cdpr.InputError, match="found a path at"):
        cdpr.check(fixed, cdpr.plan(plank))
    with pytest.raises(cdpr.InputError, match='did you mean "along"'):
        cdpr.plan(plank, orientation="alon")


def test_better_paths_are_told_over_all_orientations(plank: cdpr.Scene) -> None:
    wide = plank.without("left", "right").replace(goal=[1.55, 1.1, 0.9])
    heard: list[float] = []
    result = cdpr.plan(wide, on_improvement=lambda seconds, cost, path: heard.append(cost))
    assert heard[-1] == pytest.approx(result.cost) and heard == sorted(heard, reverse=True)


def test_scenes_are_made_with_orientations(plank: cdpr.Scene) -> None:
    turns = {"across": ACROSS, "along": LEVEL}
    workspace = plank.workspace
    made = cdpr.Scene(plank.robot, dict(plank.obstacles), workspace=workspace, orientations=turns, orientation="along")
    assert list(made.orientations) == ["across", "along"] and made.orientation.tolist() == LEVEL
    assert cdpr.Scene.from_dict(made.to_dict()) == made
    with pytest.raises(cdpr.InputError, match="length 1"):
        cdpr.Scene(plank.robot, workspace=workspace, orientations={"a": [1, 1, 0, 0]})


YAWED = [0.9961946980917455, 0.0, 0.0, 0.08715574274765817]  # by 10°
WAY = [[0.45, 1.0, 0.5], [1.55, 1.0, 0.5]]


@pytest.mark.parametrize("turns", [LEVEL, [LEVEL, LEVEL], [LEVEL, YAWED]])
def test_orientations_beside_a_path_select_the_orientation_of_a_scene_that_leaves_it_open(turns: list[Any], plank: cdpr.Scene, tmp_path: Path) -> None:
    report = cdpr.check(plank, WAY, turns)
    assert report == cdpr.check(plank.replace(orientation="along"), WAY, turns)
    shorter = cdpr.refine(plank, WAY, turns)
    assert (shorter.orientations is not None) == (turns == [LEVEL, YAWED])
    assert cdpr.check(plank, shorter) == report
    limits = {"speed": 1, "acceleration": 2, "turn_speed": 1, "turn_acceleration": 2}
    motion = cdpr.trajectory(plank, WAY, turns, **limits)
    assert motion.turns == (turns == [LEVEL, YAWED]) and motion.orientation.tolist() == LEVEL
    # A file with a quaternion in each row describes these motions as well.
    cdpr.Path(WAY, 1.1, orientations=turns).save(tmp_path / "path.csv")
    for loaded in (cdpr.load_path(tmp_path / "path.csv"), cdpr.load_path(tmp_path / "path.csv", plank)):
        assert cdpr.check(plank, loaded) == report
        assert cdpr.trajectory(plank, loaded, **limits).duration == motion.duration
        assert "html" in cdpr._view.view(plank, loaded).html
    motion.save(tmp_path / "motion.csv")
    assert cdpr.load_trajectory(tmp_path / "motion.csv", plank).turns == motion.turns


def test_other_orientations_than_those_of_a_path_are_refused(plank: cdpr.Scene) -> None:
    path = cdpr.refine(plank, cdpr.plan(plank))
    assert cdpr.check(plank, path, [-x for x in LEVEL]).valid
    for ask in (cdpr.check, cdpr.refine, cdpr.trajectory):
        with pytest.raises(cdpr.InputError, match=r"^orientations: found \[0.99.*\] for a path that keeps \[1.0, 0.0, 0.0, 0.0\]"):
            ask(plank, path, [LEVEL, YAWED])


def test_the_rule_swept_is_for_all_motions_without_a_turn(plank: cdpr.Scene) -> None:
    along, across = plank.replace(orientation="along"), plank.replace(orientation="across")
    turns = [plank.orientations["along"], plank.orientations["across"]]
    start, end = np.array(WAY)
    for places in ([start, start], [start, end], [end, [1.0, 1.0, 1.2]]):
        swept = plank.states_valid(places, turns, interference="swept").tolist()
        assert swept == [bool(at.states_valid(p, interference="swept")) for at, p in zip((along, across), places, strict=True)]
    found = plank.motions_valid([start, start], [end, start], turns, turns, interference="swept").tolist()
    assert found == [bool(along.motions_valid(start, end, interference="swept")), bool(across.states_valid(start))]
    assert cdpr.check(plank, WAY, turns[0], interference="swept") == cdpr.check(along, WAY, interference="swept")
    assert plank.violations(start, end, turns[0], turns[0], interference="swept") == along.violations(start, end, interference="swept")
    near = [plank.nearest_valid(start, turns[0], interference="swept"), along.nearest_valid(start, interference="swept")]
    assert near[0].tolist() == near[1].tolist()
    for ask in (lambda: plank.motions_valid(start, end, *turns, interference="swept"), lambda: cdpr.check(plank, WAY, turns, interference="swept")):
        with pytest.raises(cdpr.InputError, match='interference: found "swept", which is for motions without a turn'):
            ask()


def test_a_certificate_needs_a_selected_orientation_not_a_single_one(plank: cdpr.Scene, tmp_path: Path) -> None:
    with pytest.raises(cdpr.InputError, match="certificate: found a scene with several orientations that selects none"):
        cdpr.lower_bound(plank, certificate=tmp_path / "bound.json")
    selected = plank.replace(orientation="along")
    bound = cdpr.lower_bound(selected, certificate=tmp_path / "bound.json")
    assert bound == pytest.approx(1.1, abs=1e-3) and cdpr.check_proof(selected, tmp_path / "bound.json")


def test_an_unknown_orientation_is_called_by_the_name_of_its_argument(plank: cdpr.Scene) -> None:
    for name in ("orientation", "start_orientation", "goal_orientation"):
        with pytest.raises(cdpr.InputError, match=f'^{name}: found "askew", expected a quaternion'):
            cdpr.plan(plank, **{name: "askew"})
