"""Docstrings of all public names, in NumPy's style; their examples run as doctests."""

import dataclasses
import importlib
import inspect

import pytest
from numpydoc.docscrape import NumpyDocString
from numpydoc.validate import validate

import cdpr

# Checks that do not apply here, and why.
LEFT_OUT = {
    "GL02",  # closing quotes of one-line docstrings
    "ES01",  # a sufficient summary needs no extension
    "SA01",  # See Also: links are in the text
    "PR07",  # `scene : Scene` is sufficient
    "RT03",  # and so is `Returns: Scene`
    "SS05",  # "Collision-free paths" is a summary, too
}
MODULES = ["cdpr", "cdpr.ompl", "cdpr.figures", "cdpr.exceptions"]
ALIASES = ["cdpr.shadows", "cdpr.save_shadows"]  # their docstrings name the methods
ERRORS = ["CdprError", "InputError", "FileError", "InternalError", "CdprWarning", "AnotherSceneWarning"]


def public():
    """Names of functions, classes and their own methods and properties."""
    for place in MODULES:
        module = importlib.import_module(place)
        names = getattr(module, "__all__", ERRORS)
        for name in names:
            thing = getattr(module, name)
            if inspect.isfunction(thing) or inspect.isclass(thing):
                yield f"{place}.{name}"
            if inspect.isclass(thing) and issubclass(thing, tuple):
                own = [key for key in vars(thing) if key not in getattr(thing, "_fields", ())]
            else:
                own = list(vars(thing)) if inspect.isclass(thing) else []
            for key in own:
                member = inspect.getattr_static(thing, key)
                if not key.startswith("_") and isinstance(member, (property, classmethod, staticmethod, type(public))):
                    yield f"{place}.{name}.{key}"


NAMES = sorted(set(public()))


def test_docstrings_of_the_whole_package_are_checked():
    some = {"cdpr.plan", "cdpr.Scene.without", "cdpr.ompl.MotionValidator.checkMotion"}
    assert len(NAMES) > 80 and some <= set(NAMES)


def described(thing):
    """Attributes that a class's docstring lists."""
    sections = NumpyDocString(inspect.getdoc(thing))
    return [name.strip() for entry in sections["Attributes"] for name in entry.name.split(",")]


def results():
    """Classes created by functions, not by users: their attributes are what matters."""
    classes = (getattr(cdpr, name) for name in cdpr.__all__)
    return [thing for thing in classes if inspect.isclass(thing) and described(thing)]


@pytest.mark.parametrize("thing", results(), ids=lambda thing: thing.__name__)
def test_results_describe_every_attribute(thing):
    fields = dataclasses.fields(thing) if dataclasses.is_dataclass(thing) else ()
    own = getattr(thing, "_fields", [field.name for field in fields if not field.name.startswith("_")])
    assert described(thing) == list(own or described(thing)) and len(results()) == 30


@pytest.mark.parametrize("name", NAMES)
def test_docstrings_are_in_numpys_style(name):
    found = validate(name)
    left_out = LEFT_OUT | (set() if name.rpartition(".")[0] in MODULES else {"EX01"})  # methods may go without examples
    if name in [f"cdpr.{thing.__name__}" for thing in results()]:
        left_out |= {"PR01"}  # the code that creates them passes the attributes
    if name in ALIASES:
        left_out |= {"PR01", "RT01", "EX01"}
    assert [problem for problem in found["errors"] if problem[0] not in left_out] == []
