"""Poses from cable lengths."""

import pickle

import numpy as np
import pytest

import cdpr


def turn(axis, angle):
    """A rotation as a quaternion w x y z."""
    return np.array([np.cos(angle / 2), *(np.sin(angle / 2) * np.asarray(axis, float))])


@pytest.fixture
def robot(cogiro):
    return cogiro.robot


def hanging_point():
    """A point mass; with cables of 5 m it is at the origin, or at its mirror image 8 m above."""
    outlets = [[3, 0, 4], [-3, 0, 4], [0, 3, 4], [0, -3, 4]]
    return cdpr.Robot(outlets, np.zeros((4, 3)), [[[0, 0, 0]]])


def test_a_pose_comes_back_from_its_lengths(robot):
    tilted = turn([0.6, 0, 0.8], 0.3)
    lengths = robot.cable_lengths([0.5, -1, 2], orientation=tilted)
    found = cdpr.pose_from_lengths(robot, lengths)
    assert np.abs(found.position - [0.5, -1, 2]).max() < 1e-9
    assert np.abs(found.orientation * np.sign(found.orientation[0]) - tilted).max() < 1e-9
    assert (found.rank, found.full_rank, found.covariance.shape, found.residuals.shape) == (6, 6, (6, 6), (8,))
    assert np.abs(found.residuals).max() < 1e-9 and type(found.rank) is int and found.others == ()


def test_a_pose_comes_back_from_commands_and_angles(robot):
    drum = {"radius": 0.1, "gear": -20.0, "zero": 9.0, "lead": 3.0}
    elastic = robot.replace(cable={"stiffness": 7e5, "drum": drum})
    positions = np.array([[0.5, -1, 2], [0.6, -1, 2]])
    tensions = np.linspace(100, 4000, 16).reshape(2, 8)
    commands = (robot.cable_lengths(positions) + 3) / (1 + tensions / 7e5) - 3
    angles = -20 * (commands - 9) / 0.1
    for joints, values in (("command", commands), ("angle", angles)):
        found = cdpr.pose_from_lengths(elastic, values, joints=joints, tensions=tensions)
        assert np.abs(found.position - positions).max() < 1e-9 and np.abs(found.residuals).max() < 1e-9
        assert found.others == ((), ())
        alone = cdpr.pose_from_lengths(elastic, values[0], joints=joints, tensions=tensions[0])
        assert np.abs(alone.position - positions[0]).max() < 1e-9
    stiff = robot.replace(cable={"drum": drum})
    found = cdpr.pose_from_lengths(stiff, -20 * (robot.cable_lengths([0.5, -1, 2]) - 9) / 0.1, joints="angle")
    assert np.abs(found.position - [0.5, -1, 2]).max() < 1e-9


def test_commands_without_what_they_need_are_refused(robot):
    elastic = robot.replace(cable={"stiffness": 7e5})
    lengths = robot.cable_lengths([0.5, -1, 2])
    for match, robot_, values, options in (
        (r"lengths\.cable 0: found no tension of a cable that stretches", elastic, lengths, {"joints": "command"}),
        (r"lengths\[0\]\.cable 0: found no tension", elastic, [lengths, lengths], {"joints": "command"}),
        (r"found an angle of a cable without a drum", elastic, lengths, {"joints": "angle", "tensions": lengths}),
        (r"found a tension of -1 N", elastic, lengths, {"joints": "command", "tensions": [-1.0] * 8}),
        (r"found a tension of NaN N", elastic, lengths, {"joints": "command", "tensions": [np.nan] * 8}),
        (r'tensions: found with joints="length", where they have no effect', elastic, lengths, {"tensions": lengths}),
        (r"tensions: found an array of shape \(7,\)", elastic, lengths, {"joints": "command", "tensions": lengths[:7]}),
        (r"joints: found \"motor\", expected one of length, command, angle", elastic, lengths, {"joints": "motor"}),
    ):
        with pytest.raises(cdpr.InputError, match=match):
            cdpr.pose_from_lengths(robot_, values, **options)


