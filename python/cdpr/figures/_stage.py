"""A drawing in space: opaque solids, translucent faces and lines, so that what is in front covers what is behind.

Axes3D sorts whole artists by their middle, which puts cables through pillars. Here the order is computed for one
direction of view, seen from infinitely far away, and handed to Axes3D as fixed layers; so turn a picture by ``view``,
not with the mouse.
"""

from __future__ import annotations

from collections import defaultdict
from itertools import pairwise
from typing import Any, NamedTuple, TypeAlias

import matplotlib.patheffects as effects
import numpy as np
from matplotlib import pyplot
from matplotlib.colors import to_rgb
from matplotlib.text import Annotation, Text
from matplotlib.ticker import MaxNLocator
from matplotlib.transforms import Bbox, BboxBase
from mpl_toolkits.mplot3d import Axes3D, proj3d
from mpl_toolkits.mplot3d.art3d import Poly3DCollection

from .._arrays import Floats, numbers
from ..exceptions import InputError
from ._polyhedra import Solid, back_to_front, hidden, normal, overlap, visible
from ._style import COLUMN, GREY, LIGHT, Printed, laid_out

View: TypeAlias = tuple[float, float]

# Layers, from back to front: markers that solids hide, solids and faces, what shows of lines, other markers, words.
_UNDER, _SOLIDS, _OVER, _MARKS, _WORDS = 1.0, 10.0, 1e6, 2e6, 3e6
_LIGHT_FROM = np.array([0.35, -0.6, 0.72])
_AMBIENT = 0.72
_COVERED = 1000  # cost of covering other words; that of a point of a line is 1
_FAR = 8  # points from a body to its name, beyond which a line joins them
_LEADER: Any = {"arrowstyle": "-", "color": GREY, "linewidth": 0.5, "shrinkA": 0, "shrinkB": 0}
_MARGIN = 0.08  # below a legend, inches
_FLAT = 0.05  # least thickness of a drawing, relative to its width


class _Words(NamedTuple):
    """Text, the position that it belongs to, and where it should be from there on the paper, points."""

    place: Floats
    text: str
    offset: tuple[float, float]
    style: dict[str, Any]


