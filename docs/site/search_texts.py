"""The text of all pages for the search, in one script: a page on a disk may not read others to show what it found in them.

_static/search_scorer.js orders and shows what was found by it.
"""

import json
from pathlib import Path

from docutils import nodes
from sphinx import addnodes

SCRIPT = "page_texts.js"
FORMULAS = (nodes.math, nodes.math_block)
HIDDEN = (nodes.comment, nodes.raw, nodes.system_message, addnodes.desc_parameterlist)


def words(node) -> str:
    if isinstance(node, nodes.Text):
        return node.astext()
    if isinstance(node, FORMULAS):
        return " \u2026 "
    if isinstance(node, HIDDEN):
        return " "
    gap = "" if isinstance(node, nodes.TextElement) else " "
    return gap.join(map(words, node.children))


def text_of(section) -> str:
    """Without its title and its subsections; code comes last, because a sentence is the better excerpt."""
    parts = [child for child in section.children[1:] if not isinstance(child, nodes.section)]
    parts.sort(key=lambda child: isinstance(child, nodes.literal_block))
    return " ".join(" ".join(map(words, parts)).split())


def texts(env) -> dict:
    if not hasattr(env, "page_texts"):
        env.page_texts = {}
    return env.page_texts


def read(app, doctree) -> None:
    """[anchor, heading, text] of each section."""
    texts(app.env)[app.env.docname] = [[section["ids"][0], section.next_node(nodes.title).astext(), text_of(section)]
                                       for section in doctree.findall(nodes.section)]


def forget(app, env, docname) -> None:
    texts(env).pop(docname, None)


def merge(app, env, docnames, other) -> None:
    texts(env).update({name: texts(other)[name] for name in docnames if name in texts(other)})


def add_script(app, pagename, templatename, context, doctree) -> None:
    if pagename == "search":
        app.add_js_file(SCRIPT)


def write(app, exception) -> None:
    if exception is None and app.builder.format == "html":
        text = json.dumps(dict(sorted(texts(app.env).items())), ensure_ascii=False, separators=(",", ":"))
        (Path(app.outdir) / "_static" / SCRIPT).write_text(f"const PAGE_TEXTS = {text};\n", encoding="utf-8")


def setup(app):
    app.connect("doctree-read", read)
    app.connect("env-purge-doc", forget)
    app.connect("env-merge-info", merge)
    app.connect("html-page-context", add_script)
    app.connect("build-finished", write)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
