"""Sphinx's configuration: the pages of papers/ as a site (papers/course/build.py runs it)."""

import sys
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parent), str(Path(__file__).parent / "plugins")]

from anchors import github_anchor  # noqa: E402
from page import SOLUTIONS  # noqa: E402

project = "morskin"
language = "en"
root_doc = "README"
include_patterns = ["*.md", "lessons/*.md"]
if not tags.has("student"):  # noqa: F821  Sphinx gives it
    include_patterns.append(f"{SOLUTIONS.name}/*.md")

extensions = ["myst_parser", "without_solutions", "sidebar", "sources_shown", "made_pictures",
              "interactive", "formulas", "theme"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
myst_heading_slug_func = github_anchor
suppress_warnings = ["myst.header"]  # pages may begin a part with any depth of heading

html_theme = "furo"
html_title = "Skin triangulation, a course"
html_math_renderer = "katex"
html_static_path = ["static"]
html_css_files = ["katex/katex.min.css", "site.css"]
html_js_files = ["frames.js"]
html_copy_source = False
html_show_copyright = False
html_show_search_summary = False  # would be fetched, which browsers refuse from a file
html_use_index = False
highlight_language = "text"
pygments_style = "tango"
pygments_dark_style = "github-dark"
