"""Robots."""

from __future__ import annotations

import json
import os
import warnings
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._arrays import Floats, as_numbers, finite, flat_points, numbers, of_each, one_for_each, point, rows, shaped
from ._distribution import Distribution
from ._given import file_name, one_of, plain, table, text, texts
from ._tables import KEPT, Bodies, Kept, bodies, put
from ._values import Immutable
from .exceptions import CdprWarning, InputError

Tables: TypeAlias = Mapping[str, Any] | Sequence[Mapping[str, Any] | None]
Unit: TypeAlias = Literal["mm", "cm", "m", "in", "ft"]


class Robot(Immutable):
    """A cable robot: a platform of convex parts that hangs on cables.

    Parameters
    ----------
    outlets : array_like (m, 3)
        Where the cables leave the frame, world, m.
    attachments : array_like (m, 3)
        Where the cables are attached to the platform, platform frame, m.
    platform : array_like (k, 3), mesh, mapping, or sequence of them
        Corners of each convex part, platform frame, m; a part may be flat, a segment or a point. A mesh is any object
        with ``vertices`` and ``faces``, such as those of trimesh; a mapping is a table of a robot file; see `Scene`.
    tensions : array_like (2,) or (m, 2), optional
        Minimum and maximum tension, N, of all cables or of each.
    mass : float, optional
        Mass of the platform, kg.
    center_of_mass : array_like (3,), optional
        Centre of mass, platform frame, m; default the origin.
    inertia : array_like (3,) or (3, 3), optional
        Inertia about the centre of mass, platform axes, kg·m²: Ixx, Iyy and Izz, or the symmetric tensor; default that of the
        parts at uniform density. It matters for timed motions on which the platform turns.
    cable_names : sequence of str (m,), optional
        Names used in messages and tables; default "cable 0", "cable 1" and so on.
    diameters : array_like () or (m,), optional
        Diameters of all cables or of each, m; default 0.
    lengths : array_like (2,) or (m, 2), optional
        Minimum and maximum length between outlet and attachment, m, of all cables or of each.
    linear_densities : array_like () or (m,), optional
        Mass per length, kg/m; the cables then sag. Default 0.
    sag_tensions : array_like () or (m,), optional
        Tension at the platform that the controller keeps at least, N, which limits the sag; default the minimum tension.
    outlet_errors : array_like () or (m,), optional
        The true outlet is at most this far from the given one, m; default 0.
    pulleys : mapping, or sequence of mappings and None (m,), optional
        Last pulley of all cables or of each: ``radius``, m, and ``axis``, the direction in which the cable arrives at the outlet,
        world; the wheel swivels about it. By default, outlets are fixed points.
    stiffnesses : array_like () or (m,), optional
        Axial stiffness E A, N; by default cables do not stretch.
    drums : mapping, or sequence of mappings and None (m,), optional
        Drum of the winch of all cables or of each: ``radius``, m; ``gear``, turns of the motor for one turn of the drum, negative if
        positive angles of the motor wind the cable in, default 1; ``zero``, the length of the cable at which the motor's angle is 0,
        m, default 0; ``lead``, the length of the cable between drum and outlet, m, default 0.
    cable : mapping, optional
        Values for cables that do not have their own: ``linear_density``, ``sag_tension``, ``outlet_error``, ``pulley``,
        ``stiffness``, ``drum``, as in the table ``[robot.cable]`` of a file.
    tension_distribution : str, optional
        Which of all tensions that balance the loads the controller keeps; default "middle", see `tension_distribution`.
    name : str, optional
        Name used in messages and figures.

    Raises
    ------
    InputError
        Wrong shapes, numbers that are not finite, an attachment inside a part, limits out of order, duplicate names.

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
        platform: Bodies,
        *,
        tensions: ArrayLike | None = None,
        mass: float | None = None,
        center_of_mass: ArrayLike | None = None,
        inertia: ArrayLike | None = None,
        cable_names: Sequence[str] | None = None,
        diameters: ArrayLike | None = None,
        lengths: ArrayLike | None = None,
        linear_densities: ArrayLike | None = None,
        sag_tensions: ArrayLike | None = None,
        outlet_errors: ArrayLike | None = None,
        pulleys: Tables | None = None,
        stiffnesses: ArrayLike | None = None,
        drums: Tables | None = None,
        cable: Mapping[str, Any] | None = None,
        tension_distribution: Distribution | None = None,
        name: str | None = None,
    ) -> None:
        """See the class."""
        ends = rows("outlets", outlets), rows("attachments", attachments)
        count = len(ends[0])
        if len(ends[1]) != count:
            raise InputError(f"attachments: found {len(ends[1])} rows, expected {count}, one for each outlet")
        cables: list[dict[str, Any]] = [{} for _ in range(count)]
        of_cables: dict[str, Any] = {"outlets": ends[0], "attachments": ends[1], "tensions": tensions, "cable_names": cable_names}
        of_cables |= {"diameters": diameters, "lengths": lengths, "linear_densities": linear_densities}
        of_cables |= {"sag_tensions": sag_tensions, "outlet_errors": outlet_errors, "stiffnesses": stiffnesses}
        _put_cables(cables, of_cables | {"pulleys": pulleys, "drums": drums})
        spec: dict[str, Any] = {"platform": bodies("platform", platform), "cables": cables}
        whole = {"mass": mass, "center_of_mass": center_of_mass, "inertia": inertia, "cable": cable, "name": name}
        whole["tension_distribution"] = tension_distribution
        for key, value in whole.items():
            put(spec, key, value, _OF_ROBOT[key])
        self._spec = _checked(spec)

    def replace(
        self,
        *,
        outlets: ArrayLike | Kept = KEPT,
        attachments: ArrayLike | Kept = KEPT,
        platform: Bodies | Kept = KEPT,
        tensions: ArrayLike | None | Kept = KEPT,
        mass: float | None | Kept = KEPT,
        center_of_mass: ArrayLike | None | Kept = KEPT,
        inertia: ArrayLike | None | Kept = KEPT,
        cable_names: Sequence[str] | None | Kept = KEPT,
        diameters: ArrayLike | None | Kept = KEPT,
        lengths: ArrayLike | None | Kept = KEPT,
        linear_densities: ArrayLike | None | Kept = KEPT,
        sag_tensions: ArrayLike | None | Kept = KEPT,
        outlet_errors: ArrayLike | None | Kept = KEPT,
        pulleys: Tables | None | Kept = KEPT,
        stiffnesses: ArrayLike | None | Kept = KEPT,
        drums: Tables | None | Kept = KEPT,
        cable: Mapping[str, Any] | None | Kept = KEPT,
        tension_distribution: Distribution | None | Kept = KEPT,
        name: str | None | Kept = KEPT,
    ) -> Robot:
        """Return a copy of the robot with the given changes.

        Parameters
        ----------
        outlets, attachments : array_like (m, 3), optional
            World and platform frame, m; the number of cables cannot change.
        platform : array_like, mesh, mapping, or sequence of them, optional
            All parts of the platform, platform frame, m.
        tensions, mass, center_of_mass, inertia, cable_names, diameters, lengths : optional
            Values of the arguments of `Robot` with these names; None removes them.
        linear_densities, sag_tensions, outlet_errors, pulleys, stiffnesses, drums, cable : optional
            Values of the arguments of `Robot` with these names; None removes them.
        tension_distribution, name : optional
            Values of the arguments of `Robot` with these names; None removes them.

        Returns
        -------
        Robot

        Raises
        ------
        InputError
            Values that `Robot` refuses; a different number of cables.

        Examples
        --------
        >>> import cdpr
        >>> robot = cdpr.example("empty").robot
        >>> robot.replace(mass=12.5, tensions=[5, 400]).mass, robot.mass
        (12.5, 10.0)
        """
        spec = self.to_dict()
        of_cables: dict[str, Any] = {"outlets": outlets, "attachments": attachments, "tensions": tensions}
        of_cables |= {"cable_names": cable_names}
        of_cables |= {"diameters": diameters, "lengths": lengths, "linear_densities": linear_densities}
        of_cables |= {"sag_tensions": sag_tensions, "outlet_errors": outlet_errors, "stiffnesses": stiffnesses}
        _put_cables(spec["cables"], of_cables | {"pulleys": pulleys, "drums": drums})
        whole = {"mass": mass, "center_of_mass": center_of_mass, "inertia": inertia, "cable": cable, "name": name}
        whole["tension_distribution"] = tension_distribution
        for key, value in whole.items():
            put(spec, key, value, _OF_ROBOT[key])
        if not isinstance(platform, Kept):
            spec["platform"] = bodies("platform", platform)
        return self._of_sound(_checked(spec))

    __replace__ = replace  # copy.replace of Python 3.13

    def cable_lengths(self, positions: ArrayLike, *, orientation: ArrayLike | None = None) -> Floats:
        """Compute the lengths of the cables, from outlet to attachment and round pulleys; requires no mass or tension limits.

        Parameters
        ----------
        positions : array_like (..., 3)
            Positions of the platform's origin, world, m; a path is (k, 3).
        orientation : array_like (4,), optional
            World-from-platform unit quaternion w x y z, such as that of a scene; default: no rotation.

        Returns
        -------
        ndarray (..., m)
            Metres, in the order of the cables; NaN where a cable cannot leave its pulley, or would wrap more than half a turn.

        Examples
        --------
        >>> robot = Robot([[0, 0, 3], [4, 0, 3]], [[0, 0, 0], [0, 0, 0]], [[[0, 0, 0]]], cable_names=["left", "right"])
        >>> robot.cable_lengths([2, 0, 3])
        array([2., 2.])
        >>> robot.cable_lengths([[2, 0, 3], [0, 0, 0]])
        array([[2., 2.],
               [3., 5.]])
        """
        flat, shape = flat_points("positions", positions)
        turn = None if orientation is None else numbers("orientation", orientation, 4, "w x y z")
        statics = _core.Statics(json.dumps(self._spec), turn, None, None, 1.0)
        return shaped(statics.cable_lengths(flat), shape)

    @classmethod
    def from_dict(cls, spec: Mapping[str, Any]) -> Robot:
        """Make a robot from the table of a robot file.

        Parameters
        ----------
        spec : mapping
            The table of a robot file, such as :meth:`to_dict` returns.

        Returns
        -------
        Robot

        Raises
        ------
        InputError
            Names the key, what was found and what is expected.
        """
        return cls._of_sound(_checked(_without_version(table("robot", spec))))

    @classmethod
    def _of_sound(cls, spec: dict[str, Any]) -> Robot:
        """Make a robot from values that have already been checked."""
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
        >>> import cdpr
        >>> cdpr.example("cogiro").robot.save("cogiro.toml")
        >>> Robot.load("cogiro.toml")
        Robot('CoGiRo (LIRMM/Tecnalia), 8-cable suspended', 8 cables)
        """
        return cls._of_sound(_without_version(json.loads(_core.load_robot(file_name(path)))))

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
        _core.save_robot(file_name(path), json.dumps({"version": 1, **self._spec}))

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
        """The name, or "robot"."""
        return str(self._spec.get("name", "robot"))

    @property
    def cable_names(self) -> tuple[str, ...]:
        """Names of the cables; cables without a name are "cable 0", "cable 1" and so on."""
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
    def tensions(self) -> Floats:
        """Minimum and maximum tension of each cable, (m, 2), N; NaN if not given."""
        return self._of_cables("tension", [np.nan, np.nan])

    @property
    def diameters(self) -> Floats:
        """Diameter of each cable, (m,), m."""
        return self._of_cables("diameter", 0.0)

    @property
    def lengths(self) -> Floats:
        """Minimum and maximum length of each cable, (m, 2), m; 0 and infinity if not given."""
        return self._of_cables("length", [0.0, np.inf])

    @property
    def linear_densities(self) -> Floats:
        """Mass per length of each cable, (m,), kg/m."""
        return self._of_cables("linear_density", 0.0)

    @property
    def sag_tensions(self) -> Floats:
        """Tension that is kept at least in each cable, (m,), N: as given, else the minimum tension; NaN if neither is given."""
        least = [cable.get("tension", [np.nan])[0] for cable in self._spec["cables"]]
        given = self._of_cables("sag_tension", np.nan)
        return np.where(np.isnan(given), least, given)

    @property
    def outlet_errors(self) -> Floats:
        """Largest distance of the true outlet of each cable from the given one, (m,), m."""
        return self._of_cables("outlet_error", 0.0)

    @property
    def pulleys(self) -> tuple[dict[str, Any] | None, ...]:
        """Last pulley of each cable, as `radius` and `axis`; None for outlets that are fixed points."""
        return self._tables_of_cables("pulley")

    @property
    def stiffnesses(self) -> Floats:
        """Axial stiffness of each cable, (m,), N; infinity if it does not stretch."""
        return self._of_cables("stiffness", np.inf)

    @property
    def drums(self) -> tuple[dict[str, Any] | None, ...]:
        """Drum of each cable's winch, `radius`, and `gear`, `zero` and `lead` as far as given; None if unknown."""
        return self._tables_of_cables("drum")

    @property
    def cable(self) -> dict[str, Any] | None:
        """Values for cables that do not have their own, as given."""
        common = self._spec.get("cable")
        return None if common is None else dict(common)

    @property
    def tension_distribution(self) -> Distribution | None:
        """Which of all tensions that balance the loads the controller keeps, None if not given; see `tension_distribution`."""
        return self._spec.get("tension_distribution")

    def _of_cables(self, key: str, missing: Any) -> Floats:
        missing = self._spec.get("cable", {}).get(key, missing)
        return np.array([cable.get(key, missing) for cable in self._spec["cables"]], dtype=np.float64)

    def _tables_of_cables(self, key: str) -> tuple[dict[str, Any] | None, ...]:
        common = self._spec.get("cable", {}).get(key)
        found = (cable.get(key, common) for cable in self._spec["cables"])
        return tuple(table and dict(table) for table in found)

    @property
    def mass(self) -> float | None:
        """Mass of the platform, kg, if given."""
        return self._spec.get("mass")

    @property
    def center_of_mass(self) -> Floats:
        """Centre of mass, (3,), platform frame, m."""
        return np.array(self._spec.get("center_of_mass", [0.0, 0.0, 0.0]), dtype=np.float64)

    @property
    def inertia(self) -> Floats | None:
        """Inertia about the centre of mass, (3, 3), platform axes, kg·m², if given."""
        given = self._spec.get("inertia")
        if given is None:
            return None
        numbers = np.array(given, dtype=np.float64)
        return np.diag(numbers) if numbers.ndim == 1 else numbers

    def __reduce__(self) -> tuple[Any, tuple[dict[str, Any]]]:
        """Pickle by value."""
        return Robot._of_sound, (self._spec,)

    def __repr__(self) -> str:
        """Show name and size."""
        return f"Robot({self.name!r}, {len(self._spec['cables'])} cables)"


