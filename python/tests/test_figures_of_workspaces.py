"""Sections of a proved workspace, against the positions that they are filled for."""

import numpy as np
import pytest
from artists import closed  # noqa: F401 (fixture)
from conftest import TESTDATA
from matplotlib import pyplot

import cdpr
from cdpr import figures


def area(boxes):
    """Total area of drawn rectangles."""
    return sum(np.ptp(path.vertices, axis=0).prod() for path in boxes.get_paths())


@pytest.mark.parametrize(("axis", "at"), [("x", None), ("y", 1.0), ("z", None), ("z", "lowest"), ("z", "highest")])
def test_a_section_of_a_workspace_is_filled_as_its_positions_are(axis, at):
    scene = cdpr.Scene.load(TESTDATA / "scenes/hard3.toml")
    found = cdpr.workspace(scene, resolution=0.06)
    low, high = scene.position_box
    normal = "xyz".index(axis)
    place = {"lowest": low[normal], "highest": high[normal]}.get(at, at)
    ax = figures.workspace(found, axis=axis, at=place)
    drawn = {boxes.get_gid(): boxes for boxes in ax.collections}
    assert {"valid", "undecided", "cable-obstacle"} <= set(drawn)
    # The boxes of the section tile it.
    across = [k for k in range(3) if k != normal]
    assert sum(map(area, drawn.values())) == pytest.approx(np.prod((high - low)[across]))
    place = float(ax.get_title(loc="left").split()[-2]) if place is None else place
    positions = np.random.default_rng(0).uniform(low, high, (400, 3))
    positions[:, normal] = np.clip(place, low[normal], high[normal])
    valid = scene.states_valid(positions)
    for position, is_valid in zip(positions[:, across], valid, strict=True):
        holding = [
            name for name, boxes in drawn.items()
            if any((path.vertices.min(axis=0) <= position).all() and (position <= path.vertices.max(axis=0)).all() for path in boxes.get_paths())
        ]  # fmt: skip
        assert holding and ("undecided" in holding or ("valid" in holding) == is_valid), position


def test_a_flat_workspace_is_drawn_as_it_lies():
    found = cdpr.workspace(cdpr.Scene.load(TESTDATA / "scenes/empty.toml"), resolution=0.2)
    assert figures.workspace(found).get_xlabel() == "x (m)"
    nowhere = cdpr.workspace(cdpr.example("hard1").replace(clearance=5.0), resolution=0.5)
    ax = figures.workspace(nowhere)
    assert "valid" not in [text.get_text() for text in ax.get_legend().get_texts()]
    assert figures.workspace(nowhere, ax=pyplot.subplots()[1]) is not ax
