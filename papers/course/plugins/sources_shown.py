"""The sources in the site: each file that a page names, with numbered lines, as a page of its own.

- A code span that names a file, or a thing or a test in the file named before it, becomes a link
  to its line (the same reading as tests/pages_test.py).
- `[excerpt: NAME](FILE)`, alone in its paragraph, becomes the lines between the marks.
- Links to files of the project lead to their listings.
- The course for students has no listings with answers; what would lead there is plain text.
"""

import os
import sys
from pathlib import Path

from docutils import nodes
from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import get_lexer_for_filename
from pygments.lexers.special import TextLexer
from pygments.util import ClassNotFound
from sources import ROOT, excerpts_in, line_of, tests_in
from sphinx import addnodes
from sphinx.transforms import SphinxTransform
from student import is_hidden

sys.path.insert(0, str(ROOT / "tests"))
from pages_test import FILE, NAME  # noqa: E402  one reading of code spans for both

LINKS = (addnodes.download_reference, addnodes.pending_xref)
LANGUAGES = {".py": "python", ".h": "cpp", ".cpp": "cpp"}


class SourcesShown(SphinxTransform):
    default_priority = 230

    def apply(self, **options):
        self.page = Path(self.env.doc2path(self.env.docname))
        for link in list(self.document.findall(lambda node: isinstance(node, LINKS))):
            self.show_target(link)
        for block in self.blocks():
            self.link_names(block)

    def blocks(self):
        """What one file name is about: a table's row, else a paragraph or heading."""
        rows = list(self.document.findall(nodes.row))
        inside = {id(node) for row in rows for node in row.findall(nodes.TextElement)}
        texts = [node for node in self.document.findall(nodes.TextElement)
                 if isinstance(node, (nodes.paragraph, nodes.title)) and id(node) not in inside]
        return rows + texts

    def is_listed(self, path):
        return not (self.app.tags.has("student") and is_hidden(path))

    def link(self, path, line, *children):
        """A link to a line of a file, which gets a listing."""
        listed = self.app.builder.listed
        listed.add(path)
        up = "../" * self.env.docname.count("/")
        anchor = f"#L-{line}" if line else ""
        return nodes.reference("", "", *children, internal=True,
                               refuri=f"{up}{listing_of(path)}.html{anchor}")

    def show_target(self, link):
        path = (self.page.parent / link["reftarget"].partition("#")[0]).resolve()
        if not path.is_file() or not path.is_relative_to(ROOT):
            return
        if path.suffix == ".md" and self.env.path2doc(str(path)) in self.env.found_docs:
            return
        if not self.is_listed(path):
            link.replace_self(link.children)
            return
        name = link.astext().removeprefix("excerpt: ")
        if name != link.astext() and len(link.parent.children) == 1:
            link.parent.replace_self(self.excerpt(path, name))
        else:
            link.replace_self(self.link(path, None, *link.children))

    def excerpt(self, path, name):
        first, text = excerpts_in(path)[name]
        label = f"{path.relative_to(ROOT)}, lines {first} to {first + text.count(chr(10))}"
        code = nodes.literal_block(text, text, language=LANGUAGES[path.suffix])
        return [nodes.paragraph("", "", self.link(path, first, nodes.Text(label)),
                                classes=["excerpt"]), code]

    def link_names(self, block):
        file = None
        for span in list(block.findall(nodes.literal)):
            name = " ".join(span.astext().split())
            place = None
            if name.startswith('"') and file:
                place = file, tests_in(file)[name.strip('"')]
            elif FILE.fullmatch(name) and (ROOT / name).is_file():
                file = ROOT / name
                place = (file, None) if file.suffix in LANGUAGES else None
            elif file and NAME.fullmatch(name):
                place = line_of(file, name)
            is_in_link = isinstance(span.parent.parent, (nodes.reference, *LINKS))
            if place and self.is_listed(place[0]) and not is_in_link:
                self.put_link(span, place, file)

    def put_link(self, span, place, file):
        path, line = place
        parts = [self.link(path, line, span.deepcopy())]
        if line:
            other = f" {path.name}" if path != file else ""
            parts.append(nodes.inline("", f"{other}:{line}", classes=["line"]))
        span.parent.replace(span, parts)


def listing_of(path):
    return f"src/{path.relative_to(ROOT)}"


def listings(app):
    """A page for each file that a link leads to."""
    for path in sorted(app.builder.listed):
        try:
            lexer = get_lexer_for_filename(path.name)
        except ClassNotFound:
            lexer = TextLexer()
        style = HtmlFormatter(linenos="inline", lineanchors="L", anchorlinenos=True)
        name = path.relative_to(ROOT)
        code = highlight(path.read_text(encoding="utf-8"), lexer, style)
        body = f'<h1>{os.sep.join(name.parts)}</h1>\n<div class="listing">{code}</div>'
        yield listing_of(path), {"title": str(name), "body": body}, "page.html"


def setup(app):
    app.connect("builder-inited", lambda app: setattr(app.builder, "listed", set()))
    app.add_transform(SourcesShown)
    app.connect("html-collect-pages", listings)
    return {"parallel_read_safe": False}
