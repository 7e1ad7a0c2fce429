"""Check certificates: that no path exists (cdpr-proof), or that none is shorter than a length (cdpr-bound).

A cdpr-proof certificate proves that no path from start to goal keeps a gap of more than the margin. It tiles the box of
positions with boxes. Each box is open, inside a region of forbidden positions, or forbidden as a whole for a stated reason.
Each such set is convex and so is the set of positions that a pair of convex bodies forbids. So a region is forbidden if its
vertices are, and a box if its corners are. If the open boxes that contain the start are not connected with those of the
goal, each path enters a forbidden box. :func:`check_bound` describes cdpr-bound certificates.

All decisions are exact. Floating point only finds witnesses (nearest points), which are then verified in rationals;
labels of bounds and boxes in which wrenches lack are compared in floating point, with reserves far above rounding errors.
This package shares no code with the program that writes certificates, and needs only the standard library.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from ._bends import Bends
from ._certificate import Bound, Certificate, Question, parsed
from ._forbidden import ROUNDING, Model
from ._hulls import clipped
from ._labels import check_labels
from ._tiling import check_inside, check_open_around, check_separation, tiling_of
from ._vectors import dot, exact
from ._wrenches import check_lack


def check_certificate(scene: Mapping[str, Any], certificate: Mapping[str, Any] | str, fingerprint: str | None) -> None:
    """Raise ValueError, with the reason, unless the certificate proves that this scene has no path.

    The scene is plain data with an inline robot and convex bodies; `fingerprint` is the scene's (None: do not compare).
    """
    file = parsed(certificate) if isinstance(certificate, str) else certificate
    if isinstance(file, Mapping) and file.get("format") == "cdpr-bound":
        return check_bound(scene, file, fingerprint)
    proof = Certificate(file)
    _same_scene(file, fingerprint)
    model = Model(scene, proof)
    tree = tiling_of(proof.box, proof.boxes)
    check_separation(proof, tree)
    _check_regions(model, proof)
    check_inside(proof)
    for k, reason in proof.reasons.items():
        if not model.closes(reason, proof.boxes[k]):
            raise ValueError(f"boxes[{k}]: not all of its positions are forbidden by {list(reason)}")
    for end, point in enumerate((proof.start, proof.goal)):
        if end in model.touched:
            check_open_around("goal" if end else "start", point, proof)


def check_bound(scene: Mapping[str, Any], file: Mapping[str, Any], fingerprint: str | None) -> None:
    """Raise ValueError, with the reason, unless the certificate proves that no path is shorter than its length.

    Among the positions outside all regions, a shortest path bends only at edges and corners of regions. The certificate
    lists all of these with labels that grow no faster than the length of a path, up to a little for each bend. So the
    label of the goal is a lower bound of the length.
    """
    proof = Bound(file)
    _same_scene(file, fingerprint)
    for name, end in (("start", proof.start), ("goal", proof.goal)):
        if not all(proof.box[k] <= end[k] <= proof.box[k + 3] for k in range(3)):
            raise ValueError(f"{name}: found {list(end)}, expected it in the box")
    _check_regions(Model(scene, proof, at_one_end=True), proof)
    _check_outside(proof)
    check_labels(proof, Bends(proof))


def _same_scene(file: Mapping[str, Any], fingerprint: str | None) -> None:
    if fingerprint is not None and file["scene"] != fingerprint:
        raise ValueError(f"scene: found {file['scene']!r}, which is another scene; this one is {fingerprint!r}")


def _check_outside(proof: Bound) -> None:
    """Of paths between ends inside a region, anything is true."""
    for name, end in (("start", proof.start), ("goal", proof.goal)):
        for k, region in enumerate(proof.regions):
            heights = (dot(exact(row[:3]), exact(end)) - Fraction(row[3]) for row in region.half_spaces)
            if all(height < -ROUNDING for height in heights):
                raise ValueError(f"{name}: found it inside regions[{k}], expected it in no region")


def _check_regions(model: Model, proof: Question) -> None:
    for k, region in enumerate(proof.regions):
        vertices = clipped(proof.box, region.half_spaces)
        if not vertices:
            raise ValueError(f"regions[{k}].half_spaces: found no position of the box in them, expected some")
        if region.lacks_wrench:
            if not isinstance(proof, Bound):
                raise ValueError(f"regions[{k}].who: found \"wrench\", expected a pair; boxes have it as a reason")
            try:
                check_lack(model.requirement, proof, region, vertices)
            except ValueError as problem:
                raise ValueError(f"regions[{k}].{problem}") from None
        elif not model.forbids(region.who, vertices):
            found = f"reaches more than the margin beyond the positions that {' and '.join(region.who)} forbid"
            raise ValueError(f"regions[{k}]: {found}")
