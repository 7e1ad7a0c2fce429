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
