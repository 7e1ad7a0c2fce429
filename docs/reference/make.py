"""Writes the reference pages that are made from the program itself: `make reference`.

The command line from the program's help, scenes and experiments from the JSON Schemas, Python from the docstrings, Rust from the
README of its crate. The pages are under version control, so that they can be read beside the code; python/tests/test_docs.py compares them with what this
script makes. CDPR names the program, `cdpr` by default.
"""

import importlib
import inspect
import json
import os
import re
import subprocess
import textwrap
from collections.abc import Callable, Iterator
from pathlib import Path

from numpydoc.docscrape import NumpyDocString

import cdpr

HERE = Path(__file__).parent
MADE = "<!-- Made by `make reference`; changes made here are lost. -->"
WIDTH = 100


def page(title: str, introduction: str, *sections: str) -> str:
    return "\n\n".join([f"# {title}", MADE, textwrap.dedent(introduction).strip(), *sections]) + "\n"


def contents(names: list[str]) -> str:
    """Links to the sections of a page, by the anchors that GitHub and the site give to headings."""
    return " · ".join(f"[{name}](#{anchor(name)})" for name in names)


def anchor(heading: str) -> str:
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def fenced(language: str, text: str) -> str:
    return f"```{language}\n{text.strip()}\n```"


# The command line


def printed(*command: str) -> str:
    program = os.environ.get("CDPR", "cdpr")
    environment = os.environ | {"COLUMNS": str(WIDTH)}
    done = subprocess.run([program, *command], check=True, capture_output=True, text=True, env=environment)
    shown = "\n".join(line.rstrip() for line in done.stdout.splitlines())
    return fenced("console", f"$ cdpr {' '.join(command)}\n{shown}")


def commands() -> list[str]:
    program = os.environ.get("CDPR", "cdpr")
    help_text = subprocess.run([program, "--help"], check=True, capture_output=True, text=True).stdout
    listed = help_text.partition("Commands:\n")[2].partition("\n\n")[0]
    return [name for name in re.findall(r"^  ([a-z]+) ", listed, re.MULTILINE) if name != "help"]


def command_line() -> str:
    names = commands()
    introduction = "The help of every command, as `cdpr COMMAND --help` prints it."
    sections = [f"## cdpr {name}\n\n{printed(name, '--help')}" for name in names]
    return page("Command line", introduction, contents([f"cdpr {name}" for name in names]), printed("--help"), *sections)


# Files, from their JSON Schemas

SCALARS = {"number": "number", "integer": "whole number", "string": "text", "boolean": "true or false", "null": "nothing"}


def definition(name: str) -> str:
    return name.removesuffix("Spec")


def mentioned(schema, definitions: dict, found: list[str]) -> list[str]:
    """Names of definitions in the order in which a reader meets them."""
    for key, value in schema.items() if isinstance(schema, dict) else enumerate(schema):
        if key == "$ref":
            name = value.rsplit("/", 1)[1]
            if name not in found:
                found.append(name)
                mentioned(definitions[name], definitions, found)
        elif isinstance(value, dict | list):
            mentioned(value, definitions, found)
    return found


def kind(schema: dict) -> str:
    """What a value may be, in words."""
    if "$ref" in schema:
        name = definition(schema["$ref"].rsplit("/", 1)[1])
        return f"[{name}](#{anchor(name)})"
    if "const" in schema:
        return f"`{json.dumps(schema['const'])}`"
    if "enum" in schema:
        return " or ".join(f"`{json.dumps(value)}`" for value in schema["enum"])
    if alternatives := schema.get("anyOf") or schema.get("oneOf"):
        return " or ".join(kind(one) for one in alternatives if one.get("type") != "null")
    types = [schema["type"]] if isinstance(schema.get("type"), str) else schema.get("type", [])
    return " or ".join(single(one, schema) for one in types if one != "null") or "anything"


