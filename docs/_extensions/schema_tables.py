"""The directive `{schema-tables} scene`: a JSON Schema of the program as tables, one for each kind of object."""

import json

import cdpr
from sphinx.util.docutils import SphinxDirective

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


def linked(reference: str) -> str:
    name = definition(reference.rsplit("/", 1)[1])
    return f"[{name}](#{name.lower()})"


def kind(schema: dict) -> str:
    """What a value may be, in words."""
    if "$ref" in schema:
        return linked(schema["$ref"])
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


def row(name: str, schema: dict, required: bool) -> str:
    key = f"**`{name}`**" if required else f"`{name}`"
    return f"| {key} | {cell(kind(schema))} | {cell(schema.get('description', ''))} |"


def described(schema: dict) -> str:
    """Description, keys as a table, alternatives as a list."""
    parts = [schema.get("description", "")]
    if properties := schema.get("properties"):
        required = schema.get("required", [])
        rows = [row(name, one, name in required) for name, one in properties.items()]
        parts.append("\n".join(["| key | value | meaning |", "|---|---|---|", *rows]))
    if alternatives := schema.get("oneOf") or schema.get("anyOf"):
        parts.append("\n".join(f"- {kind(one)}: {cell(one.get('description', ''))}" for one in alternatives))
    elif "enum" in schema:
        parts.append("One of " + kind(schema) + ".")
    return "\n\n".join(parts)


class SchemaTables(SphinxDirective):
    required_arguments = 1

    def run(self):
        schema = cdpr.schema(self.arguments[0])
        names = mentioned({key: value for key, value in schema.items() if key != "$defs"}, schema.get("$defs", {}), [])
        sections = [(self.arguments[0].capitalize(), schema), *((definition(name), schema["$defs"][name]) for name in names)]
        text = "\n\n".join(f"## {title}\n\n{described(one)}" for title, one in sections)
        return self.parse_text_to_nodes(text, allow_section_headings=True)


def setup(app):
    app.add_directive("schema-tables", SchemaTables)
    return {"parallel_read_safe": True}
