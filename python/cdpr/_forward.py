"""Forward kinematics: poses from cable lengths."""

from __future__ import annotations

import json
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import Floats, Ints, as_numbers, point, quaternion
from ._given import instance, one_of
from ._robot import Robot
from ._trajectory import Joints
from ._values import ByValue
from .exceptions import InputError

if TYPE_CHECKING:
    from ._core import _Poses

_Turn: TypeAlias = tuple[float, float, float, float]
_LEVEL: _Turn = (1.0, 0.0, 0.0, 0.0)


@dataclass(frozen=True, eq=False, repr=False)
class PoseEstimate(ByValue):
    """The pose that fits given cable lengths, or one pose for each of n rows of lengths.

    Attributes
    ----------
    position : ndarray (3,) or (n, 3)
        Of the platform's origin, world, m.
    orientation : ndarray (4,) or (n, 4)
        World-from-platform unit quaternion w x y z.
    residuals : ndarray (m,) or (n, m)
        Given lengths minus those at the pose, m.
    rank : int or ndarray (n,)
        Rank of the Jacobian of the lengths at the pose, where singular values below 1e-5 of the largest count as zero.
    full_rank : int
        The rank at which the lengths determine the pose: 6, or 3 if the orientation was given.
    covariance : ndarray (6, 6) or (n, 6, 6)
        Covariance of the errors of position, m, and orientation, a rotation vector in world axes, rad, if the lengths have
        independent errors of variance 1 m²: multiply by the variance of the lengths. Zero for an orientation that was given;
        NaN if the rank is not full.
    iterations : int or ndarray (n,)
        Number of steps that were tried.

    Examples
    --------
    >>> import cdpr
    >>> robot = cdpr.example("cogiro").robot
    >>> rows = robot.cable_lengths([[1.0, -0.5, 2.0], [1.0, -0.5, 2.1]])
    >>> pose_from_lengths(robot, rows).position.round(9)
    array([[ 1. , -0.5,  2. ],
           [ 1. , -0.5,  2.1]])
    """

    position: Floats
    orientation: Floats
    residuals: Floats
    rank: int | Ints
    full_rank: int
    covariance: Floats
    iterations: int | Ints
    _asked: tuple[Robot, Floats, _Turn | None] = field(repr=False, compare=False)

    def __repr__(self) -> str:
        """Show place, rank and the largest residual, or how many poses there are."""
        if self.position.ndim > 1:
            return f"PoseEstimate({len(self.position)} poses)"
        place = [round(x, 4) for x in self.position.tolist()]
        largest = 1e3 * np.abs(self.residuals).max()
        return f"PoseEstimate(at {place} m, rank {self.rank} of {self.full_rank}, residuals up to {largest:.3f} mm)"

    @cached_property
    def others(self) -> tuple[PoseEstimate, ...] | tuple[tuple[PoseEstimate, ...], ...]:
        """Other poses with the same lengths, nearest first; for several rows, those of each. Computed when first asked for."""
        robot, lengths, turn = self._asked
        poses = list(zip(np.atleast_2d(self.position).tolist(), np.atleast_2d(self.orientation).tolist(), strict=True))
        found = _core.other_poses(json.dumps(robot.to_dict()), np.atleast_2d(lengths), turn, poses)
        each = tuple(
            tuple(_estimate(others, k, (robot, row, turn)) for k in range(len(others[0])))
            for others, row in zip(found, np.atleast_2d(lengths), strict=True)
        )
        return each if lengths.ndim == 2 else each[0]


def _estimate(found: _Poses, row: int | None, asked: tuple[Robot, Floats, _Turn | None]) -> PoseEstimate:
    """Return one row of poses or, for None, all."""
    position, orientation, residuals, covariance, rank, iterations = found
    full_rank = 6 if asked[2] is None else 3
    if row is None:
        return PoseEstimate(position, orientation, residuals, rank, full_rank, covariance, iterations, asked)
    numbers = int(rank[row]), full_rank, covariance[row], int(iterations[row])
    return PoseEstimate(position[row], orientation[row], residuals[row], *numbers, asked)


