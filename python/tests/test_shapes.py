"""Points of any shape: (3,) is one point, (..., 3) are many; answers have the shape of the query."""

import threading
import warnings

import numpy as np
import pytest
from conftest import TESTDATA

import cdpr

SHAPES = [(), (1,), (4,), (2, 3), (0,), (2, 0, 5), (1, 1, 2)]


def drawn(shape, low, high):
    return np.random.default_rng(4).uniform(low, high, (*shape, 3))


@pytest.mark.parametrize("shape", SHAPES)
def test_scenes_answer_in_the_shape_of_the_question(hard1, shape):
    points, ends = drawn(shape, 0.2, 1.8), drawn(shape, 0.2, 1.8)[..., ::-1]
    for asked in (
        lambda p, q: hard1.states_valid(p),
        lambda p, q: hard1.clearance(p),
        lambda p, q: hard1.motions_valid(p, q),
    ):
        flat = asked(points.reshape(-1, 3), ends.reshape(-1, 3))
        found = asked(points, ends)
        assert np.shape(found) == shape and (np.ravel(found) == flat).all()
        assert 0 in shape or np.shape(asked(points.tolist(), ends.tolist())) == shape
    if shape == ():
        assert isinstance(hard1.states_valid(points), np.bool_) and isinstance(hard1.clearance(points), np.float64)


def test_one_end_of_motions_may_stand_for_all(hard1):
    points = drawn((3, 5), 0.2, 1.8)
    fan = hard1.motions_valid([0.3, 1.0, 0.3], points)
    assert fan.shape == (3, 5)
    assert (fan == hard1.motions_valid(np.broadcast_to([0.3, 1.0, 0.3], points.shape), points)).all()
    assert hard1.motions_valid(points, [0.3, 1.0, 0.3]).shape == (3, 5)
    assert hard1.motions_valid(points[:, :1], points[0]).shape == (3, 5)


@pytest.mark.parametrize("shape", SHAPES)
def test_robots_answer_in_the_shape_of_the_question(cogiro, shape):
    robot, positions = cogiro.robot, drawn(shape, [-2, -2, 1], [2, 2, 3])
    for ask, rest in [
        (cdpr.capacity_margin, ()),
        (cdpr.force_margin, ()),
        (cdpr.moment_margin, ()),
        (cdpr.tension_distribution, (8,)),
        (cdpr.wrench_matrix, (6, 8)),
        (cdpr.Robot.cable_lengths, (8,)),
    ]:
        found = ask(robot, positions)
        assert np.shape(found) == shape + rest, ask
        flat = ask(robot, positions.reshape(-1, 3))
        assert np.array_equal(np.reshape(found, flat.shape), flat)


def test_cable_lengths_are_distances_from_outlet_to_attachment(cogiro):
    robot = cogiro.robot
    positions, half = drawn((7,), [-2, -2, 1], [2, 2, 3]), np.sqrt(0.5)
    plain = np.linalg.norm(robot.outlets - robot.attachments - positions[:, None], axis=-1)
    assert robot.cable_lengths(positions) == pytest.approx(plain, abs=1e-12)
    turned = robot.attachments @ np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 1]])  # a quarter turn about z
    expected = np.linalg.norm(robot.outlets - turned - positions[:, None], axis=-1)
    assert robot.cable_lengths(positions, orientation=[half, 0, 0, half]) == pytest.approx(expected, abs=1e-12)
    bare = robot.replace(tensions=None, mass=None)  # neither is needed
    assert (bare.cable_lengths(positions) == robot.cable_lengths(positions)).all()
    path = cdpr.Path([[0, 0, 2], [1, 0, 2]], 1.0)
    assert robot.cable_lengths(path).shape == (2, 8)


def test_tensions_along_a_path_carry_the_names_of_the_cables(cogiro):
    named = cogiro.replace(robot=cogiro.robot.replace(cable_names=[f"winch {k + 1}" for k in range(8)]))
    along = cdpr.tensions_along(named, [[0, 0, 2], [1, 0, 2]], step=0.5)
    assert along.cables == named.robot.cable_names
    columns = list(along.to_pandas())
    assert columns[4] == "length:winch 1" and columns[12] == "tension:winch 1"
    assert not any(column.endswith(("_0", "_1")) for column in columns)


def test_a_path_of_another_scene_is_refused_with_strict(cogiro):
    path = cdpr.plan(cogiro, budget=5.0)
    other = cogiro.replace(clearance=0.001)
    with pytest.warns(cdpr.AnotherSceneWarning):
        cdpr.tensions_along(other, path, step=1.0)
    with pytest.raises(cdpr.InputError, match="found a path planned for another scene"):
        cdpr.tensions_along(other, path, step=1.0, strict=True)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        cdpr.tensions_along(cogiro, path, step=1.0, strict=True)


