"""Lengths of cables round pulleys are those of CASPR.

Both begin where the cable meets its wheel and include the part on the wheel, so there is no constant between the two.
"""

from __future__ import annotations

import numpy as np
import pytest
from conftest import TESTDATA
from pulleys import leaves, rotation

import cdpr


@pytest.fixture(scope="module")
def caroca() -> cdpr.Robot:
    with pytest.warns(cdpr.CdprWarning, match="not carried over"):
        return cdpr.import_robot(TESTDATA / "caspr" / "CAROCA", cable_set="with_rotating_pulleys")


def poses(generator, count, lower, upper):
    """Random positions in a box, and orientations of all kinds."""
    quaternions = generator.normal(size=(count, 4))
    return generator.uniform(lower, upper, (count, 3)), quaternions / np.linalg.norm(quaternions, axis=1, keepdims=True)


def compared(robot, positions, quaternions):
    """Largest difference of lengths from CASPR's, m, how many were compared, and how many neither robot has."""
    worst, number, impossible = 0.0, 0, 0
    for position, quaternion in zip(positions, quaternions, strict=True):
        found = robot.cable_lengths(position, orientation=quaternion)
        ends = position + robot.attachments @ rotation(quaternion).T
        for length, outlet, pulley, end in zip(found, robot.outlets, robot.pulleys, ends, strict=True):
            _, expected, possible = leaves(outlet, pulley["axis"], pulley["radius"], end)
            assert possible != np.isnan(length), (position, quaternion, length, expected)
            worst = max(worst, abs(length - expected)) if possible else worst
            number, impossible = number + possible, impossible + (not possible)
    return worst, number, impossible


def test_lengths_of_caroca_are_those_of_caspr(caroca):
    # The ranges of the joint in CAROCA's bodies file: all of its hall, above the outlets as well.
    worst, number, impossible = compared(caroca, *poses(np.random.default_rng(1), 2000, [-3.5, -3.5, 0.0], [3.5, 3.5, 3.5]))
    print(f"{number} lengths differ by at most {worst:.1e} m; {impossible} cables wrap more than half a turn")
    assert number > 15_000 and worst < 1e-9
    assert impossible < 50


def test_lengths_round_tilted_pulleys_are_those_of_caspr(caroca):
    generator = np.random.default_rng(2)
    for _ in range(20):
        axes = generator.normal([0.0, 0.0, 1.0], 0.3, (8, 3)) * generator.uniform(0.01, 100.0)
        radii = generator.uniform(0.01, 0.5, 8)
        pulleys = [{"radius": r, "axis": list(a)} for r, a in zip(radii, axes, strict=True)]
        robot = caroca.replace(pulleys=pulleys)
        worst, number, _ = compared(robot, *poses(generator, 50, [-1.2, -2.0, 0.0], [1.2, 2.0, 2.5]))
        assert number > 300 and worst < 1e-9


def test_a_length_worked_by_hand(caroca):
    # The attachment of the first cable at the height of its outlet, 0.585 m away: D = 0.54 from the wheel's centre, which
    # is 12 radii; the free length is sqrt(0.54² - 0.045²), the wrap π minus arccos(1/12).
    outlet, attachment = caroca.outlets[0], caroca.attachments[0]
    position = outlet - attachment - [0.585, 0.0, 0.0]
    expected = np.sqrt(0.54**2 - 0.045**2) + 0.045 * (np.pi - np.arccos(1 / 12))
    assert caroca.cable_lengths(position)[0] == pytest.approx(expected, abs=1e-12)
    assert leaves(outlet, [0, 0, 1], 0.045, position + attachment)[1] == pytest.approx(expected, abs=1e-9)


def test_a_cable_that_would_wrap_more_than_half_a_turn_has_no_length(caroca):
    # Below the outlet and nearer to the axis than twice the radius, 0.09 m; CASPR would go round the other side of the wheel.
    under = caroca.outlets[0] - caroca.attachments[0]
    lengths = caroca.cable_lengths([under - [0.08, 0.0, 1.0], under - [0.1, 0.0, 1.0]])
    assert np.isnan(lengths[0, 0]) and lengths[1, 0] == pytest.approx(1.0 + 0.045 * np.pi, abs=2e-3)


def test_cables_pull_towards_the_leaving_point_of_caspr(caroca):
    for position, quaternion in zip(*poses(np.random.default_rng(3), 200, [-1.2, -2.0, 0.0], [1.2, 2.0, 2.5]), strict=True):
        matrix = cdpr.wrench_matrix(caroca, position, orientation=quaternion)
        ends = position + caroca.attachments @ rotation(quaternion).T
        for k, end in enumerate(ends):
            leaving, _, possible = leaves(caroca.outlets[k], [0, 0, 1], 0.045, end)
            assert possible
            pull = (leaving - end) / np.linalg.norm(leaving - end)
            assert np.abs(matrix[:3, k] - pull).max() < 1e-9
