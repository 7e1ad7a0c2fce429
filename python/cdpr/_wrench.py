"""Wrenches: what the cables can exert, its margin over what is required, and the tensions."""

from __future__ import annotations

import json
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arrays import Floats, flat_points, number, numbers, point, rows, shaped, thread_count
from ._distribution import Distribution, distribution
from ._given import instance
from ._robot import Robot
from ._values import ByValue


def _statics(
    robot: Robot,
    orientation: ArrayLike | None,
    gravity: ArrayLike | None,
    load: ArrayLike | None,
    characteristic_length: float = 1.0,
) -> _core.Statics:
    return _core.Statics(
        json.dumps(instance("robot", robot, Robot).to_dict()),
        None if orientation is None else numbers("orientation", orientation, 4, "w x y z"),
        None if gravity is None else point("gravity", gravity),
        None if load is None else numbers("load", load, 6, "fx fy fz mx my mz"),
        number("characteristic_length", characteristic_length),
    )


def wrench_matrix(robot: Robot, positions: ArrayLike, *, orientation: ArrayLike | None = None) -> Floats:
    """Compute wrench matrices W: column i is [uᵢ ; rᵢ × uᵢ], and equilibrium is W t + w_ext = 0.

    Parameters
    ----------
    robot : Robot
    positions : array_like (..., 3)
        Positions of the platform's origin, world, m.
    orientation : array_like (4,), optional
        World-from-platform unit quaternion w x y z; default: no rotation.

    Returns
    -------
    ndarray (..., 6, m)
        World axes; uᵢ is the unit vector from attachment to outlet, rᵢ runs from the platform's origin to the attachment.
        Rows 0 to 2 have no unit, rows 3 to 5 are metres.

    Raises
    ------
    InputError
        A position where a cable has no length.

    Examples
    --------
    >>> import cdpr
    >>> robot = cdpr.example("cogiro").robot
    >>> w = wrench_matrix(robot, [[0, 0, 2], [1, 0, 2]])
    >>> w.shape, int(np.linalg.matrix_rank(w[0]))
    ((2, 6, 8), 6)
    """
    flat, shape = flat_points("positions", positions)
    return shaped(_statics(robot, orientation, None, None).wrench_matrix(flat), shape)


def capacity_margin(
    robot: Robot,
    positions: ArrayLike,
    *,
    force: float = 0.0,
    moment: float = 0.0,
    vertices: ArrayLike | None = None,
    load: ArrayLike | None = None,
    gravity: ArrayLike | None = None,
    orientation: ArrayLike | None = None,
    characteristic_length: float = 1.0,
    threads: int | None = None,
) -> Floats:
    """Compute the capacity margin: the smallest slack of the required wrenches over all facets of the available wrench set.

    Parameters
    ----------
    robot : Robot
        With a mass and tension limits.
    positions : array_like (..., 3)
        Positions of the platform's origin, world, m.
    force, moment : float
        Radii of the required balls, N and N·m, around the wrench that balances weight and load.
    vertices : array_like (k, 6), optional
        Corners of a required polytope instead of the balls, N and N·m, on top of the balancing wrench.
    load : array_like (6,), optional
        An additional constant wrench, world axes, with its moment about the platform's origin, N and N·m.
    gravity : array_like (3,), optional
        World axes, m/s²; default (0, 0, -9.81). It acts at the robot's centre of mass.
    orientation : array_like (4,), optional
        World-from-platform unit quaternion w x y z; default: no rotation.
    characteristic_length : float
        Length that converts moments to forces, m.
    threads : int, optional
        Default all cores; the answers do not depend on it.

    Returns
    -------
    ndarray (...)
        Margins, N; a NumPy scalar for a single position. If a margin is not negative, all required wrenches are
        available; NaN where a cable has no length. For a point mass only the three force rows count.

    Raises
    ------
    InputError
        A robot without mass or tension limits, negative radii, a moment required of a point mass.

    Notes
    -----
    A rigorous form of the paper's section 3.3: forces and moments are considered together. See ``docs/wrench.md``.

    Examples
    --------
    >>> import cdpr
    >>> robot = cdpr.example("cogiro").robot
    >>> capacity_margin(robot, [[0, 0, 2], [6, 5, 0]], force=50, moment=5).round(1)
    array([ 316.4, -196.8])
    """
    corners = None if vertices is None else [tuple(corner) for corner in rows("vertices", vertices, 6).tolist()]
    statics = _statics(robot, orientation, gravity, load, characteristic_length)
    flat, shape = flat_points("positions", positions)
    radii = number("force", force), number("moment", moment)
    return shaped(statics.capacity_margin(flat, *radii, corners, thread_count(threads)), shape)


