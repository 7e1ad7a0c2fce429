"""Where a cable leaves its pulley, as CASPR defines it: independent of the package."""

from __future__ import annotations

import numpy as np


def leaves(fixed, entry, radius, attachment):
    """Leaving point, length from the fixed point to the attachment, and whether at most half a turn lies on the wheel.

    The definition of CASPR (``BaseRotatingPulleyAttachment`` and ``CableModelBase``, https://github.com/darwinlau/CASPR),
    restated: the cable meets the wheel at the fixed point F, running in the direction of the entry vector v. The wheel's
    centre C is at its radius from F, at right angles to v, on the side of the attachment B. The cable leaves at the point A
    where the line to B touches the wheel, the tangent point on the side of v. Its length is |AB| plus the arc from F to A,
    the radius times the angle between CF and CA.
    """
    up = np.asarray(entry) / np.linalg.norm(entry)
    line = attachment - fixed
    side = line - (line @ up) * up
    side /= np.linalg.norm(side)
    center = fixed + radius * side
    to_end = attachment - center
    distance = np.linalg.norm(to_end)
    if distance <= radius:
        return center, np.nan, False
    elevation = np.arctan2(to_end @ up, to_end @ side) + np.arccos(radius / distance)
    leaving = center + radius * (np.cos(elevation) * side + np.sin(elevation) * up)
    cosine = (fixed - center) @ (leaving - center) / radius**2
    arc = radius * np.arccos(np.clip(cosine, -1.0, 1.0))
    return leaving, np.linalg.norm(attachment - leaving) + arc, elevation >= 0.0


def rotation(quaternion):
    """The matrix of a unit quaternion w x y z."""
    w, x, y, z = quaternion
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + 2 * w * cross + 2 * cross @ cross
