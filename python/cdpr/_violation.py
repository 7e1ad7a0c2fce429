"""What is wrong with a motion."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, repr=False)
class Violation:
    """A condition that a motion breaks.

    Attributes
    ----------
    at : float
        Fraction of the motion (of the segment, on a path) at which it begins, 0 to 1.
    kind : str
        "workspace", "cable-length", "cable-platform", "cable-cable", "platform-obstacle", "cable-obstacle" or "wrench".
    culprits : tuple of str
        Who is involved, by the names of the scene; cables count from 0.
    margin : float or None
        Gap less what is required, m: never positive.
    segment : int
        Which segment of a path, counting from 0.
    wrench_margin : float or None
        For the kind "wrench": margin less demand, in ``unit``, where it is least.
    unit : str or None
        "N" or "N·m".
    measure : str or None
        What it is measured by: "capacity", "force" or "moment".
    rank, full_rank : int or None
        Rank of the wrench matrix there, and the highest there can be: 6, or 3 for a point mass.
    holding : str or None
        What follows from it: "fully_constrained", "suspended" or "underconstrained"; see `WrenchReport`.
    free_motions : tuple of str
        The motions that no tensions resist, such as "turning about z".
    at_greatest, at_least : tuple of str
        Cables at their greatest and least tension there.
    corner : tuple of float or None
        Corner of the grid cell for which the grid rule refused, m.
    unproved : bool
        For the kind "wrench": nothing is known to be lacking, but what is left is too little to prove that nothing is.
    gap : float or None
        Worst gap over the motion, m: between surfaces, minus a penetration depth where bodies overlap; for the workspace
        and the length of a cable the room left. None for the kind "wrench".
    required : float or None
        What the gap would have to be, m.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.Scene.load("testdata/scenes/hard1.toml")
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

    def __repr__(self) -> str:
        """Say what is in whose way, where, and how badly."""
        parts = [f"{self.kind!r}", " / ".join(self.culprits), f"at {self.at:.4f} of segment {self.segment}"]
        if self.margin is not None:
            parts.append(f"margin {self.margin:.4f} m")
        if self.gap is not None and self.required:
            parts.append(f"gap {self.gap:.4f} m of {self.required:.4f} m")
        if self.wrench_margin is not None:
            parts.append(f"margin {self.wrench_margin:.4f} {self.unit}")
        if self.free_motions:
            parts.append(f"rank {self.rank} of {self.full_rank}")
        if self.unproved:
            parts.append("unproved")
        return f"Violation({', '.join(part for part in parts if part)})"


def violation_from(values: Mapping[str, Any]) -> Violation:
    """A violation from the core's JSON."""
    fields: dict[str, Any] = {k: tuple(value) if isinstance(value, list) else value for k, value in values.items()}
    fields["free_motions"] = tuple(motion["words"] for motion in fields.get("free_motions", ()))
    return Violation(**fields)


@dataclass(frozen=True)
class Exemption:
    """A pair that is not held to the clearance of its kind.

    Attributes
    ----------
    pair : tuple of str
        Two names of the scene.
    reason : str
        "unattainable" (at no position can the pair be as far apart; it must still not touch, if it can keep from that),
        "touch" (the scene lets it touch, but not enter each other) or "ignore" (not checked at all).
    demanded : float
        The clearance that would have to be kept otherwise, m.
    attainable : float or None
        For "unattainable" the largest gap at any position, m; negative where thick cables overlap everywhere.
    gap : float or None
        Nearest approach of the pair on the path, m; None where it is not measured: ignored pairs, and those that touch by
        construction.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.Scene.load("testdata/scenes/hard1.toml").replace(touch=[("platform", "pillar")])
    >>> [exemption.reason for exemption in cdpr.plan(scene).exempt]
    ['touch']
    """

    pair: tuple[str, str]
    reason: str
    demanded: float
    attainable: float | None
    gap: float | None


def exemption_from(values: Mapping[str, Any]) -> Exemption:
    """An exemption from the core's JSON."""
    first, second = values["pair"]
    return Exemption(**{**values, "pair": (first, second)})
