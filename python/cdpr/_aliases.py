"""Functions that are other names of methods of `Scene`."""

from __future__ import annotations

import os
from typing import Any

from ._given import instance
from ._scene import Scene
from ._shadows import Mesh


def example(name: str) -> Scene:
    """Call :meth:`Scene.example`.

    Parameters
    ----------
    name : str
        Name of the scene.

    Returns
    -------
    Scene

    Examples
    --------
    >>> import cdpr
    >>> cdpr.example("closed")
    Scene('closed', 8 cables, 2 obstacles)
    """
    return Scene.example(name)


def shadows(scene: Scene, **options: Any) -> dict[str, Mesh]:
    """Call :meth:`Scene.shadows` of a scene with the given options."""
    return instance("scene", scene, Scene).shadows(**options)


def save_shadows(path: str | os.PathLike[str], scene: Scene, **options: Any) -> None:
    """Call :meth:`Scene.save_shadows` of a scene with the given path and options."""
    instance("scene", scene, Scene).save_shadows(path, **options)
