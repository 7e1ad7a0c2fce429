"""Example files that the package contains."""

from __future__ import annotations

import os
from pathlib import Path

from . import _core
from ._given import file_name, flag


def save_example_files(folder: str | os.PathLike[str], *, overwrite: bool = False) -> list[Path]:
    """Write example files, to try imports with and to build scenes around.

    Robots as published with CASPR (`caspr/CoGiRo` and others), CAROCA for cdpr for Gazebo (`gazebo/caroca.yaml`), two
    meshes (`meshes/machine.stl`, a machine tool, and `meshes/platform.stl`, CAROCA's platform in millimetres), and the
    robots of the example scenes (`robots/cogiro.toml` and others). The scenes themselves need no files: :func:`example`.

    Parameters
    ----------
    folder : path
        Where they are written; it is made if it is missing. Files that are there already with the same contents stay as
        they are.
    overwrite : bool
        Replace files of the same names that have other contents.

    Returns
    -------
    list of pathlib.Path
        All example files, in alphabetical order.

    Raises
    ------
    FileError
        A file of the same name has other contents, or the folder cannot be written. Then nothing is written.

    Examples
    --------
    >>> import cdpr
    >>> [file.name for file in cdpr.save_example_files("examples") if file.suffix == ".stl"]
    ['machine.stl', 'platform.stl']
    """
    return [Path(path) for path in _core.save_example_files(file_name(folder), flag("overwrite", overwrite))]
