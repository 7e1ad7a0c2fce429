"""Tensions, lengths and margins at a position and along a path of a scene."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Floats, number, numbers, point
from ._distribution import Distribution, distribution
from ._given import instance
from ._pandas import by_cable, frame
from ._paths import way_of
from ._results import Path
from ._scene import Scene
from ._values import ByValue


class Settling(NamedTuple):
    """How far a platform settles if its winches are commanded the lengths of taut cables, without their stretch.

    Attributes
    ----------
    displacement : float
        Distance that the platform's origin moves, m.
    rotation : float
        Angle that the platform turns, rad.

    Examples
    --------
    >>> scene = Scene.example("cogiro")
    >>> found = wrench_at(scene.replace(robot=scene.robot.replace(stiffnesses=7e5)), scene.start).settling
    >>> print(f"{1000 * found.displacement:.1f} mm, {np.degrees(found.rotation):.2f}°")
    13.3 mm, 0.07°
    """

    displacement: float
    rotation: float


@dataclass(frozen=True, eq=False, repr=False)
class WrenchReport(ByValue):
    """What the cables can balance at a position.

    Attributes
    ----------
    feasible : bool
        Whether planning with the same requirements accepts the position under the rule "certified": all required wrenches are
        available and, unless the margin is "projected", the rank is full.
    balanced : bool
        Whether tensions within the limits can balance weight and load alone.
    rank, full_rank : int
        Rank of the wrench matrix, and the highest possible rank: 6, or 3 for a point mass.
    holding : str
        What follows from the rank and the directions of the cables: "fully_constrained" (they pull against each other),
        "suspended" (they need a load, such as the weight, to pull against) or "underconstrained" (no tensions resist some
        motion).
    free_motions : tuple of str
        The motions that no tensions resist, world axes, such as "turning about z".
    free_twists : ndarray (full_rank - rank, 6)
        Velocity of the platform's origin and angular velocity of each of these motions, m/s and rad/s, scaled so that the
        largest entry is 1.
    capacity_margin, force_margin, moment_margin : float
        N, N, N·m; NaN where there is none. See `capacity_margin`, `force_margin` and `moment_margin`.
    at_greatest, at_least : tuple of str
        Cables at their maximum and minimum tension on the facet that limits the capacity margin.
    load_case : str or None
        If the scene has several load cases, the one with the smallest capacity margin, which margins and tensions are for.
        ``feasible`` and ``balanced`` concern all of them.
    cables : tuple of str
        Names of the cables, in the order of what follows.
    lengths : ndarray (m,)
        Of each cable, m.
    tensions : ndarray (m,)
        Of each cable, N: those that balance weight and load; NaN if there are none.
    tension_distribution : str
        Which of all such tensions these are; see `tension_distribution`.
    wrench_matrix : ndarray (6, m)
        Column i is [uᵢ ; rᵢ × uᵢ], see `wrench_matrix`.
    settling : Settling or None
        How far the platform settles if the winches are commanded ``lengths``, without the stretch of the cables; None if the
        stiffness of a cable is not known, or if the platform does not come to rest.

    Examples
    --------
    >>> report = wrench_at(Scene.example("empty"), [1, 1, 1])
    >>> report
    WrenchReport(not feasible, rank 5 of 6, underconstrained)
    >>> report.balanced, report.free_motions, report.free_twists
    (True, ('turning about z',), array([[0., 0., 0., 0., 0., 1.]]))
    """

    feasible: bool
    balanced: bool
    rank: int
    full_rank: int
    holding: str
    free_motions: tuple[str, ...]
    free_twists: Floats
    capacity_margin: float
    force_margin: float
    moment_margin: float
    at_greatest: tuple[str, ...]
    at_least: tuple[str, ...]
    load_case: str | None
    cables: tuple[str, ...]
    lengths: Floats
    tensions: Floats
    tension_distribution: str
    wrench_matrix: Floats
    settling: Settling | None

    def __repr__(self) -> str:
        """Show feasibility, rank and what follows from it."""
        verdict = "feasible" if self.feasible else "not feasible"
        return f"WrenchReport({verdict}, rank {self.rank} of {self.full_rank}, {self.holding.replace('_', ' ')})"


def wrench_at(
    scene: Scene,
    position: ArrayLike,
    *,
    force: float | None = None,
    moment: float | None = None,
    tensions: Distribution | None = None,
) -> WrenchReport:
    """Compute what the cables can balance at a position.

    Parameters
    ----------
    scene : Scene
        Its robot, gravity, orientation, and the loads and requirements of its ``[wrench]`` are used.
    position : array_like (3,)
        Of the platform's origin, world, m.
    force, moment : float, optional
        Radii of the required balls instead of the scene's, N and N·m.
    tensions : {"middle", "least", "p4", "p8", "closed-form"}, optional
        Which of all tensions that balance the loads; default that of the robot, else "middle". See `tension_distribution`.

    Returns
    -------
    WrenchReport

    Raises
    ------
    InputError
        A robot without mass or tension limits, a position where a cable has no length, a moment required of a point mass.

    Examples
    --------
    >>> report = wrench_at(Scene.example("cogiro"), [0, 0, 2])
    >>> report.feasible, report.rank, report.holding
    (True, 6, 'suspended')
    """
    core = instance("scene", scene, Scene)._core
    radii = [None if r is None else number(key, r) for key, r in (("force", force), ("moment", moment))]
    found = json.loads(core.wrench_at(point("position", position), radii[0], radii[1], distribution(tensions)))
    motions = found["free_motions"]
    known: dict[str, Any] = {key: found[key] for key in ("feasible", "balanced", "rank", "full_rank", "holding")}
    known |= {key: _or_nan(found[key]) for key in ("capacity_margin", "force_margin", "moment_margin")}
    known |= {key: tuple(found["limit"][key]) for key in ("at_greatest", "at_least")}
    return WrenchReport(
        **known,
        load_case=found["limit"].get("load_case"),
        free_motions=tuple(motion["words"] for motion in motions),
        free_twists=np.array([motion["twist"] for motion in motions], dtype=np.float64).reshape(-1, 6),
        cables=tuple(found["cables"]),
        lengths=np.array(found["lengths"]),
        tension_distribution=found["tension_distribution"],
        tensions=np.full(len(found["cables"]), np.nan) if found["tensions"] is None else np.array(found["tensions"]),
        wrench_matrix=np.array(found["wrench_matrix"]),
        settling=None if found["settling"] is None else Settling(**found["settling"]),
    )


def _or_nan(value: float | None) -> float:
    return float("nan") if value is None else value


@dataclass(frozen=True, eq=False, repr=False)
class Tensions(ByValue):
    """Lengths, tensions and margins at even steps along a path.

    Attributes
    ----------
    s : ndarray (n,)
        Distance along the path, m; turns count as in its length.
    positions : ndarray (n, 3)
        World, m.
    orientations : ndarray (n, 4) or None
        World-from-platform unit quaternions w x y z, if the platform turns.
    lengths : ndarray (n, m)
        Of each cable, m.
    tensions : ndarray (n, m)
        Of each cable, N; rows of NaN where the loads cannot be balanced.
    commands : ndarray (n, m) or None
        Length to command to each winch, m: the unstretched length of a cable that has its length and tension; NaN without tensions.
        None if no cable has a stiffness.
    angles : ndarray (n, m) or None
        Angle of each motor at its commanded length, rad, from that at the `zero` of its drum; with a positive gear it grows while
        the cable is let out. None if a cable has no drum.
    torques : ndarray (n, m) or None
        Torque of the tension about the axis of each motor, N·m; NaN without tensions. None if a cable has no drum.
    capacity_margin, force_margin, moment_margin : ndarray (n,)
        N, N, N·m; NaN where they do not exist.
    cables : tuple of str
        Names of the cables, in the order of the columns.

    Examples
    --------
    >>> scene = Scene.example("empty")
    >>> tensions_along(scene, [[0.3, 1, 0.3], [1.7, 1, 1.7]], step=0.1)
    Tensions(21 rows, 8 cables, 1.9799 m)
    """

    s: Floats
    positions: Floats
    orientations: Floats | None
    lengths: Floats
    tensions: Floats
    commands: Floats | None
    angles: Floats | None
    torques: Floats | None
    capacity_margin: Floats
    force_margin: Floats
    moment_margin: Floats
    cables: tuple[str, ...]

    def to_pandas(self) -> Any:
        """Return the rows as a table; requires pandas.

        Returns
        -------
        DataFrame
            Like the CSV file of ``cdpr wrench --along``: ``s``, ``x``, ``y``, ``z`` (m), if the platform turns the quaternion
            ``qw``, ``qx``, ``qy``, ``qz``, for each cable by its name ``length:cable 0`` (m), ``tension:cable 0`` (N) and, if
            they are known, ``command:`` (m), ``angle:`` (rad) and ``torque:`` (N·m), then ``capacity_margin``, ``force_margin``
            (N), ``moment_margin`` (N·m).

        Examples
        --------
        >>> scene = Scene.example("empty")
        >>> table = tensions_along(scene, [[0.3, 1, 0.3], [1.7, 1, 1.7]], step=0.1).to_pandas()
        >>> list(table)[4:6]
        ['length:cable 0', 'length:cable 1']
        """
        columns = {"s": self.s, **{axis: self.positions[:, k] for k, axis in enumerate("xyz")}}
        if self.orientations is not None:
            columns |= {f"q{part}": self.orientations[:, k] for k, part in enumerate("wxyz")}
        of_cables: dict[str, Floats | None] = {"length": self.lengths, "tension": self.tensions}
        of_cables |= {"command": self.commands, "angle": self.angles, "torque": self.torques}
        columns |= by_cable(self.cables, of_cables)
        for name in ("capacity_margin", "force_margin", "moment_margin"):
            columns[name] = getattr(self, name)
        return frame(columns)

    def __repr__(self) -> str:
        """Show the size."""
        rows_, cables = self.tensions.shape
        return f"Tensions({rows_} rows, {cables} cables, {self.s[-1] if rows_ else 0.0:.4f} m)"


def tensions_along(
    scene: Scene,
    waypoints: ArrayLike | Path,
    *,
    step: float = 0.01,
    tensions: Distribution | None = None,
    reference: Sequence[float] | None = None,
    strict: bool = False,
) -> Tensions:
    """Compute lengths, tensions and margins at even steps along a path, including its end.

    Parameters
    ----------
    scene : Scene
        Its robot, gravity, orientation, and the loads and requirements of its ``[wrench]`` are used.
    waypoints : array_like (k, 3), k >= 2, or Path
        Positions of the platform's origin, world, m. Along a path with orientations the platform turns, and the loads are
        balanced at each pose.
    step : float
        Distance between rows, m; turns count as in the length of the path.
    tensions : {"middle", "least", "p4", "p8", "closed-form"}, optional
        Which of all tensions that balance the loads; default that of the robot, else "middle". See `tension_distribution`.
    reference : sequence of float (m,), optional
        Instead of ``tensions``: tension of each cable that the tensions are to be near, N.
    strict : bool
        Raise an error for a path that was planned for another scene, instead of an `AnotherSceneWarning`.

    Returns
    -------
    Tensions

    Raises
    ------
    InputError
        A robot without mass or tension limits (`Robot.cable_lengths` requires neither), a step that is not positive,
        fewer than two waypoints, both ``tensions`` and ``reference``; with ``strict``, a path that was planned for another scene.

    Examples
    --------
    >>> scene = Scene.example("empty")
    >>> along = tensions_along(scene, [[0.3, 1, 0.3], [1.7, 1, 1.7]], step=0.1)
    >>> along.tensions.shape, bool(np.isfinite(along.tensions).all())
    ((21, 8), True)
    """
    core, positions, along = way_of(scene, "waypoints", waypoints, strict=strict)
    cables = scene.robot.cable_names
    count = len(cables)
    wanted = None if reference is None else numbers("reference", reference, count)
    found = core.tensions_along(positions, number("step", step), wanted, distribution(tensions, reference), along)
    (s, capacity, force, moment), places, turns, (lengths, balancing, (commands, angles, torques)) = found
    return Tensions(
        s, places, turns, lengths, balancing, commands, angles, torques, capacity, force, moment, cables
    )
