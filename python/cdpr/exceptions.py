"""Exceptions and warnings of cdpr."""


class CdprError(Exception):
    """Base of all errors of this package.

    Examples
    --------
    >>> import cdpr
    >>> try:
    ...     cdpr.Scene.load("nowhere.toml")
    ... except cdpr.CdprError as problem:
    ...     print(type(problem).__name__)
    FileError
    """


class InputError(CdprError, ValueError):
    """Bad input: a value, a key, a shape. The message states what was found, where, and what is expected.

    Examples
    --------
    >>> import cdpr
    >>> cdpr.distance([[0, 0]], [[1, 1, 1]])
    Traceback (most recent call last):
    cdpr.exceptions.InputError: a: found an array of shape (1, 2), expected (..., 3)
    """


class FileError(CdprError, OSError):
    """A file cannot be read or written, or its name has the wrong extension.

    Examples
    --------
    >>> import cdpr
    >>> cdpr.load_path("path.txt")
    Traceback (most recent call last):
    cdpr.exceptions.FileError: path.txt: found the extension .txt, expected .json or .csv
    """


class InternalError(CdprError, RuntimeError):
    """A bug of this package, not of the input; please report it with the message.

    Examples
    --------
    >>> import cdpr
    >>> issubclass(cdpr.exceptions.InternalError, cdpr.CdprError)
    True
    """


class CdprWarning(UserWarning):
    """A remark about a scene that the user should know.

    Examples
    --------
    >>> import cdpr, warnings
    >>> with warnings.catch_warnings(record=True) as told:
    ...     scene = cdpr.example("plank")
    >>> [warning.category.__name__ for warning in told]
    ['CdprWarning']
    """


class AnotherSceneWarning(CdprWarning):
    """A path was planned for a scene other than the one in which it is checked or shown.

    Examples
    --------
    >>> import cdpr, warnings
    >>> scene = cdpr.example("hard1")
    >>> path = cdpr.plan(scene)
    >>> with warnings.catch_warnings(record=True) as told:
    ...     valid = cdpr.check(scene.replace(clearance=0.01), path).valid
    >>> valid, [warning.category.__name__ for warning in told]
    (False, ['AnotherSceneWarning'])
    """
