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
    "sphinx_copybutton",
    "plain_pages",
]
exclude_patterns = ["_extensions", "_static", "figures"]
highlight_language = "none"

myst_heading_anchors = 4

nitpicky = True

html_theme = "furo"
html_title = f"cdpr {version}"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_show_sphinx = False
html_copy_source = False