def single(name: str, schema: dict) -> str:
    if name == "array":
        least, most = schema.get("minItems"), schema.get("maxItems")
        count = f"{least} × " if least is not None and least == most else ""
        return f"list of {count}{kind(schema.get('items', {}))}"
    if name == "object":
        return f"table of {kind(schema['additionalProperties'])}" if schema.get("additionalProperties") else "table"
    return SCALARS[name]


def cell(text: str) -> str:
    return " ".join(text.split()).replace("|", "\\|")


def described(schema: dict) -> str:
    """Description, keys as a table, alternatives as a list."""
    parts = [schema.get("description", "")]
    if properties := schema.get("properties"):
        required = schema.get("required", [])
        keys = {name: f"**`{name}`**" if name in required else f"`{name}`" for name in properties}
        rows = [f"| {keys[k]} | {cell(kind(one))} | {cell(one.get('description', ''))} |" for k, one in properties.items()]
        parts.append("\n".join(["| key | value | meaning |", "|---|---|---|", *rows]))
    if alternatives := schema.get("oneOf") or schema.get("anyOf"):
        parts.append("\n".join(f"- {kind(one)}: {cell(one.get('description', ''))}" for one in alternatives))
    elif "enum" in schema:
        parts.append("One of " + kind(schema) + ".")
    return "\n\n".join(filter(None, parts))


def file_format(name: str, title: str, introduction: str) -> str:
    schema = cdpr.schema(name)
    definitions = schema.get("$defs", {})
    names = mentioned({key: value for key, value in schema.items() if key != "$defs"}, definitions, [])
    sections = {name.capitalize(): schema} | {definition(one): definitions[one] for one in names}
    texts = [f"## {heading}\n\n{described(one)}" for heading, one in sections.items()]
    return page(title, introduction, contents(list(sections)), *texts)


def scene() -> str:
    return file_format("scene", "Scenes, robots, paths", """
        Files are TOML or JSON. `cdpr schema scene` prints the JSON Schema that this page is made from, `cdpr.schema()` returns
        it, and editors check files against it. Keys in bold are required. Lengths are metres, angles radians, forces newtons;
        z points up.

        A robot stands in its scene or in a [file of its own](#robot); `cdpr plan -o path.json` writes a path file
        (`cdpr schema path`).
    """)  # fmt: skip


def experiment() -> str:
    return file_format("experiment", "Experiments", """
        The input of `cdpr batch` and `cdpr.run_batch`; `cdpr schema experiment` prints its JSON Schema. Keys in bold are
        required. [Compare planners in an experiment](../howto/batch.md) has an example.
    """)  # fmt: skip


# Python, from docstrings in NumPy's style

MODULES = ["cdpr", "cdpr.figures", "cdpr.ompl"]
METHOD_KINDS = (property, classmethod, staticmethod, type(page))
LISTS = ["Parameters", "Attributes", "Returns", "Raises", "Warns"]


def markdown(lines: list[str]) -> str:
    """Text of a docstring: examples are fenced, marks of reStructuredText are those of Markdown."""
    blocks = re.split(r"\n\s*\n", textwrap.dedent("\n".join(lines)).strip())
    grouped: list[str] = []
    for block in blocks:
        if block.startswith(">>>") and grouped and grouped[-1].startswith(">>>"):
            grouped[-1] += f"\n\n{block}"
        else:
            grouped.append(block)
    return "\n\n".join(fenced("pycon", block) if block.startswith(">>>") else inline(block) for block in grouped)


def inline(text: str) -> str:
    return re.sub(r":\w+:(?=`)", "", text).replace("``", "`").replace("*(", "\\*(")


def entries(parameters) -> str:
    return "\n".join(f"- {entry(name, kind, inline(' '.join(text)))}" for name, kind, text in parameters)


def entry(name: str, kind: str, text: str) -> str:
    head = f"`{name}`: {inline(kind)}" if name and kind else f"`{name or kind}`"
    return f"{head}. {text}".rstrip() if text and name and kind else f"{head}: {text}" if text else head


