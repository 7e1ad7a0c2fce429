"""Pages are plain Markdown that reads well on GitHub; this turns them into pages of the site.

- A page that is a title and a link to a Markdown file outside of docs shows that file; links to the file lead to the page.
- Links to other files outside of docs become downloads, and those to folders and pages that the site does not have, plain text.
- What only the site has stands in comments: `<!-- site: ... -->`.
- The lists of the index, one below each heading, are the site's table of contents.
"""

import os
import re
from pathlib import Path

LINK = re.compile(r"(!?)\[([^\]]*)\]\(([^)\s#:]+)(#[^)\s]*)?\)")
STAND_IN = re.compile(r"# .*\n\n\[[^\]]*\]\((\.\./[^)\s#]+\.md)\)\n")
FENCED = re.compile(r"(^```.*?^```$)", re.MULTILINE | re.DOTALL)
SITE_ONLY = re.compile(r"<!-- site: (.*?) -->")
LISTED = re.compile(r"^## (.+)\n\n((?:- .*\n)+)", re.MULTILINE)


def stand_ins(source: Path) -> dict[Path, Path]:
    """Files outside of docs, by the page that shows them."""
    pages = {}
    for page in source.rglob("*.md"):
        if found := STAND_IN.fullmatch(page.read_text(encoding="utf-8")):
            pages[page] = (page.parent / found[1]).resolve()
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


def with_contents(index: str) -> str:
    """The index with a hidden table of contents below each of its lists."""

    def toctree(found: re.Match[str]) -> str:
        pages = "\n".join(target for _, _, target, _ in LINK.findall(found[2]))
        return f"{found[0]}\n```{{toctree}}\n:hidden:\n:caption: {found[1]}\n\n{pages}\n```\n"

    return LISTED.sub(toctree, index)


def setup(app):
    source = Path(app.srcdir)
    shown = stand_ins(source)
    pages = {file: page for page, file in shown.items()}

    def on_read(app, docname, content):
        page = source / f"{docname}.md"
        file = shown.get(page, page)
        text = content[0] if file == page else file.read_text(encoding="utf-8")
        text = SITE_ONLY.sub(r"\1", rebase(text, file.parent, page, source, pages))
        if file != page:
            app.env.note_dependency(str(file))
        content[0] = with_contents(text) if docname == app.config.root_doc else text

    app.connect("source-read", on_read)
    return {"parallel_read_safe": True}
