"""Sphinx's settings for the documentation site. tools/docs calls it: sphinx-build -c docs/site docs build/docs."""

import importlib.util
import os
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(HERE))

project = "ljmd"
author = "The ljmd developers"
copyright = "the ljmd developers; licence GPL-3.0-or-later"
root_doc = "index"
language = "en"
exclude_patterns = ["site/*.py", "**/__pycache__", "paper"]  # the paper is for a journal

extensions = ["myst_parser", "sphinx.ext.autodoc", "breathe", "code_lines", "doi_links", "folders", "furo_of_debian", "mathml",
              "menu_groups", "notebook_pages", "python_docstrings", "repository_files", "search_texts"]

# Markdown: formulas between dollars, links to headings.
source_suffix = {".md": "markdown"}
myst_enable_extensions = ["dollarmath", "colon_fence"]
myst_heading_anchors = 4
myst_dmath_double_inline = True
suppress_warnings = ["myst.header",  # a page may begin with a picture or skip a level
                     "ref.python"]   # a class is known by its module's name, too

# The Python package, from its sources: the engine, which would have to be built, is left out, and ASE where it is not installed. All that
# is documented is in Python.
sys.path.insert(0, str(ROOT / "python"))
autodoc_mock_imports = ["ljmd._core"] + ([] if importlib.util.find_spec("ase") else ["ase"])
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
add_module_names = False
default_role = "literal"

# The C++ library: Doxygen's XML, made by tools/docs.
breathe_projects = {"ljmd": os.environ.get("LJMD_DOXYGEN_XML", str(ROOT / "build/doxygen/xml"))}
breathe_default_project = "ljmd"

html_theme = "furo"
html_title = "ljmd"
html_static_path = ["_static"]
html_css_files = ["ljmd.css"]
html_search_scorer = str(HERE / "search_scorer.js")
html_copy_source = False
html_show_sphinx = False
html_math_renderer = "mathml"
# Debian's furo has lost the rules for browsers that ask for a dark page: these are its own dark colours, with another blue.
DARK = {
    "color-problematic": "#ee5151",
    "color-foreground-primary": "#ffffffcc",
    "color-foreground-secondary": "#9ca0a5",
    "color-foreground-muted": "#81868d",
    "color-foreground-border": "#666666",
    "color-background-primary": "#131416",
    "color-background-secondary": "#1a1c1e",
    "color-background-hover": "#1e2124ff",
    "color-background-hover--transparent": "#1e212400",
    "color-background-border": "#303335",
    "color-background-item": "#444",
    "color-announcement-background": "#000000dd",
    "color-announcement-text": "#eeebee",
    "color-brand-primary": "#56b4e9",
    "color-brand-content": "#7cc4ee",
    "color-highlighted-background": "#083563",
    "color-guilabel-background": "#08356380",
    "color-guilabel-border": "#13395f80",
    "color-api-keyword": "var(--color-foreground-secondary)",
    "color-highlight-on-target": "#333300",
    "color-admonition-background": "#18181a",
    "color-card-border": "var(--color-background-secondary)",
    "color-card-background": "#18181a",
    "color-card-marginals-background": "var(--color-background-hover)",
}
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#005b8f", "color-brand-content": "#0072b2"},
    "dark_css_variables": DARK,
}
pygments_style = "friendly"
pygments_dark_style = "native"