def import_robot(
    path: str | os.PathLike[str],
    *,
    bodies: str | os.PathLike[str] | None = None,
    cable_set: str | None = None,
    platform: str | os.PathLike[str] | None = None,
    units: Unit = "m",
) -> Robot:
    """Import a robot from another program.

    Parameters
    ----------
    path : path
        CASPR: the cables file or the bodies file of a model, or their folder. Gazebo
        (https://github.com/oKermorgant/cdpr): its YAML file.
    bodies : path, optional
        CASPR's bodies file, if it is not beside the cables file under the same name.
    cable_set : str, optional
        CASPR's cable set; default: the file's own default.
    platform : path, optional
        Mesh of the platform in the platform frame (.stl or .obj); default: the shape in the source, or the hull of the
        attachments.
    units : {"mm", "cm", "m", "in", "ft"}
        Unit of that mesh.

    Returns
    -------
    Robot
        A `CdprWarning` lists everything that was not carried over.

    Raises
    ------
    InputError
        Bad contents; the message names the element and its line.

    Examples
    --------
    >>> import cdpr
    >>> files = cdpr.save_example_files("examples")
    >>> cdpr.import_robot("examples/caspr/CoGiRo")
    Robot('CoGiRo', 8 cables)
    """
    files = [None if given is None else file_name(given, key) for key, given in (("bodies", bodies), ("platform", platform))]
    chosen = None if cable_set is None else text("cable_set", cable_set)
    found, notes = _core.import_robot(file_name(path), files[0], chosen, files[1], text("units", units))
    if notes:
        warnings.warn("not carried over: " + "; ".join(notes), CdprWarning, stacklevel=2)
    return Robot.from_dict(json.loads(found))


