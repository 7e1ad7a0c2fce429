"""Payloads of a scene and its task. The functions are methods of `Scene`."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from numpy.typing import ArrayLike

from . import _tables
from ._arrays import shown
from ._given import plain, several, table, text
from ._stations import place
from .exceptions import InputError

if TYPE_CHECKING:
    from ._scene import Scene


def _payload_tables(given: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Return the table of payloads, from tables of a file by name; bodies may also be corners or meshes."""
    named = table("payloads", given).items()
    return [_payload(f"payloads[{name!r}]", text("payloads", name), payload) for name, payload in named]


def _payload(key: str, name: str, payload: Any) -> dict[str, Any]:
    if not isinstance(payload, Mapping):
        raise InputError(f"{key}: found {shown(payload)}, expected a table with body, mass and at")
    if "name" in payload:
        raise InputError(f"{key}: found a table with a name of its own, expected none")
    own = {"name": name}
    if "body" in payload:
        bodies = _tables.bodies(f"{key}.body", payload["body"])
        own["body"] = bodies[0] if len(bodies) == 1 else bodies  # type: ignore[assignment]
    copy: dict[str, Any] = plain(key, {entry: value for entry, value in payload.items() if entry != "body"})
    return copy | own


def _task_rows(given: Iterable[Any]) -> list[dict[str, Any]]:
    """Return the rows of a task."""
    return [_row(f"task[{k}]", row) for k, row in enumerate(several("task", given, "rows such as {'pick': 'crate'}"))]


def _row(key: str, row: Any) -> dict[str, Any]:
    if not isinstance(row, Mapping):
        raise InputError(f"{key}: found {shown(row)}, expected a mapping such as {{'pick': 'crate'}}")
    copy: dict[str, Any] = plain(key, {entry: value for entry, value in row.items() if entry not in ("go", "via")})
    return copy | {entry: place(f"{key}.{entry}", row[entry]) for entry in ("go", "via") if entry in row}


SCENE = _tables.SCENE | {"payloads": _payload_tables, "task": _task_rows}


def carrying(self: Scene, name: str) -> Scene:
    """Return the scene in which the platform carries a payload: a part of the platform, of its mass and of its inertia.

    The scene has no task, since that begins elsewhere.

    Parameters
    ----------
    name : str
        Name of a payload; others may be carried already.

    Returns
    -------
    Scene

    Raises
    ------
    InputError
        An unknown name, or a payload that overlaps one that is carried already.

    Examples
    --------
    >>> import cdpr
    >>> crate = {"body": {"box": [0.1, 0.1, 0.1], "position": [0, 0, -0.1]}, "mass": 2, "at": [1.7, 1, 0.3]}
    >>> scene = cdpr.example("hard1").replace(payloads={"crate": crate})
    >>> list(scene.obstacles), scene.robot.mass
    (['pillar', 'crate'], 10.0)
    >>> carried = scene.carrying("crate")
    >>> list(carried.obstacles), carried.robot.mass
    (['pillar'], 12.0)
    """
    return type(self)._of_core(self._core.carrying(text("name", name)))


def placed(self: Scene, name: str, at: ArrayLike | str) -> Scene:
    """Return the scene in which a payload stands where it would be carried if the platform were there.

    The scene has no task, since that begins elsewhere.

    Parameters
    ----------
    name : str
        Name of a payload.
    at : array_like (3,) or str
        Position of the platform's origin, world, m, or the name of a station.

    Returns
    -------
    Scene

    Raises
    ------
    InputError
        An unknown name.

    Examples
    --------
    >>> import cdpr
    >>> crate = {"body": {"box": [0.1, 0.1, 0.1], "position": [0, 0, -0.1]}, "mass": 2, "at": [1.7, 1, 0.3]}
    >>> scene = cdpr.example("hard1").replace(payloads={"crate": crate})
    >>> scene.placed("crate", [0.3, 1, 0.5]).obstacles["crate"][0].mean(axis=0)
    array([0.3, 1. , 0.4])
    """
    return type(self)._of_core(self._core.placed(text("name", name), place("at", at)))
