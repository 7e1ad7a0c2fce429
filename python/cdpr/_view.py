"""The page that shows a scene and a path: in a notebook, in a browser, in a file."""

from __future__ import annotations

import html
import json
import os
import sys
import tempfile
import warnings
import webbrowser
from dataclasses import dataclass
from pathlib import Path as FilePath
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import in_order, rows
from ._given import file_name, flag, instance, text
from ._paths import core_for, turns_along, two_or_more
from ._questions import Interference
from ._results import Path, Result, turns_of
from ._scene import Scene
from ._trajectory import Trajectory
from ._workspace import Workspace
from .exceptions import AnotherSceneWarning, InputError

_INLINE_HEIGHT = 640


@dataclass(frozen=True, repr=False)
class View:
    """One self-contained HTML page; a notebook shows it inline.

    Attributes
    ----------
    html : str
        The page.

    Examples
    --------
    >>> import cdpr
    >>> page = cdpr.show(cdpr.example("hard1"))  # doctest: +SKIP
    >>> page.save("view.html")  # doctest: +SKIP
    """

    html: str

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the page to a file; it opens offline.

        Parameters
        ----------
        path : path

        Raises
        ------
        FileError
            A file that cannot be written; nothing half-written is left.
        """
        _core.save_text(file_name(path), self.html)

    def open(self) -> FilePath:
        """Open the page in a browser tab.

        Returns
        -------
        pathlib.Path
            The file of the page, in the folder for temporary files.
        """
        handle, name = tempfile.mkstemp(prefix="cdpr-", suffix=".html")
        os.close(handle)
        self.save(name)
        webbrowser.open_new_tab(FilePath(name).as_uri())
        return FilePath(name)

    def __repr__(self) -> str:
        """Say the size."""
        return f"View({len(self.html) // 1000} kB)"

    def _repr_html_(self) -> str:
        # A separate frame, so that the page and the notebook cannot affect each other.
        return (
            f'<iframe srcdoc="{html.escape(self.html)}" sandbox="allow-scripts allow-downloads" title="cdpr" '
            f'style="width: 100%; height: {_INLINE_HEIGHT}px; border: 0"></iframe>'
        )


def view(
    scene: Scene,
    waypoints: ArrayLike | Path | Trajectory | Workspace | None = None,
    orientations: ArrayLike | None = None,
    interference: Interference = "exact",
    strict: bool = False,
    live: bool = True,
) -> View:
    own = instance("scene", scene, Scene)._core
    if orientations is not None and (waypoints is None or isinstance(waypoints, Trajectory | Workspace)):
        what = "no path" if waypoints is None else f"a {type(waypoints).__name__}, which has its own"
        raise InputError(f"orientations: found some for {what}, expected none")
    if isinstance(waypoints, Trajectory):
        page, warning = waypoints._motion.page(own, text("interference", interference), flag("strict", strict))
        if warning is not None:
            warnings.warn(warning, AnotherSceneWarning, stacklevel=3)
        return View(page)
    without = waypoints is None or isinstance(waypoints, Workspace)
    if without and (flag("strict", strict) or text("interference", interference) != "exact"):
        option = "strict" if strict else "interference"
        raise InputError(f"{option}: found without a path, where it has no effect; expected a path or a trajectory")
    if isinstance(waypoints, Workspace):
        flag("live", live)
        return View(waypoints._core.page(own))
    file = None if waypoints is None else json.dumps(_file(waypoints, orientations))
    tree, certificate = None, None
    if isinstance(waypoints, Result):
        tree = (in_order(waypoints.tree.states), in_order(waypoints.tree.parents))
        certificate = None if waypoints.proof is None else waypoints.proof._certificate
    core = own if waypoints is None else core_for(scene, waypoints, strict=strict, level=4)
    return View(core.page(file, tree, certificate, text("interference", interference), flag("live", live)))


def _file(waypoints: ArrayLike | Path, orientations: ArrayLike | None) -> dict[str, Any]:
    """Return the contents of a path file for these waypoints."""
    turns = turns_along(waypoints, orientations)
    if orientations is None or turns is None:
        return waypoints._said() if isinstance(waypoints, Path) else {"waypoints": rows("waypoints", waypoints).tolist()}
    positions = two_or_more("waypoints", waypoints)
    return {"waypoints": positions.tolist(), "orientations": turns_of(positions, turns).tolist()}


def save_view(
    path: str | os.PathLike[str],
    scene: Scene,
    waypoints: ArrayLike | Path | Trajectory | Workspace | None = None,
    *,
    orientations: ArrayLike | None = None,
    interference: Interference = "exact",
    strict: bool = False,
    live: bool = True,
) -> None:
    """Write one self-contained HTML page that shows a scene and, if given, a path, motion or workspace; it opens offline.

    Parameters
    ----------
    path : path
        Name of the page's file.
    scene : Scene
    waypoints : array_like (k, 3), Path, Result, Trajectory or Workspace, optional
        Positions of the platform's origin, world, m. A ``Result`` is shown with its raw path and search tree,
        or, if it has a proof that there is no path, with the reason. A ``Trajectory`` is played in real time, with
        its curves over time and their limits. A ``Workspace`` is drawn as the surface of what is proved inside.
    orientations : array_like (k, 4) or (4,), optional
        World-from-platform unit quaternions w x y z, one for each waypoint, or a single one for all; default those of the path
        or, if it has none, the scene's orientation.
    interference : {"exact", "swept"}
        How the path is checked for what the page shows in red.
    strict : bool
        Refuse a path that was planned for another scene, instead of an `AnotherSceneWarning`.
    live : bool
        Let the reader edit the scene and plan in the page, offline; False makes a page that only shows it, 1 MB smaller.
        Pages of a ``Trajectory`` or a ``Workspace`` only show it.

    Raises
    ------
    FileError
        A file that cannot be written; nothing half-written is left.

    Examples
    --------
    >>> import cdpr, tempfile
    >>> scene = cdpr.example("hard1")
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     cdpr.save_view(f"{folder}/view.html", scene, cdpr.plan(scene))
    """
    _core.check_target(file_name(path))
    view(scene, waypoints, orientations, interference, strict, live).save(path)


def show(
    scene: Scene,
    waypoints: ArrayLike | Path | Trajectory | Workspace | None = None,
    *,
    orientations: ArrayLike | None = None,
    interference: Interference = "exact",
    strict: bool = False,
    live: bool = True,
) -> View:
    """Show a scene and, if given, a path, a timed motion or a proved workspace.

    The page appears inline as the last line of a notebook's cell, otherwise in a browser tab.

    Parameters
    ----------
    scene : Scene
    waypoints : array_like (k, 3), Path, Result, Trajectory or Workspace, optional
        Positions of the platform's origin, world, m. A ``Result`` is shown with its raw path and search tree,
        or, if it has a proof that there is no path, with the reason. A ``Trajectory`` is played in real time, with
        its curves over time and their limits. A ``Workspace`` is drawn as the surface of what is proved inside.
    orientations : array_like (k, 4) or (4,), optional
        World-from-platform unit quaternions w x y z, one for each waypoint, or a single one for all; default those of the path
        or, if it has none, the scene's orientation.
    interference : {"exact", "swept"}
        How the path is checked for what the page shows in red.
    strict : bool
        Refuse a path that was planned for another scene, instead of an `AnotherSceneWarning`.
    live : bool
        Let the reader edit the scene and plan in the page, offline; False makes a page that only shows it, 1 MB smaller.
        Pages of a ``Trajectory`` or a ``Workspace`` only show it.

    Returns
    -------
    View
        ``show(...).save("view.html")`` keeps the page.

    Examples
    --------
    >>> import cdpr
    >>> scene = cdpr.example("hard1")
    >>> page = cdpr.show(scene, cdpr.plan(scene))  # doctest: +SKIP
    """
    shown = view(scene, waypoints, orientations, interference, strict, live)
    if not _in_notebook():
        shown.open()
    return shown


def _in_notebook() -> bool:
    """Tell whether a Jupyter kernel runs this: a terminal's IPython cannot show pages."""
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython else None
    return shell is not None and "IPKernelApp" in shell.config