def force_margin(
    robot: Robot,
    positions: ArrayLike,
    *,
    load: ArrayLike | None = None,
    gravity: ArrayLike | None = None,
    orientation: ArrayLike | None = None,
    threads: int | None = None,
) -> Floats:
    """Compute the radius of the largest ball of forces around the balancing force that the cables can exert, with any moment.

    This is the paper's effective force set. It is optimistic: a force may come with a moment.

    Parameters
    ----------
    robot : Robot
        With a mass and tension limits.
    positions : array_like (..., 3)
        Positions of the platform's origin, world, m.
    load : array_like (6,), optional
        An additional constant wrench, world axes, with its moment about the platform's origin, N and N·m.
    gravity : array_like (3,), optional
        World axes, m/s²; default (0, 0, -9.81). It acts at the robot's centre of mass.
    orientation : array_like (4,), optional
        World-from-platform unit quaternion w x y z; default: no rotation.
    threads : int, optional
        Default all cores.

    Returns
    -------
    ndarray (...)
        Margins, N; a NumPy scalar for a single position. Negative where the balancing force itself is not available.

    Raises
    ------
    InputError
        A robot without mass or tension limits.

    Examples
    --------
    >>> import cdpr
    >>> robot = cdpr.example("cogiro").robot
    >>> force_margin(robot, [[0, 0, 2]]).round(1)
    array([589.1])
    """
    flat, shape = flat_points("positions", positions)
    statics = _statics(robot, orientation, gravity, load)
    return shaped(statics.force_margin(flat, thread_count(threads)), shape)


def moment_margin(
    robot: Robot,
    positions: ArrayLike,
    *,
    load: ArrayLike | None = None,
    gravity: ArrayLike | None = None,
    orientation: ArrayLike | None = None,
    threads: int | None = None,
) -> Floats:
    """Compute the radius of the largest ball of moments around the balancing moment that the cables can exert, with any force.

    Parameters
    ----------
    robot : Robot
        With a mass and tension limits.
    positions : array_like (..., 3)
        Positions of the platform's origin, about which the moments are, world, m.
    load : array_like (6,), optional
        An additional constant wrench, world axes, with its moment about the platform's origin, N and N·m.
    gravity : array_like (3,), optional
        World axes, m/s²; default (0, 0, -9.81). It acts at the robot's centre of mass.
    orientation : array_like (4,), optional
        World-from-platform unit quaternion w x y z; default: no rotation.
    threads : int, optional
        Default all cores.

    Returns
    -------
    ndarray (...)
        Margins, N·m; a NumPy scalar for a single position. NaN for a point mass, on which cables exert no moments.

    Examples
    --------
    >>> import cdpr
    >>> robot = cdpr.example("cogiro").robot
    >>> moment_margin(robot, [[0, 0, 2]]).round(1)
    array([5505.6])
    """
    flat, shape = flat_points("positions", positions)
    statics = _statics(robot, orientation, gravity, load)
    return shaped(statics.moment_margin(flat, thread_count(threads)), shape)


@dataclass(frozen=True, eq=False, repr=False)
class AvailableSet(ByValue):
    """The set of forces or of moments that the cables can exert at a position, as a surface.

    Attributes
    ----------
    rank : int
        Dimension of the set: 3 for a closed surface, 2 for a polygon with two sides, 1 for a segment, 0 for a point.
    balance : ndarray (3,)
        The force (moment) that balances weight and load, N (N·m).
    margin : float
        Radius of the largest ball around ``balance`` inside the set, N (N·m); negative where the balance is outside.
    vertices : ndarray (n, 3)
        Corners, N (N·m), world axes.
    triangles : ndarray (k, 3) of int64
        Corners of each triangle, counter-clockwise seen from outside, as indices into ``vertices``.

    Examples
    --------
    >>> import cdpr
    >>> force_set(cdpr.example("empty").robot, [1, 1, 1])
    AvailableSet(rank 3, margin 1561, 14 vertices)
    """

    rank: int
    balance: Floats
    margin: float
    vertices: Floats
    triangles: NDArray[np.int64]

    def __repr__(self) -> str:
        """Show rank, margin and size."""
        return f"AvailableSet(rank {self.rank}, margin {self.margin:.4g}, {len(self.vertices)} vertices)"


def force_set(
    robot: Robot,
    position: ArrayLike,
    *,
    load: ArrayLike | None = None,
    gravity: ArrayLike | None = None,
    orientation: ArrayLike | None = None,
) -> AvailableSet:
    """Compute the set of forces that the cables can exert at a position, with any moment: the paper's Figure 4b.

    Parameters
    ----------
    robot : Robot
        With a mass and tension limits.
    position : array_like (3,)
        Of the platform's origin, world, m.
    load : array_like (6,), optional
        An additional constant wrench, world axes, with its moment about the platform's origin, N and N·m.
    gravity : array_like (3,), optional
        World axes, m/s²; default (0, 0, -9.81). It acts at the robot's centre of mass.
    orientation : array_like (4,), optional
        World-from-platform unit quaternion w x y z; default: no rotation.

    Returns
    -------
    AvailableSet

    Raises
    ------
    InputError
        A robot without mass or tension limits; a position where a cable has no length.

    Examples
    --------
    >>> import cdpr
    >>> found = force_set(cdpr.example("empty").robot, [1, 1, 1])
    >>> len(found.vertices), round(found.balance[2], 1)  # a rhombic dodecahedron: four directions, both ways
    (14, np.float64(98.1))
    """
    return _available(_statics(robot, orientation, gravity, load).force_set(point("position", position)))


