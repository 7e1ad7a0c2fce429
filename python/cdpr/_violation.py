"""Violations of a motion, and exemptions of a scene."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, repr=False)
class Violation:
    """A condition that a motion violates.

    Attributes
    ----------
    at : float
        Fraction of the motion (of the segment, on a path) at which it begins, 0 to 1.
    kind : str
        "workspace", "cable-length", "cable-platform", "cable-cable", "platform-obstacle", "cable-obstacle", "wrench",
        "tilt" or "turning-axis".
    culprits : tuple of str
        Names of the bodies involved; cables count from 0.
    margin : float or None
        Gap minus the required gap, m: never positive. None for the kinds "wrench", "tilt" and "turning-axis".
    segment : int
        Segment of the path, counting from 0.
    wrench_margin : float or None
        For the kind "wrench": margin minus the required margin, in ``unit``, at its minimum.
    unit : str or None
        "N" or "N·m".
    measure : str or None
        The margin that is meant: "capacity", "force" or "moment".
    load_case : str or None
        The load case that is meant, such as "load 2 of 3 with the payload", if the scene has several.
    rank, full_rank : int or None
        Rank of the wrench matrix there, and the highest possible rank: 6, or 3 for a point mass.
    holding : str or None
        What follows from the rank: "fully_constrained", "suspended" or "underconstrained"; see `WrenchReport`.
    free_motions : tuple of str
        The motions that no tensions resist, such as "turning about z".
    at_greatest, at_least : tuple of str
        Cables at their maximum and minimum tension there.
    corner : tuple of float or None
        Corner of the grid cell that the grid rule rejected, m.
    unproved : bool
        No deficit was found, but the margin is too small to prove that there is none: of a wrench, or of a gap while the
        platform turns.
    gap : float or None
        Smallest gap over the motion, m: between surfaces, or minus the penetration depth if bodies overlap; for the
        workspace and cable lengths, the remaining room. Of a thick cable that ends on a body or cannot stay clear of it,
        only the axis must not enter it, and the gap is that of the axis. None for the kinds "wrench", "tilt" and
        "turning-axis".
    required : float or None
        Required gap, m; 0 for bodies that only have to stay apart.
    sag, exit : float or None
        How much lower than a straight line the cable can hang there, and how far from its outlet it can leave the frame, m: the
        gap is that of the worst shape. None for cables that are straight lines from their outlets.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.example("hard1")
    >>> scene.explain_motion([0.3, 1, 0.3], [1.7, 1, 1.7])
    Violation('cable-obstacle', cable 1 / pillar, at 0.2668 of segment 0, margin -0.0750 m)
    """

    at: float
    kind: str
    culprits: tuple[str, ...]
    margin: float | None
    segment: int = 0
    wrench_margin: float | None = None
    unit: str | None = None
    measure: str | None = None
    load_case: str | None = None
    rank: int | None = None
    full_rank: int | None = None
    holding: str | None = None
    free_motions: tuple[str, ...] = ()
    at_greatest: tuple[str, ...] = ()
    at_least: tuple[str, ...] = ()
    corner: tuple[float, float, float] | None = None
    unproved: bool = False
    gap: float | None = None
    required: float | None = None
    sag: float | None = None
    exit: float | None = None

    def __repr__(self) -> str:
        """Show the kind, the bodies involved, the place and the margin."""
        parts = [f"{self.kind!r}", " / ".join(self.culprits), f"at {self.at:.4f} of segment {self.segment}"]
        if self.margin is not None:
            parts.append(f"margin {self.margin:.4f} m")
        if self.gap is not None and self.required:
            parts.append(f"gap {self.gap:.4f} m of {self.required:.4f} m")
        if self.wrench_margin is not None:
            parts.append(f"margin {self.wrench_margin:.4f} {self.unit}")
        if self.load_case is not None:
            parts.append(self.load_case)
        if self.free_motions:
            parts.append(f"rank {self.rank} of {self.full_rank}")
        if self.unproved:
            parts.append("unproved")
        return f"Violation({', '.join(part for part in parts if part)})"


def violation_from(values: Mapping[str, Any]) -> Violation:
    """Make a violation from the core's JSON."""
    fields: dict[str, Any] = {k: tuple(value) if isinstance(value, list) else value for k, value in values.items()}
    fields |= fields.pop("shapes", {})
    fields["free_motions"] = tuple(motion["words"] for motion in fields.get("free_motions", ()))
    return Violation(**fields)


@dataclass(frozen=True)
class Exemption:
    """A pair that is exempt from the clearance of its kind.

    Attributes
    ----------
    pair : tuple of str
        Names of the two bodies.
    reason : str
        "unattainable" (the pair cannot keep the clearance at any position; it must still not touch, if that is
        possible), "touch" (the scene lets the pair touch but not overlap) or "ignore" (not checked at all).
    demanded : float
        The clearance that would otherwise be required, m.
    attainable : float or None
        For "unattainable": the largest gap at any position, m; negative if thick cables overlap everywhere.
    gap : float or None
        Nearest approach of the pair on the path, m; None if it is not measured, for ignored pairs and for pairs that
        touch by construction.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.example("hard1").replace(touch=[("platform", "pillar")])
    >>> [exemption.reason for exemption in cdpr.plan(scene).exempt]
    ['touch']
    """

    pair: tuple[str, str]
    reason: str
    demanded: float
    attainable: float | None
    gap: float | None


def exemption_from(values: Mapping[str, Any]) -> Exemption:
    """Make an exemption from the core's JSON."""
    first, second = values["pair"]
    return Exemption(**{**values, "pair": (first, second)})
