"""Notebooks as pages: their text and code. They are stored without outputs; the page says how to run them."""

import json

from docutils import nodes
from myst_parser.parsers.sphinx_ import MystParser

NOTE = """\
```{{note}}
This is the notebook `docs/notebooks/{name}.ipynb`, stored without its results. [Notebooks](README.md) says how to run it.
```
"""


def markdown(notebook: dict, name: str) -> str:
    parts = []
    for cell in notebook["cells"]:
        source = "".join(cell["source"])
        parts.append(source if cell["cell_type"] == "markdown" else f"```python\n{source}\n```")
    title, _, rest = parts[0].partition("\n")
    return "\n\n".join([title, NOTE.format(name=name), rest, *parts[1:]])


class NotebookParser(MystParser):
    supported = ("notebook",)

    def parse(self, inputstring: str, document: nodes.document) -> None:
        name = document.settings.env.docname.rpartition("/")[2]
        super().parse(markdown(json.loads(inputstring), name), document)


def setup(app):
    app.add_source_suffix(".ipynb", "notebook")
    app.add_source_parser(NotebookParser)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
