"""Check that everything can be published as it is: `make release-check`.

Parts, each of which can be named as an argument:

- `metadata`: manifests, versions, licences, addresses; the notices are up to date
- `crates`: the crates are packed; `cargo install` builds the program from the packed crates and vendored dependencies, offline
- `wheel`: sdist and wheel are built, checked by twine, and installed into fresh environments outside the checkout, where the
  README's Python, the examples and the command run in an empty folder

Faults are listed, and end it with status 1. What nobody has decided yet (decisions.toml) is listed apart, and is no fault.
"""

import argparse
import ast
import email.message
import email.parser
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tarfile
import tomllib
import zipfile
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import decisions
import notices
import prepare
from decisions import PUBLISHED, ROOT

WORK = ROOT / "target/release-check"
SOURCE = WORK / "source"
LICENCES = ("LICENSE-MIT", "LICENSE-APACHE")
THREE = "crates/cdpr-view/src/assets/THREE_LICENSE.txt"
MOST_BYTES_OF_A_CRATE = 10 * 1024 * 1024  # crates.io refuses larger ones
EXAMPLES = ("plan_one.py",)  # those that need neither an extra nor minutes
ISOLATED = ("PYTHONPATH", "PYTHONHOME", "VIRTUAL_ENV", "CARGO_TARGET_DIR", "CDPR")


class Failed(Exception):
    """A step failed; the rest of its part cannot run."""


def run(*command: str | Path, cwd: Path, **environment: str) -> str:
    """Run a program outside of this process's Python and build; its output."""
    inherited = {key: found for key, found in os.environ.items() if key not in ISOLATED}
    done = subprocess.run(command, cwd=cwd, env=inherited | environment, capture_output=True, text=True)
    if done.returncode != 0:
        words = " ".join(map(str, command))
        raise Failed(f"status {done.returncode} of `{words[:200]}`:\n{(done.stdout + done.stderr).strip()[-3000:]}")
    return done.stdout


def say(text: str) -> None:
    print(text, flush=True)


def fresh(folder: Path) -> Path:
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


# --- metadata ---


def manifest_faults(package: dict[str, Any], readme: str) -> list[str]:
    """What crates.io or its readers would miss in a crate (an entry of `cargo metadata`)."""
    name, faults = package["name"], []
    for key in ("description", "license", "readme", "rust_version"):
        if not package[key]:
            faults.append(f"{name}: no {key}")
    if not 1 <= len(package["keywords"]) <= 5:
        faults.append(f"{name}: {len(package['keywords'])} keywords, expected 1 to 5")
    for keyword in package["keywords"]:
        if not re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9_+-]{0,19}", keyword):
            faults.append(f"{name}: keyword {keyword!r} is too long or has other characters than letters, digits, _, - and +")
    if not 1 <= len(package["categories"]) <= 5:
        faults.append(f"{name}: {len(package['categories'])} categories, expected 1 to 5")
    if "rs" not in ((package["metadata"] or {}).get("docs") or {}):
        faults.append(f"{name}: no [package.metadata.docs.rs]")
    for dependency in package["dependencies"]:
        if dependency.get("path") and dependency["kind"] != "dev" and dependency["req"] == "*":
            faults.append(f"{name}: {dependency['name']} has a path but no version")
    for target in prepare.relative_links(readme):
        faults.append(f"{name}: README.md links to {target}, which its page on crates.io does not have")
    return faults


def project_faults(project: dict[str, Any]) -> list[str]:
    """What PyPI or its readers would miss in pyproject.toml."""
    faults = [
        f"pyproject.toml: no {key}"
        for key in ("description", "readme", "requires-python", "license", "license-files", "keywords", "classifiers")
        if not project.get(key)
    ]
    classifiers = project.get("classifiers", [])
    for kind in ("Development Status", "Intended Audience", "Operating System", "Programming Language", "Topic"):
        if not any(classifier.startswith(f"{kind} :: ") for classifier in classifiers):
            faults.append(f"pyproject.toml: no classifier {kind}")
    for path in (*LICENCES, "THIRD_PARTY_NOTICES.txt", THREE):
        if path not in project.get("license-files", []):
            faults.append(f"pyproject.toml: {path} is not among the license-files")
    return faults


