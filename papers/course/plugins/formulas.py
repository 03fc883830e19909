"""Formulas set by KaTeX while the site is built, with its fonts beside the pages; no script sets
any in the browser. Debian's packages katex and libjs-katex have both."""

import json
import os
import shutil
import subprocess
from pathlib import Path

from docutils import nodes
from sphinx.util import logging

PROGRAM = Path(__file__).with_suffix(".cjs")
KATEX = Path("/usr/share/javascript/katex")
LICENCE = Path("/usr/share/doc/libjs-katex/copyright")

logger = logging.getLogger(__name__)


class Typesetter:
    """A process of Node.js that sets formulas as long as it is asked to."""

    def __init__(self):
        self.process = subprocess.Popen(
            ["node", PROGRAM], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
            encoding="utf-8", env={**os.environ, "NODE_PATH": "/usr/share/nodejs"})

    def html(self, tex, display=False):
        """Raises ValueError if it is no formula that KaTeX knows."""
        self.process.stdin.write(json.dumps({"tex": tex, "display": display}) + "\n")
        self.process.stdin.flush()
        reply = json.loads(self.process.stdout.readline())
        if "error" in reply:
            raise ValueError(reply["error"])
        return reply["html"]

    def close(self):
        self.process.stdin.close()
        self.process.stdout.close()
        self.process.wait()


def typeset(translator, node, display):
    app = translator.builder.app
    if not hasattr(app, "typesetter"):
        app.typesetter = Typesetter()
    try:
        return app.typesetter.html(node.astext(), display)
    except ValueError as error:
        logger.error("%s", error, location=node)
        return ""


def visit_inline(translator, node):
    translator.body.append(typeset(translator, node, False))
    raise nodes.SkipNode


def visit_display(translator, node):
    html = typeset(translator, node, True)
    translator.body.append(f'<div class="formula" tabindex="0">{html}</div>\n')
    raise nodes.SkipNode


def finish(app, error):
    if hasattr(app, "typesetter"):
        app.typesetter.close()
        del app.typesetter
    if error:
        return
    static = Path(app.outdir) / "_static" / "katex"
    (static / "fonts").mkdir(parents=True, exist_ok=True)
    for file in (KATEX / "katex.min.css", LICENCE):
        shutil.copyfile(file, static / file.name)
    for font in sorted((KATEX / "fonts").glob("*.woff2")):
        shutil.copyfile(font, static / "fonts" / font.name)


def setup(app):
    app.add_html_math_renderer("katex", (visit_inline, None), (visit_display, None))
    app.connect("build-finished", finish)
    return {"parallel_read_safe": True}