class Stage:
    """An Axes3D of a box of space, and what is to be painted in it."""

    def __init__(self, ax: Axes3D | None, low: Floats, high: Floats, view: View, unit: str = "m", *, zoom: float = 0.96) -> None:
        """Set up the axes: equal scales, parallel projection, no panes."""
        if ax is not None and not isinstance(ax, Axes3D):
            raise InputError(f'ax: found {type(ax).__name__}, expected Axes3D: add_subplot(projection="3d")')
        elevation, azimuth = numbers("view", view, 2)
        self.ax = new_axes() if ax is None else ax
        self.toward = _toward(elevation, azimuth)
        self.solids: list[Solid] = []
        self.faces: list[tuple[Floats, str, float, str]] = []
        self.lines: list[tuple[Floats, dict[str, Any]]] = []
        self.points: list[tuple[Floats, dict[str, Any]]] = []
        self.written: list[_Words] = []
        self.own = ax is None
        _frame(self.ax, low, high, (elevation, azimuth), unit, zoom)

    def solid(self, vertices: Floats, faces: list[list[int]], colour: str, name: str) -> None:
        """Add a convex solid; a segment or a point is drawn as such."""
        if faces:
            self.solids.append(Solid(vertices, faces, colour, name))
        elif len(vertices) > 1:
            self.line(vertices, color=colour, linewidth=2, gid=name)
        else:
            self.point(vertices[0], color=colour, marker="o", markersize=4, gid=name)

    def sheet(self, polygons: list[Floats], colour: str, alpha: float, name: str) -> None:
        """Add translucent faces."""
        self.faces += [(polygon, colour, alpha, name) for polygon in polygons]

    def line(self, points: Floats, **style: Any) -> None:
        """Add a line along points (n, 3); solids hide it, except those that it may shine through (see `_hiding`)."""
        self.lines.append((np.asarray(points, dtype=np.float64), style))

    def point(self, place: Floats, **style: Any) -> None:
        """Add a marker, hidden like a line."""
        self.points.append((np.asarray(place, dtype=np.float64), style))

    def words(self, place: Floats, text: str, offset: tuple[float, float] = (4, 4), **style: Any) -> None:
        """Write text at a position, shifted on the paper by about a number of points: where it covers least."""
        self.written.append(_Words(place, text, offset, style))

    def arrow(self, start: Floats, end: Floats, colour: str, name: str) -> None:
        """Add an arrow that nothing hides."""
        self.line(np.array([start, end]), color=colour, linewidth=1.2, gid=name, through=True)
        head = {"arrowstyle": "-|>,head_width=0.18,head_length=0.4", "color": colour, "shrinkA": 0, "shrinkB": 0}
        tail = self.on_paper(start + 0.9 * (end - start))
        self.ax.annotate("", self.on_paper(end), tail, zorder=_MARKS, arrowprops=head)

    def on_paper(self, place: Floats) -> tuple[float, float]:
        """Where a place in space is in the flat coordinates of the axes; they have no annotations in space."""
        x, y, _ = proj3d.proj_transform(*place, self.ax.get_proj())
        return float(x), float(y)

    def paint(self) -> Axes3D:
        """Draw everything."""
        solids = back_to_front(self.solids, self.toward)
        for layer, solid in enumerate(solids):
            self._paint_solid(solid, _SOLIDS + 2 * layer + 1)
        self._paint_faces(solids)
        for points, style in self.lines:
            self._paint_line(solids, points, style)
        for place, style in self.points:
            covered = any(hidden(solid, place, place, self.toward) for solid in _hiding(solids, style))
            xyz = [[x] for x in place]
            self.ax.plot(*xyz, linestyle="none", zorder=_UNDER if covered else _MARKS, **style)
        self._write()
        return self.ax

    def lower(self, height: float) -> None:
        """Make a figure higher by what a legend of this height, pixels, needs below the axes."""
        figure, box = self.ax.figure, self.ax.get_position()
        missing = height / figure.dpi + _MARGIN - box.y0 * figure.get_figheight()
        if missing > 0:
            old = figure.get_figheight()
            new = old + missing
            figure.set_figheight(new)
            self.ax.set_position((box.x0, (box.y0 * old + missing) / new, box.width, box.height * old / new))

    def _write(self) -> None:
        """Write the words one after the other, each where it covers no other words, and few of the lines that count.

        Names of bodies without such a place are left out.
        """
        if not self.written:
            return
        laid_out(self.ax)
        box = self.ax.bbox
        ends = [np.linspace(a, b, 25) for points, style in self.lines if "label" in style for a, b in pairwise(points)]
        places = np.vstack([*ends, np.empty((0, 3)), *(place[None] for place, _ in self.points)])
        marks = self.ax.transData.transform([self.on_paper(place) for place in places]).reshape(-1, 2)
        axes = (self.ax.xaxis, self.ax.yaxis, self.ax.zaxis)
        taken = [axis.label.get_window_extent() for axis in axes]
        taken += [number.get_window_extent() for axis in axes for number in axis.get_ticklabels() if number.get_text()]
        for place, text, offset, style in sorted(self.written, key=lambda words: words.offset == (0, 0)):
            found: list[tuple[float, int, tuple[float, float]]] = []
            label = self._label(place, text, offset, style)
            for k, shifted in enumerate(_shifts(offset)):
                _align(label, shifted, style)
                area = label.get_window_extent()
                over = sum(area.overlaps(other) for other in taken) + (not _within(area, box))
                covered = int(np.all((marks >= area.min) & (marks <= area.max), axis=1).sum())
                found.append((_COVERED * over + covered + 0.3 * k, k, shifted))
                if found[-1][0] < 1:
                    break
            cost, _, best = min(found)
            if offset == (0, 0) and cost >= _COVERED:
                label.remove()
                continue
            if offset == (0, 0) and abs(best[1]) > _FAR:
                label.remove()
                label = self._label(place, text, best, {**style, "arrowprops": _LEADER})
            _align(label, best, style)
            label.get_window_extent()  # moves the text to its place
            taken.append(Text.get_window_extent(label))  # without the line

    def _label(self, place: Floats, text: str, offset: tuple[float, float], style: dict[str, Any]) -> Annotation:
        look: dict[str, Any] = {"fontsize": 7, "va": "center", **style}
        label: Annotation = self.ax.annotate(
            text, self.on_paper(place), offset, textcoords="offset points", zorder=_WORDS, **look
        )
        label.set_path_effects([effects.withStroke(linewidth=2, foreground="white")])
        return label

    def _paint_solid(self, solid: Solid, layer: float) -> None:
        front = [k for k, n in enumerate(solid.normals) if n @ self.toward > 0]
        shades = [_shaded(solid.colour, solid.normals[k]) for k in front]
        faces = [solid.vertices[solid.faces[k]] for k in front]
        edge = _shaded(solid.colour, -_LIGHT_FROM / 2)
        self.ax.add_collection3d(
            Poly3DCollection(
                faces, facecolors=shades, edgecolors=[edge], linewidths=0.4, zorder=layer, gid=solid.name
            ),
            autolim=False,
        )

    def _paint_faces(self, solids: list[Solid]) -> None:
        """Paint each face above the last solid behind it, so that a shadow's back is behind its obstacle, its front before.

        Faces on the surface of a solid, where a shadow begins, are the solid's own.
        """
        layers: dict[tuple[int, str, float, str], list[Floats]] = defaultdict(list)
        for polygon, colour, alpha, name in self.faces:
            if any(solid.has_on_surface(polygon) for solid in solids):
                continue
            across = normal(polygon)
            across = across if across @ self.toward >= 0 else -across
            behind = [
                k + 1
                for k, solid in enumerate(solids)
                if overlap(solid.vertices, polygon, self.toward)
                and float((solid.vertices.mean(axis=0) - polygon[0]) @ across) < 0
            ]
            layers[max(behind, default=0), colour, alpha, name].append(polygon)
        for (layer, colour, alpha, name), polygons in layers.items():
            self.ax.add_collection3d(
                Poly3DCollection(
                    polygons,
                    facecolors=[(*to_rgb(colour), alpha)],
                    edgecolors=[(*to_rgb(colour), min(1.0, 3 * alpha))],
                    linewidths=0.5,
                    zorder=_SOLIDS + 2 * layer,
                    gid=name,
                ),
                autolim=False,
            )

    def _paint_line(self, solids: list[Solid], points: Floats, style: dict[str, Any]) -> None:
        """Paint what shows of a line, as one line with gaps."""
        blocking = _hiding(solids, style)
        pieces: list[Floats] = []
        for start, end in zip(points[:-1], points[1:], strict=True):
            for part in visible(blocking, start, end, self.toward):
                joined = bool(pieces) and np.array_equal(pieces[-1][-1], part[0])
                pieces += [part[1:]] if joined else [np.full((1, 3), np.nan), part]
        shown = np.vstack(pieces)[1:] if pieces else np.empty((0, 3))
        self.ax.plot(*shown.T, zorder=_OVER, solid_capstyle="round", **style)


