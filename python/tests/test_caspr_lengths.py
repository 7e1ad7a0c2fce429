"""Lengths of cables round pulleys are those of CASPR.

CASPR's definition (``BaseRotatingPulleyAttachment`` and ``CableModelBase``, https://github.com/darwinlau/CASPR), restated:
the cable meets the wheel at the fixed point F, running in the direction of the entry vector v. The wheel's centre C is at
its radius from F, at right angles to v, on the side of the attachment B. The cable leaves at the point A where the line to
B touches the wheel, the tangent point on the side of v. Its length is |AB| plus the arc from F to A, the radius times
the angle between CF and CA. It begins at F like the lengths here, so there is no constant between the two.
"""

from __future__ import annotations

import numpy as np
import pytest
from conftest import TESTDATA

import cdpr


@pytest.fixture(scope="module")
def caroca() -> cdpr.Robot:
    with pytest.warns(cdpr.CdprWarning, match="not carried over"):
        return cdpr.import_robot(TESTDATA / "caspr" / "CAROCA", cable_set="with_rotating_pulleys")


def of_caspr(fixed, entry, radius, attachment):
    """Length and leaving point of a cable (CASPR), and whether it touches at most half of the wheel, outside of it."""
    up = entry / np.linalg.norm(entry)
    line = attachment - fixed
    side = line - (line @ up) * up
    side /= np.linalg.norm(side)
    center = fixed + radius * side
    to_end = attachment - center
    distance = np.linalg.norm(to_end)
    if distance <= radius:
        return np.nan, center, False
    elevation = np.arctan2(to_end @ up, to_end @ side) + np.arccos(radius / distance)
    leaving = center + radius * (np.cos(elevation) * side + np.sin(elevation) * up)
    cosine = (fixed - center) @ (leaving - center) / radius**2
    arc = radius * np.arccos(np.clip(cosine, -1.0, 1.0))
    return np.linalg.norm(attachment - leaving) + arc, leaving, elevation >= 0.0


def poses(generator, count, lower, upper):
    """Random positions in a box, and orientations of all kinds."""
    quaternions = generator.normal(size=(count, 4))
    return generator.uniform(lower, upper, (count, 3)), quaternions / np.linalg.norm(quaternions, axis=1, keepdims=True)


def rotation(quaternion):
    w, x, y, z = quaternion
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + 2 * w * cross + 2 * cross @ cross


def compared(robot, positions, quaternions):
    """Largest difference of lengths from CASPR's, m, how many were compared, and how many neither robot has."""
    worst, number, impossible = 0.0, 0, 0
    for position, quaternion in zip(positions, quaternions, strict=True):
        found = robot.cable_lengths(position, orientation=quaternion)
        ends = position + robot.attachments @ rotation(quaternion).T
        for length, outlet, pulley, end in zip(found, robot.outlets, robot.pulleys, ends, strict=True):
            expected, _, possible = of_caspr(outlet, np.array(pulley["axis"]), pulley["radius"], end)
            assert possible != np.isnan(length), (position, quaternion, length, expected)
            worst = max(worst, abs(length - expected)) if possible else worst
            number, impossible = number + possible, impossible + (not possible)
    return worst, number, impossible


def test_lengths_of_caroca_are_those_of_caspr(caroca):
    # The ranges of the joint in CAROCA's bodies file: all of its hall, above the outlets as well.
    worst, number, impossible = compared(caroca, *poses(np.random.default_rng(1), 2000, [-3.5, -3.5, 0.0], [3.5, 3.5, 3.5]))
    print(f"{number} lengths differ by at most {worst:.1e} m; {impossible} cables wrap more than half a turn")
    assert number > 15_000 and worst < 1e-8
    assert impossible < 50


def test_lengths_round_tilted_pulleys_are_those_of_caspr(caroca):
    generator = np.random.default_rng(2)
    for _ in range(20):
        axes = generator.normal([0.0, 0.0, 1.0], 0.3, (8, 3)) * generator.uniform(0.01, 100.0)
        radii = generator.uniform(0.01, 0.5, 8)
        pulleys = [{"radius": r, "axis": list(a)} for r, a in zip(radii, axes, strict=True)]
        robot = caroca.replace(pulleys=pulleys)
        worst, number, _ = compared(robot, *poses(generator, 50, [-1.2, -2.0, 0.0], [1.2, 2.0, 2.5]))
        assert number > 300 and worst < 1e-8


def test_a_length_worked_by_hand(caroca):
    # The attachment of the first cable at the height of its outlet, 0.585 m away: D = 0.54 from the wheel's centre, which
    # is 12 radii; the free length is sqrt(0.54² - 0.045²), the wrap π minus arccos(1/12).
    outlet, attachment = caroca.outlets[0], caroca.attachments[0]
    position = outlet - attachment - [0.585, 0.0, 0.0]
    expected = np.sqrt(0.54**2 - 0.045**2) + 0.045 * (np.pi - np.arccos(1 / 12))
    assert caroca.cable_lengths(position)[0] == pytest.approx(expected, abs=1e-12)
    assert of_caspr(outlet, np.array([0.0, 0.0, 1.0]), 0.045, position + attachment)[0] == pytest.approx(expected, abs=1e-9)


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
            _, leaving, possible = of_caspr(caroca.outlets[k], np.array([0.0, 0.0, 1.0]), 0.045, end)
            assert possible
            pull = (leaving - end) / np.linalg.norm(leaving - end)
            assert np.abs(matrix[:3, k] - pull).max() < 1e-9
