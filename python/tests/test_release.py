"""The checks of a release, on examples; what they say of this checkout is tested where it needs no build."""

import email.parser
import shutil
import sys
import tomllib

import pytest
from conftest import ROOT

sys.path.insert(0, str(ROOT / "release"))

import check
import decisions
import notices
import prepare

EMPTY = {
    "repository": "", "homepage": "", "documentation": "", "security-contact": "", "conduct-contact": "",
    "joss-statements": "", "authors": [], "paper": {"authors": [], "volume": "", "pages": ""},
}  # fmt: skip
DECIDED = {
    "repository": "https://host.example/cdpr",
    "homepage": "https://cdpr.example",
    "documentation": "https://docs.example/cdpr",
    "security-contact": "security@host.example",
    "conduct-contact": "conduct@host.example",
    "joss-statements": "We thank nobody.",
    "authors": [
        {"given-names": "Ada", "family-names": "First", "affiliation": "Institute of Examples", "orcid": "0000-0000-0000-0000"},
        {"given-names": "Ben \"B\"", "family-names": "Second", "affiliation": "Institute of Examples"},
    ],
    "paper": {"authors": [{"given-names": "J.", "family-names": "Doe"}], "volume": "1", "pages": "2–3"},
}  # fmt: skip


def texts() -> dict[str, str]:
    return {path: (ROOT / path).read_text(encoding="utf-8") for path in decisions.FILES}


def test_what_is_empty_is_to_be_decided_and_nothing_else():
    assert len(decisions.undecided(EMPTY)) == len(decisions.KEYS)
    assert decisions.undecided(DECIDED) == []
    assert decisions.undecided(DECIDED | {"homepage": ""}) == []
    assert [line.partition(":")[0] for line in decisions.undecided(DECIDED | {"authors": []})] == ["authors"]


def test_an_address_that_cannot_be_right_is_a_mistake():
    assert decisions.mistakes(DECIDED) == decisions.mistakes(EMPTY) == []
    assert len(decisions.mistakes(DECIDED | {"repository": "host.example/cdpr/", "authors": [{"given-names": "Ada"}]})) == 2


@pytest.mark.parametrize("path", decisions.FILES)
def test_a_decision_is_written_once_and_can_be_taken_back(path):
    fill = decisions.FILES[path]
    empty = fill(texts()[path], EMPTY)
    decided = fill(empty, DECIDED)
    assert decided != empty
    assert fill(decided, DECIDED) == decided
    assert fill(decided, EMPTY) == empty


def test_manifests_with_decisions_are_valid():
    filled = {path: decisions.FILES[path](text, DECIDED) for path, text in texts().items()}
    package = tomllib.loads(filled["Cargo.toml"])["workspace"]["package"]
    assert package["authors"] == ["Ada First", 'Ben "B" Second']
    assert package["repository"] == DECIDED["repository"] and package["homepage"] == DECIDED["homepage"]
    for name in decisions.PUBLISHED:
        crate = tomllib.loads(filled[f"crates/{name}/Cargo.toml"])["package"]
        assert crate["repository"] == crate["authors"] == crate["homepage"] == {"workspace": True}
    project = tomllib.loads(filled["pyproject.toml"])["project"]
    assert project["authors"] == [{"name": "Ada First"}, {"name": 'Ben "B" Second'}]
    assert set(project["urls"]) == {"Repository", "Homepage", "Documentation", "Issues"}
    assert project["optional-dependencies"]["figures"]
    assert "security@host.example" in filled["SECURITY.md"] and "conduct@host.example" in filled["CODE_OF_CONDUCT.md"]


def test_citation_and_paper_name_authors_and_pages():
    filled = {path: decisions.FILES[path](text, DECIDED) for path, text in texts().items()}
    assert 'orcid: "https://orcid.org/0000-0000-0000-0000"' in filled["CITATION.cff"]
    assert "The cdpr developers" not in filled["CITATION.cff"]
    assert '    start: "2"\n    end: "3"\n' in filled["CITATION.cff"]
    assert "  pages = {2--3},\n" in filled["joss/paper.bib"] and "author = {Doe, J.}" in filled["joss/paper.bib"]
    assert filled["joss/paper.md"].count("Institute of Examples") == 1
    assert filled["joss/paper.md"].count("    affiliation: 1\n") == 2
    assert decisions.TO_BE_DECIDED not in filled["joss/paper.md"]


def test_every_reference_of_the_paper_is_in_its_bibliography():
    paper, bibliography = texts()["joss/paper.md"], texts()["joss/paper.bib"]
    cited = set(check.re.findall(r"@(\w+)[\];]", paper))
    assert cited == set(check.re.findall(r"^@\w+\{(\w+),$", bibliography, check.re.MULTILINE))


def test_the_files_say_what_is_decided():
    assert decisions.not_filled_in(decisions.load()) == []