def version_faults(texts: dict[str, str]) -> list[str]:
    """Places that state another version than Cargo.toml."""
    manifest = tomllib.loads(texts["Cargo.toml"])
    version = manifest["workspace"]["package"]["version"]
    stated = {
        "CITATION.cff": re.findall(r"^version: (.*)$", texts["CITATION.cff"], re.MULTILINE),
        "CHANGELOG.md": re.findall(r"^## (\d\S*)", texts["CHANGELOG.md"], re.MULTILINE)[:1],
        "viewer/package.json": [json.loads(texts["viewer/package.json"])["version"]],
    }
    for name, dependency in manifest["workspace"]["dependencies"].items():
        if isinstance(dependency, dict) and "path" in dependency and "version" in dependency:
            stated[f"Cargo.toml, {name}"] = [dependency["version"]]
    return [f"{place}: version {found}, expected {version}" for place, found in stated.items() if found != [version]]


def open_ends(texts: dict[str, str]) -> list[str]:
    """What has to be changed on the day of a release and is not yet."""
    found = []
    if re.search(r"^## .*\(unreleased\)", texts["CHANGELOG.md"], re.MULTILINE | re.IGNORECASE):
        found.append("date of the release (CHANGELOG.md says unreleased; CITATION.cff: date-released)")
    return found


def check_metadata() -> Iterable[str]:
    """Faults of manifests and texts."""
    decided = decisions.load()
    yield from decisions.mistakes(decided)
    for path in decisions.not_filled_in(decided):
        yield f"{path}: does not say what release/decisions.toml says; run `make release-fill`"
    command = ("cargo", "metadata", "--format-version", "1", "--locked", "--no-deps")
    packages = {package["name"]: package for package in json.loads(run(*command, cwd=ROOT))["packages"]}
    published = sorted(name for name, package in packages.items() if package["publish"] is None)
    if published != sorted(PUBLISHED):
        yield f"crates without `publish = false`: {', '.join(published)}; expected {', '.join(sorted(PUBLISHED))}"
    for name in PUBLISHED:
        folder = Path(packages[name]["manifest_path"]).parent
        yield from manifest_faults(packages[name], (folder / "README.md").read_text(encoding="utf-8"))
        for licence in LICENCES:
            if not same(folder / licence, ROOT / licence):
                yield f"{name}: {licence} differs from that of the repository"
    pyproject = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    yield from project_faults(pyproject["project"])
    yield from version_faults(release_texts())
    for path in notices.outdated():
        yield f"{path}: out of date; run `make notices`"


def release_texts() -> dict[str, str]:
    paths = ("Cargo.toml", "CITATION.cff", "CHANGELOG.md", "viewer/package.json")
    return {path: (ROOT / path).read_text(encoding="utf-8") for path in paths}


def same(a: Path, b: Path) -> bool:
    return a.exists() and a.read_bytes() == b.read_bytes()


# --- source ---


def copy_source() -> None:
    """The files under version control, as they would be published."""
    listed = run("git", "ls-files", "-z", "--cached", "--others", "--exclude-standard", cwd=ROOT).split("\0")
    fresh(SOURCE)
    for path in filter(None, listed):
        if (ROOT / path).is_file():
            (SOURCE / path).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / path, SOURCE / path)
    prepare.prepare(SOURCE, decisions.load())


# --- crates ---


def packing_faults(name: str, files: Iterable[str], size: int) -> list[str]:
    """What is missing in a packed crate, or too much."""
    wanted = {"Cargo.toml", "Cargo.lock", "README.md", *LICENCES}
    if name == "cdpr-view":
        wanted |= {"THIRD_PARTY_NOTICES.txt", "src/assets/THREE_LICENSE.txt"}
    faults = [f"{name}: {path} is not in the packed crate" for path in sorted(wanted - set(files))]
    if size > MOST_BYTES_OF_A_CRATE:
        faults.append(f"{name}: {size} bytes packed; crates.io takes {MOST_BYTES_OF_A_CRATE}")
    return faults