def pose_from_lengths(
    robot: Robot,
    lengths: ArrayLike,
    *,
    joints: Joints = "length",
    tensions: ArrayLike | None = None,
    guess: ArrayLike | tuple[ArrayLike, ArrayLike] | PoseEstimate | None = None,
    orientation: ArrayLike | None = None,
) -> PoseEstimate:
    """Find the pose of the platform from the lengths of its cables; the inverse of `Robot.cable_lengths`.

    Parameters
    ----------
    robot : Robot
        With at least six cables, or three if the orientation is given.
    lengths : array_like (m,) or (n, m)
        From outlet to attachment, round pulleys if there are any, m, in the order of the cables. Of several rows, each is
        solved from the pose of the row before, as encoders report them.
    joints : {"length", "command", "angle"}
        What ``lengths`` are: lengths of the cables; lengths as the winches are commanded, which are unstretched, m; or angles of
        the motors, rad, for which all cables need a ``drum``.
    tensions : array_like (m,) or (n, m), optional
        With commanded lengths or angles, the tensions, N, by which cables with a ``stiffness`` are stretched.
    guess : array_like (3,), pair of array_like (3,) and (4,), or PoseEstimate, optional
        Where to look for the (first) pose: a position, a position and a unit quaternion w x y z, or an earlier result, of which
        the last pose counts. A position alone is that of a platform without rotation. Default: trilateration for a platform without
        rotation, below the outlets if they lie in a plane; if the pose that is found from there does not fit, others are looked for
        as for ``others``.
    orientation : array_like (4,), optional
        Known world-from-platform unit quaternion w x y z; only the position is then found. Robots with fewer than six cables
        need it, and those whose cables meet in one point of the platform.

    Returns
    -------
    PoseEstimate
        With ``position``, ``orientation``, ``residuals``, ``rank``, ``covariance`` and ``others``. Large residuals are no error:
        they tell that no pose near the guess has these lengths.

    Raises
    ------
    InputError
        Wrong shape, lengths that are not positive, too few cables, a guess at which a cable cannot leave its pulley, no
        convergence; commanded lengths or angles without tensions if cables stretch, or without drums. The row and the cable are
        named.
    KeyboardInterrupt
        On Ctrl-C.

    Notes
    -----
    Levenberg and Marquardt's method for the sum of squares of the residuals, which leads to a minimum near the guess. There may be
    others: ``others`` lists those whose residuals have at most twice the root mean square. They are looked for where the lengths
    would be nearly the same again along one of the three directions in which they change least, and from the pose moved by the mean
    length of the cables to both sides along each axis and, unless the orientation is given, turned by 90° to both sides about each;
    not all are found. If residuals are left that rounding does not explain, the same starts are tried for the first pose (for a pose
    near the row before, only one): another pose is returned if it fits twice as well, and better by a larger factor than that by
    which it is farther from the guess.

    Examples
    --------
    >>> import cdpr
    >>> robot = cdpr.example("cogiro").robot
    >>> found = pose_from_lengths(robot, robot.cable_lengths([1.0, -0.5, 2.0]))
    >>> found.position.round(9), found.rank, len(found.others)
    (array([ 1. , -0.5,  2. ]), 6, 0)
    >>> np.sqrt(found.covariance.diagonal()[:3]).round(2)  # in mm for lengths accurate to 1 mm
    array([0.64, 0.85, 1.15])

    What the winches report is not the length of a cable that stretches:

    >>> elastic = robot.replace(cable={"stiffness": 7e5, "drum": {"radius": 0.1, "lead": 3.0}})
    >>> commands = [9.689, 9.014, 10.375, 10.425, 9.918, 9.466, 8.561, 8.631]
    >>> pulled = [300, 900, 700, 400, 900, 200, 800, 500]
    >>> pose_from_lengths(elastic, commands, joints="command", tensions=pulled).position.round(2)
    array([ 0.5, -1. ,  2. ])
    >>> pose_from_lengths(elastic, commands).position.round(2)  # 3 cm too high
    array([ 0.5 , -0.99,  2.03])
    """
    spec = json.dumps(instance("robot", robot, Robot).to_dict())
    cables = len(robot.to_dict()["cables"])
    given = as_numbers("lengths", lengths)
    if given.ndim not in (1, 2) or given.shape[-1] != cables:
        raise InputError(f"lengths: found an array of shape {given.shape}, expected ({cables},) or (n, {cables})")
    turn = None if orientation is None else quaternion("orientation", orientation)
    many = given.ndim == 2
    what = one_of("joints", joints, Joints)
    pulled = None if tensions is None else as_numbers("tensions", tensions)
    if pulled is not None and what == "length":
        raise InputError('tensions: found with joints="length", where they have no effect; expected joints="command" or "angle"')
    if pulled is not None and pulled.shape != given.shape:
        raise InputError(f"tensions: found an array of shape {pulled.shape}, expected that of the lengths, {given.shape}")
    if what != "length":
        rows = None if pulled is None else np.atleast_2d(pulled)
        given = _core.lengths_from(spec, what, np.atleast_2d(given), rows, many).reshape(given.shape)
    found = _core.pose_from_lengths(spec, np.atleast_2d(given), turn, _pose(guess), many)
    return _estimate(found, None if many else 0, (robot, given, turn))


def _pose(guess: ArrayLike | tuple[ArrayLike, ArrayLike] | PoseEstimate | None) -> tuple[tuple[float, float, float], _Turn] | None:
    """Return the position and the orientation of a guess."""
    if guess is None:
        return None
    if isinstance(guess, PoseEstimate):
        if not guess.position.size:
            raise InputError("guess: found a result without poses, expected at least one")
        guess = np.atleast_2d(guess.position)[-1], np.atleast_2d(guess.orientation)[-1]
    if isinstance(guess, (tuple, list)) and len(guess) == 2:
        return point("guess[0]", guess[0]), quaternion("guess[1]", guess[1])
    return point("guess", guess), _LEVEL
