"""The sidebar: papers/README.md says which pages there are and in which order, its tables first.

The links to neighbours under a page's title serve who reads the Markdown; the site has its own.
"""

import re

from docutils import nodes
from sphinx.transforms import SphinxTransform

PAGE = re.compile(r"\]\((?!\w+:)([\w./-]+)\.md\)")


def parts(index):
    """By heading of the index, the pages that its part leads to and no earlier one does."""
    found, seen = {}, set()
    for part in re.split(r"^## ", index, flags=re.MULTILINE)[1:]:
        heading = part.splitlines()[0]
        rows = [line for line in part.splitlines() if line.startswith("|")]
        others = [line for line in part.splitlines() if not line.startswith("|")]
        links = PAGE.findall("\n".join(rows + others))
        found[heading] = [p for p in dict.fromkeys(links) if p not in seen]
        seen.update(links)
    return {heading: pages for heading, pages in found.items() if pages}


def add_contents(app, docname, source):
    if docname != app.config.root_doc:
        return
    for heading, pages in parts(source[0]).items():
        lines = "\n".join(pages)
        source[0] += f"\n\n```{{toctree}}\n:hidden:\n:caption: {heading}\n\n{lines}\n```\n"


class WithoutNeighbours(SphinxTransform):
    default_priority = 210

    def apply(self, **options):
        first = next(self.document.findall(nodes.paragraph), None)
        if first is not None and " · " in first.astext() and len(first.children) > 2:
            first.parent.remove(first)


def setup(app):
    app.connect("source-read", add_contents)
    app.add_transform(WithoutNeighbours)
    return {"parallel_read_safe": True}
