"""Wrenches: what the cables can exert, how far that is from what they must, and with which tensions."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _core
from ._arrays import Floats, number, numbers, point, rows, thread_count
from ._pandas import frame
from ._planning import core_for, path_rows
from ._results import Path
from ._robot import Robot
from ._scene import Scene
from ._values import ByValue


def _statics(
    robot: Robot,
    orientation: ArrayLike | None,
    gravity: ArrayLike | None,
    load: ArrayLike | None,
    characteristic_length: float = 1.0,
) -> _core.Statics:
    return _core.Statics(
        json.dumps(robot.to_dict()),
        None if orientation is None else numbers("orientation", orientation, 4, "w x y z"),
        None if gravity is None else point("gravity", gravity),
        None if load is None else numbers("load", load, 6, "fx fy fz mx my mz"),
        number("characteristic_length", characteristic_length),
    )


def wrench_matrix(robot: Robot, positions: ArrayLike, *, orientation: ArrayLike | None = None) -> Floats:
    """Wrench matrices W: column i is [uᵢ ; rᵢ × uᵢ], and equilibrium is W t + w_ext = 0.

    Parameters
    ----------
    robot : Robot
    positions : array_like (n, 3)
        Positions of the platform's origin, world, m.
    orientation : array_like (4,), optional
        World-from-platform unit quaternion w x y z; default no turn.

    Returns
    -------
    ndarray (n, 6, m)
        World axes; uᵢ is the unit vector from attachment to outlet, rᵢ runs from the platform's origin to the attachment.
        Rows 0 to 2 have no unit, rows 3 to 5 are metres.

    Raises
    ------
    InputError
        A position where a cable has no length.

    Examples
    --------
    >>> robot = Robot.load("testdata/robots/cogiro.toml")
    >>> w = wrench_matrix(robot, [[0, 0, 2], [1, 0, 2]])
    >>> w.shape, int(np.linalg.matrix_rank(w[0]))
    ((2, 6, 8), 6)
    """
    matrices: Floats = _statics(robot, orientation, None, None).wrench_matrix(rows("positions", positions))
    return matrices


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
    """Least slack between what the cables can exert and what they must, over all facets of the available wrench set.

    Parameters
    ----------
    robot : Robot
        With a mass and tension limits.
    positions : array_like (n, 3)
        Positions of the platform's origin, world, m.
    force, moment : float
        Radii of the required balls, N and N·m, around the wrench that balances weight and load.
    vertices : array_like (k, 6), optional
        Corners of a required polytope instead of the balls, N and N·m, on top of the balancing wrench.
    load : array_like (6,), optional
        A further constant wrench, world axes, its moment about the platform's origin, N and N·m.
    gravity : array_like (3,), optional
        World axes, m/s²; default (0, 0, -9.81). It acts at the robot's centre of mass.
    orientation : array_like (4,), optional
        World-from-platform unit quaternion w x y z; default no turn.
    characteristic_length : float
        Length that turns moments into forces, m.
    threads : int, optional
        Default all cores; the answers do not depend on it.

    Returns
    -------
    ndarray (n,)
        N. Where it is not negative, all that is required is available; NaN where a cable has no length. Of a point mass
        the three force rows count.

    Raises
    ------
    InputError
        A robot without mass or tension limits, negative radii, a moment required of a point mass.

    Notes
    -----
    The paper's section 3.3 made rigorous: forces and moments count together. See ``docs/wrench.md``.

    Examples
    --------
    >>> robot = Robot.load("testdata/robots/cogiro.toml")
    >>> capacity_margin(robot, [[0, 0, 2], [6, 5, 0]], force=50, moment=5).round(1)
    array([ 316.4, -196.8])
    """
    corners = None if vertices is None else [tuple(corner) for corner in rows("vertices", vertices, 6).tolist()]
    statics = _statics(robot, orientation, gravity, load, characteristic_length)
    margins: Floats = statics.capacity_margin(rows("positions", positions), number("force", force), number("moment", moment), corners, thread_count(threads))
    return margins


def force_margin(
    robot: Robot,
    positions: ArrayLike,
    *,
    load: ArrayLike | None = None,
    gravity: ArrayLike | None = None,
    orientation: ArrayLike | None = None,
    threads: int | None = None,
) -> Floats:
    """Radius of the largest ball of forces around the balancing one that the cables can exert, whatever their moment.

    This is the paper's effective force set. It is optimistic: exerting a force may bring a moment along.

    Parameters
    ----------
    robot : Robot
        With a mass and tension limits.
    positions : array_like (n, 3)
        Positions of the platform's origin, world, m.
    load, gravity, orientation : array_like, optional
        As in `capacity_margin`.
    threads : int, optional
        Default all cores.

    Returns
    -------
    ndarray (n,)
        N; negative where the balancing force itself is out of reach.

    Raises
    ------
    InputError
        A robot without mass or tension limits.

    Examples
    --------
    >>> robot = Robot.load("testdata/robots/cogiro.toml")
    >>> force_margin(robot, [[0, 0, 2]]).round(1)
    array([589.1])
    """
    return _statics(robot, orientation, gravity, load).force_margin(rows("positions", positions), thread_count(threads))


def moment_margin(
    robot: Robot,
    positions: ArrayLike,
    *,
    load: ArrayLike | None = None,
    gravity: ArrayLike | None = None,
    orientation: ArrayLike | None = None,
    threads: int | None = None,
) -> Floats:
    """Radius of the largest ball of moments around the balancing one that the cables can exert, whatever their force.

    Parameters
    ----------
    robot : Robot
        With a mass and tension limits.
    positions : array_like (n, 3)
        Positions of the platform's origin, about which the moments are, world, m.
    load, gravity, orientation : array_like, optional
        As in `capacity_margin`.
    threads : int, optional
        Default all cores.

    Returns
    -------
    ndarray (n,)
        N·m; NaN for a point mass, which has no moments.

    Examples
    --------
    >>> robot = Robot.load("testdata/robots/cogiro.toml")
    >>> moment_margin(robot, [[0, 0, 2]]).round(1)
    array([5505.6])
    """
    return _statics(robot, orientation, gravity, load).moment_margin(rows("positions", positions), thread_count(threads))


@dataclass(frozen=True, eq=False, repr=False)
class AvailableSet(ByValue):
    """The forces, or the moments, that the cables can exert at a position, as a surface.

    Attributes
    ----------
    rank : int
        Dimension of the set; 3 has a closed surface, 2 a polygon with two sides, 1 two ends, 0 one point.
    balance : ndarray (3,)
        What balances weight and load, N (N·m).
    margin : float
        Radius of the largest ball around ``balance`` inside the set, N (N·m); negative where the balance is outside.
    vertices : ndarray (n, 3)
        Corners, N (N·m), world axes.
    triangles : ndarray (k, 3) of int64
        Corners of each triangle, counter-clockwise seen from outside, as indices into ``vertices``.

    Examples
    --------
    >>> force_set(Robot.load("testdata/robots/paper.toml"), [1, 1, 1])
    AvailableSet(rank 3, margin 1561, 14 vertices)
    """

    rank: int
    balance: Floats
    margin: float
    vertices: Floats
    triangles: NDArray[np.int64]

    def __repr__(self) -> str:
        """Say rank, margin and size."""
        return f"AvailableSet(rank {self.rank}, margin {self.margin:.4g}, {len(self.vertices)} vertices)"


def force_set(
    robot: Robot,
    position: ArrayLike,
    *,
    load: ArrayLike | None = None,
    gravity: ArrayLike | None = None,
    orientation: ArrayLike | None = None,
) -> AvailableSet:
    """Set of the forces that the cables can exert at a position, whatever their moment: the paper's Figure 4b.

    Parameters
    ----------
    robot : Robot
        With a mass and tension limits.
    position : array_like (3,)
        Of the platform's origin, world, m.
    load, gravity, orientation : array_like, optional
        As in `capacity_margin`.

    Returns
    -------
    AvailableSet

    Raises
    ------
    InputError
        A robot without mass or tension limits; a position where a cable has no length.

    Examples
    --------
    >>> found = force_set(Robot.load("testdata/robots/paper.toml"), [1, 1, 1])
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
    """Set of the moments that the cables can exert at a position, whatever their force.

    Parameters
    ----------
    robot : Robot
        With a mass and tension limits; a point mass has no moments and is refused.
    position : array_like (3,)
        Of the platform's origin, about which the moments are, world, m.
    load, gravity, orientation : array_like, optional
        As in `capacity_margin`.

    Returns
    -------
    AvailableSet

    Raises
    ------
    InputError
        As `force_set`, and for a point mass.

    Examples
    --------
    >>> found = moment_set(Robot.load("testdata/robots/cogiro.toml"), [0, 0, 2])
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
    reference: ArrayLike | None = None,
    gravity: ArrayLike | None = None,
    orientation: ArrayLike | None = None,
    characteristic_length: float = 1.0,
    threads: int | None = None,
) -> Floats:
    """Tensions that balance the loads and are nearest to a reference: they minimise Σ (tᵢ − refᵢ)² within the limits.

    Parameters
    ----------
    robot : Robot
        With a mass and tension limits.
    positions : array_like (n, 3)
        Positions of the platform's origin, world, m.
    load : array_like (6,), optional
        As in `capacity_margin`.
    reference : array_like (m,), optional
        N; default the middle of each cable's limits.
    gravity, orientation : array_like, optional
        As in `capacity_margin`.
    characteristic_length : float
        Length that turns moments into forces, m.
    threads : int, optional
        Default all cores.

    Returns
    -------
    ndarray (n, m)
        N; rows of NaN where no tensions within the limits balance the loads. They are continuous along a path.

    Raises
    ------
    InputError
        A robot without mass or tension limits, a reference of another size.

    Examples
    --------
    >>> robot = Robot.load("testdata/robots/cogiro.toml")
    >>> t = tension_distribution(robot, [[0, 0, 2]])
    >>> weight = np.array([0, 0, -robot.mass * 9.81])
    >>> bool(np.allclose((wrench_matrix(robot, [[0, 0, 2]])[0] @ t[0])[:3] + weight, 0, atol=1e-6))
    True
    """
    wanted = None if reference is None else numbers("reference", reference, len(robot.outlets))
    statics = _statics(robot, orientation, gravity, load, characteristic_length)
    return statics.tensions(rows("positions", positions), wanted, thread_count(threads))


@dataclass(frozen=True, eq=False, repr=False)
class Tensions(ByValue):
    """Lengths, tensions and margins at even steps along a path.

    Attributes
    ----------
    s : ndarray (n,)
        Way along the path, m.
    positions : ndarray (n, 3)
        World, m.
    lengths : ndarray (n, m)
        Of each cable, m.
    tensions : ndarray (n, m)
        Of each cable, N; rows of NaN where the loads cannot be balanced.
    capacity_margin, force_margin, moment_margin : ndarray (n,)
        N, N, N·m; NaN where they do not exist.

    Examples
    --------
    >>> scene = Scene.load("testdata/scenes/empty.toml")
    >>> tensions_along(scene, [[0.3, 1, 0.3], [1.7, 1, 1.7]], step=0.1)
    Tensions(21 rows, 8 cables, 1.9799 m)
    """

    s: Floats
    positions: Floats
    lengths: Floats
    tensions: Floats
    capacity_margin: Floats
    force_margin: Floats
    moment_margin: Floats

    def to_pandas(self) -> Any:
        """Return the rows as a table; it needs pandas.

        Returns
        -------
        DataFrame
            ``s``, ``x``, ``y``, ``z`` (m), ``length_0`` and on (m), ``tension_0`` and on (N), ``capacity_margin``,
            ``force_margin`` (N), ``moment_margin`` (N·m).
        """
        columns = {"s": self.s, **{axis: self.positions[:, k] for k, axis in enumerate("xyz")}}
        for name, matrix in (("length", self.lengths), ("tension", self.tensions)):
            columns |= {f"{name}_{cable}": column for cable, column in enumerate(matrix.T)}
        for name in ("capacity_margin", "force_margin", "moment_margin"):
            columns[name] = getattr(self, name)
        return frame(columns)

    def __repr__(self) -> str:
        """Say the size."""
        rows_, cables = self.tensions.shape
        return f"Tensions({rows_} rows, {cables} cables, {self.s[-1] if rows_ else 0.0:.4f} m)"


def tensions_along(
    scene: Scene,
    waypoints: ArrayLike | Path,
    *,
    step: float = 0.01,
    reference: Sequence[float] | None = None,
) -> Tensions:
    """Compute lengths, tensions and margins at even steps along a path, its end included.

    Parameters
    ----------
    scene : Scene
        Its robot, gravity, orientation, and what its ``[wrench]`` says of loads and requirements.
    waypoints : array_like (k, 3), k >= 2
        Positions of the platform's origin, world, m.
    step : float
        Distance of the rows, m.
    reference : sequence of float (m,), optional
        As in `tension_distribution`.

    Returns
    -------
    Tensions

    Raises
    ------
    InputError
        A robot without mass or tension limits, a step that is not positive, fewer than two waypoints.

    Examples
    --------
    >>> scene = Scene.load("testdata/scenes/empty.toml")
    >>> along = tensions_along(scene, [[0.3, 1, 0.3], [1.7, 1, 1.7]], step=0.1)
    >>> along.tensions.shape, bool(np.isfinite(along.tensions).all())
    ((21, 8), True)
    """
    count = len(scene.robot.outlets)
    wanted = None if reference is None else numbers("reference", reference, count)
    core = core_for(scene, waypoints)
    found = json.loads(core.tensions_along(path_rows("waypoints", waypoints), number("step", step), wanted))

    def column(key: str) -> Floats:
        return np.array([np.nan if row[key] is None else row[key] for row in found], dtype=np.float64)

    def matrix(key: str, width: int) -> Floats:
        empty = [float("nan")] * width
        return np.array([empty if row[key] is None else row[key] for row in found], dtype=np.float64).reshape(-1, width)

    return Tensions(
        s=column("s"),
        positions=matrix("position", 3),
        lengths=matrix("lengths", count),
        tensions=matrix("tensions", count),
        capacity_margin=column("capacity_margin"),
        force_margin=column("force_margin"),
        moment_margin=column("moment_margin"),
    )
