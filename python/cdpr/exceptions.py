"""Everything that cdpr raises and warns of."""


class CdprError(Exception):
    """Base of all errors of this package."""


class InputError(CdprError, ValueError):
    """Bad input: a value, a key, a shape. The message says what was found, where, and what is expected."""


class FileError(CdprError, OSError):
    """A file cannot be read or written, or its name has the wrong extension."""


class CdprWarning(UserWarning):
    """Something about a scene that the user should know."""
