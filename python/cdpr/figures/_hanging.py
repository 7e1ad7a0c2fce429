"""The course of a cable with a pulley or weight: round the wheel, then hanging below the straight line to its end.

The mathematics is that of the core, in ``geometry/pulley.rs`` and ``model/envelope.rs``.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from .._arrays import Floats

_ARC = np.linspace(0, 1, 9)
_HANGING = np.linspace(0, 1, 17)


def course(cable: dict[str, Any], end: Floats) -> Floats:
    """Return points (n, 3) of a cable from its outlet to its end, m, as low as it can hang."""
    outlet, pulley, sag = np.array(cable["outlet"]), cable["bent"].get("pulley"), cable["bent"].get("sag")
    arc = _arc(outlet, pulley, end) if pulley else outlet[None]
    if not sag:
        return np.vstack([arc, end])
    up, curvature = np.array(sag["up"]), sag["weight"] * sag["factor"] / (2 * sag["tension"])
    # It leaves its wheel in the direction in which it begins: to a point below its end. Two steps suffice to find it, as the
    # chord hardly changes.
    for _ in range(2 if pulley else 0):
        arc = _arc(outlet, pulley, end - curvature * np.sum((end - arc[-1]) ** 2) * up)
    share, chord = _HANGING[:, None], end - arc[-1]
    return np.vstack([arc[:-1], arc[-1] + share * chord - curvature * chord @ chord * share * (1 - share) * up])


def _arc(outlet: Floats, pulley: dict[str, Any], end: Floats) -> Floats:
    """Return points from the outlet to where the taut cable to the end leaves its wheel; the outlet alone if it cannot."""
    radius, axis = pulley["radius"], np.array(pulley["axis"])
    height = axis @ (end - outlet)
    across = end - outlet - height * axis
    distance = float(np.linalg.norm(across))
    beyond = distance - 2 * radius
    square = distance * beyond + height * height
    if not (square > 0 and distance > 0) or (height < 0 and beyond < 0):
        return outlet[None]
    free = np.sqrt(square)
    half = np.arctan2(distance, height + free) if height >= 0 else np.arctan2(free - height, beyond)
    angle = 2 * half * _ARC[:, None]
    points: Floats = outlet + radius * ((1 - np.cos(angle)) * across / distance + np.sin(angle) * axis)
    return points
