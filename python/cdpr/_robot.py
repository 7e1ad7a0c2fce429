"""Robots."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Mapping, Sequence
from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import Floats, number, point, rows
from ._tables import TriangleMesh, body_table
from ._values import Immutable
from .exceptions import CdprWarning, InputError

Unit: TypeAlias = Literal["mm", "cm", "m", "in", "ft"]


class Robot(Immutable):
    """A cable robot: a platform of convex parts, hung on straight cables.

    Parameters
    ----------
    outlets : array_like (m, 3)
        Where the cables leave the frame, world, m.
    attachments : array_like (m, 3)
        Where they meet the platform, platform frame, m.
    platform : sequence of array_like (k, 3) or mesh
        Corners of each convex part, platform frame, m; a part may be flat, a segment or a point. A mesh is any object
        with ``vertices`` and ``faces``, as those of trimesh; see `Scene`.
    tensions : array_like (2,) or (m, 2), optional
        Least and largest tension, N, for all cables or each.
    mass : float, optional
        Mass of the platform, kg.
    center_of_mass : array_like (3,), optional
        Platform frame, m; default the origin.
    name : str, optional
        For messages and pictures.

    Raises
    ------
    InputError
        Wrong shapes, numbers that are not finite, an attachment inside a part, limits out of order.

    Examples
    --------
    >>> robot = Robot([[0, 0, 1], [1, 0, 1]], [[0, 0, 0], [0.1, 0, 0]], [[[0, 0, 0], [0.1, 0, 0]]])
    >>> robot
    Robot('robot', 2 cables)
    """

    def __init__(
        self,
        outlets: ArrayLike,
        attachments: ArrayLike,
        platform: Sequence[ArrayLike | TriangleMesh],
        *,
        tensions: ArrayLike | None = None,
        mass: float | None = None,
        center_of_mass: ArrayLike | None = None,
        name: str | None = None,
    ) -> None:
        """See the class."""
        ends = rows("outlets", outlets), rows("attachments", attachments)
        count = len(ends[0])
        if len(ends[1]) != count:
            raise InputError(f"attachments: found {len(ends[1])} rows, expected {count}, one for each outlet")
        cables: list[dict[str, Any]] = [
            {"outlet": outlet, "attachment": attachment}
            for outlet, attachment in zip(ends[0].tolist(), ends[1].tolist(), strict=True)
        ]
        if tensions is not None:
            for cable, limits in zip(cables, _limits(tensions, count), strict=True):
                cable["tension"] = limits
        parts = [body_table(f"platform[{k}]", part) for k, part in enumerate(platform)]
        spec: dict[str, Any] = {"platform": parts, "cables": cables}
        if mass is not None:
            spec["mass"] = number("mass", mass)
        if center_of_mass is not None:
            spec["center_of_mass"] = point("center_of_mass", center_of_mass)
        if name is not None:
            spec["name"] = name
        self._spec = _checked(spec)

    @classmethod
    def from_dict(cls, spec: Mapping[str, Any]) -> Robot:
        """Make a robot from the table of a robot file.

        Parameters
        ----------
        spec : mapping
            As :meth:`to_dict` returns it.

        Returns
        -------
        Robot

        Raises
        ------
        InputError
            Names the key, what was found and what is expected.
        """
        return cls._of_sound(_checked(_without_version(spec)))

    @classmethod
    def _of_sound(cls, spec: dict[str, Any]) -> Robot:
        """Make a robot of what has been checked already."""
        robot = cls.__new__(cls)
        robot._spec = spec
        return robot

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Robot:
        """Load a robot file.

        Parameters
        ----------
        path : path
            .toml or .json.

        Returns
        -------
        Robot

        Raises
        ------
        FileError
            It cannot be read, or its name has another extension.
        InputError
            Bad contents; the message names file, key, what was found and what is expected.

        Examples
        --------
        >>> Robot.load("testdata/robots/cogiro.toml")
        Robot('CoGiRo (LIRMM/Tecnalia), 8-cable suspended', 8 cables)
        """
        return cls._of_sound(_without_version(json.loads(_core.load_robot(os.fspath(path)))))

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write a robot file.

        Parameters
        ----------
        path : path
            .toml or .json.

        Raises
        ------
        FileError
            Another extension, or a file that cannot be written; nothing half-written is left.
        """
        _core.save_robot(os.fspath(path), json.dumps({"version": 1, **self._spec}))

    def to_dict(self) -> dict[str, Any]:
        """Return the table of a robot file.

        Returns
        -------
        dict
            A copy; :meth:`from_dict` takes it.
        """
        copy: dict[str, Any] = json.loads(json.dumps(self._spec))
        return copy

    @property
    def name(self) -> str:
        """Name, or "robot"."""
        return str(self._spec.get("name", "robot"))

    @property
    def cable_names(self) -> tuple[str, ...]:
        """Names of the cables, in order; "cable 0", "cable 1", ... where they have none of their own."""
        return tuple(cable.get("name") or f"cable {k}" for k, cable in enumerate(self._spec["cables"]))

    @property
    def outlets(self) -> Floats:
        """Outlets, (m, 3), world, m."""
        return np.array([cable["outlet"] for cable in self._spec["cables"]], dtype=np.float64)

    @property
    def attachments(self) -> Floats:
        """Attachments, (m, 3), platform frame, m."""
        return np.array([cable["attachment"] for cable in self._spec["cables"]], dtype=np.float64)

    @property
    def mass(self) -> float | None:
        """Mass of the platform, kg, if given."""
        return self._spec.get("mass")

    def __reduce__(self) -> tuple[Any, tuple[dict[str, Any]]]:
        """Pickle by value."""
        return Robot._of_sound, (self._spec,)

    def __repr__(self) -> str:
        """Say name and size."""
        return f"Robot({self.name!r}, {len(self._spec['cables'])} cables)"