def check_crates() -> Iterable[str]:
    """Pack all crates, then install the program from them and from vendored crates, as from a registry."""
    copy_source()
    version = tomllib.loads((SOURCE / "Cargo.toml").read_text(encoding="utf-8"))["workspace"]["package"]["version"]
    chosen = [word for name in PUBLISHED for word in ("-p", name)]
    say("packing the crates")
    run("cargo", "package", "--locked", "--allow-dirty", "--no-verify", *chosen, "--target-dir", WORK / "packed", cwd=SOURCE)
    registry = WORK / "registry"
    shutil.rmtree(registry, ignore_errors=True)
    run("cargo", "vendor", "--locked", "--versioned-dirs", registry, cwd=SOURCE)
    for name in PUBLISHED:
        archive = WORK / f"packed/package/{name}-{version}.crate"
        with tarfile.open(archive) as packed:
            files = [path.partition("/")[2] for path in packed.getnames()]
            packed.extractall(registry, filter="data")
        yield from packing_faults(name, files, archive.stat().st_size)
        checksum = {"files": {}, "package": hashlib.sha256(archive.read_bytes()).hexdigest()}
        (registry / f"{name}-{version}/.cargo-checksum.json").write_text(json.dumps(checksum), encoding="utf-8")
        say(f"  {archive.name}: {archive.stat().st_size / 1e3:.0f} kB, {len(files)} files")
    program = tomllib.loads((registry / f"cdpr-cli-{version}/Cargo.toml").read_text(encoding="utf-8"))
    if "release" not in program.get("profile", {}):
        yield "cdpr-cli: the packed manifest has no profile, so `cargo install` would build another than the measured one"
    say("cargo install cdpr-cli, from the packed crates, offline")
    installed, elsewhere = WORK / "installed", fresh(WORK / "empty")
    from_registry = (
        "--config", 'source.crates-io.replace-with="packed"',
        "--config", f'source.packed.directory="{registry.as_posix()}"',
    )  # fmt: skip
    install = ("install", "cdpr-cli", "--version", f"={version}", "--locked", "--offline", "--force", "--root", installed)
    run("cargo", *install, *from_registry, cwd=elsewhere, CARGO_TARGET_DIR=str(WORK / "build"))
    try_command(installed / "bin/cdpr", version, elsewhere)


def try_command(command: Path, version: str, folder: Path) -> None:
    """The first commands of a newcomer, in an empty folder."""
    found = run(command, "--version", cwd=folder)
    if version not in found:
        raise Failed(f"{command} --version says {found.strip()}, expected {version}")
    run(command, "new", "hall.toml", cwd=folder)
    run(command, "plan", "hall.toml", "-o", "path.json", "--html", "view.html", cwd=folder)
    run(command, "check", "hall.toml", "path.json", cwd=folder)
    say(f"  {found.strip()}: new, plan and check in an empty folder")


# --- wheel ---


def distribution_faults(name: str, metadata: email.message.Message, decided: dict[str, Any]) -> list[str]:
    """What is missing in the metadata of a wheel or sdist."""
    keys = ["Name", "Version", "Summary", "Description-Content-Type", "License-Expression", "Requires-Python", "Keywords"]
    keys += ["Author"] if decided["authors"] else []
    keys += ["Project-URL"] if decided["repository"] or decided["documentation"] else []
    faults = [f"{name}: no {key}" for key in keys if not metadata.get(key)]
    named = [Path(path).name for path in metadata.get_all("License-File", [])]
    for path in (*LICENCES, "THIRD_PARTY_NOTICES.txt", THREE):
        if Path(path).name not in named:
            faults.append(f"{name}: no License-File {Path(path).name}")
    if not metadata.get_payload():
        faults.append(f"{name}: no description")
    return faults


def python_blocks(markdown: str) -> list[str]:
    """The Python code of a page.

    >>> python_blocks("```python\\nx = 1\\n```\\ntext\\n```sh\\nls\\n```\\n")
    ['x = 1\\n']
    """
    return re.findall(r"^```python\n(.*?)^```$", markdown, re.MULTILINE | re.DOTALL)