def test_rows_are_solved_one_from_the_other(robot):
    positions = np.linspace([0, 0, 2], [1, -1, 1.5], 50)
    lengths = robot.cable_lengths(positions)
    found = cdpr.pose_from_lengths(robot, lengths, guess=([0.1, 0, 2], turn([0, 0, 1], 0.1)))
    assert np.abs(found.position - positions).max() < 1e-9
    assert found.orientation.shape == (50, 4) and found.residuals.shape == (50, 8) and found.covariance.shape == (50, 6, 6)
    assert (found.rank == 6).all() and found.iterations.shape == (50,) and found.others == ((),) * 50
    alone = cdpr.pose_from_lengths(robot, lengths[7], guess=found)
    assert np.abs(alone.position - positions[7]).max() < 1e-9
    nothing = cdpr.pose_from_lengths(robot, np.empty((0, 8)))
    assert nothing.position.shape == (0, 3) and nothing.others == ()


def test_at_a_given_orientation_three_cables_are_enough_and_the_mirror_image_is_named():
    robot = hanging_point()
    found = cdpr.pose_from_lengths(robot, [5, 5, 5, 5], orientation=[1, 0, 0, 0])
    assert np.abs(found.position).max() < 1e-9 and (found.rank, found.full_rank) == (3, 3)
    assert np.allclose(found.covariance, np.diag([1 / 0.72, 1 / 0.72, 1 / 2.56, 0, 0, 0]), atol=1e-9)
    (image,) = found.others
    assert np.abs(image.position - [0, 0, 8]).max() < 1e-9
    assert np.abs(image.others[0].position).max() < 1e-9
    above = cdpr.pose_from_lengths(robot, [5, 5, 5, 5], orientation=[1, 0, 0, 0], guess=[0, 0, 7])
    assert np.abs(above.position - [0, 0, 8]).max() < 1e-9
    assert len(cdpr.pose_from_lengths(robot, [[5] * 4] * 3, orientation=[1, 0, 0, 0]).others[2]) == 1


def test_residuals_are_given_minus_found(robot):
    lengths = robot.cable_lengths([0, 0, 2]) + [0.1, 0, 0, 0, 0, 0, 0, 0]
    found = cdpr.pose_from_lengths(robot, lengths)
    there = robot.cable_lengths(found.position, orientation=found.orientation)
    assert np.abs(found.residuals - (lengths - there)).max() < 1e-12 and found.residuals[0] > 0.01
    balance = cdpr.wrench_matrix(robot, found.position, orientation=found.orientation) @ found.residuals
    assert np.abs(balance).max() < 1e-8


def test_an_open_pose_has_a_lower_rank_and_no_covariance():
    robot = cdpr.example("hard1").robot
    found = cdpr.pose_from_lengths(robot, robot.cable_lengths([1, 1, 1]))
    assert found.rank == 5 and np.isnan(found.covariance).all()


def test_results_are_values(robot):
    found = cdpr.pose_from_lengths(robot, robot.cable_lengths([0, 0, 2]))
    again = pickle.loads(pickle.dumps(found))
    assert again == found and again.others == found.others
    assert found != cdpr.pose_from_lengths(robot, robot.cable_lengths([0, 0, 2.1]))


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"lengths": [5.0] * 3}, r"lengths: found an array of shape \(3,\), expected \(8,\) or \(n, 8\)"),
        ({"lengths": 5.0}, r"lengths: found an array of shape \(\), expected"),
        ({"lengths": [9.0, 9, 0, 9, 9, 9, 9, 9]}, "lengths.cable 2: found a length of 0 m, expected a positive number"),
        ({"lengths": [[9.0] * 8, [9.0] * 7 + [-1]]}, r"lengths\[1\].cable 7: found a length of -1 m"),
        ({"lengths": [np.nan] * 8}, "lengths.cable 0: found a length of NaN m"),
        ({"lengths": [4978.0, 5644, 7742, 1.7, 0.03, 1e-4, 65, 301]}, "lengths: found no pose after 200 iterations: the root mean square"),
        ({"guess": [0, 0]}, r"guess\[0\]: found an array of shape \(\), expected \(3,\)"),
        ({"guess": [0, 0, np.inf]}, r"guess\[2\]: found inf"),
        ({"guess": ([0, 0, 1], [1, 1, 0, 0])}, r"guess\[1\]: found a quaternion of length 1.41"),
        ({"orientation": [2, 0, 0, 0]}, "orientation: found a quaternion of length 2"),
        ({"robot": hanging_point(), "lengths": [5.0] * 4}, "robot.cables: found 4 cables, expected at least 6"),
        ({"robot": "cogiro"}, "robot: found the text 'cogiro', expected a Robot"),
    ],
)
def test_errors_say_what_was_found(robot, change, said):
    with pytest.raises(cdpr.InputError, match=said):
        cdpr.pose_from_lengths(**{"robot": robot, "lengths": [9.0] * 8} | change)
