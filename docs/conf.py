"""Configuration of the documentation site, built by `make docs`."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent / "_extensions"))

import cdpr

project = "cdpr"
copyright = "the cdpr developers"
version = release = cdpr.__version__

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "sphinx.ext.mathjax",
    "sphinx_copybutton",
    "outside_links",
    "program_help",
    "python_modules",
    "schema_tables",
]
exclude_patterns = ["_extensions", "_static", "figures"]
highlight_language = "none"

myst_heading_anchors = 4

autodoc_member_order = "groupwise"
autodoc_typehints = "none"  # the docstrings tell types and shapes
napoleon_google_docstring = False
napoleon_use_ivar = True
napoleon_use_rtype = False

nitpicky = True
# Types in docstrings are words for people: "ndarray (n, 3)", "Robot or None".
nitpick_ignore_regex = [("py:class", ".*")]

html_theme = "furo"
html_title = f"cdpr {version}"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_show_sphinx = False
html_copy_source = False
