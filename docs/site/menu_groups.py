"""The menu's groups open and close: a caption of docs/index.md and the pages below it. Open is the one that has the page, else the first."""

import re


def fold(app, pagename, templatename, context, doctree) -> None:
    before, *groups = re.split(r'<p class="caption"[^>]*><span class="caption-text">(.*?)</span></p>', context.get("furo_navigation_tree", ""))
    named = list(zip(groups[::2], groups[1::2]))
    opened = next((at for at, (_, pages) in enumerate(named) if "current-page" in pages), 0)
    context["furo_navigation_tree"] = before + "".join(
        f'<details{" open" if at == opened else ""}><summary class="caption">{name}</summary>{pages}</details>'
        for at, (name, pages) in enumerate(named))


def setup(app):
    app.connect("html-page-context", fold, priority=900)  # after furo
    return {"parallel_read_safe": True, "parallel_write_safe": True}
