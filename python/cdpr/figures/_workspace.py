"""Sections of a proved workspace."""

from __future__ import annotations

from typing import Literal, TypeAlias

import numpy as np
from matplotlib import pyplot
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.patches import Patch

from .._arrays import Floats, finite
from .._given import instance, one_of
from .._workspace import Workspace
from ..exceptions import InputError
from ._style import BLACK, COLUMN, GREEN, GREY, LIGHT, ORANGE, PURPLE, SKY, VERMILION, Printed, styled

Axis: TypeAlias = Literal["x", "y", "z"]

_REST = 0.6  # height of title, legend and numbers, beyond that of the section in the width of a column, inches

_VALID = SKY
_UNDECIDED = BLACK
# By the kind of the condition that forbids a box; the rest is grey.
_KINDS = {
    "wrench": VERMILION,
    "cable-obstacle": ORANGE,
    "platform-obstacle": GREY,
    "cable-cable": PURPLE,
    "cable-platform": GREEN,
}


@styled
def workspace(
    workspace: Workspace, *, axis: Axis | None = None, at: float | None = None, ax: Axes | None = None
) -> Axes:
    """Draw a section of a proved workspace: where the platform can be, and what takes the rest away.

    Parameters
    ----------
    workspace : Workspace
        As returned by `cdpr.workspace`.
    axis : {"x", "y", "z"}, optional
        Normal of the section; default: that of a flat workspace, otherwise z.
    at : float, optional
        Coordinate of the section along this axis, m; default the middle of the largest part, or of the box of positions if
        no position is valid.
    ax : Axes, optional
        Where to draw; default a new figure of the width of a column.

    Returns
    -------
    Axes
        Positions of the platform's origin, m. Collections of boxes have the ``gid`` "valid", "undecided" and, for what
        forbids the others, the kind of the condition, such as "cable-obstacle".

    Raises
    ------
    InputError
        A section outside the box of positions.

    Examples
    --------
    >>> import cdpr, cdpr.figures
    >>> found = cdpr.workspace(cdpr.example("hard1"), resolution=0.1)
    >>> ax = cdpr.figures.workspace(found, axis="y", at=1.0)
    >>> ax.get_xlabel(), [drawn.get_gid() for drawn in ax.collections][:2]
    ('x (m)', ['valid', 'undecided'])
    """
    instance("workspace", workspace, Workspace)
    low, high = workspace.lower.min(axis=0), workspace.upper.max(axis=0)
    normal = int((high - low).argmin()) if workspace.dimension < 3 else 2
    if axis is not None:
        normal = "xyz".index(one_of("axis", axis, Axis))
    place = _middle(workspace, normal, low, high) if at is None else finite("at", at)
    if not low[normal] <= place <= high[normal]:
        raise InputError(f"at: found {place:g} m, expected a coordinate from {low[normal]:g} to {high[normal]:g} m")
    # A box ends where the next one begins: the section passes through one of them.
    met = (workspace.lower[:, normal] <= place) & ((place < workspace.upper[:, normal]) | (place == high[normal]))
    met &= (place < high[normal]) | (workspace.upper[:, normal] == high[normal])
    across = [k for k in range(3) if k != normal]
    if ax is not None:
        instance("ax", ax, Axes)
    else:
        wide, tall = (high - low)[across]
        size = (COLUMN, min(COLUMN * tall / wide, 2 * COLUMN) + _REST)
        ax = pyplot.subplots(figsize=size, layout="constrained", FigureClass=Printed)[1]
    _fill(ax, workspace, np.flatnonzero(met), across)
    ax.set(xlim=(low[across[0]], high[across[0]]), ylim=(low[across[1]], high[across[1]]), aspect="equal")
    ax.set(xlabel=f"{'xyz'[across[0]]} (m)", ylabel=f"{'xyz'[across[1]]} (m)")
    ax.set_title(f"section at {'xyz'[normal]} = {place:.4g} m", loc="left")
    return ax


def _middle(workspace: Workspace, normal: int, low: Floats, high: Floats) -> float:
    """Return the middle of the largest part along an axis, or of all if there is none."""
    if workspace.parts:
        low, high = workspace.parts[0].extent
    return float(0.5 * (low[normal] + high[normal]))


def _fill(ax: Axes, workspace: Workspace, met: np.ndarray, across: list[int]) -> None:
    """Fill the boxes that a section meets, by what is known of them."""
    kinds = np.array([*(cause.split(":")[0] for cause in workspace.causes), ""])[workspace.cause[met]]
    verdict = workspace.verdict[met]
    groups = [("valid", _VALID, verdict == 1), ("undecided", _UNDECIDED, verdict == 0)]
    found = dict.fromkeys(kinds[verdict == -1])
    groups += [(kind, _KINDS.get(kind, LIGHT), (verdict == -1) & (kinds == kind)) for kind in sorted(found)]
    corners = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], dtype=bool)
    for name, colour, of_it in groups:
        boxes = np.hstack([end[met[of_it]][:, across] for end in (workspace.lower, workspace.upper)])
        boxes = _merged(_merged(boxes, 0), 1)
        rectangles = np.where(corners, boxes[:, None, 2:], boxes[:, None, :2])
        # Edges in the same colour leave no white lines between boxes.
        ax.add_collection(PolyCollection(list(rectangles), facecolor=colour, edgecolor=colour, linewidth=0.2, gid=name))
    shown = [Patch(color=colour, label=name) for name, colour, of_it in groups if of_it.any()]
    ax.legend(handles=shown, loc="lower center", bbox_to_anchor=(0.5, 1.08), ncols=3, handlelength=1, columnspacing=1)


def _merged(boxes: Floats, along: int) -> Floats:
    """Merge boxes (n, 4), smallest and largest coordinates, that continue each other along an axis of the section."""
    if not len(boxes):
        return boxes
    other = 1 - along
    boxes = boxes[np.lexsort([boxes[:, along], boxes[:, other + 2], boxes[:, other]])]
    before, after = boxes[:-1], boxes[1:]
    continued = (before[:, [other, other + 2]] == after[:, [other, other + 2]]).all(axis=1)
    continued &= before[:, along + 2] == after[:, along]
    first = np.flatnonzero(np.concatenate([[True], ~continued]))
    last = np.concatenate([first[1:] - 1, [len(boxes) - 1]])
    merged = boxes[first]
    merged[:, along + 2] = boxes[last, along + 2]
    return merged
