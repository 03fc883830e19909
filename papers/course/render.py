"""Pages as HTML: names linked to their lines, excerpts put in, formulas as MathML (by pandoc)."""

import html
import re
import subprocess
import sys

from lesson import lessons
from page import EXCERPT, FENCE, LESSONS, PAPERS
from sources import ROOT, excerpts_in, line_of, lines_of, tests_in

sys.path.insert(0, str(ROOT / "tests"))
from pages_test import FILE, NAME, SPAN, blocks  # noqa: E402  one reading of code spans for both

STYLE = PAPERS / "course" / "style.css"


class Listings:
    """Source files shown with numbered lines, each on a page of its own."""

    def __init__(self, folder):
        self.folder = folder
        self.written = set()

    def link(self, path, line=None):
        """The address of a line, from a page in the folder above; writes the listing if new."""
        name = path.relative_to(ROOT)
        target = self.folder / f"{name}.html"
        if target not in self.written:
            self.written.add(target)
            target.parent.mkdir(parents=True, exist_ok=True)
            rows = "\n".join(f'<a id="L{i}"></a><i>{i:5}</i>  {html.escape(text)}'
                             for i, text in enumerate(lines_of(path), start=1))
            up = "../" * len(name.parts)
            target.write_text(
                f'<!doctype html><meta charset="utf-8"><title>{name}</title><style>'
                "body{font:13px/1.45 monospace;margin:1em}i{color:#888;font-style:normal}"
                ":target+i{background:#fd6;color:#000}@media(prefers-color-scheme:dark)"
                "{body{background:#16181c;color:#ddd}a{color:#8bf}}</style>"
                f'<p><a href="{up}README.html">The course</a> · {name}</p><pre>{rows}\n</pre>\n',
                encoding="utf-8")
        return f"src/{name}.html" + (f"#L{line}" if line else "")


def linked_spans(text, listings, missing, where):
    """A block with its code spans linked to files and lines; `file` is what `name` lies in."""
    file = None
    pieces, end = [], 0
    for match in SPAN.finditer(text):
        pieces.append(text[end:match.start()])
        end = match.end()
        span = " ".join(match[2].split())
        is_linked = text[match.start() - 1:match.start()] == "["
        place = None
        if span.startswith('"') and file:
            line = tests_in(file).get(span.strip('"'))
            place = (file, line) if line else None
            if not line:
                missing.append(f"{where}: no test {span} in {file.relative_to(ROOT)}")
        elif FILE.fullmatch(span) and (ROOT / span).is_file():
            file = ROOT / span
            place = (file, None) if file.suffix in {".h", ".cpp", ".py"} else None
        elif file and NAME.fullmatch(span):
            place = line_of(file, span)
            if not place:
                missing.append(f"{where}: no {span} in {file.relative_to(ROOT)}")
        shown = match[0]
        if place and not is_linked:
            path, line = place
            other = f" {path.name}" if path != file else ""
            number = f'<span class="line">{other}:{line}</span>' if line else ""
            shown = f"[{match[0]}]({listings.link(path, line)}){number}"
        pieces.append(shown)
    return "".join(pieces) + text[end:]


def prepared(page, listings, missing):
    """The page's Markdown with excerpts in and names linked."""
    def excerpt(match):
        path = ROOT / match[2]
        first, text = excerpts_in(path)[match[1]]
        last = first + text.count("\n")
        language = "python" if path.suffix == ".py" else "cpp"
        address = listings.link(path, first)
        return (f"[{match[2]}, lines {first} to {last}]({address})\n\n"
                f"```{language}\n{text}\n```")

    out, is_fenced = [], False
    lines = page.text.splitlines()
    spans = {start: block for start, block in blocks(page.text)}
    i = 0
    while i < len(lines):
        if FENCE.match(lines[i]):
            is_fenced = not is_fenced
        block = None if is_fenced else spans.get(i + 1)
        is_code = lines[i].startswith("    ") and (i == 0 or not lines[i - 1].strip())
        if block is None or is_code:
            if is_code and block is not None:
                count = block.count("\n") + 1
                out.extend(lines[i:i + count])
                i += count
                continue
            out.append(lines[i])
            i += 1
            continue
        out.append(linked_spans(block, listings, missing, f"{page.path.name}:{i + 1}"))
        i += block.count("\n") + 1
    return EXCERPT.sub(excerpt, "\n".join(out) + "\n")


def relinked(text, page, stems, listings):
    """Links between pages lead to their HTML, links to sources to their listings."""
    def target(match):
        address, hash_, anchor = match[1].partition("#")
        if re.match(r"[a-z]+:", address) or address.startswith("src/") or not address:
            return match[0]
        path = (page.path.parent / address).resolve()
        if path.parent in (PAPERS, LESSONS) and path.suffix == ".md" and path.stem in stems:
            return f'href="{path.stem}.html{hash_}{anchor}"'
        if path.parent == PAPERS / "interactive" and path.suffix == ".html":
            return f'href="interactive/{path.name}{hash_}{anchor}"'
        if path.is_file() and path.is_relative_to(ROOT) and path.suffix != ".png":
            return f'href="{listings.link(path)}"'
        if path.exists():
            return f'href="{"../" * 2}{path.relative_to(ROOT)}"'
        return match[0]
    return re.sub(r'href="([^"]+)"', target, text)


def with_words(text):
    """Words in formulas as one element each, upright or slanted as asked: browsers set letters by
    themselves, all in italics, whatever their style says."""
    word = re.compile(r'<mstyle mathvariant="(normal|italic)">((?:<mi>[A-Za-z]</mi>){2,})</mstyle>')

    def joined(match):
        style = ' style="font-style: italic"' if match[1] == "italic" else ""
        return f'<mi{style}>{re.sub("<[^>]*>", "", match[2])}</mi>'
    return word.sub(joined, text)


def navigation(page):
    """Links to the reading path and the pages that all others need."""
    places = [("README", "Index"), *((p.stem, p.stem.split("-")[0]) for p in lessons()),
              ("equations", "Equations"), ("errata", "Errata"), ("glossary", "Glossary")]
    links = [f"<b>{name}</b>" if stem == page.stem else f'<a href="{stem}.html">{name}</a>'
             for stem, name in places]
    return f"<nav>{' '.join(links)}</nav>"


def rendered(page, stems, listings, resources, missing):
    """The page as one HTML file that needs nothing else; pictures are looked for in `resources`."""
    command = ["pandoc", "--from=gfm+tex_math_dollars", "--to=html5", "--mathml", "--standalone",
               "--self-contained", f"--css={STYLE}", "--highlight-style=kate",
               f"--metadata=pagetitle:{page.title}", "--metadata=lang:en",
               f"--resource-path={':'.join(str(r) for r in resources)}"]
    done = subprocess.run(command, input=prepared(page, listings, missing), text=True,
                          capture_output=True, check=False)
    problems = [line for line in done.stderr.splitlines() if line.strip()]
    missing.extend(f"{page.path.name}: pandoc: {line}" for line in problems)
    text = relinked(with_words(done.stdout), page, stems, listings)
    return text.replace("<body>", f"<body>\n{navigation(page)}", 1)