def docstring(thing: object) -> str:
    found = NumpyDocString(inspect.getdoc(thing) or "")
    parts = [markdown(found["Summary"]), markdown(found["Extended Summary"])]
    parts += [f"**{name}**\n\n{entries(found[name])}" for name in LISTS if found[name]]
    parts += [f"**{name}**\n\n{markdown(found[name])}" for name in ("Notes", "Examples") if found[name]]
    return "\n\n".join(filter(None, parts))


def signature(name: str, call: Callable[..., object]) -> str:
    parameters = inspect.signature(call).parameters.values()
    plain = [one.replace(annotation=inspect.Parameter.empty) for one in parameters if one.name not in ("self", "cls")]
    text = f"{name}{inspect.Signature(plain)}"
    return fenced("pyi", "\n".join(textwrap.wrap(text, WIDTH, subsequent_indent="    ")))


def public(module: str) -> list[tuple[str, object]]:
    """Names of the functions and classes of a module, in the order of its __all__."""
    found = importlib.import_module(module)
    things = [(name, getattr(found, name)) for name in found.__all__]
    return [(name, thing) for name, thing in things if inspect.isfunction(thing) or inspect.isclass(thing)]


def members(thing: type) -> Iterator[tuple[str, object]]:
    for name in vars(thing):
        member = inspect.getattr_static(thing, name)
        if not name.startswith("_") and isinstance(member, METHOD_KINDS):
            yield name, member


def entity(name: str, thing: object) -> str:
    if not inspect.isclass(thing):
        return f"### {name}\n\n{signature(name, thing)}\n\n{docstring(thing)}"
    parts = [f"### {name}"]
    if NumpyDocString(inspect.getdoc(thing))["Parameters"]:
        parts.append(signature(name, thing))
    parts.append(docstring(thing))
    for key, member in members(thing):
        call = getattr(member, "__func__", member)
        heading = f"#### {name.rpartition('.')[2]}.{key}"
        parts += [heading] if isinstance(member, property) else [heading, signature(key, call)]
        parts.append(docstring(member))
    return "\n\n".join(parts)


def module(name: str) -> str:
    things = [(f"{name}.{short}", thing) for short, thing in public(name)]
    text = markdown(inspect.getdoc(importlib.import_module(name)).splitlines())
    return "\n\n".join([f"## {name}", text, contents([key for key, _ in things]), *(entity(*thing) for thing in things)])


def python() -> str:
    return page("Python", """
        Arrays in and out, in metres, radians and newtons; the interpreter is released while the core works. All errors derive
        from `cdpr.CdprError`.
    """, *(module(name) for name in MODULES))  # fmt: skip


# Rust


def rust() -> str:
    readme = (HERE / "../../crates/cdpr-files/README.md").read_text(encoding="utf-8")
    example = readme.partition("<!-- begin -->")[2].partition("Licence:")[0]
    return page("Rust", """
        `cargo doc --open` in a clone opens the reference of the library, `cdpr-core`: one page with all public names. A program beside a clone names
        the crates in its `Cargo.toml`:

        ```toml
        [dependencies]
        cdpr-core = { path = "../cdpr/crates/cdpr-core" }    # scenes, planners, checks
        cdpr-files = { path = "../cdpr/crates/cdpr-files" }  # reads and writes files
        ```

        <!-- site: <a href="../rust/cdpr_core/index.html">The same on this site.</a> -->
    """, example.strip())  # fmt: skip


PAGES = {
    "command-line.md": command_line,
    "scene.md": scene,
    "experiment.md": experiment,
    "python.md": python,
    "rust.md": rust,
}


def main() -> None:
    for name, make in PAGES.items():
        (HERE / name).write_text(make(), encoding="utf-8")
        print(f"wrote {HERE / name}")


if __name__ == "__main__":
    main()
