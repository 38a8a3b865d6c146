"""Links to files of the repository: the site has a page for each file that a document links to.

A document links to a deck, a header or a folder as on the repository's own pages, by a relative path. The site stands alone, on any host or
on a disk: so the file becomes a page of it, `files/inputs/verlet1967/argon-864.toml.html`, and a folder a list of its files.
"""

import html
import posixpath
import subprocess
from pathlib import Path

from docutils import nodes
from sphinx import addnodes
from sphinx.transforms import SphinxTransform
from sphinx.util import logging

logger = logging.getLogger(__name__)

ROOT = Path(__file__).resolve().parents[2]
LANGUAGES = {".cpp": "cpp", ".hpp": "cpp", ".py": "python", ".toml": "toml", ".sh": "sh", ".cff": "yaml", ".json": "json"}
# Documents of the repository that stand outside of docs/, and their pages.
PAGES = {"CONTRIBUTING.md": "site/contributing", "CHANGELOG.md": "site/changelog", "README.md": "index"}
# Pages that include documents of the repository, whose links are those of the document.
ORIGINS = {"site/contributing": "CONTRIBUTING.md", "site/changelog": "CHANGELOG.md", "site/first-deck": "README.md"}


def tracked_files() -> list[str]:
    """Git's, and new ones that it does not ignore."""
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-z", "--cached", "--others", "--exclude-standard"], check=True,
                            capture_output=True).stdout.decode()
    return sorted(name for name in set(listed.split("\0")) if name and (ROOT / name).is_file())


def origin(env) -> str:
    """The document of the repository that the page shows."""
    return ORIGINS.get(env.docname) or f"docs/{env.doc2path(env.docname, base=False)}"


class RepositoryLinks(SphinxTransform):
    """Gives links of Markdown that lead to the repository their pages; the others are MyST's."""

    default_priority = 50

    def apply(self, **kwargs) -> None:
        kinds = (addnodes.pending_xref, addnodes.download_reference)
        for node in [each for each in self.document.findall() if isinstance(each, kinds) and each.get("reftype") == "myst"]:
            path, _, anchor = node["reftarget"].partition("#")
            here = origin(self.env)
            if not path.endswith(".png"):  # pictures stay what they are
                self.resolve(node, posixpath.normpath(posixpath.join(posixpath.dirname(here), path)) if path else here, anchor)

    def resolve(self, node, path: str, anchor: str) -> None:
        page = PAGES.get(path) or self.page_of(path)
        if page is not None and anchor and f'<a id="{anchor}">' in (ROOT / path).read_text(encoding="utf-8"):
            node.replace_self(nodes.reference("", "", *node.children, internal=True, refuri="", place_in_page=(page, anchor)))
        elif page is not None:
            there = posixpath.relpath(self.env.doc2path(page, base=False), posixpath.dirname(self.env.docname) or ".")
            link = addnodes.pending_xref("", *node.children, refdoc=self.env.docname, reftype="myst", refdomain=None, refwarn=True,
                                         reftarget=there + (f"#{anchor}" if anchor else ""), refexplicit=True)
            link.source, link.line = node.source, node.line
            node.replace_self(link)
        elif (ROOT / path).exists():
            linked_files(self.env).setdefault(self.env.docname, set()).add(path)
            node.replace_self(nodes.reference("", "", *node.children, internal=True, refuri="", repository_file=path))
        else:
            logger.warning("no file %s in the repository", path, location=node, type="ref")

    def page_of(self, path: str):
        """The document of the site that a file is; a folder is its README."""
        for name in (path, f"{path}/README.md"):
            docname = posixpath.splitext(name.removeprefix("docs/"))[0]
            if name.startswith("docs/") and docname in self.env.found_docs:
                return docname
        return None


def linked_files(env) -> dict:
    if not hasattr(env, "repository_files"):
        env.repository_files = {}
    return env.repository_files


def forget(app, env, docname) -> None:
    linked_files(env).pop(docname, None)


def merge(app, env, docnames, other) -> None:
    linked_files(env).update(linked_files(other))


def page_name(path: str) -> str:
    return f"files/{path}"


def place(app, doctree, docname) -> None:
    for node in doctree.findall(nodes.reference):
        if "repository_file" in node:
            node["refuri"] = app.builder.get_relative_uri(docname, page_name(node["repository_file"]))
        elif "place_in_page" in node:
            page, anchor = node["place_in_page"]
            node["refuri"] = f"{app.builder.get_relative_uri(docname, page)}#{anchor}"


def file_pages(app):
    """A page for each linked file, and for each file of a linked folder."""
    linked = set().union(*linked_files(app.env).values()) if linked_files(app.env) else set()
    tracked = tracked_files()
    folders = {path for path in linked if (ROOT / path).is_dir()}
    inside = {path: [name for name in tracked if name.startswith(f"{path}/")] for path in folders}
    for path, names in inside.items():
        rows = "".join(f'<li><a href="{app.builder.get_relative_uri(page_name(path), page_name(name))}">'
                       f"{html.escape(name.removeprefix(path + '/'))}</a></li>" for name in names)
        yield page_name(path), {"title": f"{path}/", "body": f"<h1>{html.escape(path)}/</h1><ul>{rows}</ul>"}, "page.html"
    for path in (linked - folders).union(*inside.values()):
        text = (ROOT / path).read_text(encoding="utf-8")
        code = app.builder.highlighter.highlight_block(text, LANGUAGES.get(Path(path).suffix, "text"))
        yield page_name(path), {"title": path, "body": f"<h1>{html.escape(path)}</h1>{code}"}, "page.html"


def setup(app):
    app.add_transform(RepositoryLinks)
    app.connect("env-purge-doc", forget)
    app.connect("env-merge-info", merge)
    app.connect("doctree-resolved", place)
    app.connect("html-collect-pages", file_pages)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
