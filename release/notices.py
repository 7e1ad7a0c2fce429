"""Notices of everything that the wheel, the programs and the page contain of others.

Writes THIRD_PARTY_NOTICES.txt for wheel and programs, and crates/cdpr-view/THIRD_PARTY_NOTICES.txt for the page, which holds
the planner as WebAssembly. Names, versions and licences come from `cargo metadata`, licence texts from the sources of the
crates. Where a crate offers a choice, the first licence of PREFERENCE is taken. `--check` writes nothing.
"""

import argparse
import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]

# What is compiled into each file's product; crates that run only while compiling are left out.
PRODUCTS = {
    "THIRD_PARTY_NOTICES.txt": ("the Python package cdpr and the program cdpr", ("cdpr-cli", "cdpr-py", "cdpr-live")),
    "crates/cdpr-view/THIRD_PARTY_NOTICES.txt": ("the page of cdpr and the planner inside it", ("cdpr-live",)),
}

PREFERENCE = ("MIT", "Apache-2.0", "BSD-2-Clause", "BSD-3-Clause", "ISC", "Zlib", "Unicode-3.0", "BSL-1.0", "Unlicense")

# How the file of a licence is named, if a crate has several.
NAMED = {
    "MIT": r"mit",
    "Apache-2.0": r"apache(?!.*llvm)",
    "BSD-2-Clause": r"bsd",
    "BSD-3-Clause": r"bsd|whatwg",
    "ISC": r"isc",
    "Zlib": r"zlib",
    "Unicode-3.0": r"unicode",
    "BSL-1.0": r"boost|bsl",
    "Unlicense": r"unlicense",
}
LICENCE_FILE = re.compile(r"(?i)(licen[cs]e|copying|unlicense)")
GENERAL_FILE = re.compile(r"(?i)(licen[cs]e|copying)(\.\w+)?$")
NOTICE_FILE = re.compile(r"(?i)(notice|copyright)(\.\w+)?$")
RULE = "-" * 80

Package = dict[str, Any]


def chosen(expression: str) -> list[str]:
    """The licences under which a crate is used: of alternatives, the most preferred.

    >>> chosen("Apache-2.0/MIT"), chosen("(MIT OR Apache-2.0) AND Unicode-3.0")
    (['MIT'], ['MIT', 'Unicode-3.0'])
    """
    tokens = re.findall(r"[()]|[^\s()]+", expression.replace("/", " OR "))

    def alternatives() -> list[str]:
        found = [together()]
        while tokens[:1] == ["OR"]:
            tokens.pop(0)
            found.append(together())
        return min(found, key=lambda licences: max(map(rank, licences)))

    def together() -> list[str]:
        found = single()
        while tokens[:1] == ["AND"]:
            tokens.pop(0)
            found = found + single()
        return found

    def single() -> list[str]:
        token = tokens.pop(0)
        if token == "(":
            found = alternatives()
            assert tokens.pop(0) == ")", expression
            return found
        if tokens[:1] == ["WITH"]:
            token = f"{token} WITH {tokens[1]}"
            del tokens[:2]
        return [token]

    licences = alternatives()
    unknown = [licence for licence in licences if licence not in PREFERENCE]
    if tokens or unknown:
        raise ValueError(f"a licence that nobody has looked at: {expression}; add it to PREFERENCE in {Path(__file__).name}")
    return licences


def rank(licence: str) -> int:
    return PREFERENCE.index(licence) if licence in PREFERENCE else len(PREFERENCE)


def files_of(licences: list[str], names: list[str]) -> list[str]:
    """The files of a crate with the texts of its licences and its notices; none if it has no text."""
    found: list[str] = []
    for licence in licences:
        named = [name for name in names if LICENCE_FILE.match(name) and re.search(NAMED[licence], name.lower())]
        found += named or [name for name in names if GENERAL_FILE.match(name)]
    if found:
        found += [name for name in names if NOTICE_FILE.match(name)]
    return sorted(set(found))


def standard_text(licence: str, package: Package) -> str:
    """The text for a crate that declares a licence and holds no text of it."""
    if licence == "MIT":
        authors = ", ".join(re.sub(r" <.*>", "", author) for author in package["authors"]) or "its authors"
        return mit(f"Copyright (c) {package['name']}: {authors}")
    if licence == "Apache-2.0":
        return (ROOT / "LICENSE-APACHE").read_text(encoding="utf-8")
    raise ValueError(f"{package['name']} has no text of its licence, {licence}")


def mit(copyright_line: str) -> str:
    return re.sub(r"(?m)^Copyright .*$", copyright_line, (ROOT / "LICENSE-MIT").read_text(encoding="utf-8"), count=1)


