"""Figures for print, with matplotlib: ``pip install '.[figures]'``.

Each function draws one kind of figure into the axes that it is given, or into a new figure of the width of a column, and
returns its ``Axes``; `along`, `convergence` and `trajectory` draw several charts and return a tuple of them.
``ax.figure.savefig("figure.svg")`` writes it. PDF files of new figures have TrueType fonts; draw and save on axes of your own
within ``with cdpr.figures.style():``, and theirs have them too. Colours are those of Okabe and Ito, which colour-blind
readers can tell apart.
"""

try:
    import matplotlib as _  # noqa: F401
except ImportError as problem:
    raise ImportError("cdpr.figures needs matplotlib: pip install 'cdpr[figures]'") from problem

from ._along import along
from ._charts import boxes, repeats, step_sweep
from ._convergence import convergence
from ._motion import trajectory
from ._space import available_set, model, paths, rewinding, scene
from ._style import BLACK, BLUE, COLUMN, CYCLE, GREEN, GREY, LIGHT, ORANGE, PAGE, PURPLE, SKY, VERMILION, style
from ._workspace import workspace

__all__ = [
    "BLACK",
    "BLUE",
    "COLUMN",
    "CYCLE",
    "GREEN",
    "GREY",
    "LIGHT",
    "ORANGE",
    "PAGE",
    "PURPLE",
    "SKY",
    "VERMILION",
    "along",
    "available_set",
    "boxes",
    "convergence",
    "model",
    "paths",
    "repeats",
    "rewinding",
    "scene",
    "step_sweep",
    "style",
    "trajectory",
    "workspace",
]