def _without_version(spec: Mapping[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in spec.items() if key != "version"}


def _inertia(value: ArrayLike) -> Any:
    numbers = as_numbers("inertia", value)
    if numbers.shape not in ((3,), (3, 3)):
        raise InputError(f"inertia: found an array of shape {numbers.shape}, expected (3,) or (3, 3)")
    return numbers.tolist()


def _checked(spec: dict[str, Any]) -> dict[str, Any]:
    checked: dict[str, Any] = json.loads(_core.check_robot(json.dumps(plain("", spec))))
    return checked


_OF_ROBOT: dict[str, Callable[[Any], Any]] = {
    "mass": lambda value: finite("mass", value),
    "center_of_mass": lambda value: point("center_of_mass", value),
    "inertia": lambda value: _inertia(value),
    "cable": lambda value: table("cable", value),
    "tension_distribution": lambda value: one_of("tension_distribution", value, Distribution),
    "name": lambda value: text("name", value),
}
# For each argument, the key of a cable in a file and the function that makes its entries.
_OF_CABLES: dict[str, tuple[str, Callable[[Any, int], list[Any]]]] = {
    "outlets": ("outlet", lambda value, _: rows("outlets", value).tolist()),
    "attachments": ("attachment", lambda value, _: rows("attachments", value).tolist()),
    "tensions": ("tension", lambda value, count: of_each("tensions", value, count, (2,))),
    "cable_names": ("name", lambda value, _: texts("cable_names", value)),
    "diameters": ("diameter", lambda value, count: of_each("diameters", value, count, ())),
    "lengths": ("length", lambda value, count: of_each("lengths", value, count, (2,))),
    "linear_densities": ("linear_density", lambda value, count: of_each("linear_densities", value, count, ())),
    "sag_tensions": ("sag_tension", lambda value, count: of_each("sag_tensions", value, count, ())),
    "outlet_errors": ("outlet_error", lambda value, count: of_each("outlet_errors", value, count, ())),
    "pulleys": ("pulley", lambda value, count: _tables("pulleys", value, count)),
    "stiffnesses": ("stiffness", lambda value, count: of_each("stiffnesses", value, count, ())),
    "drums": ("drum", lambda value, count: _tables("drums", value, count)),
}


def _tables(argument: str, value: Any, count: int) -> list[Any]:
    if not isinstance(value, Sequence) or isinstance(value, str):
        return [table(argument, value)] * count
    return [entry if entry is None else table(f"{argument}[{k}]", entry) for k, entry in enumerate(value)]


def _put_cables(cables: list[dict[str, Any]], given: Mapping[str, Any]) -> None:
    """Set the given values of each cable; None removes them."""
    for argument, value in given.items():
        key, entries_of = _OF_CABLES[argument]
        if isinstance(value, Kept):
            continue
        if value is None and argument in ("outlets", "attachments"):
            raise InputError(f"{argument}: found None, expected an array of shape ({len(cables)}, 3)")
        entries = [None] * len(cables) if value is None else entries_of(value, len(cables))
        one_for_each(argument, entries, len(cables), "cable")
        for cable, entry in zip(cables, entries, strict=True):
            put(cable, key, entry, lambda entry: entry)