def tidy(text: str) -> str:
    lines = [line.rstrip() for line in text.replace("\f", "\n").splitlines()]
    return "\n".join(lines).strip("\n")


def texts_of(package: Package) -> list[str]:
    folder = Path(package["manifest_path"]).parent
    names = [path.name for path in folder.iterdir() if path.is_file()]
    licences = chosen(package["license"])
    files = files_of(licences, names)
    if not files:
        return [tidy(standard_text(licence, package)) for licence in licences]
    return [tidy((folder / name).read_text(encoding="utf-8")) for name in files]


def compiled_into(metadata: dict[str, Any], roots: tuple[str, ...]) -> list[Package]:
    """The crates of registries that are compiled into some crates of the workspace, on any platform."""
    packages = {package["id"]: package for package in metadata["packages"]}
    nodes = {node["id"]: node for node in metadata["resolve"]["nodes"]}
    todo = [name for name, package in packages.items() if package["name"] in roots]
    seen: set[str] = set()
    while todo:
        name = todo.pop()
        if name in seen or any("proc-macro" in target["kind"] for target in packages[name]["targets"]):
            continue
        seen.add(name)
        for dependency in nodes[name]["deps"]:
            if any(kind["kind"] is None for kind in dependency["dep_kinds"]):
                todo.append(dependency["pkg"])
    found = [packages[name] for name in seen if packages[name]["source"] is not None]
    return sorted(found, key=lambda package: (package["name"], package["version"]))


def others() -> list[tuple[str, str]]:
    """What is included beside crates: a title and a text each."""
    three = (ROOT / "crates/cdpr-view/src/assets/THREE_LICENSE.txt").read_text(encoding="utf-8")
    standard = mit("Copyright (c) The Rust Project contributors")
    more = "The notices of what the library itself includes are in share/doc/rust/COPYRIGHT-library.html of every Rust.\n\n"
    return [("three.js, in the page (MIT)", three), ("the Rust standard library (MIT OR Apache-2.0)", more + standard)]


def caspr() -> tuple[str, str]:
    text = (ROOT / "testdata/caspr/LICENSE-CASPR").read_text(encoding="utf-8")
    return "robot files that derive from CASPR (BSD-3-Clause)", text


def notices(title: str, packages: list[Package], beside: list[tuple[str, str]]) -> str:
    """The file: a list of the crates, then each text once, below the names of the crates that it is for."""
    groups: dict[str, tuple[str, list[str]]] = {}
    for package in packages:
        for text in texts_of(package):
            first, names = groups.setdefault(" ".join(text.split()), (text, []))
            names.append(f"{package['name']} {package['version']}")
    lines = [f"Third-party notices of {title}.", "", "Made by `make notices`. Other software that is included:", ""]
    lines += [f"- {name}" for name, _ in beside]
    lines += [f"- {package['name']} {package['version']} ({package['license']})" for package in packages]
    for name, text in beside:
        lines += ["", RULE, name, RULE, "", tidy(text)]
    for text, names in groups.values():
        lines += ["", RULE, *wrapped(sorted(set(names))), RULE, "", text]
    return "\n".join(lines) + "\n"


def wrapped(names: list[str]) -> list[str]:
    lines = [""]
    for name in names:
        joined = f"{lines[-1]}, {name}" if lines[-1] else name
        if len(joined) > len(RULE):
            lines[-1] += ","
            lines.append(name)
        else:
            lines[-1] = joined
    return lines


def made() -> dict[str, str]:
    """The text of each file as it should be."""
    command = ["cargo", "metadata", "--format-version", "1", "--locked"]
    run = subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True)
    metadata = json.loads(run.stdout)
    texts = {}
    for path, (title, roots) in PRODUCTS.items():
        beside = others() + ([] if path.startswith("crates/") else [caspr()])
        texts[path] = notices(title, compiled_into(metadata, roots), beside)
    return texts


def outdated() -> list[str]:
    """The files that differ from what they should be."""
    return [path for path, text in made().items() if not current(path, text)]


def current(path: str, text: str) -> bool:
    file = ROOT / path
    return file.exists() and file.read_text(encoding="utf-8") == text


def main() -> None:
    """Write the files, or check them."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="only say which files are out of date")
    if parser.parse_args().check:
        stale = outdated()
        sys.exit(f"out of date, run `make notices`: {', '.join(stale)}" if stale else 0)
    for path, text in made().items():
        (ROOT / path).write_text(text, encoding="utf-8")
        print(f"wrote {path}")


if __name__ == "__main__":
    main()
