"""Pictures that a page's own commands have made take the place of the kept ones."""

import os
from pathlib import Path

from docutils import nodes
from sphinx.transforms import SphinxTransform


class MadePictures(SphinxTransform):
    default_priority = 215

    def apply(self, **options):
        page = Path(self.env.doc2path(self.env.docname))
        box = Path(self.config.made_pictures) / page.stem / "papers"
        for image in self.document.findall(nodes.image):
            kept = (page.parent / image["uri"]).resolve()
            made = box / os.path.relpath(kept, self.env.srcdir)
            if made.is_file():
                image["uri"] = os.path.relpath(made, page.parent)


def setup(app):
    app.add_config_value("made_pictures", "", "env")
    app.add_transform(MadePictures)
    return {"parallel_read_safe": True}
