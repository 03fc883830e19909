"""Interactive parts: a picture, alone in its paragraph, that links to a page of interactive/,

    [![The question](../figures/play-NAME.png)](../interactive/NAME.html)

becomes a frame with that page, loaded when it comes into sight. The pages that can be had are in
the folder interactive_parts, by default interactive/ beside the Markdown. Where the Markdown itself
is read, on paper, and without scripts there is the picture, with its link.
"""

import html
import os
import shutil
from pathlib import Path

from docutils import nodes
from sphinx import addnodes
from sphinx.transforms import SphinxTransform

FOLDER = "interactive"
LINKS = (addnodes.download_reference, addnodes.pending_xref)  # to what exists, or does not


def picture_in(paragraph):
    """(link, image) if a paragraph is one picture in a link, else None."""
    images, texts = [list(paragraph.findall(kind)) for kind in (nodes.image, nodes.Text)]
    is_one = len(paragraph.children) == 1 and isinstance(paragraph[0], LINKS)
    return (paragraph[0], images[0]) if is_one and len(images) == 1 and not texts else None


class Frames(SphinxTransform):
    """Replaces such paragraphs; a part that is not there is an error of the build."""
    default_priority = 220

    def apply(self, **options):
        page = Path(self.env.doc2path(self.env.docname))
        folder = Path(self.env.srcdir) / FOLDER
        parts = parts_folder(self.app)
        for paragraph in list(self.document.findall(nodes.paragraph)):
            found = picture_in(paragraph)
            if not found:
                continue
            link, image = found
            path, hash_, state = link["reftarget"].partition("#")
            part = (page.parent / path).resolve()
            if part.parent != folder.resolve():
                continue
            src = html.escape(os.path.relpath(part, page.parent) + hash_ + state)
            title = html.escape(image.get("alt", ""))
            frame = (f'<iframe class="interactive" loading="lazy" src="{src}" title="{title}">'
                     f'</iframe>')
            fallback = nodes.paragraph(classes=["interactive-picture"])
            fallback += nodes.reference("", "", image.deepcopy(), refuri=src, internal=True)
            alone = nodes.paragraph(classes=["interactive-link"])
            alone += nodes.reference("", "On a page of its own", refuri=src, internal=True)
            paragraph.replace_self([nodes.raw("", frame, format="html"), fallback, alone])
            if not (parts / part.name).is_file():
                self.document.reporter.error(f"no interactive part {link['reftarget']}",
                                             line=paragraph.line)


def parts_folder(app):
    return Path(app.config.interactive_parts or Path(app.srcdir) / FOLDER)


def copy_parts(app, error):
    folder = parts_folder(app)
    if error or not folder.is_dir():
        return
    (Path(app.outdir) / FOLDER).mkdir(exist_ok=True)
    for part in sorted(folder.glob("*.html")):
        shutil.copyfile(part, Path(app.outdir) / FOLDER / part.name)


def setup(app):
    app.add_config_value("interactive_parts", "", "html")
    app.add_transform(Frames)
    app.connect("build-finished", copy_parts)
    return {"parallel_read_safe": True}
