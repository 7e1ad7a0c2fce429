"""Planning with a path of an earlier scene."""

from __future__ import annotations

from typing import Unpack

from numpy.typing import ArrayLike

from . import _core
from ._paths import way_of
from ._planning import result_of
from ._results import Path, Result, SearchTree
from ._scene import Scene
from ._search import Planner, SearchOptions, search_options, unknown_option


def replan(
    scene: Scene,
    waypoints: ArrayLike | Path,
    orientations: ArrayLike | None = None,
    *,
    planner: Planner = "two-trees",
    **options: Unpack[SearchOptions],
) -> Result:
    """Plan between the ends of a known path, keeping what is still valid of it, after something in the scene has moved.

    Motions that are still valid are kept, each gap between them is closed by a short search, and the whole path is shortened.
    If that is not possible, the path is planned anew.

    Parameters
    ----------
    scene : Scene
        The scene as it is now, best from :meth:`Scene.moved`, so that only what has moved is compiled again. The start and goal of
        the scene are not used.
    waypoints : array_like (k, 3), k >= 2, or Path
        Positions of the platform's origin, world, m, of a path that need not be valid.
    orientations : array_like (k, 4) or (4,), optional
        World-from-platform unit quaternions w x y z, as in :func:`check`. Where the platform turns, a gap may take much longer.
    planner : {"two-trees", "anytime", "rrt-connect", "modified-rrt", "rrt", "rrt-star"}
        What closes gaps and plans anew.
    **options
        Further keywords of :func:`plan`, from ``seed`` to ``proof``. ``budget`` is the time limit of the call, s. The default
        of ``post`` is that of the planner, or "taut" if that is "none".

    Returns
    -------
    Result
        ``found_by`` is "kept" if the whole path is still valid, "repaired" if gaps were closed, otherwise as for
        :func:`plan`. ``raw_waypoints`` is the path before it was shortened. It is rechecked as a whole.

    Raises
    ------
    InputError
        Arrays of wrong shape, bad options. An invalid start or goal is no error: see ``status``.
    KeyboardInterrupt
        On Ctrl-C, if there is no path yet.

    Examples
    --------
    >>> from cdpr import plan
    >>> scene = Scene.example("hard3")
    >>> path = plan(scene)
    >>> moved = scene.moved("west", [0.6, 1.0, 0.4])
    >>> replan(moved, path).found_by
    'repaired'
    """
    if unknown := unknown_option(options):
        raise TypeError(f"replan() got an unexpected keyword argument '{unknown}'")
    search = search_options(planner, **options)
    core, positions, turns = way_of(scene, "waypoints", waypoints, orientations, of_another=True)
    written, tree, certificate = _core.replan(core, search, positions, turns)
    return result_of(written, SearchTree(*tree), certificate, None)
