"""The documentation site: built without warning, every link inside it leads somewhere, its search knows its words and shows them, and
what stands in boxes fits.
"""

import html
import html.parser
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import urllib.parse

ROOT = pathlib.Path(__file__).resolve().parents[2]
WIDTH = 117  # characters in a box of a window of 1280 pixels


class Page(html.parser.HTMLParser):
    """Links and places of a page."""

    def __init__(self, path: pathlib.Path):
        super().__init__()
        self.links, self.places = [], set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.places.update(attributes[key] for key in ("id", "name") if attributes.get(key))
        if tag in ("a", "img", "link", "script"):
            self.links += [attributes[key] for key in ("href", "src") if attributes.get(key)]


def check_links(site: pathlib.Path) -> int:
    pages = {path: Page(path) for path in site.rglob("*.html")}
    wrong, checked = [], 0
    for path, page in pages.items():
        for link in page.links:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme or parts.netloc:
                continue
            there = (path.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else path
            checked += 1
            if not there.exists():
                wrong.append(f"{path.relative_to(site)}: {link}")
            elif parts.fragment and there in pages and urllib.parse.unquote(parts.fragment) not in pages[there].places:
                wrong.append(f"{path.relative_to(site)}: {link}: no such place")
    assert not wrong, "\n".join(wrong[:20])
    return checked


def check_search(site: pathlib.Path) -> None:
    """Sphinx cuts words to their stems."""
    index = (site / "searchindex.js").read_text(encoding="utf-8")
    for word in ("verlet", "barostat", "lindemann"):
        assert re.search(rf"\b{word}\b", index), f"the search does not know {word}"
    for name in ("run_in_directory", "to_dataframe"):
        assert name in index, f"the search does not know {name}"
    texts = json.loads((site / "_static/page_texts.js").read_text(encoding="utf-8").removeprefix("const PAGE_TEXTS = ").rstrip(";\n"))
    headings = {heading: text for _, heading, text in texts["structure"]}
    assert "coordination number" in headings["Radial distribution"], "the search has no text for its excerpts"


def check_boxes(site: pathlib.Path) -> None:
    """Tables and drawings in boxes are not wrapped; code is."""
    for path in sorted(site.rglob("*.html")):
        page = path.read_text(encoding="utf-8")
        for box in [] if "files" in path.relative_to(site).parts else re.findall(r'<div class="highlight-(?:text|none) .*?</pre>', page, re.S):
            for line in html.unescape(re.sub(r"<[^>]*>", "", box)).splitlines():
                assert len(line) <= WIDTH, f"{path.relative_to(site)}: wider than the page: {line}"


def check_formulas(site: pathlib.Path) -> None:
    """No page has a formula as it was typed."""
    for path in sorted(site.glob("*.html")):
        text = re.sub(r"<pre>.*?</pre>|<code.*?</code>", "", path.read_text(encoding="utf-8"), flags=re.S)
        assert not re.search(r"\$\\?[A-Za-z]", text), f"{path.name}: a formula is shown as text"


def main() -> int:
    missing = [program for program in ("sphinx-build", "doxygen") if shutil.which(program) is None]
    if missing:
        print(f"skipped: no {', '.join(missing)}")
        return 77
    with tempfile.TemporaryDirectory() as temporary:
        site = pathlib.Path(temporary) / "site"
        environment = {**os.environ, "LJMD_SETUP": "skip", "PYTHONDONTWRITEBYTECODE": "1"}
        done = subprocess.run([ROOT / "tools/docs", "--out", site], env=environment, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout + done.stderr
        assert done.stderr == "", done.stderr
        print(f"{check_links(site)} links inside the site lead somewhere")
        check_search(site)
        check_boxes(site)
        check_formulas(site)
    return 0


if __name__ == "__main__":
    sys.exit(main())