def moment_set(
    robot: Robot,
    position: ArrayLike,
    *,
    load: ArrayLike | None = None,
    gravity: ArrayLike | None = None,
    orientation: ArrayLike | None = None,
) -> AvailableSet:
    """Compute the set of moments that the cables can exert at a position, with any force.

    Parameters
    ----------
    robot : Robot
        With a mass and tension limits; not a point mass.
    position : array_like (3,)
        Of the platform's origin, about which the moments are, world, m.
    load : array_like (6,), optional
        An additional constant wrench, world axes, with its moment about the platform's origin, N and N·m.
    gravity : array_like (3,), optional
        World axes, m/s²; default (0, 0, -9.81). It acts at the robot's centre of mass.
    orientation : array_like (4,), optional
        World-from-platform unit quaternion w x y z; default: no rotation.

    Returns
    -------
    AvailableSet

    Raises
    ------
    InputError
        A robot without mass or tension limits; a position where a cable has no length; a point mass, on which no moments act.

    Examples
    --------
    >>> import cdpr
    >>> found = moment_set(cdpr.example("cogiro").robot, [0, 0, 2])
    >>> found.rank, round(found.margin, 1)
    (3, 5505.6)
    """
    return _available(_statics(robot, orientation, gravity, load).moment_set(point("position", position)))


def _available(found: tuple[int, tuple[float, float, float], float, Floats, NDArray[np.int64]]) -> AvailableSet:
    rank, balance, margin, vertices, triangles = found
    return AvailableSet(rank, np.array(balance, dtype=np.float64), margin, vertices, triangles)


def tension_distribution(
    robot: Robot,
    positions: ArrayLike,
    *,
    load: ArrayLike | None = None,
    tensions: Distribution | None = None,
    reference: ArrayLike | None = None,
    gravity: ArrayLike | None = None,
    orientation: ArrayLike | None = None,
    characteristic_length: float = 1.0,
    threads: int | None = None,
) -> Floats:
    """Compute tensions within the limits that balance the loads.

    Of all such tensions, the choice ``tensions`` selects those with the smallest

    - "middle": Σ (tᵢ − mᵢ)², with mᵢ the middle of the limits of cable i;
    - "least": Σ tᵢ²;
    - "p4", "p8": Σ (tᵢ − mᵢ)⁴ or ⁸, so that few come near a limit;
    - "closed-form": Σ (tᵢ − mᵢ)² without regard to limits; none where they exceed one.

    Without regard to limits, "middle" has a closed form as well, so both are the same where the latter exists.

    Parameters
    ----------
    robot : Robot
        With a mass and tension limits.
    positions : array_like (..., 3)
        Positions of the platform's origin, world, m.
    load : array_like (6,), optional
        An additional constant wrench, world axes, with its moment about the platform's origin, N and N·m.
    tensions : {"middle", "least", "p4", "p8", "closed-form"}, optional
        Default that of the robot, else "middle".
    reference : array_like (m,), optional
        Instead of ``tensions``: tension of each cable that the tensions are to be near, N; they have the smallest Σ (tᵢ − refᵢ)².
    gravity : array_like (3,), optional
        World axes, m/s²; default (0, 0, -9.81). It acts at the robot's centre of mass.
    orientation : array_like (4,), optional
        World-from-platform unit quaternion w x y z; default: no rotation.
    characteristic_length : float
        Length that converts moments to forces, m.
    threads : int, optional
        Default all cores.

    Returns
    -------
    ndarray (..., m)
        N; rows of NaN where no tensions within the limits balance the loads, or those in closed form exceed a limit. They are
        continuous along a path where the capacity margin is positive.

    Raises
    ------
    InputError
        A robot without mass or tension limits, a reference of another size, both ``tensions`` and ``reference``.

    Notes
    -----
    C. Gosselin and M. Grenier, "On the determination of the force distribution in overconstrained cable-driven parallel
    mechanisms", Meccanica 46, 2011, for "p4" and "p8". A. Pott, T. Bruckmann and L. Mikelsons, "Closed-form force distribution for
    parallel wire robots", Computational Kinematics, 2009.

    Examples
    --------
    >>> import cdpr
    >>> robot = cdpr.example("cogiro").robot
    >>> t = tension_distribution(robot, [[0, 0, 2]])
    >>> weight = np.array([0, 0, -robot.mass * 9.81])
    >>> bool(np.allclose((wrench_matrix(robot, [[0, 0, 2]])[0] @ t[0])[:3] + weight, 0, atol=1e-6))
    True

    The smallest tensions, and those that keep away from the limits:

    >>> least, p4 = (tension_distribution(robot, [0, 0, 2], tensions=chosen) for chosen in ("least", "p4"))
    >>> bool(least.sum() < p4.sum())
    True
    """
    statics = _statics(robot, orientation, gravity, load, characteristic_length)
    chosen = distribution(tensions, reference)
    wanted = None if reference is None else numbers("reference", reference, len(robot.outlets))
    flat, shape = flat_points("positions", positions)
    return shaped(statics.tensions(flat, wanted, chosen, thread_count(threads)), shape)
