"""Shadows of obstacles and the other forbidden regions, as triangle meshes. The functions are methods of `Scene`."""

from __future__ import annotations

import json
import os
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

from ._arrays import Floats
from ._given import file_name, flag, text, texts
from ._values import ByValue

if TYPE_CHECKING:
    from ._scene import Scene

Space: TypeAlias = Literal["attachment", "position"]


@dataclass(frozen=True, eq=False, repr=False)
class Mesh(ByValue):
    """A forbidden region as a closed surface of triangles, oriented outward.

    Attributes
    ----------
    name : str
        The names of the bodies, as in "cable 3 / pillar".
    kind : str
        The condition that is violated in the region: "cable-obstacle" for shadows, "platform-obstacle",
        "cable-platform" or "cable-cable".
    culprits : tuple of str
        Names of the bodies that collide in the region.
    vertices : ndarray (n, 3) of float64
        Corners, world, m.
    triangles : ndarray (m, 3) of int64
        Corners of each triangle, counter-clockwise seen from outside, as indices into ``vertices``.
    volume : float
        m³. Each convex part of a concave body is a separate closed piece, and overlapping pieces all count. 0 for two
        cables, whose region is flat and has two sides.

    Examples
    --------
    >>> import cdpr
    >>> cdpr.example("hard1").shadows()["cable 0 / pillar"]
    Mesh('cable 0 / pillar', cable-obstacle, 26 triangles, 1.53 m³)
    """

    name: str
    kind: str
    culprits: tuple[str, ...]
    vertices: Floats
    triangles: NDArray[np.int64]
    volume: float

    def __repr__(self) -> str:
        """Show name, kind and size."""
        return f"Mesh({self.name!r}, {self.kind}, {len(self.triangles)} triangles, {self.volume:.4g} m³)"


def shadows(
    self: Scene,
    *,
    space: Space | None = None,
    all_regions: bool = False,
    cables: str | Sequence[str] | None = None,
    obstacles: str | Sequence[str] | None = None,
) -> dict[str, Mesh]:
    """Compute the shadow of each obstacle seen from each outlet: where the end of that cable cannot be.

    Parameters
    ----------
    space : {"attachment", "position"}, optional
        "attachment": where the end of the cable cannot be; the shadow begins at the obstacle and is clipped to the
        workspace. "position": where the platform's origin cannot be, clipped to the positions at which the platform is
        inside the workspace. Default "attachment", or "position" with ``all_regions``.
    all_regions : bool
        Also compute the regions of platform and obstacles, of cables and platform, and of pairs of cables, which exist
        only in the space of positions.
    cables, obstacles : str or sequence of str, optional
        Compute only the regions of these, by name.

    Returns
    -------
    dict of str to Mesh
        Meshes by name, in the order of the scene. Pairs that the scene ignores and regions outside the box are left
        out.

    Raises
    ------
    InputError
        A name that is not in the scene, or all regions in the space of attachments.

    Notes
    -----
    The region of the paper's Figure 3. The meshes do not include clearances, cable diameters and length limits, which
    would round their edges.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.example("hard1")
    >>> found = scene.shadows()
    >>> list(found)[:2]
    ['cable 0 / pillar', 'cable 1 / pillar']
    >>> mesh = found["cable 0 / pillar"]
    >>> mesh.vertices.shape[1], mesh.triangles.shape[1], mesh.volume > 0
    (3, 3, True)
    """
    found = self._core.regions(*_asked(space, all_regions, cables, obstacles))
    meshes = [_mesh(json.loads(summary), vertices, triangles) for summary, vertices, triangles in found]
    return {mesh.name: mesh for mesh in meshes}


def _mesh(summary: dict[str, Any], vertices: Floats, triangles: NDArray[np.int64]) -> Mesh:
    return Mesh(
        name=summary["name"],
        kind=summary["kind"],
        culprits=tuple(summary["culprits"]),
        vertices=vertices,
        triangles=triangles,
        volume=summary["volume"],
    )


def _asked(
    space: str | None, all_regions: bool, cables: str | Sequence[str] | None, obstacles: str | Sequence[str] | None
) -> tuple[str | None, bool, list[str], list[str]]:
    chosen = None if space is None else text("space", space)
    return chosen, flag("all_regions", all_regions), _names("cables", cables), _names("obstacles", obstacles)


def _names(key: str, names: str | Sequence[str] | None) -> list[str]:
    if names is None:
        return []
    return [text(key, names)] if isinstance(names, str) else texts(key, names)


def save_shadows(
    self: Scene,
    path: str | os.PathLike[str],
    *,
    space: Space | None = None,
    all_regions: bool = False,
    cables: str | Sequence[str] | None = None,
    obstacles: str | Sequence[str] | None = None,
) -> None:
    """Write shadows of obstacles, or all forbidden regions, to a file of meshes.

    Parameters
    ----------
    path : path
        The extension selects the format: .obj has one object per region; .ply numbers the faces by region; .stl has no names
        and is in single precision (about seven digits); .html is a page that shows the regions in the scene, and opens
        offline. Regions share no vertices; a reader that merges equal vertices joins regions that touch.
    space : {"attachment", "position"}, optional
        Write the regions where the end of the cable cannot be, or those where the platform's origin cannot be. Default
        "attachment", or "position" with ``all_regions``.
    all_regions : bool
        Also write the regions of platform and obstacles, of cables and platform, and of pairs of cables.
    cables, obstacles : str or sequence of str, optional
        Write only the regions of these, by name.

    Raises
    ------
    FileError
        Another extension, or a file that cannot be written; nothing half-written is left.
    InputError
        A name that is not in the scene, or all regions in the space of attachments.

    Examples
    --------
    >>> import cdpr, tempfile
    >>> scene = cdpr.example("hard1")
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     scene.save_shadows(f"{folder}/shadows.obj", cables="cable 1")
    ...     open(f"{folder}/shadows.obj").read().count("\\no ")
    1
    """
    self._core.save_regions(file_name(path), *_asked(space, all_regions, cables, obstacles))
