"""Turn a checkout into what is published. It changes files: run it on a copy, or in a workflow.

- README.md gets absolute links, since the pages of registries have no other files; only if the repository's address is decided.
- The manifest of cdpr-cli gets the profile that is measured, `dist`, as its `release`, so that `cargo install` builds it: for a crate
  from a registry, Cargo ignores the profiles of the workspace. In the workspace itself, Cargo would warn about it.
"""

import re
import sys
import tomllib
from pathlib import Path
from typing import Any

from decisions import ROOT

PROGRAM = "crates/cdpr-cli/Cargo.toml"
LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s]+)\)")


def relative_links(text: str) -> list[str]:
    """The targets of links and pictures that lead nowhere without the other files."""
    targets = []
    for found in LINK.finditer(text):
        targets += relative_links(found[2]) + [found[3]]  # a link may hold a picture
    return [target for target in targets if is_relative(target)]


def is_relative(target: str) -> bool:
    return not re.match(r"[a-z]+:|#", target)


def absolute_links(text: str, repository: str, version: str) -> str:
    """Markdown whose links lead to the files of a version in the repository.

    >>> absolute_links("[a](docs/a.md) ![b](b.png) [c](https://c)", "https://host/x", "1.0.0")
    '[a](https://host/x/blob/v1.0.0/docs/a.md) ![b](https://host/x/raw/v1.0.0/b.png) [c](https://c)'
    """

    def replaced(found: re.Match[str]) -> str:
        picture, label, target = found.groups()
        if is_relative(target):
            target = f"{repository}/{'raw' if picture else 'blob'}/v{version}/{target}"
        return f"{picture}[{LINK.sub(replaced, label)}]({target})"

    return LINK.sub(replaced, text)


def effective_profile(manifest: dict[str, Any], crates: set[str]) -> dict[str, Any]:
    """The profile `dist` without inheritance, with what it sets for some of the crates; debug information is for developers."""
    release, dist = manifest["profile"]["release"], manifest["profile"]["dist"]
    profile = {key: found for key, found in (release | dist).items() if key not in ("inherits", "package", "debug")}
    packages = [release.get("package", {}), dist.get("package", {})]
    for name in sorted(packages[0] | packages[1]):
        settings = packages[0].get(name, {}) | packages[1].get(name, {})
        differing = {key: found for key, found in settings.items() if profile.get(key) != found}
        if name in crates and differing:
            profile.setdefault("package", {})[name] = differing
    return profile


def as_toml(profile: dict[str, Any]) -> str:
    """The profile as sections of a manifest."""
    plain = {key: found for key, found in profile.items() if key != "package"}
    lines = ["[profile.release]", *(f"{key} = {literal(found)}" for key, found in plain.items())]
    if "package" in profile:
        lines += ["", "[profile.release.package]"]
        for name, settings in profile["package"].items():
            lines.append(f"{name} = {{ {', '.join(f'{key} = {literal(found)}' for key, found in settings.items())} }}")
    return "\n".join(lines) + "\n"


def literal(found: bool | int | str) -> str:
    if isinstance(found, bool):
        return str(found).lower()
    return str(found) if isinstance(found, int) else f'"{found}"'


def prepare(root: Path, decisions: dict[str, Any]) -> None:
    """Change the files of a checkout."""
    manifest = tomllib.loads((root / "Cargo.toml").read_text(encoding="utf-8"))
    lock = tomllib.loads((root / "Cargo.lock").read_text(encoding="utf-8"))
    program = root / PROGRAM
    text = program.read_text(encoding="utf-8")
    if "[profile.release]" not in text:
        profile = effective_profile(manifest, crates_below("cdpr-cli", lock))
        program.write_text(f"{text}\n# As the workspace's `dist`.\n{as_toml(profile)}", encoding="utf-8")
    if decisions["repository"]:
        readme = root / "README.md"
        version = manifest["workspace"]["package"]["version"]
        linked = absolute_links(readme.read_text(encoding="utf-8"), decisions["repository"], version)
        readme.write_text(linked, encoding="utf-8")


def crates_below(root: str, lock: dict[str, Any]) -> set[str]:
    """The names of a crate and all that it depends on, also only in tests, by the lock file."""
    depends: dict[str, set[str]] = {}
    for package in lock["package"]:
        names = {dependency.split()[0] for dependency in package.get("dependencies", [])}
        depends.setdefault(package["name"], set()).update(names)
    found, todo = set(), [root]
    while todo:
        name = todo.pop()
        if name not in found:
            found.add(name)
            todo += depends[name]
    return found - {"cdpr-tests"}


def main() -> None:
    """Change this checkout."""
    if sys.argv[1:] != ["--here"]:
        raise SystemExit(f"{__doc__}\n`--here` changes this checkout.")
    from decisions import load

    prepare(ROOT, load())


if __name__ == "__main__":
    main()
