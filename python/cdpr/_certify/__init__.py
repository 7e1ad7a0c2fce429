"""Check a cdpr-proof certificate: that no path from start to goal keeps a gap of more than the margin.

A certificate tiles the box of positions with boxes. Each box is open, inside a region of forbidden positions, or
forbidden as a whole for a stated reason. Each such set is convex and so is the set of positions that a pair of convex
bodies forbids. So a region is forbidden if its vertices are, and a box if its corners are. If the open boxes that
contain the start are not connected with those of the goal, each path enters a forbidden box.

All decisions are exact. Floating point only finds witnesses (nearest points), which are then verified in rationals.
This package shares no code with the program that writes certificates, and needs only the standard library.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ._certificate import Certificate, parsed
from ._forbidden import Model
from ._hulls import clipped
from ._tiling import check_inside, check_open_around, check_separation, tiling_of


def check_certificate(scene: Mapping[str, Any], certificate: Mapping[str, Any] | str, fingerprint: str | None) -> None:
    """Raise ValueError, with the reason, unless the certificate proves that this scene has no path.

    The scene is plain data with an inline robot and convex bodies; `fingerprint` is the scene's (None: do not compare).
    """
    file = parsed(certificate) if isinstance(certificate, str) else certificate
    proof = Certificate(file)
    if fingerprint is not None and file["scene"] != fingerprint:
        raise ValueError(f"scene: found {file['scene']!r}, which is another scene; this one is {fingerprint!r}")
    model = Model(scene, proof)
    tree = tiling_of(proof.box, proof.boxes)
    check_separation(proof, tree)
    for k, region in enumerate(proof.regions):
        vertices = clipped(proof.box, region.half_spaces)
        if not model.forbids(region.who, vertices):
            found = f"reaches more than the margin beyond the positions that {' and '.join(region.who)} forbid"
            raise ValueError(f"regions[{k}]: {found}")
    check_inside(proof)
    for k, reason in proof.reasons.items():
        if not model.closes(reason, proof.boxes[k]):
            raise ValueError(f"boxes[{k}]: not all of its positions are forbidden by {list(reason)}")
    for end, point in enumerate((proof.start, proof.goal)):
        if end in model.touched:
            check_open_around("goal" if end else "start", point, proof)
