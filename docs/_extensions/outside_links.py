"""Pages are plain Markdown that reads well beside the code; its links are turned here into those of the site.

A page that consists of an `{include}` of a file outside of docs stands for that file. Links to it lead to the page, links
to other files become downloads, and links to folders and pages that the site does not have, plain text.
"""

import os
import re
from pathlib import Path

LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^)\s#:]+)(#[^)\s]*)?\)")
INCLUDE = re.compile(r"^```\{include\} (\S+)", re.MULTILINE)
FENCED = re.compile(r"(^```.*?^```$)", re.MULTILINE | re.DOTALL)


def stand_ins(source: Path) -> dict[Path, Path]:
    """Files outside of docs, by the page that includes them."""
    pages = {}
    for page in source.rglob("*.md"):
        if found := INCLUDE.search(page.read_text(encoding="utf-8")):
            pages[(page.parent / found[1]).resolve()] = page
    return pages


def rebase(text: str, folder: Path, page: Path, source: Path, pages: dict[Path, Path]) -> str:
    """`text`, written for `folder`, with links as they must be on `page`."""

    def link(found: re.Match[str]) -> str:
        picture, words, target, anchor = found.groups()
        path = (folder / target).resolve()
        path = pages.get(path, path)
        if path.is_dir() or (path.suffix == ".md" and source not in path.parents):
            return words
        return f"{picture}[{words}]({os.path.relpath(path, page.parent)}{anchor or ''})"

    pieces = FENCED.split(text)
    return "".join(piece if piece.startswith("```") else LINK.sub(link, piece) for piece in pieces)


def setup(app):
    source = Path(app.srcdir)
    pages = stand_ins(source)

    def page(docname: str) -> Path:
        return source / f"{docname}.md"

    def on_read(app, docname, content):
        content[0] = rebase(content[0], page(docname).parent, page(docname), source, pages)

    def on_include(app, path, docname, content):
        file = (source / path).resolve()  # MyST's docname lacks the folder
        content[0] = rebase(content[0], file.parent, pages[file], source, pages)

    app.connect("source-read", on_read)
    app.connect("include-read", on_include)
    return {"parallel_read_safe": True}
