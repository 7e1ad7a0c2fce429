"""Where the platform can be, proved box by box."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Literal, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import Floats, Ints, number, thread_count
from ._given import file_name, instance, one_of, several
from ._pandas import frame
from ._scene import Scene
from ._values import ByValue
from .exceptions import InputError

ValidAt: TypeAlias = Literal["every", "any", "turns"]


class Bounds(NamedTuple):
    """Bounds of a volume.

    Attributes
    ----------
    min, max : float
        It is at least ``min`` and at most ``max``.

    Examples
    --------
    >>> import cdpr
    >>> round(cdpr.workspace(cdpr.example("empty"), resolution=0.5).volume.max, 3)
    6.674
    """

    min: float
    max: float


@dataclass(frozen=True, eq=False, repr=False)
class WorkspacePart(ByValue):
    """A connected part of what is proved inside: between any two of its positions there is a valid path.

    Attributes
    ----------
    volume : float
        Volume of its boxes, m³; m² if the workspace is flat.
    boxes : int
        Number of its boxes.
    extent : ndarray (2, 3)
        Its smallest and largest coordinates, m.
    start, goal : bool
        Whether it holds the start or the goal of the scene.

    Examples
    --------
    >>> import cdpr
    >>> cdpr.workspace(cdpr.example("hard1"), resolution=0.1).parts[0]
    WorkspacePart(1.613, 2096 boxes, start, goal)
    """

    volume: float
    boxes: int
    extent: Floats
    start: bool
    goal: bool

    def __repr__(self) -> str:
        """Show size, and whether start and goal are in it."""
        held = "".join(f", {name}" for name in ("start", "goal") if getattr(self, name))
        return f"WorkspacePart({self.volume:.4g}, {self.boxes} boxes{held})"


@dataclass(frozen=True, eq=False, repr=False)
class Share(ByValue):
    """How much of the workspace a kind of condition rules out.

    Attributes
    ----------
    share : float
        Share of the box of positions.
    volume : float
        Volume, m³; m² if the workspace is flat.
    culprits : mapping of str to float
        The same volume by the names of the bodies, as in "cable 3 / pillar"; empty for wrenches.

    Examples
    --------
    >>> import cdpr
    >>> cdpr.workspace(cdpr.example("hard1"), resolution=0.1).shares["cable-obstacle"]
    Share(67.86 %, 8 pairs)
    """

    share: float
    volume: float
    culprits: Mapping[str, float]

    def __repr__(self) -> str:
        """Show share and number of pairs."""
        return f"Share({100 * self.share:.2f} %, {len(self.culprits)} pairs)"


class Workspace:
    """Where the platform can be at one orientation or at several, proved; made by `workspace`.

    Attributes
    ----------
    volume : Bounds
        The volume of all valid positions is at least ``volume.min`` and at most ``volume.max``, m³; areas in m² if the
        workspace is flat.
    total : float
        Volume of the box of positions, where the platform is inside the workspace of the scene.
    undecided : float
        Volume about which nothing is proved. Of undecided boxes, what flat surfaces and bounds cut off is known.
    decided : float
        Share of the box of positions that is proved to be valid or invalid.
    dimension : int
        3, or 2 for a planar robot.
    ended : str
        "complete", "budget", "interrupted" or "too_many_boxes".
    finest : float
        Longest side of the smallest boxes, m.
    parts : tuple of WorkspacePart
        Connected parts of the boxes inside, the largest first.
    shares : mapping of str to Share
        How much each kind of condition, such as "cable-obstacle", rules out. A box that several conditions
        forbid counts for the first of them, in the order of checking.
    lower, upper : ndarray (n, 3)
        Smallest and largest coordinates of the boxes, which tile the box of positions, m.
    verdict : ndarray (n,) of int64
        1 if all positions of a box are valid, -1 if none is, 0 if nothing is proved.
    part, cause : ndarray (n,) of int64
        Index of the part of a box that is inside, and of the condition in ``causes`` that forbids a box; otherwise -1.
    causes : tuple of str
        The conditions that forbid boxes, as in "cable-obstacle: cable 3 / pillar".
    orientations : tuple of ndarray (4,)
        World-from-platform unit quaternions w x y z. For turns, also those on the way at which forbidden positions were looked for.
    valid_at : str or None
        Of several orientations, whether positions are valid at "every" one, at "any", or during the "turns" from each to the next.

    Examples
    --------
    >>> import cdpr
    >>> found = cdpr.workspace(cdpr.example("closed"), resolution=0.1)
    >>> found
    Workspace(3.398 to 3.401 m³, 99.95 % decided, 2 parts)
    >>> [(part.start, part.goal) for part in found.parts]
    [(True, False), (False, True)]
    """

    def __init__(self, core: _core.Workspace) -> None:
        """See `workspace`."""
        self._core = core
        report = json.loads(core.report())
        self.volume = Bounds(**report["volume"])
        self.total: float = report["total"]
        self.undecided: float = report["undecided"]
        self.decided: float = report["decided"]
        self.dimension: int = report["dimension"]
        self.ended: str = report["ended"]
        self.finest: float = report["finest"]
        self.parts = tuple(_part(part) for part in report["parts"])
        self.shares: Mapping[str, Share] = MappingProxyType({kind: Share(**of) for kind, of in report["shares"].items()})
        more = (other["orientation"] for other in report.get("more_orientations", ()))
        self.orientations: tuple[Floats, ...] = tuple(np.array(turn) for turn in (report["orientation"], *more))
        self.valid_at: str | None = report.get("valid_at")
        self.causes = tuple(": ".join([of["condition"], " / ".join(of["culprits"])]).removesuffix(": ") for of in report["causes"])
        self.lower: Floats
        self.upper: Floats
        self.verdict: Ints
        self.part: Ints
        self.cause: Ints
        self.lower, self.upper, self.verdict, self.part, self.cause = core.boxes()

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write a file: .json with everything, .npz for NumPy, .vti for ParaView, or .stl.

        Parameters
        ----------
        path : path
            The extension selects the format. A .stl file has the surface of what is proved inside.

        Raises
        ------
        FileError
            Another extension, or a file that cannot be written.
        InputError
            A flat workspace as .stl.
        """
        self._core.save(file_name(path))

    def to_pandas(self) -> Any:
        """Return the boxes as a table; requires pandas.

        Returns
        -------
        DataFrame
            ``x_min`` to ``z_max`` (m), ``verdict``, ``part``, ``cause``.
        """
        sides = [(f"{axis}_{end}", box[:, k]) for k, axis in enumerate("xyz") for end, box in self._ends()]
        return frame(dict(sides) | {name: getattr(self, name) for name in ("verdict", "part", "cause")})

    def _ends(self) -> tuple[tuple[str, Floats], tuple[str, Floats]]:
        return ("min", self.lower), ("max", self.upper)

    def __eq__(self, other: object) -> bool:
        """Compare by value."""
        return isinstance(other, Workspace) and self._core.to_bytes() == other._core.to_bytes()

    __hash__ = None  # type: ignore[assignment]

    @classmethod
    def _from_bytes(cls, text: bytes) -> Workspace:
        return cls(_core.Workspace.from_bytes(text))

    def __reduce__(self) -> tuple[Any, tuple[bytes]]:
        """Pickle by value."""
        return Workspace._from_bytes, (self._core.to_bytes(),)

    def __repr__(self) -> str:
        """Show volume, decided share and parts."""
        unit = {3: "m³", 2: "m²", 1: "m"}.get(self.dimension, "positions")
        parts = "1 part" if len(self.parts) == 1 else f"{len(self.parts)} parts"
        return f"Workspace({self.volume.min:.3f} to {self.volume.max:.3f} {unit}, {100 * self.decided:.2f} % decided, {parts})"


