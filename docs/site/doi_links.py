"""`doi:10.1103/PhysRev.159.98` in a text is a link to the paper."""

import re

from docutils import nodes
from sphinx.transforms import SphinxTransform

DOI = re.compile(r"doi:(10\.\d+/[^\s,;]*[^\s,;.:])")
LEAVE_ALONE = (nodes.reference, nodes.literal, nodes.literal_block, nodes.raw)


def inside(node, kinds) -> bool:
    return node is not None and (isinstance(node, kinds) or inside(node.parent, kinds))


def without_foreign_brackets(doi: str) -> str:
    """A bracket that the DOI does not open belongs to the sentence, with what follows it."""
    depth = 0
    for at, letter in enumerate(doi):
        depth += (letter == "(") - (letter == ")")
        if depth < 0:
            return doi[:at]
    return doi


def linked(text: str) -> list:
    parts, done = [], 0
    for found in DOI.finditer(text):
        doi = without_foreign_brackets(found[1])
        end = found.start(1) + len(doi)
        parts += [nodes.Text(text[done:found.start()]), nodes.reference("", f"doi:{doi}", refuri=f"https://doi.org/{doi}")]
        done = end
    return [*parts, nodes.Text(text[done:])]


class DoiLinks(SphinxTransform):
    default_priority = 700

    def apply(self, **kwargs) -> None:
        for text in [each for each in self.document.findall(nodes.Text) if "doi:10." in each]:
            if not inside(text.parent, LEAVE_ALONE):
                text.parent.replace(text, linked(text.astext()))


def setup(app):
    app.add_transform(DoiLinks)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
