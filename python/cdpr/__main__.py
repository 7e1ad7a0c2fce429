"""The command ``cdpr``: ``python -m cdpr`` and the console script call it."""

import sys

from . import _core


def main() -> None:
    """Run the command with the arguments of the process, and exit with its status."""
    sys.exit(_core.command(["cdpr", *sys.argv[1:]]))


if __name__ == "__main__":
    main()