def _hiding(solids: list[Solid], style: dict[str, Any]) -> list[Solid]:
    """Return the solids that hide a line or marker: all but those with the name ``through``, or none if that is true."""
    through = style.pop("through", False)
    return [] if through is True else [solid for solid in solids if solid.name != through]


def _shifts(offset: tuple[float, float]) -> list[tuple[float, float]]:
    """Return offsets to try, in points: the given one, then the others around the same place."""
    x, y = offset
    if (x, y) == (0, 0):
        rings = [(0.0, step) for step in (0, 9, -9, 18, -18, 27, -27)]
        return rings + [(side * 8.0, step) for step in (0.0, 9.0, -9.0, 18.0, -18.0, 27.0, -27.0) for side in (1, -1)]
    near = [(x, y), (x, -y), (-x, y), (-x, -y)]
    return near + [(side * abs(x), step) for step in (12.0, -12.0, 20.0, -20.0, 28.0, -28.0) for side in (1, -1)]


def _align(label: Annotation, offset: tuple[float, float], style: dict[str, Any]) -> None:
    label.set_position(offset)
    label.set_horizontalalignment(style.get("ha", "center" if not offset[0] else "left" if offset[0] > 0 else "right"))


def _within(area: Bbox, box: BboxBase) -> bool:
    """Tell whether a text is above the axes of a drawing and not beside them."""
    return bool(area.x0 >= box.x0 and area.x1 <= box.x1)


def new_axes(width: float = COLUMN, height: float = COLUMN) -> Axes3D:
    """Axes3D on a figure of its own."""
    figure = pyplot.figure(figsize=(width, height), FigureClass=Printed)
    return figure.add_subplot(projection="3d")


def _toward(elevation: float, azimuth: float) -> Floats:
    """Return the direction from the scene to the eye."""
    up, around = np.radians([elevation, azimuth])
    return np.array([np.cos(up) * np.cos(around), np.cos(up) * np.sin(around), np.sin(up)])


def _frame(ax: Axes3D, low: Floats, high: Floats, view: View, unit: str, zoom: float) -> None:
    """Box, scales and labels; a flat box is given a thickness."""
    least = _FLAT * float(np.max(high - low)) or 1.0
    pad = np.maximum(0.0, least - (high - low)) / 2
    low, high = low - pad, high + pad
    ax.computed_zorder = False
    ax.set_proj_type("ortho")
    ax.view_init(*view)
    ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
    ax.set_box_aspect(high - low, zoom=zoom)
    for name, axis in (("x", ax.xaxis), ("y", ax.yaxis), ("z", ax.zaxis)):
        axis.set_pane_color((1, 1, 1, 0))
        axis.line.set_color(LIGHT)
        axis.pane.set_edgecolor(LIGHT)
        axis.set_major_locator(MaxNLocator(3, steps=[1, 2, 5, 10], prune="lower" if name == "y" else None))
        axis.set_tick_params(pad=-1 if name == "z" else -3)
        getattr(ax, f"set_{name}label")(f"{name} ({unit})", labelpad=-7)
    ax.grid(False)


def _shaded(colour: str, towards: Floats) -> tuple[float, float, float]:
    light = float(np.clip(towards @ _LIGHT_FROM, -1, 1))
    share = _AMBIENT + (1 - _AMBIENT) * light
    red, green, blue = (share * part for part in to_rgb(colour))
    return red, green, blue
