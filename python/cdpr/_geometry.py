"""Distances between convex polytopes."""

from __future__ import annotations

from numpy.typing import ArrayLike

from . import _core
from ._arrays import Floats, flat_points

import numpy as np


class Distance(float):
    """A distance in metres, zero if the bodies intersect; a float with witness points.

    Attributes
    ----------
    intersects : bool
        Whether the bodies have a point in common, touching included.
    points : ndarray (2, 3)
        Nearest points of the first and the second body; if they intersect, a common point, as nearly as it could be
        found.
    depth : float
        How far one body must move to separate them, m; 0 if they are apart or only touch.

    Examples
    --------
    >>> apart = distance([[0, 0, 0]], [[0, 0, 2]])
    >>> apart, apart + 1.0, apart.intersects
    (2.0, 3.0, False)
    """

    intersects: bool
    points: Floats
    depth: float

    def __new__(cls, distance: float, points: ArrayLike, depth: float) -> Distance:
        """Make a distance; :func:`distance` does."""
        self = super().__new__(cls, distance)
        self.intersects = distance == 0.0
        self.points = np.asarray(points, dtype=np.float64)
        self.depth = depth
        return self

    def __reduce__(self) -> tuple[type[Distance], tuple[float, Floats, float]]:
        """Pickle with the attributes."""
        return Distance, (float(self), self.points, self.depth)


def distance(a: ArrayLike, b: ArrayLike) -> Distance:
    """Compute the distance between the convex hulls of two vertex lists: point, segment, polygon or polyhedron, in any combination.

    Parameters
    ----------
    a, b : array_like (k, 3) or (3,)
        Vertices, m; one alone is a point.

    Returns
    -------
    Distance
        A float, m, with ``intersects``, ``points`` and ``depth``.

    Raises
    ------
    InputError
        Wrong shape, no vertices, numbers that are not finite.
    KeyboardInterrupt
        On Ctrl-C, immediately; a hull of many points is then still computed to its end on a separate thread.

    Notes
    -----
    GJK, the paper's Algorithm 2; overlaps are decided exactly by separating axes.

    Examples
    --------
    >>> square = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    >>> d = distance(square, [[0.5, 0.5, 2.0]])
    >>> float(d), d.intersects
    (2.0, False)
    >>> d.points
    array([[0.5, 0.5, 0. ],
           [0.5, 0.5, 2. ]])
    """
    value, on_a, on_b, depth = _core.polytope_distance(flat_points("a", a)[0], flat_points("b", b)[0])
    return Distance(value, [on_a, on_b], depth)
