"""Timed motions along a path."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import Floats, as_numbers, finite, positive, shaped
from ._distribution import Distribution, distribution
from ._given import file_name, flag, instance, one_of
from ._pandas import by_cable, frame
from ._paths import way_of
from ._results import Path
from ._scene import Scene
from ._values import ByValue
from .exceptions import AnotherSceneWarning, InputError

Joints: TypeAlias = Literal["length", "command", "angle"]


class Corner(NamedTuple):
    """How a trajectory passes a corner of its path.

    Attributes
    ----------
    waypoint : int
        Index of the waypoint.
    kind : str
        "rounded" (on its inside), "outward" (moved outward, then rounded) or "stop" (the platform stops there).
    deviation : float
        Largest distance between curve and path there, m; where the platform turns, of any of its corners and attachments.
    time : float
        When it is passed, s.
    turn : bool
        Whether the platform begins, ends or changes a turn there.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.example("hard1")
    >>> motion = cdpr.trajectory(scene, cdpr.plan(scene), speed=1, acceleration=2)
    >>> [(corner.waypoint, corner.kind) for corner in motion.corners]
    [(1, 'stop')]
    """

    waypoint: int
    kind: str
    deviation: float
    time: float
    turn: bool = False


class Limiting(NamedTuple):
    """A limit that determines for some time how fast the platform moves.

    Attributes
    ----------
    start, end : float
        Start and end of this time, s.
    limit : str
        "speed", "acceleration", "turn_speed", "turn_acceleration", "jerk", "cable_speed", "cable_acceleration" or "tension".
    cable : str or None
        Name of the cable, for limits of a cable's speed and acceleration.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.example("empty")
    >>> motion = cdpr.trajectory(scene, [[0.5, 1, 1], [1.5, 1, 1]], speed=1, acceleration=2)
    >>> [entry.limit for entry in motion.limiting]
    ['acceleration', 'speed', 'acceleration']
    """

    start: float
    end: float
    limit: str
    cable: str | None


@dataclass(frozen=True, eq=False, repr=False)
class MotionState(ByValue):
    """Platform and cables at a time of a trajectory, or at several.

    For times of shape (...) each array has this shape followed by what is given here.

    Attributes
    ----------
    time : float or ndarray (...)
        Seconds.
    position, velocity, acceleration : ndarray (..., 3)
        Of the platform's origin, world, m, m/s, m/s².
    orientation : ndarray (..., 4)
        World-from-platform unit quaternion w x y z.
    angular_velocity, angular_acceleration : ndarray (..., 3)
        Of the platform, world axes, rad/s and rad/s²; zero where it does not turn.
    cable_lengths, cable_speeds, cable_accelerations : ndarray (..., m) or None
        Length of each cable, m, how fast it grows, m/s, and the rate of that, m/s²; None for a loaded file without its
        scene.
    tensions : ndarray (..., m) or None
        Of each cable, N; None if they are not limited, and for a loaded file without its scene.
    commands, angles, torques : ndarray (..., m) or None
        Of each winch, as for `Trajectory`.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.example("empty")
    >>> motion = cdpr.trajectory(scene, [[0.5, 1, 1], [1.5, 1, 1]], speed=1, acceleration=2)
    >>> motion.at(0.75)
    MotionState(0.75 s, at [1.0, 1.0, 1.0] m, 1.0000 m/s)
    >>> motion.at([0.0, 0.5, 1.0]).cable_lengths.shape
    (3, 8)
    """

    time: np.float64 | Floats
    position: Floats
    velocity: Floats
    acceleration: Floats
    orientation: Floats
    angular_velocity: Floats
    angular_acceleration: Floats
    cable_lengths: Floats | None
    cable_speeds: Floats | None
    cable_accelerations: Floats | None
    tensions: Floats | None
    commands: Floats | None
    angles: Floats | None
    torques: Floats | None

    def __repr__(self) -> str:
        """Show time, place and speed, or how many states there are."""
        if np.ndim(self.time):
            return f"MotionState({np.size(self.time)} times)"
        place = [round(x, 4) for x in self.position.tolist()]
        return f"MotionState({self.time:.6g} s, at {place} m, {np.linalg.norm(self.velocity):.4f} m/s)"


@dataclass(frozen=True, eq=False, repr=False)
class Trajectory(ByValue):
    """A timed motion along a path, from rest to rest; made by `trajectory` or `load_trajectory`.

    The arrays are samples; `at` gives the state at any time.

    Attributes
    ----------
    duration : float
        From start to end, s.
    length : float
        Of the curve, m.
    rate : float
        Samples per second.
    times : ndarray (n,)
        Of the samples, s; the last one is the duration.
    positions, velocities, accelerations : ndarray (n, 3)
        Of the platform's origin, world, m, m/s, m/s².
    orientations : ndarray (n, 4)
        World-from-platform unit quaternions w x y z; all the same if the platform does not turn.
    angular_velocities, angular_accelerations : ndarray (n, 3)
        Of the platform, world axes, rad/s and rad/s²; zero if it does not turn.
    cable_lengths, cable_speeds : ndarray (n, m)
        Length of each cable, m, and how fast it grows, m/s.
    cable_accelerations : ndarray (n, m) or None
        The rate of that, m/s²; None for a loaded file that does not have it.
    tensions : ndarray (n, m) or None
        Of each cable, N; None if tensions are not limited.
    commands : ndarray (n, m) or None
        Length to command to each winch, m: the unstretched length of a cable that has its length and tension. None if no cable has
        a stiffness, or tensions are not limited.
    angles : ndarray (n, m) or None
        Angle of each motor at its commanded length, rad, from that at the `zero` of its drum; with a positive gear it grows while
        the cable is let out. None if a cable has no drum, or if cables stretch and tensions are not limited.
    torques : ndarray (n, m) or None
        Torque of the tension about the axis of each motor, N·m, without friction and the inertia of drum and motor. None if a cable
        has no drum, or tensions are not limited.
    cables : tuple of str
        Names of the cables, in the order of the columns.
    orientation : ndarray (4,)
        World-from-platform unit quaternion w x y z, held all the time; that of the scene if the platform turns.
    orientation_name : str or None
        Its name, if the scene names it.
    waypoints : ndarray (k, 3)
        The path that the curve follows, m.
    waypoint_orientations : ndarray (k, 4) or None
        Orientations at the waypoints, unit quaternions w x y z; None if the platform does not turn.
    limits : dict
        The limits that are set: ``speed``, ``acceleration``, ``turn_speed``, ``turn_acceleration``, ``jerk``,
        ``cable_speed``, ``cable_acceleration``, ``clearance``, ``wrench_margin``; always ``blend``.
    tension_limits : ndarray (m, 2) or None
        Minimum and maximum tension of each cable, N, if tensions are limited.
    tension_distribution : str or None
        Which of all tensions that balance weight, load and inertia ``tensions`` are; see `tension_distribution`. None without tensions, or
        for a loaded file that does not name it.
    corners : tuple of Corner
        How each corner of the path is passed.
    limiting : tuple of Limiting
        Which limit determines the motion when, in order of time; gaps are possible.
    largest : dict or None
        The largest rates: ``speed``, ``acceleration``, ``cable_speed``, ``cable_acceleration``, if the platform turns also
        ``turn_speed`` and ``turn_acceleration``; and ``tensions``, the smallest and the largest one, if they are limited. None
        for a loaded file without them.
    nearest : dict or None
        The nearest approach: ``time`` (s), ``value`` (m, negative where bodies overlap), ``culprits`` (two names). None for a
        loaded file without it, or if nothing can come close.
    note : str or None
        Why tensions are not limited, if they are not; what was assumed about the inertia of a platform that turns, if the
        robot does not give it; that speeds are not limited, if neither ``speed`` nor ``cable_speed`` is.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.example("empty")
    >>> motion = cdpr.trajectory(scene, [[0.5, 1, 1], [1.5, 1, 1]], speed=1, acceleration=2)
    >>> motion
    Trajectory(1.500 s, 1.0000 m, 151 samples)
    >>> motion.positions.shape, motion.cable_lengths.shape
    ((151, 3), (151, 8))
    >>> motion.tensions is None, motion.note[:24]
    (True, 'tensions are not limited')
    """

    duration: float
    length: float
    rate: float
    times: Floats
    positions: Floats
    velocities: Floats
    accelerations: Floats
    orientations: Floats
    angular_velocities: Floats
    angular_accelerations: Floats
    cable_lengths: Floats
    cable_speeds: Floats
    cable_accelerations: Floats | None
    tensions: Floats | None
    commands: Floats | None
    angles: Floats | None
    torques: Floats | None
    cables: tuple[str, ...]
    orientation: Floats
    orientation_name: str | None
    waypoints: Floats
    waypoint_orientations: Floats | None
    limits: Mapping[str, float]
    tension_limits: Floats | None
    tension_distribution: str | None
    corners: tuple[Corner, ...]
    limiting: tuple[Limiting, ...]
    largest: Mapping[str, Any] | None
    nearest: Mapping[str, Any] | None
    note: str | None = field(compare=False)
    _motion: _core.Trajectory = field(compare=False)

    def at(self, time: ArrayLike) -> MotionState:
        """Compute the state at any time exactly, not from the samples.

        Parameters
        ----------
        time : array_like (...)
            A time or several, s. Before the start and after the end, the state is that at start or end.

        Returns
        -------
        MotionState
            Its arrays have the shape of the times, followed by their own: (..., 3) or (..., m).

        Raises
        ------
        InputError
            Times that are not finite; a trajectory from a file without the exact form, such as a .csv file.

        Examples
        --------
        >>> import cdpr
        >>> scene = cdpr.example("empty")
        >>> motion = cdpr.trajectory(scene, [[0.5, 1, 1], [1.5, 1, 1]], speed=1, acceleration=2)
        >>> motion.at(motion.duration / 2).position.round(6).tolist()
        [1.0, 1.0, 1.0]
        """
        times = as_numbers("time", time)
        if not np.isfinite(times).all():
            raise InputError(f"time: found {times[~np.isfinite(times)].flat[0]}, expected finite times")
        straight, turning, cables = self._motion.at(times.reshape(-1))
        position, velocity, acceleration = (shaped(rows, times.shape) for rows in straight)
        orientation, turn, gain = (shaped(rows, times.shape) for rows in turning)
        of_cables = [None if rows is None else shaped(rows, times.shape) for rows in cables]
        return MotionState(times[()], position, velocity, acceleration, orientation, turn, gain, *of_cables)

    @property
    def turns(self) -> bool:
        """Whether the platform turns."""
        return self._motion.turns()

    def save(self, file: str | os.PathLike[str], *, joints: Joints | None = None, effort: bool = False) -> None:
        """Write a file.

        Parameters
        ----------
        file : path
            The extension selects the format: .json holds everything; .csv holds the samples, with the columns of
            `to_pandas`; .yaml is a message of ROS 2, ``trajectory_msgs/msg/JointTrajectory``, whose joints are the cables.
        joints : {"length", "command", "angle"}, optional
            What the joints of the message are: lengths of the cables (default), m; commanded lengths, m; or angles of the motors,
            rad. Velocities of the last two are slopes between the samples, and the message has no accelerations of them.
        effort : bool
            Also write the tensions into the message as effort, N, or the torques, N·m, if the joints are angles; controllers of
            positions refuse such messages.

        Raises
        ------
        FileError
            Another extension; ``joints`` or ``effort`` with another one than .yaml, or of quantities that are not known; or a file
            that cannot be written. Nothing half-written is left.
        """
        chosen = None if joints is None else one_of("joints", joints, Joints)
        self._motion.save(file_name(file, "file"), chosen, flag("effort", effort))

    def to_pandas(self) -> Any:
        """Return the samples as a table; requires pandas.

        Returns
        -------
        DataFrame
            One row per sample, with the columns of the .csv file: ``t`` (s), ``x``, ``y``, ``z`` (m), the orientation
            ``qw``, ``qx``, ``qy``, ``qz``, velocity ``vx``, ``vy``, ``vz`` (m/s), acceleration ``ax``, ``ay``, ``az``
            (m/s²), if the platform turns angular velocity ``wx``, ``wy``, ``wz`` (rad/s) and acceleration ``alphax``,
            ``alphay``, ``alphaz`` (rad/s²), world axes, and for each cable by its name ``length:cable 0`` (m) and
            ``speed:cable 0`` (m/s), and ``tension:cable 0`` (N) if tensions are limited.

        Examples
        --------
        >>> import cdpr
        >>> scene = cdpr.example("empty")
        >>> motion = cdpr.trajectory(scene, [[0.5, 1, 1], [1.5, 1, 1]], speed=1, acceleration=2)
        >>> table = motion.to_pandas()
        >>> table.shape, list(table)[:8]
        ((151, 38), ['t', 'x', 'y', 'z', 'qw', 'qx', 'qy', 'qz'])
        """
        columns: dict[str, Any] = {"t": self.times}
        columns |= dict(zip("xyz", self.positions.T, strict=True))
        columns |= {f"q{axis}": part for axis, part in zip("wxyz", self.orientations.T, strict=True)}
        rates = [("v", self.velocities), ("a", self.accelerations)]
        if self.turns:
            rates += [("w", self.angular_velocities), ("alpha", self.angular_accelerations)]
        for letter, rows in rates:
            columns |= {f"{letter}{axis}": column for axis, column in zip("xyz", rows.T, strict=True)}
        of_cables = {"length": self.cable_lengths, "speed": self.cable_speeds, "acceleration": self.cable_accelerations}
        of_cables |= {"tension": self.tensions, "command": self.commands, "angle": self.angles, "torque": self.torques}
        return frame(columns | by_cable(self.cables, of_cables), "sample")

    @classmethod
    def _of(cls, core: _core.Trajectory) -> Trajectory:
        facts: dict[str, Any] = json.loads(core.facts())
        times, (straight, turning, (lengths, speeds, rates, tensions, commands, angles, torques)) = core.samples()
        positions, velocities, accelerations = straight
        orientations, turns, gains = turning
        assert lengths is not None and speeds is not None
        limits = facts.pop("tension_limits")
        entries, ends = facts.pop("limiting"), facts.pop("waypoint_orientations")
        return cls(
            times=times,
            positions=positions,
            velocities=velocities,
            accelerations=accelerations,
            orientations=orientations,
            angular_velocities=turns,
            angular_accelerations=gains,
            cable_lengths=lengths,
            cable_speeds=speeds,
            cable_accelerations=rates,
            tensions=tensions,
            commands=commands,
            angles=angles,
            torques=torques,
            cables=tuple(facts.pop("cables")),
            orientation=np.array(facts.pop("orientation"), dtype=np.float64),
            waypoints=np.array(facts.pop("waypoints"), dtype=np.float64),
            waypoint_orientations=None if ends is None else np.array(ends, dtype=np.float64),
            tension_limits=None if limits is None else np.array(limits, dtype=np.float64),
            corners=tuple(Corner(**entry) for entry in facts.pop("corners")),
            limiting=tuple(Limiting(entry["from"], entry["to"], entry["limit"], entry["cable"]) for entry in entries),
            _motion=core,
            **facts,
        )

    @classmethod
    def _from_json(cls, file: str, scene: str | None) -> Trajectory:
        return cls._of(_core.Trajectory.from_json(file, scene))

    def __reduce__(self) -> tuple[Any, tuple[str, str | None]]:
        """Pickle by value."""
        return Trajectory._from_json, self._motion.to_json()

    def __repr__(self) -> str:
        """Show duration, length and size."""
        return f"Trajectory({self.duration:.3f} s, {self.length:.4f} m, {len(self.times)} samples)"


def trajectory(
    scene: Scene,
    path: ArrayLike | Path,
    orientations: ArrayLike | None = None,
    *,
    speed: float | None = None,
    acceleration: float | None = None,
    turn_speed: float | None = None,
    turn_acceleration: float | None = None,
    jerk: float | None = None,
    cable_speed: float | None = None,
    cable_acceleration: float | None = None,
    blend: float | None = None,
    clearance: float | None = None,
    wrench_margin: float | None = None,
    rate: float | None = None,
    tensions: Distribution | None = None,
    strict: bool = False,
) -> Trajectory:
    """Compute the fastest motion along a path that keeps all limits at every instant, from rest to rest.

    Limits that are not given are those of the scene's table ``[motion]``. At least one limit of acceleration, cable
    acceleration or tensions is required, and for a platform that turns at least one of turn acceleration, cable
    acceleration or tensions. Tensions are limited, including the inertia of the platform, if its mass and all tension
    limits are known and the cables leave no motion free.

    Parameters
    ----------
    scene : Scene
    path : array_like (k, 3), Path or Result, k >= 2
        Positions of the platform's origin, world, m; every segment must be valid. Along the widest path of the scene, planned or loaded,
        the motion keeps its clearance from obstacles, within a micrometre.
    orientations : array_like (k, 4) or (4,), optional
        World-from-platform unit quaternions w x y z at these positions, for a platform that turns; a path that turns has its
        own. Between two poses it turns about a fixed axis, the shorter way. Where a turn begins, ends or changes, it passes on a
        bend or, if none is proved free, stops.
    speed, acceleration : float, optional
        Largest speed and acceleration of the platform's origin, m/s, m/s².
    turn_speed, turn_acceleration : float, optional
        Largest angular speed and acceleration of a platform that turns, rad/s, rad/s².
    jerk : float, optional
        Largest jerk of the platform's origin, m/s³.
    cable_speed, cable_acceleration : float, optional
        Largest speed and acceleration of each cable's length, m/s, m/s².
    blend : float, optional
        Largest deviation from the path where corners are rounded, m; with 0 the platform stops at each corner. Default the
        scene's clearance.
    clearance : float, optional
        Largest clearance that the motion keeps, m, in place of the scene's ``clearance`` and of larger ones of kinds and pairs.
        By default it keeps all clearances of the scene.
    wrench_margin : float, optional
        Capacity margin that the cables keep in addition to the inertia of the platform, N.
    rate : float, optional
        Samples per second; default 100, or more for accelerations beyond 8 m/s² at a point of the platform: as many hundreds as keep
        straight lines between samples within 0.1 mm of the motion.
    tensions : {"middle", "least", "p4", "p8", "closed-form"}, optional
        Which of all tensions that balance weight, load and inertia the motion holds; default that of the robot, else "middle". The
        motion itself does not depend on it. See `tension_distribution`.
    strict : bool
        Raise an error for a path that was planned for another scene, instead of an `AnotherSceneWarning`.

    Returns
    -------
    Trajectory

    Raises
    ------
    InputError
        Wrong shape, a path that is not valid or does not move, limits that are not positive or too few, a place where the
        cables cannot hold or accelerate the platform, tensions in closed form that exceed a limit, a rate that gives too many samples; with ``strict``, a path that
        was planned for another scene.
    KeyboardInterrupt
        On Ctrl-C.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.example("hard1")
    >>> path = cdpr.plan(scene)
    >>> stopping = trajectory(scene, path, speed=1, acceleration=2)
    >>> blended = trajectory(scene, path, speed=1, acceleration=2, blend=0.03)
    >>> blended.duration < stopping.duration, blended.corners[0].kind
    (True, 'outward')

    A quarter turn on the spot:

    >>> scene, corner = Scene.example("turn"), [0.6, 1.6, 1.2]
    >>> turn = trajectory(scene, [corner, corner], [[1, 0, 0, 0], [0.5**0.5, 0, 0, 0.5**0.5]], turn_speed=1, turn_acceleration=2)
    >>> float(turn.at(turn.duration / 2).angular_velocity[2].round(3))
    1.0
    """
    given = {
        "speed": speed,
        "acceleration": acceleration,
        "turn_speed": turn_speed,
        "turn_acceleration": turn_acceleration,
        "jerk": jerk,
        "cable_speed": cable_speed,
        "cable_acceleration": cable_acceleration,
        "blend": blend,
        "clearance": clearance,
        "wrench_margin": wrench_margin,
    }
    limits = {key: finite(key, value) for key, value in given.items() if value is not None}
    core, positions, along = way_of(scene, "path", path, orientations, strict=strict)
    chosen, samples = distribution(tensions), None if rate is None else positive("rate", rate)
    kept = _width(path, core)
    found = _core.Trajectory.of(core, (positions, along), json.dumps(limits), samples, chosen, kept)
    return Trajectory._of(found)


def _width(path: ArrayLike | Path, core: _core.Scene) -> float | None:
    """Return the clearance from obstacles that the widest path of a scene keeps."""
    said = path._said() if isinstance(path, Path) else {}
    planned_for = said.get("scene", {}).get("fingerprint")
    return said["widest"]["clearance"] if "widest" in said and planned_for == core.fingerprint() else None


def load_trajectory(
    file: str | os.PathLike[str], scene: Scene | None = None, *, strict: bool = False
) -> Trajectory:
    """Load a trajectory file.

    Parameters
    ----------
    file : path
        .json, as written by `Trajectory.save` or ``cdpr trajectory``; or .csv of any source, with at least the columns
        ``t``, ``x``, ``y``, ``z``. From .csv there are only samples: no limits, and `Trajectory.at` raises an error.
    scene : Scene, optional
        The scene that it was made for: `Trajectory.at` then also gives lengths, speeds and tensions of the cables, and
        columns of cables that a .csv file does not have are computed. If it was made for another scene, an
        `AnotherSceneWarning` is issued.
    strict : bool
        Raise an error for such a file instead.

    Returns
    -------
    Trajectory

    Raises
    ------
    FileError
        It cannot be read, or its name has another extension.
    InputError
        Bad contents; a trajectory at an orientation that the scene does not have, or of another robot; a .csv file without
        orientation or cables, and no scene; with ``strict``, a trajectory of another scene.

    Examples
    --------
    >>> import cdpr, tempfile
    >>> scene = cdpr.example("empty")
    >>> motion = cdpr.trajectory(scene, cdpr.plan(scene), speed=1, acceleration=2)
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     motion.save(f"{folder}/motion.json")
    ...     load_trajectory(f"{folder}/motion.json", scene) == motion
    True
    """
    core = None if scene is None else instance("scene", scene, Scene)._core
    name = file_name(file, "file")
    found, warning = _core.Trajectory.load(name, core, flag("strict", strict))
    if warning is not None:
        warnings.warn(f"{name}: {warning}", AnotherSceneWarning, stacklevel=2)
    return Trajectory._of(found)
