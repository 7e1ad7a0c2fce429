"""Cables with pulleys and weight in figures."""

import numpy as np
import pytest
from artists import closed, named, points_of  # noqa: F401 (fixture)

import cdpr
from cdpr import figures

AT = np.array([1.0, 0.8, 0.9])


def drawn(scene, cable, number):
    """The points of a cable of a scene whose cables all have these keys, and its end."""
    spec = scene.to_dict()
    bent = cdpr.Scene.from_dict(spec | {"robot": spec["robot"] | {"cable": cable}})
    (line,) = named(figures.scene(bent, at=AT), f"cable {number}")
    points = points_of(line)
    return points[np.isfinite(points).all(axis=1)], AT + scene.robot.attachments[number]


def test_a_cable_with_weight_hangs_deepest_in_the_middle(empty):
    points, end = drawn(empty, {"linear_density": 0.1, "sag_tension": 30}, 7)
    outlet = empty.robot.outlets[7]
    assert (points[0] == outlet).all() and points[-1] == pytest.approx(end)
    # At the highest place of the workspace the tension in the middle is that at the platform.
    weight, slackness = 0.981, 0.981 * 2 * np.sqrt(3) / 30
    deepest = weight * np.sum((end - outlet) ** 2) / (8 * 30) * (1 + slackness / 4)
    assert points[len(points) // 2] == pytest.approx((outlet + end) / 2 - [0, 0, deepest], abs=1e-6)


def test_a_cable_with_a_pulley_runs_round_the_wheel(empty):
    points, end = drawn(empty, {"pulley": {"radius": 0.1, "axis": [0, 0, 1]}}, 7)
    outlet = empty.robot.outlets[7]
    side = (end - outlet) * [1, 1, 0] / np.linalg.norm((end - outlet)[:2])
    radial = points[:-1] - (outlet + 0.1 * side)
    assert np.linalg.norm(radial, axis=1) == pytest.approx(0.1)
    assert (points[0] == outlet).all() and (points[-1] == end).all()
    assert radial[-1] @ (end - points[-2]) == pytest.approx(0, abs=1e-12)
