"""Maps of wrench margins over the positions of a scene."""

from __future__ import annotations

import os
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arrays import Floats, number, thread_count
from ._given import file_name, flag, instance
from ._pandas import frame
from ._scene import Scene


class WrenchMap:
    """Margins on a grid of positions; made by `wrench_map` or `WrenchMap.load`.

    Attributes
    ----------
    margin : ndarray (nx, ny, nz)
        Capacity margins, N; NaN where a cable has no length.
    force_margin, moment_margin : ndarray (nx, ny, nz) or None
        N and N·m; None unless requested.
    origin : ndarray (3,)
        Position of the first node, world, m.
    step : float
        Distance between neighbouring nodes, m.
    feasible : ndarray (nx, ny, nz) of bool
        Where the margin is positive.
    share, volume : float
        Share of feasible nodes; their number times the volume of a cell, m³.
    extent : ndarray (2, 3) or None
        Smallest and largest coordinates of feasible nodes, m.
    positions : ndarray (nx, ny, nz, 3)
        Of the nodes, m.

    Examples
    --------
    >>> found = wrench_map(Scene.example("cogiro"), step=1.0)
    >>> found
    WrenchMap(13 x 10 x 5 nodes of 1.0 m, 50.0 % feasible)
    >>> found.positions[found.feasible].shape[1]
    3
    """

    def __init__(self, core: _core.WrenchMap) -> None:
        """See `wrench_map`."""
        self._core = core
        self.margin: Floats = core.capacity()
        self.force_margin: Floats | None = core.force()
        self.moment_margin: Floats | None = core.moment()
        origin, self.step, self.share, self.volume, extent = core.summary()
        self.origin: Floats = np.array(origin)
        self.extent: Floats | None = None if extent is None else np.array(extent)

    @property
    def feasible(self) -> NDArray[np.bool_]:
        """Where the margin is positive."""
        return self.margin > 0.0

    @property
    def positions(self) -> Floats:
        """Position of each node, (nx, ny, nz, 3), m."""
        axes = [self.origin[k] + self.step * np.arange(n) for k, n in enumerate(self.margin.shape)]
        return np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write a file: .npz, which NumPy can also read, or .vti for ParaView.

        Parameters
        ----------
        path : path
            The extension selects the format.

        Raises
        ------
        FileError
            Another extension, or a file that cannot be written.
        """
        self._core.save(file_name(path))

    @classmethod
    def load(
        cls,
        path: str | os.PathLike[str],
        scene: Scene | None = None,
        *,
        force: float | None = None,
        moment: float | None = None,
    ) -> WrenchMap:
        """Load a .npz file.

        Parameters
        ----------
        path : path
            A file written by `save`.
        scene : Scene, optional
            If given, a map with another robot, load or requirement is an error.
        force, moment : float, optional
            Radii of the required balls instead of the scene's, N and N·m.

        Returns
        -------
        WrenchMap

        Raises
        ------
        FileError
            A file that cannot be read.
        InputError
            A file that is not a map, or a map that does not match the scene.
        """
        core = None if scene is None else instance("scene", scene, Scene)._core
        return cls(_core.WrenchMap.load(file_name(path), core, _radius("force", force), _radius("moment", moment)))

    def to_pandas(self) -> Any:
        """Return the nodes as a table; requires pandas.

        Returns
        -------
        DataFrame
            ``x``, ``y``, ``z`` (m), ``margin`` (N); if computed, ``force_margin`` (N), ``moment_margin`` (N·m).
        """
        columns = {axis: self.positions[..., k].ravel() for k, axis in enumerate("xyz")}
        for name in ("margin", "force_margin", "moment_margin"):
            if (margins := getattr(self, name)) is not None:
                columns[name] = margins.ravel()
        return frame(columns)

    def __eq__(self, other: object) -> bool:
        """Compare by value: margins, grid, and what the margins depend on."""
        return isinstance(other, WrenchMap) and self._core.to_bytes() == other._core.to_bytes()

    __hash__ = None  # type: ignore[assignment]

    @classmethod
    def _from_bytes(cls, npz: bytes) -> WrenchMap:
        return cls(_core.WrenchMap.from_bytes(npz))

    def __reduce__(self) -> tuple[Any, tuple[bytes]]:
        """Pickle by value."""
        return WrenchMap._from_bytes, (self._core.to_bytes(),)

    def __repr__(self) -> str:
        """Show size and share."""
        shape = " x ".join(map(str, self.margin.shape))
        return f"WrenchMap({shape} nodes of {self.step} m, {100 * self.share:.1f} % feasible)"


def wrench_map(
    scene: Scene,
    *,
    step: float = 0.05,
    force: float | None = None,
    moment: float | None = None,
    projected: bool = False,
    threads: int | None = None,
) -> WrenchMap:
    """Compute capacity margins on a grid over all positions at which the platform is inside the workspace.

    Parameters
    ----------
    scene : Scene
        Its robot, gravity, orientation, and the loads and requirements of its ``[wrench]`` are used.
    step : float
        Distance between neighbouring nodes, m. A map takes 8 bytes per node and margin.
    force, moment : float, optional
        Radii of the required balls instead of the scene's, N and N·m.
    projected : bool
        Also compute force and moment margins, which takes some twenty times longer.
    threads : int, optional
        Default all cores; the margins do not depend on it.

    Returns
    -------
    WrenchMap

    Raises
    ------
    InputError
        A robot without mass or tension limits, a step that is not positive, more nodes than fit into memory.
    KeyboardInterrupt
        On Ctrl-C, immediately.

    Examples
    --------
    >>> scene = Scene.example("cogiro")
    >>> wrench_map(scene, step=1.0).margin.ndim
    3
    """
    core = instance("scene", scene, Scene)._core
    radii = _radius("force", force), _radius("moment", moment)
    asked = number("step", step), *radii, flag("projected", projected), thread_count(threads)
    return WrenchMap(_core.WrenchMap.of(core, *asked))


def _radius(name: str, radius: float | None) -> float | None:
    return None if radius is None else number(name, radius)
