#!/usr/bin/env python3
"""Sphinx's plug-ins of the course (papers/course/plugins), on a small site of their own. Takes
Debian's Sphinx, MyST and furo (cmake/pages_packages.txt)."""

import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from support.plain_tests import run_all

ROOT = Path(__file__).resolve().parent.parent
COURSE = ROOT / "papers" / "course"
INDEX = "# Index\n\n## The path\n\n| page |\n|---|\n| [one](one.md) |\n"
PLAY = "[![How far do the discs go?](figures/play.png)](interactive/discs.html)"
PIXEL = bytes.fromhex(
    "89504e470d0a1a0a0000000d49484452000000010000000108060000001f15c4890000000d49444154789c63f8cfc0"
    "f01f0005000201fe5a0e0b0000000049454e44ae426082")


def site(page, parts=("discs",), index=INDEX):
    """(exit code, complaints, the built page) of an index and one page."""
    with tempfile.TemporaryDirectory() as folder:
        source, out = Path(folder) / "papers", Path(folder) / "out"
        for name in ("figures", "interactive"):
            (source / name).mkdir(parents=True)
        (source / "README.md").write_text(index, encoding="utf-8")
        (source / "one.md").write_text(f"# One\n\n{page}\n", encoding="utf-8")
        (source / "figures" / "play.png").write_bytes(PIXEL)
        for name in parts:
            (source / "interactive" / f"{name}.html").write_text("<p>Discs", encoding="utf-8")
        done = subprocess.run(
            [sys.executable, "-m", "sphinx", "-q", "-E", "-W", "--keep-going", "-b", "html",
             "-c", COURSE, source, out], capture_output=True, text=True, check=False,
            env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"})
        built = out / "one.html"
        text = built.read_text(encoding="utf-8") if built.exists() else ""
        copied = sorted(p.name for p in (out / "interactive").glob("*"))
        article = re.search(r"<article.*?</article>", text, re.DOTALL)
        return done.returncode, done.stderr, text, article[0] if article else "", copied


def test_a_picture_that_links_to_a_part_becomes_a_frame():
    code, complaints, _, article, copied = site(PLAY)
    assert code == 0, complaints
    frame = re.search(r"<iframe[^>]*>", article)[0]
    assert 'loading="lazy"' in frame and 'src="interactive/discs.html"' in frame
    assert 'title="How far do the discs go?"' in frame
    # The picture stays, as a link to the part, for paper and where no script runs.
    picture = article[article.index("interactive-picture"):]
    assert re.search(r'href="interactive/discs.html"[^>]*><img alt="How far', picture)
    assert copied == ["discs.html"]


def test_the_state_of_a_part_goes_along():
    article = site(PLAY.replace("discs.html", "discs.html#r=2&w=0"))[3]
    assert 'src="interactive/discs.html#r=2&amp;w=0"' in article


def test_a_part_that_is_not_there_ends_the_build():
    code, complaints, *_ = site(PLAY, parts=())
    assert code != 0 and "no interactive part interactive/discs.html" in complaints


def test_other_pictures_stay_pictures():
    for page in (f"See {PLAY}.", "![Discs](figures/play.png)",
                 "[![Discs](figures/play.png)](README.md)"):
        code, complaints, _, article, _ = site(page)
        assert code == 0, complaints
        assert "<iframe" not in article and "<img" in article


def test_formulas_are_set_and_bad_ones_refused():
    code, complaints, _, article, _ = site("Where $r < 2$:\n\n$$\\frac{1}{\\rho} .$$")
    assert code == 0, complaints
    assert article.count('class="katex-html"') == 2 and 'class="katex-display"' in article
    code, complaints, *_ = site("Where $\\nosuchthing$ is.")
    assert code != 0 and "nosuchthing" in complaints


def test_the_sidebar_has_the_pages_of_the_index_and_a_page_not_on_it_fails():
    text = site("Text.")[2]
    assert "The path" in text and '<li class="toctree-l1' in text
    assert "rel=\"prev\"" in text
    assert site("[two](two.md)")[0] != 0
    without = INDEX.replace("[one](one.md)", "one")
    assert site("Text.", index=f"{without}\n## More\n\nRead [one](one.md) too.\n")[0] == 0
    code, complaints, *_ = site("Text.", index=without)
    assert code != 0 and "isn't included in any toctree" in complaints


def test_names_lead_to_their_lines():
    article = site("The `certify/sizing.h`: `edge_ratio`.")[3]
    assert re.search(r'href="src/certify/sizing.h.html#L-\d+"', article)


if __name__ == "__main__":
    sys.exit(run_all(globals()))
