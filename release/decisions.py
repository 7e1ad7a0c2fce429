"""What only the owner can decide (decisions.toml), and the files that repeat it.

Every function in FILES gives the text of a file as it should be; applied twice, it changes nothing more. Run as a program,
this writes all of them.
"""

import re
import tomllib
from collections.abc import Callable
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
PUBLISHED = ("cdpr-core", "cdpr-certify", "cdpr-view", "cdpr-files", "cdpr-study", "cdpr-cli")  # in the order of publication

Decisions = dict[str, Any]

# What each key is for, in the list of what is to be decided.
KEYS = {
    "repository": "address of the repository (manifests, pyproject.toml, CITATION.cff, links of README.md on registries)",
    "documentation": "address of the documentation (pyproject.toml)",
    "security-contact": "where to report a vulnerability (SECURITY.md)",
    "conduct-contact": "where to report behaviour (CODE_OF_CONDUCT.md)",
    "joss-statements": "acknowledgements and funding (joss/paper.md)",
    "authors": "authors of cdpr (manifests, pyproject.toml, CITATION.cff, joss/paper.md)",
    "paper.authors": "full list of authors of Bak et al. (CITATION.cff, joss/paper.bib)",
    "paper.volume": "volume of Bak et al. (CITATION.cff, joss/paper.bib)",
    "paper.pages": "pages of Bak et al. (CITATION.cff, joss/paper.bib)",
}
TO_BE_DECIDED = "to be decided"


def load() -> Decisions:
    return tomllib.loads((ROOT / "release/decisions.toml").read_text(encoding="utf-8"))


def value(decisions: Decisions, key: str) -> Any:
    found: Any = decisions
    for part in key.split("."):
        found = found[part]
    return found


def undecided(decisions: Decisions) -> list[str]:
    """The keys that are empty, each with what it is for; `homepage` may stay empty."""
    return [f"{key}: {purpose}" for key, purpose in KEYS.items() if not value(decisions, key)]


def mistakes(decisions: Decisions) -> list[str]:
    """What is filled in but cannot be right."""
    found = []
    for key in ("repository", "homepage", "documentation"):
        address = decisions[key]
        if address and (not address.startswith("https://") or address.endswith("/") or " " in address):
            found.append(f"{key}: expected https://… without a slash at the end, found {address!r}")
    for key in ("authors", "paper.authors"):
        for author in value(decisions, key):
            if not author.get("family-names"):
                found.append(f"{key}: an author without family-names: {author}")
    return found


def full_name(author: dict[str, str]) -> str:
    return f"{author.get('given-names', '')} {author['family-names']}".strip()


def quoted(text: str) -> str:
    """A string of TOML, YAML or JSON."""
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'


# --- manifests ---

SHARED_KEYS = ("authors", "homepage", "repository")


def shared(decisions: Decisions) -> dict[str, str]:
    """The keys of a manifest that are decided, as TOML."""
    found = {}
    if decisions["authors"]:
        found["authors"] = f"[{', '.join(quoted(full_name(author)) for author in decisions['authors'])}]"
    for key in ("homepage", "repository"):
        if decisions[key]:
            found[key] = quoted(decisions[key])
    return found


def workspace_manifest(text: str, decisions: Decisions) -> str:
    lines = [f"{key} = {found}\n" for key, found in shared(decisions).items()]
    return after_licence(text, rf"^({'|'.join(SHARED_KEYS)}) = .*\n", r"^license = .*\n", lines)


def crate_manifest(text: str, decisions: Decisions) -> str:
    lines = [f"{key}.workspace = true\n" for key in shared(decisions)]
    return after_licence(text, rf"^({'|'.join(SHARED_KEYS)})\.workspace = true\n", r"^license\.workspace = true\n", lines)


def after_licence(text: str, old: str, licence: str, lines: list[str]) -> str:
    cleared = re.sub(old, "", text, flags=re.MULTILINE)
    return re.sub(licence, lambda found: found[0] + "".join(lines), cleared, count=1, flags=re.MULTILINE)


def pyproject(text: str, decisions: Decisions) -> str:
    text = re.sub(r"^authors = .*\n", "", text, flags=re.MULTILINE)
    if decisions["authors"]:
        names = ", ".join(f"{{ name = {quoted(full_name(author))} }}" for author in decisions["authors"])
        text = re.sub(r"^readme = .*\n", lambda found: f"{found[0]}authors = [{names}]\n", text, count=1, flags=re.MULTILINE)
    text = re.sub(r"^\[project\.urls\]\n(?:.+\n)*\n", "", text, flags=re.MULTILINE)
    urls = {"Repository": decisions["repository"], "Homepage": decisions["homepage"], "Documentation": decisions["documentation"]}
    if decisions["repository"]:
        urls["Issues"] = f"{decisions['repository']}/issues"
    lines = [f"{name} = {quoted(address)}\n" for name, address in urls.items() if address]
    section = "".join(["[project.urls]\n", *lines, "\n"]) if lines else ""
    return text.replace("[project.optional-dependencies]\n", f"{section}[project.optional-dependencies]\n")


# --- citation and paper ---


def yaml_block(text: str, key: str, block: str, before: str) -> str:
    """YAML with the top-level `key` replaced by `block`, or inserted before another key; removed if `block` is empty."""
    pattern = re.compile(rf"^{key}:.*\n(?:[ -].*\n)*", re.MULTILINE)
    if pattern.search(text):
        return pattern.sub(lambda _: block, text, count=1)
    return re.sub(rf"^{before}:", lambda found: block + found[0], text, count=1, flags=re.MULTILINE)


