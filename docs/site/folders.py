"""The page of a folder, its README.md, is the parent of the pages of the folder that it links to, in their order: the site's menu has them
below it. Those in folders below come last.

So Markdown in the repository needs no list of pages for Sphinx.
"""

import posixpath
import re


def add_pages_of_the_folder(app, docname: str, source: list) -> None:
    folder, name = posixpath.split(docname)
    if name != "README":
        return
    linked = re.findall(r"\]\(([\w/-]+)\.(?:md|ipynb)(?:#[^)]*)?\)", source[0])
    pages = [page for page in sorted(dict.fromkeys(linked), key=lambda page: page.count("/")) if posixpath.join(folder, page) in app.env.found_docs]
    source[0] += "\n\n```{toctree}\n:hidden:\n\n" + "\n".join(pages) + "\n```\n"


def setup(app):
    app.connect("source-read", add_pages_of_the_folder)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
