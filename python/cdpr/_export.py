"""Models for simulators."""

from __future__ import annotations

import os
import warnings
from typing import Literal, TypeAlias

from . import _core
from ._given import file_name, flag, instance, one_of
from ._scene import Scene
from ._trajectory import Trajectory
from .exceptions import AnotherSceneWarning, CdprWarning, InputError

Control: TypeAlias = Literal["tension", "length"]


def save_mjcf(
    path: str | os.PathLike[str],
    scene: Scene,
    motion: Trajectory | None = None,
    *,
    control: Control = "tension",
    strict: bool = False,
) -> None:
    """Write a scene, and if given a timed motion, for the simulator MuJoCo.

    The platform is a free body with its mass, centre of mass and inertia. Obstacles are geoms, and each cable is a tendon with an
    actuator, all by name; a pulley is a wheel that swivels. In MuJoCo cables pass through bodies.

    Parameters
    ----------
    path : path
        Name of the model, with the extension .xml. A motion is written beside it, with the extension .npz.
    scene : Scene
        Its robot must have a mass.
    motion : Trajectory, optional
        A motion with tensions, at whose first pose the model begins; without it, the model begins at the start of the scene.
    control : {"tension", "length"}
        What the controls are: "tension", that of each cable, N; "length", for each cable 1 / (lead + commanded length), 1/m, where
        the lead is that of its drum, or 0. With "length" cables stretch by their stiffness, which all of them must have.
    strict : bool
        Refuse a motion that was made for another scene, instead of an `AnotherSceneWarning`.

    Raises
    ------
    FileError
        Another extension, or a file that cannot be written; nothing half-written is left.
    InputError
        No mass, a motion without tensions, a cable without stiffness for "length".

    Warns
    -----
    CdprWarning
        What the scene says and the model leaves out or assumes.

    Notes
    -----
    Arrays of the .npz file, by rows in time: ``t`` (s); ``positions`` (m) and ``quaternions`` (w x y z) of the platform; ``lengths``
    (m), ``speeds`` (m/s), ``tensions`` (N) and, if they are known, ``commands`` (m) of the cables; ``qpos``, ``qvel``, ``qacc`` and
    ``ctrl`` as MuJoCo orders them, with the platform before the wheels. ``tendon_leads`` (m) says by how much each tendon is longer
    than its cable, 0 without a pulley; ``cables`` are the names.

    Examples
    --------
    >>> import cdpr, tempfile, warnings
    >>> scene = cdpr.example("cogiro").replace(obstacles=None)
    >>> motion = cdpr.trajectory(scene, [scene.start, scene.goal], speed=1, acceleration=2)
    >>> with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
    ...     warnings.simplefilter("ignore")  # the inertia is assumed
    ...     cdpr.save_mjcf(f"{folder}/model.xml", scene, motion)
    """
    core = instance("scene", scene, Scene)._core
    chosen = one_of("control", control, Control)
    if motion is None and flag("strict", strict):
        raise InputError("strict: found without a motion, where it has no effect; expected a motion")
    timed = None if motion is None else instance("motion", motion, Trajectory)._motion
    notes, warning = _core.save_mjcf(file_name(path), core, timed, chosen, flag("strict", strict))
    if warning is not None:
        warnings.warn(warning, AnotherSceneWarning, stacklevel=2)
    if notes:
        warnings.warn("; ".join(notes), CdprWarning, stacklevel=2)
