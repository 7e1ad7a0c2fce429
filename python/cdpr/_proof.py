"""Proofs that there is no path."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import Floats
from ._given import file_name, instance
from ._certify import check_certificate
from ._scene import Scene
from ._stations import between
from ._values import ByValue
from .exceptions import FileError

MOST_BYTES = 200_000_000


@dataclass(frozen=True, eq=False, repr=False)
class Proof(ByValue):
    """A proof that no path keeps a gap of more than ``margin``, and why.

    Attributes
    ----------
    culprits : tuple of tuple of str
        The pairs whose conditions close the way; single names are of cables with length limits, or "wrench".
    blocking : tuple of str
        The obstacles that close the way; none can be left out.
    without : dict
        For each of these the length of the path that exists if it is removed, m, or None if none was found then either.
    reachable_volume : float
        Volume of the positions known to be reachable from the start, m³.
    nearest_to_goal : ndarray (3,)
        The reachable position that is nearest to the goal, m.
    margin : float
        Metres.
    boxes : int
        Number of boxes of the proof.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.example("closed")
    >>> result = cdpr.plan(scene)
    >>> result.status, result.proof.blocking
    ('no_path', ('south', 'north'))
    """

    culprits: tuple[tuple[str, ...], ...]
    blocking: tuple[str, ...]
    without: Mapping[str, float | None]
    reachable_volume: float
    nearest_to_goal: Floats
    margin: float
    boxes: int
    _certificate: str = field(default="", compare=False, kw_only=True)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the certificate, which anyone can check: see :func:`cdpr.check_proof`.

        Parameters
        ----------
        path : path
            A JSON file.

        Raises
        ------
        FileError
            A file that cannot be written; nothing half-written is left.
        """
        _core.save_text(file_name(path), self._certificate + "\n")

    def __repr__(self) -> str:
        """Show the culprits and the size of the proof."""
        pairs = ", ".join(" and ".join(pair) for pair in self.culprits)
        return f"Proof({pairs}; {self.boxes} boxes)"


def proof_from(values: Mapping[str, Any], certificate: str) -> Proof:
    """Make a proof from JSON of the core."""
    return Proof(
        culprits=tuple(tuple(pair) for pair in values["culprits"]),
        blocking=tuple(values["blocking"]),
        without=dict(values["without"]),
        reachable_volume=values["reachable_volume"],
        nearest_to_goal=np.array(values["nearest_to_goal"]),
        margin=values["margin"],
        boxes=values["boxes"],
        _certificate=certificate,
    )


def check_proof(
    scene: Scene,
    path: str | os.PathLike[str],
    *,
    start: ArrayLike | str | None = None,
    goal: ArrayLike | str | None = None,
) -> bool:
    """Check a certificate that a scene has no path, or none shorter than some length, with exact arithmetic and without the code that made it.

    Parameters
    ----------
    scene : Scene
    path : path
        The file that `Proof.save`, `lower_bound` or ``cdpr plan --proof`` wrote.
    start, goal : array_like (3,) or str, optional
        The ends that were given to planning instead of the scene's, m, or names of stations.

    Returns
    -------
    bool
        True: no path keeps a gap of more than the margin of the certificate, or none that does is shorter than its
        ``"length"``, m.

    Raises
    ------
    FileError
        A file that cannot be read, is no certificate, or does not prove what it says of this scene; the message says
        what is wrong with it, and where.

    Notes
    -----
    A certificate is for one orientation; if the scene lists several, select one before. Pure Python with rational numbers: about 1 s for 10 000 boxes.

    Examples
    --------
    >>> import cdpr, os, tempfile
    >>> scene = cdpr.example("closed")
    >>> file = os.path.join(tempfile.mkdtemp(), "proof.json")
    >>> cdpr.plan(scene).proof.save(file)
    >>> cdpr.check_proof(scene, file)
    True
    """
    instance("scene", scene, Scene)
    name = file_name(path)
    try:
        if os.path.getsize(name) > MOST_BYTES:
            raise FileError(f"{name}: found more than {MOST_BYTES} bytes, expected a certificate")
        with open(name, encoding="utf-8") as file:
            text = file.read()
    except (OSError, UnicodeDecodeError) as problem:
        raise FileError(f"{name}: cannot be read: {problem}") from None
    asked = between(scene._core, start, goal)
    query = json.loads(asked.located_query())
    spec = scene._plain | {"query": query}
    try:
        if len(scene.orientations) > 1 and "orientation" not in query:
            raise ValueError("orientation: found a scene that selects none, expected one: scene.replace(orientation=...)")
        check_certificate(spec, text, asked.fingerprint())
    except ValueError as problem:
        raise FileError(f"{name}: {problem}") from None
    return True
