"""The directive `{python-modules}`: the package and its public modules, whatever they are, by autodoc."""

import importlib
import pkgutil

from sphinx.util.docutils import SphinxDirective


def public_modules(package: str) -> list[str]:
    inside = importlib.import_module(package).__path__
    return [package, *(f"{package}.{found.name}" for found in pkgutil.iter_modules(inside) if found.name[0] != "_")]


class PythonModules(SphinxDirective):
    required_arguments = 1

    def run(self):
        modules = [name for name in public_modules(self.arguments[0]) if name != "cdpr.exceptions"]  # all in cdpr
        text = "\n".join(f"## {name}\n\n{self.automodule(name)}" for name in modules)
        return self.parse_text_to_nodes(text, allow_section_headings=True)

    def automodule(self, name: str) -> str:
        return f"```{{eval-rst}}\n.. automodule:: {name}\n   :members:\n   :imported-members:\n```\n"


def on_skip(app, what, name, member, skip, options):
    """Fields of named tuples are told with their class."""
    return True if type(member).__name__ == "_tuplegetter" else None


def setup(app):
    app.connect("autodoc-skip-member", on_skip)
    app.add_directive("python-modules", PythonModules)
    return {"parallel_read_safe": True}
