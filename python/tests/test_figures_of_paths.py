"""Figures of paths: lines, platforms at poses along them, and charts."""

from itertools import pairwise

import numpy as np
import pytest
from artists import closed, length, named, points_of, polygons  # noqa: F401 (fixture)
from conftest import TESTDATA

import cdpr
from cdpr import figures


def test_a_path_is_drawn_with_its_raw_path_and_lengths(hard1):
    result = cdpr.plan(hard1, "modified-rrt", seed=3)
    ax = figures.scene(hard1, result, robot=False, labels=True, view=(90, -90))  # nothing hides it from above
    for gid, way in (("path", result.waypoints), ("raw path", result.raw_waypoints)):
        (line,) = named(ax, gid)
        drawn = points_of(line)
        assert (drawn[0] == way[0]).all() and (drawn[-1] == way[-1]).all()
        assert {tuple(p) for p in drawn} >= {tuple(p) for p in way}
    texts = [text.get_text() for text in ax.get_legend().get_texts()]
    assert texts == [f"raw: {result.raw_cost:.3f} m", f"path: {result.cost:.3f} m"]


@pytest.fixture(scope="module")
def bar():
    return cdpr.Scene.load(TESTDATA / "scenes/turn.toml")


def test_a_turning_platform_is_drawn_at_poses_along_its_path(bar):
    across = bar.goal_orientation
    high, low = np.array([1.0, 1.0, 1.4]), np.array([1.0, 1.0, 1.2])
    path = cdpr.Path([high, low, low], 1.0, orientations=[bar.orientation, bar.orientation, across])
    ax = figures.scene(bar, path, poses=3, view=(60, -50))
    # The way down is 0.2 m long, the turn as long as the way of the farthest corner; the middle is in the turn.
    reach = np.linalg.norm([0.3, 0.04, 0.04])
    middle = (reach * np.pi / 2 + 0.2) / 2
    expected = [(high, 0.0), (low, (middle - 0.2) / reach), (low, np.pi / 2)]
    platforms = [np.vstack(polygons(drawn)) for drawn in named(ax, "platform")]
    assert len(platforms) == 3
    for cable, (outlet, attachment) in enumerate(zip(bar.robot.outlets, bar.robot.attachments, strict=True)):
        ends = np.array([points_of(line)[-1] for line in named(ax, f"cable {cable}")])
        for (place, angle), end in zip(expected, ends, strict=True):
            cosine, sine = np.cos(angle), np.sin(angle)
            x, y, z = attachment
            at = place + [cosine * x - sine * y, sine * x + cosine * y, z]
            if np.isfinite(end).all():  # an end that is seen
                assert np.linalg.norm(np.cross(at - outlet, end - outlet)) < 1e-9
    for place, angle in expected:
        width = np.abs([0.3 * np.cos(angle) + 0.04 * np.sin(angle), 0.3 * np.sin(angle) + 0.04 * np.cos(angle)])
        assert any(np.allclose(p[:, :2].max(axis=0), place[:2] + width) and np.isclose(p[:, 2].max(), place[2] + 0.04) for p in platforms)
    assert [text.get_text() for text in ax.get_legend().get_texts()] == ["path: 0.200 m, turns by 90°"]
    (line,) = named(ax, "path")  # also seen where platforms are
    assert (points_of(line)[[0, -1]] == [high, low]).all()
    assert len(named(figures.scene(bar, path), "platform")) == 5 and not named(figures.scene(bar, path, robot=False), "platform")


def test_a_platform_that_keeps_its_orientation_is_drawn_once_or_at_poses(hard1):
    result = cdpr.plan(hard1)
    assert len(named(figures.scene(hard1, result), "platform")) == 1
    platforms = [np.vstack(polygons(drawn)) for drawn in named(figures.scene(hard1, result, poses=2), "platform")]
    middles = sorted((p.max(axis=0) + p.min(axis=0))[0] / 2 for p in platforms)
    assert middles == pytest.approx([0.3, 1.7])


def test_without_a_path_the_platform_is_drawn_as_it_starts(bar):
    across = bar.replace(start=[1, 1, 1.4], start_orientation=bar.goal_orientation)
    for ax, width in ((figures.scene(across), 0.04), (figures.scene(across, at=[1, 1, 1.4]), 0.3)):
        assert np.vstack(polygons(named(ax, "platform")[0]))[:, 0].max() == pytest.approx(1 + width)


def test_shadows_of_cable_ends_do_not_depend_on_the_orientation(bar):
    here, there = (bar.replace(orientation=turn).shadows() for turn in (bar.orientation, bar.goal_orientation))
    assert list(here) == list(there)
    assert all(np.allclose(np.sort(here[name].vertices, axis=0), np.sort(there[name].vertices, axis=0)) for name in here)