def import_robot(
    path: str | os.PathLike[str],
    *,
    bodies: str | os.PathLike[str] | None = None,
    cable_set: str | None = None,
    platform: str | os.PathLike[str] | None = None,
    units: Unit = "m",
) -> Robot:
    """Import a robot of another program.

    Parameters
    ----------
    path : path
        CASPR: the cables file or the bodies file of a model, or their folder. Gazebo
        (https://github.com/oKermorgant/cdpr): its YAML file.
    bodies : path, optional
        CASPR's bodies file, where it does not stand beside the cables file under the same name.
    cable_set : str, optional
        CASPR's set of cables; default the one that the file names.
    platform : path, optional
        Mesh of the platform in its frame (.stl or .obj); default what the source says, or the hull of the attachments.
    units : {"mm", "cm", "m", "in", "ft"}
        Unit of that mesh.

    Returns
    -------
    Robot
        A `CdprWarning` lists what was not carried over.

    Raises
    ------
    InputError
        The file makes no sense; the message names the element and its line.

    Examples
    --------
    >>> import warnings
    >>> with warnings.catch_warnings():
    ...     warnings.simplefilter("ignore")
    ...     import_robot("testdata/caspr/CoGiRo")
    Robot('CoGiRo', 8 cables)
    """
    files = [None if given is None else os.fspath(given) for given in (bodies, platform)]
    text, notes = _core.import_robot(os.fspath(path), files[0], cable_set, files[1], units)
    if notes:
        warnings.warn("not carried over: " + "; ".join(notes), CdprWarning, stacklevel=2)
    return Robot.from_dict(json.loads(text))


def _without_version(spec: Mapping[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in spec.items() if key != "version"}


def _checked(spec: dict[str, Any]) -> dict[str, Any]:
    try:
        text = json.dumps(spec, allow_nan=False)
    except (TypeError, ValueError) as problem:
        raise InputError(f"robot: {problem}") from None
    checked: dict[str, Any] = json.loads(_core.check_robot(text))
    return checked


def _limits(tensions: ArrayLike, count: int) -> list[list[float]]:
    array = np.asarray(tensions, dtype=np.float64)
    if array.shape not in ((2,), (count, 2)):
        raise InputError(f"tensions: found an array of shape {array.shape}, expected (2,) or ({count}, 2)")
    limits: list[list[float]] = np.broadcast_to(array, (count, 2)).tolist()
    return limits
