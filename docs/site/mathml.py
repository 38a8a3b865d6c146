"""Formulas as MathML, which browsers draw by themselves: no script, no download, nothing to install.

What docutils makes of them is mended: it reads \\frac32 as 32 over what follows, lets every angle bracket grow to the highest part of the
line, and puts wide spaces around / and |.
"""

import re

from docutils import nodes
from docutils.utils.math.latex2mathml import tex2mathml


def mathml(tex: str, inline: bool) -> str:
    tex = re.sub(r"\\frac(\d)(\d)", r"\\frac{\1}{\2}", tex)
    for name, bracket in (("langle", "⟨"), ("rangle", "⟩")):
        tex = re.sub(rf"(?<!\\left)(?<!\\right)\\{name}\b", rf"\\text{{{bracket}}}", tex)
    found = tex2mathml(tex, inline=inline)
    found = re.sub("<mtext>([⟨⟩])</mtext>", r'<mo stretchy="false">\1</mo>', found)
    return re.sub('<mo stretchy="false">([/|])</mo>', r'<mo stretchy="false" lspace="0" rspace="0">\1</mo>', found)


def visit_inline(writer, node: nodes.math) -> None:
    writer.body.append(mathml(node.astext(), inline=True))
    raise nodes.SkipNode


def visit_display(writer, node: nodes.math_block) -> None:
    writer.body.append(f'<div class="formula">{mathml(node.astext(), inline=False)}</div>')
    raise nodes.SkipNode


def setup(app):
    app.add_html_math_renderer("mathml", inline_renderers=(visit_inline, None), block_renderers=(visit_display, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