def test_all_that_is_wrong_with_a_position_is_told(hard1):
    inside = [1.0, 1.0, 1.0]
    found = hard1.violations(inside)
    assert len(found) > 1 and found[0] == hard1.explain_motion(inside, inside)
    assert {violation.kind for violation in found} == {"platform-obstacle", "cable-obstacle"}
    assert all(violation.required == 0.0 and violation.gap < 0 for violation in found)
    report = cdpr.check(hard1, inside)
    assert not report.valid and report.length == 0.0 and report.violations == found
    assert report.min_clearance["value"] == hard1.clearance(inside)
    assert cdpr.check(hard1, [0.3, 1.0, 0.3]).valid and hard1.violations([0.3, 1.0, 0.3]) == ()
    assert hard1.violations([0.3, 1, 0.3], [1.7, 1, 1.7]) == cdpr.check(hard1, [[0.3, 1, 0.3], [1.7, 1, 1.7]]).violations


def test_what_the_cables_hold_is_told(cogiro):
    report = cdpr.wrench_at(cogiro, [0, 0, 2])
    assert report.feasible and report.balanced and (report.rank, report.full_rank) == (6, 6)
    assert report.holding == "suspended" and report.free_motions == () and report.free_twists.shape == (0, 6)
    assert report.capacity_margin == pytest.approx(cdpr.capacity_margin(cogiro.robot, [0, 0, 2], force=150, moment=30))
    assert (report.lengths == cogiro.robot.cable_lengths([0, 0, 2])).all() and report.cables == cogiro.robot.cable_names
    assert (report.wrench_matrix == cdpr.wrench_matrix(cogiro.robot, [0, 0, 2])).all()
    ceiling = [[0, 0, 3], [6, 0, 3], [6, 4, 3], [0, 4, 3]]
    corners = [[-0.2, -0.2, 0.1], [0.2, -0.2, 0.1], [0.2, 0.2, 0.1], [-0.2, 0.2, 0.1]]
    body = {"box": [0.4, 0.4, 0.2]}
    swing = cdpr.Robot(ceiling, corners, body, tensions=[5, 500], mass=20)
    hall = cdpr.Scene(swing, workspace=[[0, 0, 0], [6, 4, 3]], wrench={}, start=[3, 2, 1], goal=[4, 2, 1])
    report = cdpr.wrench_at(hall, [3, 2, 1])
    assert report.balanced and not report.feasible and report.rank == 4 and report.holding == "underconstrained"
    assert "turning about x while moving along y" in report.free_motions
    lengths = [swing.cable_lengths([3, 2, 1]) for _ in range(2)]
    matrix = cdpr.wrench_matrix(swing, [3, 2, 1])
    assert np.abs(report.free_twists @ matrix).max() < 1e-9 and (lengths[0] == lengths[1]).all()
    refused = cdpr.plan(hall).reason
    assert refused.kind == "wrench" and refused.free_motions == report.free_motions and refused.rank == 4
    assert cdpr.check(hall, [3, 2, 1]).violations == (refused,)


def test_good_news_is_no_warning():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        scene = cdpr.Scene(
            cdpr.Robot.load(TESTDATA / "robots/cogiro.toml"),
            {"machine": {"mesh": str(TESTDATA / "meshes/machine.stl")}},
            workspace=[[-7, -5, 0], [7, 5, 6]],
        )
    (note,) = scene.notes
    assert note.endswith("which fill it exactly")


def test_many_threads_may_ask_anything_at_once(hard1, cogiro):
    points = drawn((50,), 0.2, 1.8)
    asks = [
        lambda: hard1.states_valid(points).sum(),
        lambda: hard1.clearance(points).sum(),
        lambda: len(hard1.violations(points[0], points[1])),
        lambda: cdpr.check(hard1, points[:5]).length,
        lambda: cdpr.plan(hard1, seed=2).cost,
        lambda: cdpr.wrench_at(cogiro, [0, 0, 2]).capacity_margin,
        lambda: cogiro.robot.cable_lengths(points).sum(),
        lambda: hard1.replace(clearance=0.001).required_clearance,
        lambda: hash(cdpr.Scene.from_dict(hard1.to_dict())),
    ]
    expected = [ask() for ask in asks]
    found, problems = [], []

    def work():
        try:
            found.append([ask() for ask in asks])
        except BaseException as problem:  # noqa: BLE001
            problems.append(problem)

    threads = [threading.Thread(target=work) for _ in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not problems and found == [expected] * 6