@pytest.mark.parametrize(
    ("expression", "licences"),
    [
        ("MIT OR Apache-2.0", ["MIT"]),
        ("Unlicense/MIT", ["MIT"]),
        ("(Apache-2.0 OR MIT) AND BSD-3-Clause", ["MIT", "BSD-3-Clause"]),
        ("Apache-2.0 WITH LLVM-exception OR Apache-2.0 OR MIT", ["MIT"]),
        ("MIT OR Apache-2.0 OR LGPL-2.1-or-later", ["MIT"]),
        ("Apache-2.0 OR BSL-1.0", ["Apache-2.0"]),
    ],
)
def test_of_a_choice_one_licence_is_taken(expression, licences):
    assert notices.chosen(expression) == licences


@pytest.mark.parametrize("expression", ["GPL-3.0-only", "MIT AND MPL-2.0", "Apache-2.0 WITH LLVM-exception"])
def test_a_licence_that_nobody_has_looked_at_is_refused(expression):
    with pytest.raises(ValueError, match="nobody has looked at"):
        notices.chosen(expression)


def test_the_texts_of_a_crate_are_those_of_its_licence_and_its_notices():
    both = ["LICENSE-APACHE", "LICENSE-MIT", "README.md", "COPYRIGHT"]
    assert notices.files_of(["MIT"], both) == ["COPYRIGHT", "LICENSE-MIT"]
    assert notices.files_of(["Zlib"], ["LICENSE", "NOTICE"]) == ["LICENSE", "NOTICE"]
    assert notices.files_of(["MIT"], ["LICENSE.md", "LICENSE-APACHE"]) == ["LICENSE.md"]
    assert notices.files_of(["MIT"], ["README.md", "COPYRIGHT"]) == []


def crate(folder, name, text):
    (folder / name).mkdir()
    if text:
        (folder / name / "LICENSE").write_text(text)
    manifest = str(folder / name / "Cargo.toml")
    return {"name": name, "version": "1.0.0", "license": "MIT", "authors": ["Zoe <z@z>"], "manifest_path": manifest}


def test_a_text_stands_once_below_all_crates_that_it_is_for(tmp_path):
    crates = [crate(tmp_path, "a", "One\ntext."), crate(tmp_path, "b", "One text. \n"), crate(tmp_path, "c", "")]
    found = notices.notices("things", crates, [("a font", "Another text.")])
    assert found.count("One\ntext.") == 1 and "One text." not in found
    assert f"{notices.RULE}\na 1.0.0, b 1.0.0\n{notices.RULE}\n\nOne\ntext.\n" in found
    assert "- a font\n- a 1.0.0 (MIT)\n" in found and "Another text." in found
    assert "Copyright (c) c: Zoe\n" in found and "Permission is hereby granted" in found


def test_only_what_is_compiled_in_is_listed():
    def package(name, source, kind):
        return {"id": name, "name": name, "version": "1.0.0", "source": source, "targets": [{"kind": [kind]}]}

    def node(name, **needs):
        return {"id": name, "deps": [{"pkg": other, "dep_kinds": [{"kind": kind}]} for other, kind in needs.items()]}

    names = ["program", "used", "deeper", "tested", "builds", "macros", "inmacro"]
    packages = [package(name, None if name == "program" else "registry", "proc-macro" if name == "macros" else "lib") for name in names]
    nodes = [node("program", used=None, tested="dev", builds="build", macros=None), node("used", deeper=None), node("macros", inmacro=None)]
    nodes += [node(name) for name in ("deeper", "tested", "builds", "inmacro")]
    metadata = {"packages": packages, "resolve": {"nodes": nodes}}
    assert [found["name"] for found in notices.compiled_into(metadata, ("program",))] == ["deeper", "used"]


@pytest.mark.skipif(shutil.which("cargo") is None, reason="needs cargo")
def test_the_notices_are_up_to_date():
    assert notices.outdated() == [], "run `make notices`"


def test_links_of_a_published_page_are_absolute():
    text = "[![a](a.png)](docs/b.md#c) [d](https://d.example) [e](#e) [f](mailto:f@f.example) `[g]`"
    assert prepare.relative_links(text) == ["a.png", "docs/b.md#c"]
    found = prepare.absolute_links(text, "https://host.example/x", "1.2.3")
    picture, page = "https://host.example/x/raw/v1.2.3/a.png", "https://host.example/x/blob/v1.2.3/docs/b.md#c"
    assert found == text.replace("a.png", picture).replace("docs/b.md#c", page)
    assert prepare.relative_links(found) == []


def test_the_published_program_has_the_profile_that_is_measured():
    manifest = {
        "profile": {
            "release": {
                "opt-level": 1,
                "lto": "off",
                "package": {"a": {"opt-level": 0, "codegen-units": 16}, "b": {"opt-level": 3}, "z": {"lto": "fat"}},
            },
            "dist": {"inherits": "release", "opt-level": 3, "debug": "line-tables-only", "package": {"a": {"opt-level": 3}}},
        }
    }
    profile = prepare.effective_profile(manifest, {"a", "b"})
    assert profile == {"opt-level": 3, "lto": "off", "package": {"a": {"codegen-units": 16}}}
    assert tomllib.loads(prepare.as_toml(profile)) == {"profile": {"release": profile}}