def test_turning_paths_are_compared_with_their_angles(bar):
    found = {"trees": cdpr.plan(bar, "two-trees", seed=1), "connect": cdpr.plan(bar, "rrt-connect", seed=1)}
    ax = figures.paths(bar, found, view=(90, -90))
    for (name, result), text in zip(found.items(), ax.get_legend().get_texts(), strict=True):
        turned = sum(2 * np.arccos(min(1.0, abs(a @ b))) for a, b in pairwise(result.orientations))
        expected = f"{name}: {length(result.waypoints):.2f} m, turns by {np.degrees(turned):.0f}°, {len(result.waypoints)} waypoints"
        assert text.get_text() == expected and points_of(named(ax, name)[0])[-1] == pytest.approx(bar.goal)


def test_charts_along_a_turning_path(bar):
    result = cdpr.plan(bar, "two-trees", seed=1)
    clearance, turned = figures.along(bar, result)
    (line,), (dot,) = named(clearance, "clearance"), named(clearance, "nearest")
    report = cdpr.check(bar, result)
    places, gaps = line.get_data()
    assert places[-1] == pytest.approx(report.length) == result.cost and len(places) > 400
    assert gaps[0] == pytest.approx(float(bar.clearance(bar.start, bar.start_orientation)))
    assert gaps[-1] == pytest.approx(float(bar.clearance(bar.goal, bar.goal_orientation)))
    assert dot.get_ydata()[0] == report.min_clearance["value"] <= gaps.min() + 1e-9
    assert np.interp(dot.get_xdata()[0], places, gaps) == pytest.approx(dot.get_ydata()[0], abs=2e-3)
    assert clearance.texts[0].get_text() == " and ".join(report.min_clearance["culprits"])
    ends, angles = named(turned, "turned")[0].get_data()
    assert len(ends) == len(result.waypoints) and (np.diff(angles) >= 0).all() and angles[-1] >= 90 - 1e-9
    assert [line.get_xdata()[0] for line in named(turned, "waypoint")] == pytest.approx(ends[1:-1])


@pytest.mark.parametrize("angle", [0.0, 0.1])
def test_charts_along_a_path_with_tensions(angle):
    scene = cdpr.Scene.load(TESTDATA / "scenes/cogiro.toml")
    turns = [[np.cos(a / 2), 0, 0, np.sin(a / 2)] for a in (0.0, angle)]
    path = cdpr.Path([[0, 0, 2], [1, 0, 2]], 1.0, orientations=turns if angle else None)
    charts = figures.along(scene, path)
    titles = ["clearance (m)", "turned so far (°)", "tensions (N)", "capacity margin (N)"]
    assert [chart.get_title("left") for chart in charts] == [title for title in titles if angle or title[0] != "t" or title[1] == "e"]
    rows = cdpr.tensions_along(scene, path, step=0.1)
    for k, cable in enumerate(rows.cables):
        (line,) = named(charts[-2], cable)
        assert np.interp(rows.s, *line.get_data()) == pytest.approx(rows.tensions[:, k], rel=1e-3)
    (line,) = named(charts[-1], "capacity margin")
    assert np.interp(rows.s, *line.get_data()) == pytest.approx(rows.capacity_margin, rel=1e-3)


def test_paths_are_compared_by_name_length_and_waypoints(hard1):
    found = {"RRT*": cdpr.plan(hard1, "rrt-star", seed=1, post="none"), "rewound": cdpr.plan(hard1, "modified-rrt", seed=1)}
    ax = figures.paths(hard1, found)
    for (name, result), text in zip(found.items(), ax.get_legend().get_texts(), strict=True):
        assert text.get_text() == f"{name}: {result.cost:.2f} m, {len(result.waypoints)} waypoints"
        assert len(named(ax, name)) == 1
    assert len({named(ax, name)[0].get_color() for name in found}) == 2


def test_charts_of_tensions_name_the_cables(hard1):
    charts = figures.along(hard1, cdpr.plan(hard1))
    (legend,) = charts[0].figure.legends
    assert [text.get_text() for text in legend.get_texts()] == [f"cable {k}" for k in range(8)]
    own = charts[0].figure.subplots(3, 1)
    assert figures.along(hard1, cdpr.plan(hard1), ax=own)[1].get_legend_handles_labels()[1][0] == "cable 0"


def test_the_clearance_that_is_drawn_is_that_of_the_pair_it_names():
    scene = cdpr.Scene.load(TESTDATA / "scenes/hard1.toml")
    scene = scene.replace(clearance=0.001, clearances={("cable 1", "pillar"): 0.004})
    path = [[0.3, 1.0, 0.3], [0.72, 1.0, 0.3]]
    nearest = cdpr.check(scene, path).min_clearance
    assert (nearest["required"], nearest["culprits"]) == (0.004, ["cable 1", "pillar"])
    chart, *_ = figures.along(scene, path)
    assert chart.get_title("right").startswith("0.004 m required of cable 1 and pillar")