def check_wheel() -> Iterable[str]:
    """Build sdist and wheel, and use both where nothing else is."""
    copy_source()
    dist, decided = fresh(WORK / "dist"), decisions.load()
    say("building sdist and wheel")
    run(sys.executable, "-m", "maturin", "sdist", "--out", dist, cwd=SOURCE)
    (sdist,) = dist.glob("*.tar.gz")
    unpacked = fresh(WORK / "sdist")
    with tarfile.open(sdist) as archive:
        archive.extractall(unpacked, filter="data")
    (folder,) = unpacked.iterdir()
    build = str(WORK / "build")
    # Not locked: the lock file also names the crates of the workspace that the sdist leaves out.
    run(sys.executable, "-m", "maturin", "build", "--profile", "dist", "--out", dist, cwd=folder, CARGO_TARGET_DIR=build)
    (wheel,) = dist.glob("*.whl")
    for file in (sdist, wheel):
        say(f"  {file.name}: {file.stat().st_size / 1e6:.1f} MB")
    run(sys.executable, "-m", "twine", "check", "--strict", sdist, wheel, cwd=dist)
    with zipfile.ZipFile(wheel) as archive:
        names = archive.namelist()
        (inside,) = [name for name in names if name.endswith(".dist-info/METADATA")]
        text = archive.read(inside).decode()
    for file, found in ((wheel, text), (sdist, (folder / "PKG-INFO").read_text(encoding="utf-8"))):
        yield from distribution_faults(file.name, email.parser.Parser().parsestr(found), decided)
    # From its folder, so that cargo reuses what it built; pip unpacks an archive into a new one each time.
    for kind, package in (("wheel", wheel), ("sdist", folder)):
        say(f"installing the {kind} into a fresh environment")
        yield from installed_faults(kind, package, build)


def installed_faults(kind: str, package: Path, build: str) -> Iterable[str]:
    """Install a package and do there what a newcomer does."""
    home = fresh(WORK / f"installed-{kind}")
    run(sys.executable, "-m", "venv", home / "env", cwd=home)
    python = home / ("env/Scripts/python" if os.name == "nt" else "env/bin/python")
    pip = (python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check")
    run(*pip, package, cwd=home, CARGO_TARGET_DIR=build)
    say(f"  {run(python, '-I', ROOT / 'release/first_steps.py', cwd=fresh(home / 'first')).strip()}")
    yield from attempt("the README's Python", lambda: run_blocks(python, fresh(home / "readme")), kind)
    for name in EXAMPLES:
        yield from attempt(f"python/examples/{name}", lambda name=name: run_example(python, name, fresh(home / "example")), kind)
    if kind == "wheel":
        for extra in ("figures", "ompl", "pandas"):
            wanted = f"cdpr[{extra}] @ {package.as_uri()}"
            yield from attempt(f"the extra {extra}", lambda wanted=wanted: run(*pip, "--dry-run", wanted, cwd=home), kind)


def attempt(what: str, action: Callable[[], Any], kind: str) -> list[str]:
    try:
        action()
    except Failed as problem:
        return [f"{kind}: {what} fails: {problem}"]
    say(f"  {what}: works")
    return []


def run_blocks(python: Path, folder: Path) -> None:
    script = "\n".join(python_blocks((ROOT / "README.md").read_text(encoding="utf-8")))
    ast.parse(script)
    run(python, "-I", "-c", script, cwd=folder)


def run_example(python: Path, name: str, folder: Path) -> None:
    shutil.copy(ROOT / "python/examples" / name, folder)
    run(python, "-I", folder / name, cwd=folder)


PARTS = {"metadata": check_metadata, "crates": check_crates, "wheel": check_wheel}


def main() -> None:
    """Run the parts, then list faults and what is to be decided."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("parts", nargs="*", metavar="part", help=f"{', '.join(PARTS)}; all of them by default")
    chosen = parser.parse_args().parts or list(PARTS)
    if unknown := set(chosen) - set(PARTS):
        parser.error(f"no part {', '.join(sorted(unknown))}")
    faults = []
    for part in chosen:
        say(f"== {part}")
        try:
            faults += list(PARTS[part]())
        except Failed as problem:
            faults.append(f"{part}: {problem}")
    pending = [*decisions.undecided(decisions.load()), *open_ends(release_texts())]
    for title, items in (("To be decided", pending), ("Faults", faults)):
        say(f"\n{title}: {len(items) or 'none'}")
        for item in items:
            say(f"- {item}")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