def test_the_crates_of_a_program_are_those_of_the_lock_file():
    lock = {"package": [{"name": "a", "dependencies": ["b 1.0.0"]}, {"name": "b", "dependencies": ["c"]}, {"name": "c"}, {"name": "d"}]}
    assert prepare.crates_below("a", lock) == {"a", "b", "c"}


GOOD_CRATE = {
    "name": "a", "description": "d", "license": "MIT", "readme": "README.md", "rust_version": "1.90", "keywords": ["robotics"],
    "categories": ["science"], "metadata": {"docs": {"rs": {}}},
    "dependencies": [{"name": "b", "path": "/b", "kind": None, "req": "^1"}, {"name": "t", "path": "/t", "kind": "dev", "req": "*"}],
}  # fmt: skip


@pytest.mark.parametrize(
    ("change", "fault"),
    [
        ({"description": None}, "a: no description"),
        ({"keywords": list("abcdef")}, "a: 6 keywords, expected 1 to 5"),
        ({"keywords": ["a keyword"]}, "a: keyword 'a keyword' is too long or has other characters than letters, digits, _, - and +"),
        ({"categories": []}, "a: 0 categories, expected 1 to 5"),
        ({"metadata": None}, "a: no [package.metadata.docs.rs]"),
        ({"dependencies": [{"name": "b", "path": "/b", "kind": None, "req": "*"}]}, "a: b has a path but no version"),
    ],
)
def test_a_crate_that_lacks_something_is_named(change, fault):
    assert check.manifest_faults(GOOD_CRATE, "[a](https://a.example)") == []
    assert check.manifest_faults(GOOD_CRATE | change, "") == [fault]


def test_a_readme_of_a_crate_has_no_relative_links():
    assert check.manifest_faults(GOOD_CRATE, "[a](../a.md)") == ["a: README.md links to ../a.md, which its page on crates.io does not have"]


def test_a_packed_crate_has_its_licences():
    files = ["Cargo.toml", "Cargo.lock", "README.md", "LICENSE-MIT", "LICENSE-APACHE"]
    assert check.packing_faults("cdpr-core", files, 1000) == []
    assert check.packing_faults("cdpr-core", files[:-1], 1000) == ["cdpr-core: LICENSE-APACHE is not in the packed crate"]
    assert len(check.packing_faults("cdpr-view", files, 20_000_000)) == 3


def test_versions_agree_or_are_named():
    dependency = '[workspace.package]\nversion = "1.0.0"\n[workspace.dependencies]\na = { path = "a", version = "1.0.0" }\nb = { path = "b" }\n'
    places = {
        "Cargo.toml": dependency, "CITATION.cff": "version: 1.0.0\n", "CHANGELOG.md": "## 1.0.0 (unreleased)\n## 0.9.0\n",
        "viewer/package.json": '{"version": "1.0.0"}',
    }  # fmt: skip
    assert check.version_faults(places) == []
    assert len(check.open_ends(places)) == 1 and check.open_ends(places | {"CHANGELOG.md": "## 1.0.0 (2026-01-01)\n"}) == []
    older = dependency.replace('a", version = "1.0.0', 'a", version = "0.9.0')
    assert check.version_faults(places | {"Cargo.toml": older}) == ["Cargo.toml, a: version ['0.9.0'], expected 1.0.0"]
    assert len(check.version_faults(places | {"CITATION.cff": "", "CHANGELOG.md": "## 0.9.0\n"})) == 2


def test_metadata_of_a_wheel_is_complete_or_what_is_missing_is_named():
    lines = ["Name: cdpr", "Version: 1", "Summary: s", "Description-Content-Type: text/markdown", "License-Expression: MIT"]
    lines += ["Requires-Python: >=3.11", "Keywords: k", *(f"License-File: {name}" for name in (*check.LICENCES, check.THREE))]
    lines += ["License-File: THIRD_PARTY_NOTICES.txt", "", "# cdpr"]

    def faults(kept, decided):
        return check.distribution_faults("w", email.parser.Parser().parsestr("\n".join(kept)), decided)

    assert faults(lines, EMPTY) == []
    assert faults(lines, DECIDED) == ["w: no Author", "w: no Project-URL"]
    assert faults(lines[1:], EMPTY) == ["w: no Name"]
    assert faults([*lines[:-3], "", "text"], EMPTY) == ["w: no License-File THIRD_PARTY_NOTICES.txt"]


@pytest.mark.skipif(shutil.which("cargo") is None, reason="needs cargo")
def test_the_manifests_of_this_checkout_are_complete():
    assert list(check.check_metadata()) == []


def test_the_readme_has_python_to_try():
    assert check.python_blocks((ROOT / "README.md").read_text(encoding="utf-8"))