def _part(found: dict[str, Any]) -> WorkspacePart:
    extent = np.array([found["extent"]["min"], found["extent"]["max"]])
    return WorkspacePart(found["volume"], found["boxes"], extent, found["start"], found["goal"])


def workspace(
    scene: Scene,
    *,
    orientation: ArrayLike | str | None = None,
    orientations: Sequence[ArrayLike | str] | None = None,
    valid_at: ValidAt = "every",
    resolution: float | None = None,
    budget: float | None = None,
    threads: int | None = None,
) -> Workspace:
    """Prove where the platform can be, at one orientation, at several or during turns.

    Divides the box of positions into boxes of which every position is valid, boxes of which one condition forbids every
    position, and a rest that is undecided.

    Parameters
    ----------
    scene : Scene
        Obstacles, clearances, lengths and shapes of cables, and the requirements of its ``[wrench]`` count as in planning.
    orientation : array_like (4,) or str, optional
        World-from-platform unit quaternion w x y z, or the name of one of the scene's orientations, to use instead of the
        scene's.
    orientations : sequence, optional
        Several orientations instead of one, each as for ``orientation``.
    valid_at : {"every", "any", "turns"}
        At which of them positions have to be valid: at every one, at any, or at every orientation on the way from each to the
        next, by the shorter turn. At "any", the platform may have to turn between two positions of a part, which is not
        proved to be possible.
    resolution : float, optional
        Divide boxes until their sides are at most this long, m. Default a 64th of the longest side of the box of
        positions, with a budget as small as time allows.
    budget : float, optional
        Time limit, s, including the time to compile the scene.
    threads : int, optional
        Default all cores; without a budget, the result does not depend on it.

    Returns
    -------
    Workspace
        On Ctrl-C, with what is decided so far.

    Raises
    ------
    InputError
        A workspace that the platform does not fit into, a resolution that is not positive, no orientation, both
        ``orientation`` and ``orientations``, ``valid_at`` without ``orientations``; for turns, a single orientation, a turn
        that the scene's ``[turning]`` does not allow, or the wrench rule "grid".

    Examples
    --------
    >>> import cdpr
    >>> found = cdpr.workspace(cdpr.example("hard1"), resolution=0.2)
    >>> found.volume.min <= found.volume.max < found.total
    True
    >>> inside = found.verdict == 1
    >>> bool(cdpr.example("hard1").states_valid((found.lower + found.upper)[inside] / 2).all())
    True

    Where a bar fits both lengthwise and across:

    >>> plank = cdpr.example("plank")
    >>> both = cdpr.workspace(plank, orientations=["along", "across"], resolution=0.1)
    >>> either = cdpr.workspace(plank, orientations=["along", "across"], valid_at="any", resolution=0.1)
    >>> both.volume.max < either.volume.min
    True

    And where it can turn from one to the other:

    >>> turns = cdpr.workspace(plank, orientations=["along", "across"], valid_at="turns", resolution=0.1)
    >>> turns.volume.max <= both.volume.max
    True
    """
    instance("scene", scene, Scene)
    chosen = one_of("valid_at", valid_at, ValidAt)
    if orientations is None:
        if chosen != "every":
            raise InputError(f'valid_at: found "{chosen}" without orientations; expected several orientations')
        turned = [scene if orientation is None else scene.replace(orientation=orientation)]
    elif orientation is not None:
        raise InputError("orientations: found orientation, too; expected only one of the two")
    else:
        turned = [scene.replace(orientation=given) for given in several("orientations", orientations, "a sequence of orientations")]
    asked = _optional("resolution", resolution), _optional("budget", budget), thread_count(threads)
    return Workspace(_core.Workspace.of([at._core for at in turned], chosen, *asked))


def _optional(name: str, value: float | None) -> float | None:
    return None if value is None else number(name, value)
