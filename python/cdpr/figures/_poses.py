"""The platform along a path: its positions and orientations at even steps."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from .._arrays import Floats
from .._paths import two_or_more
from .._results import Path, Result
from .._scene import Scene
from ..exceptions import InputError

_NO_TURN = 1e-12  # rad


class Way(NamedTuple):
    """A path that can be drawn: waypoints (k, 3), and the orientation at each of them (k, 4)."""

    positions: Floats
    orientations: Floats
    turns: bool

    @property
    def length(self) -> float:
        """Length of the line of the platform's origin, m."""
        return float(np.linalg.norm(np.diff(self.positions, axis=0), axis=1).sum())

    @property
    def words(self) -> str:
        """How far the platform turns in all, to be written after a length; empty if it does not."""
        return f", turns by {np.degrees(self.angles.sum()):.0f}°" if self.turns else ""

    @property
    def angles(self) -> Floats:
        """The angle of the turn between each two waypoints, rad."""
        return np.array([2 * _half_turn(*pair)[1] for pair in zip(self.orientations[:-1], self.orientations[1:], strict=True)])

    def steps(self, scene: Scene) -> Floats:
        """Length of each segment with its turn, m."""
        steps: Floats = np.linalg.norm(np.diff(self.positions, axis=0), axis=1) + scene._core.turn_weight() * self.angles
        return steps

    def at(self, scene: Scene, places: Floats) -> tuple[Floats, Floats]:
        """Positions and orientations at these distances from the start, which count turns like the length of the path."""
        ends = np.concatenate([[0.0], np.cumsum(self.steps(scene))])
        segments = np.clip(np.searchsorted(ends, places, side="right") - 1, 0, len(ends) - 2)
        sizes = ends[segments + 1] - ends[segments]
        shares = np.clip((places - ends[segments]) / np.where(sizes > 0, sizes, 1.0), 0.0, 1.0)[:, None]
        positions: Floats = (1 - shares) * self.positions[segments] + shares * self.positions[segments + 1]
        turns = [between(self.orientations[k], self.orientations[k + 1], t) for k, t in zip(segments, shares[:, 0], strict=True)]
        return positions, np.array(turns)


def way_of(name: str, scene: Scene, path: ArrayLike | Path) -> Way:
    """What can be drawn as a path; without orientations, the platform keeps the scene's."""
    if isinstance(path, Result) and not path.solved:
        raise InputError(f"{name}: found a result with status {path.status!r}, expected a solved one")
    positions = two_or_more(name, path)
    own = path.orientations if isinstance(path, Path) else None
    level = np.tile(scene.orientation, (len(positions), 1))
    return Way(positions, level if own is None else own, own is not None)


def between(first: Floats, last: Floats, share: float) -> Floats:
    """Return the orientation after a share of the shorter turn from one to another."""
    last, half = _half_turn(first, last)
    if half < _NO_TURN:
        return first
    found: Floats = (np.sin((1 - share) * half) * first + np.sin(share * half) * last) / np.sin(half)
    return found


def _half_turn(first: Floats, last: Floats) -> tuple[Floats, float]:
    """Return the quaternion of the second orientation nearer to that of the first, and half the angle of the turn to it, rad."""
    last = -last if first @ last < 0 else last
    return last, 2 * float(np.arctan2(np.linalg.norm(last - first), np.linalg.norm(last + first)))


def rotation(quaternion: Floats) -> Floats:
    """Return the world-from-platform rotation matrix of a unit quaternion w x y z."""
    w, x, y, z = quaternion
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )
