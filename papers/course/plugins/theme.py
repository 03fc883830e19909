"""What Debian 12 leaves out of furo: normalize.css, which its style asks a web server for, the dark
colours of browsers that ask for them, and the bundling of its two scripts."""

import re
from pathlib import Path

NORMALIZE = Path("/usr/share/javascript/normalize.css/normalize.css")
STYLE_IMPORT = "@import url(/javascript/normalize.css/normalize.css);"
DARK = re.compile(r'body\[data-theme="dark"\] \{\n(\s*--[^}]*)\}')
SCRIPT_IMPORT = 'import Gumshoe from "./gumshoe-patched.js";'


def mended_style(style):
    """Raises ValueError if it is not the style that this is for."""
    dark = DARK.search(style)
    if STYLE_IMPORT not in style or not dark:
        raise ValueError("furo.css is not as Debian 12 has it")
    return (style.replace(STYLE_IMPORT, NORMALIZE.read_text(encoding="utf-8"))
            + "\n@media not print { @media (prefers-color-scheme: dark) {\n"
            + f'  body:not([data-theme="light"]) {{\n{dark[1]}}} }} }}\n')


def mended_script(script, imported):
    """Raises ValueError if it is not the script that this is for."""
    if SCRIPT_IMPORT not in script:
        raise ValueError("furo.js is not as Debian 12 has it")
    return imported + script.replace(SCRIPT_IMPORT, "")


def mend(app, error):
    if error:
        return
    static = Path(app.outdir) / "_static"
    style, script = static / "styles" / "furo.css", static / "scripts" / "furo.js"
    gumshoe = script.with_name("gumshoe-patched.js")
    style.write_text(mended_style(style.read_text(encoding="utf-8")), encoding="utf-8")
    script.write_text(mended_script(script.read_text(encoding="utf-8"),
                                    gumshoe.read_text(encoding="utf-8")), encoding="utf-8")
    gumshoe.unlink()


def setup(app):
    app.connect("build-finished", mend)
    return {"parallel_read_safe": True}
