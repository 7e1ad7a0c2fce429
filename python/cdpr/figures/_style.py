"""How figures look: sizes, and colours that colour-blind readers can tell apart."""

from __future__ import annotations

import functools
from collections.abc import Callable
from contextlib import AbstractContextManager
from typing import Any, ParamSpec, TypeVar

import matplotlib as mpl
from cycler import cycler
from matplotlib.axes import Axes
from matplotlib.figure import Figure

# Okabe and Ito, "Color Universal Design", 2008; yellow is left out, it is too light for lines on white.
BLACK, ORANGE, SKY, GREEN, BLUE, VERMILION, PURPLE = (
    *("#000000", "#E69F00", "#56B4E9", "#009E73", "#0072B2", "#D55E00", "#CC79A7"),
)
CYCLE = (BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY, BLACK)
GREY, LIGHT, PALE = "#6e6e6e", "#c4c4c4", "#cfe3f3"
SAND = "#efe1c6"  # obstacles: robot, path and shadows stand out against it

# Width of a column and of a page of a journal, inches.
COLUMN, PAGE = 3.5, 7.2

# TrueType: journals refuse matplotlib's default, Type 3.
_FONTS: Any = {"pdf.fonttype": 42, "ps.fonttype": 42}

_PARAMETERS: Any = {
    "font.family": "DejaVu Sans",  # comes with matplotlib, so pictures are the same everywhere
    "font.size": 8,
    "axes.titlesize": 8,
    "axes.labelsize": 8,
    "xtick.labelsize": 7,
    "ytick.labelsize": 7,
    "legend.fontsize": 7,
    "legend.frameon": False,
    "axes.linewidth": 0.6,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.prop_cycle": cycler(color=CYCLE),
    "grid.color": "#e2e2e2",
    "grid.linewidth": 0.5,
    "lines.linewidth": 1.4,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "svg.hashsalt": "cdpr",  # the same file for the same picture
    "savefig.dpi": 200,
    **_FONTS,
}

P = ParamSpec("P")
R = TypeVar("R")


def style() -> AbstractContextManager[None]:
    """Matplotlib's settings of these figures, for what is drawn around them.

    Returns
    -------
    context manager

    Examples
    --------
    >>> import cdpr.figures, matplotlib
    >>> with cdpr.figures.style():
    ...     matplotlib.rcParams["font.size"]
    8.0
    """
    return mpl.rc_context(_PARAMETERS)


class Printed(Figure):
    """A figure whose PDF and PS files have TrueType fonts, whatever the settings are when it is saved."""

    def savefig(self, *args: Any, **kwargs: Any) -> None:
        """Save the figure as matplotlib does."""
        with mpl.rc_context(_FONTS):
            super().savefig(*args, **kwargs)


def laid_out(ax: Axes) -> None:
    """Place axes, and the numbers on them, without drawing: from then on they can be measured."""
    ax.figure.canvas.figure.draw_without_rendering()  # the whole figure, even if the axes are in a part of one


def make_high(ax: Axes, height: float) -> None:
    """Change the height of a figure that was made for these axes, inches."""
    figure = ax.figure
    assert isinstance(figure, Printed)
    figure.set_figheight(height)


def styled(function: Callable[P, R]) -> Callable[P, R]:
    """Run a drawing function in this style, and leave the caller's settings alone."""

    @functools.wraps(function)
    def draw(*args: P.args, **kwargs: P.kwargs) -> R:
        with style():
            return function(*args, **kwargs)

    return draw