def person(author: dict[str, str], indent: str, keys: tuple[str, ...]) -> str:
    pairs = [f"{key}: {quoted(author[key])}" for key in keys if author.get(key)]
    return f"{indent}- " + f"\n{indent}  ".join(pairs) + "\n"


def citation(text: str, decisions: Decisions) -> str:
    keys = ("family-names", "given-names", "affiliation", "orcid")
    people = [{**author, "orcid": orcid(author)} for author in decisions["authors"]]
    authors = "".join(person(author, "  ", keys) for author in people) or "  - name: The cdpr developers\n"
    text = yaml_block(text, "authors", f"authors:\n{authors}", "license")
    repository, homepage = decisions["repository"], decisions["homepage"]
    text = yaml_block(text, "repository-code", f"repository-code: {quoted(repository)}\n" if repository else "", "license")
    text = yaml_block(text, "url", f"url: {quoted(homepage)}\n" if homepage else "", "license")
    return yaml_block(text, "references", reference(decisions["paper"]), "references")


def orcid(author: dict[str, str]) -> str:
    return f"https://orcid.org/{author['orcid']}" if author.get("orcid") else ""


def reference(paper: Decisions) -> str:
    """The paper whose method cdpr implements, for CITATION.cff."""
    people = "".join(person(author, "      ", ("family-names", "given-names")) for author in paper["authors"])
    people = people or '      - family-names: Bak\n        given-names: J.-H.\n      - name: "and others"\n'
    lines = [
        "references:\n  - type: article\n",
        "    title: Collision-free path planning of cable-driven parallel robots in cluttered environments\n",
        f"    authors:\n{people}",
        "    journal: Intelligent Service Robotics\n",
        "    year: 2019\n",
    ]
    if paper["volume"]:
        lines.append(f"    volume: {quoted(paper['volume'])}\n")
    if paper["pages"]:
        first, last = re.split(r"\s*[-–]+\s*", paper["pages"], maxsplit=1)
        lines.append(f"    start: {quoted(first)}\n    end: {quoted(last)}\n")
    return "".join([*lines, "    doi: 10.1007/s11370-019-00278-7\n"])


def bibliography(text: str, decisions: Decisions) -> str:
    """paper.bib with the entry of Bak et al. as far as it is known."""
    paper = decisions["paper"]
    names = " and ".join(f"{author['family-names']}, {author.get('given-names', '')}" for author in paper["authors"])
    fields = {
        "author": names or "Bak, J.-H. and others",
        "title": "Collision-free path planning of cable-driven parallel robots in cluttered environments",
        "journal": "Intelligent Service Robotics",
        "year": "2019",
        "volume": paper["volume"],
        "pages": re.sub(r"\s*[-–]+\s*", "--", paper["pages"]),
        "doi": "10.1007/s11370-019-00278-7",
    }
    lines = [f"  {key} = {{{found}}},\n" for key, found in fields.items() if found]
    entry = "".join(["@article{bak2019,\n", *lines, "}\n"])
    return re.sub(r"^@article\{bak2019,\n(?:  .*\n)*\}\n", lambda _: entry, text, flags=re.MULTILINE)


def joss(text: str, decisions: Decisions) -> str:
    """paper.md with its authors and affiliations."""
    people, places = decisions["authors"], []
    for author in people:
        if author.get("affiliation") and author["affiliation"] not in places:
            places.append(author["affiliation"])
    text = marked("joss-statements")(text, decisions)
    authors = "".join(
        f"  - name: {quoted(full_name(author))}\n"
        + (f"    orcid: {author['orcid']}\n" if author.get("orcid") else "")
        + (f"    affiliation: {places.index(author['affiliation']) + 1}\n" if author.get("affiliation") else "")
        for author in people
    )
    affiliations = "".join(f"  - name: {quoted(place)}\n    index: {index}\n" for index, place in enumerate(places, 1))
    nobody = f"  - name: {TO_BE_DECIDED}\n    affiliation: 1\n"
    nowhere = f"  - name: {TO_BE_DECIDED}\n    index: 1\n"
    text = yaml_block(text, "authors", f"authors:\n{authors or nobody}", "date")
    return yaml_block(text, "affiliations", f"affiliations:\n{affiliations or nowhere}", "date")


# --- texts ---


def marked(key: str) -> Callable[[str, Decisions], str]:
    """A text that names a decision between `<!-- key -->` and `<!-- end -->`."""

    def fill(text: str, decisions: Decisions) -> str:
        found = decisions[key] or TO_BE_DECIDED
        return re.sub(rf"<!-- {key} -->.*?<!-- end -->", f"<!-- {key} -->{found}<!-- end -->", text)

    return fill


FILES: dict[str, Callable[[str, Decisions], str]] = {
    "Cargo.toml": workspace_manifest,
    **{f"crates/{name}/Cargo.toml": crate_manifest for name in PUBLISHED},
    "pyproject.toml": pyproject,
    "CITATION.cff": citation,
    "joss/paper.md": joss,
    "joss/paper.bib": bibliography,
    "SECURITY.md": marked("security-contact"),
    "CODE_OF_CONDUCT.md": marked("conduct-contact"),
}


def not_filled_in(decisions: Decisions) -> list[str]:
    """The files that differ from what the decisions say."""
    texts = {path: (ROOT / path).read_text(encoding="utf-8") for path in FILES}
    return [path for path, fill in FILES.items() if fill(texts[path], decisions) != texts[path]]


def main() -> None:
    """Write the decisions to all files that repeat them."""
    decisions = load()
    if found := mistakes(decisions):
        raise SystemExit("\n".join(found))
    for path in not_filled_in(decisions):
        file = ROOT / path
        file.write_text(FILES[path](file.read_text(encoding="utf-8"), decisions), encoding="utf-8")
        print(f"wrote {path}")


if __name__ == "__main__":
    main()
