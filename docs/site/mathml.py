"""Formulas as MathML, which browsers draw by themselves: no script, no download, nothing to install.

What docutils makes of them is mended: it reads \\frac32 as 32 over what follows, takes ' for a letter, lets every angle bracket grow to the
highest part of the line, puts wide spaces around / and |, and none beside names of functions.
"""

import re

from docutils import nodes
from docutils.utils.math.latex2mathml import tex2mathml


def mathml(tex: str, inline: bool) -> str:
    tex = re.sub(r"\\frac(\d)(\d)", r"\\frac{\1}{\2}", tex)
    tex = re.sub("'+", lambda primes: "^{" + r"\prime" * len(primes[0]) + "}", tex)
    for name, bracket in (("langle", "⟨"), ("rangle", "⟩")):
        tex = re.sub(rf"(?<!\\left)(?<!\\right)\\{name}\b", rf"\\text{{{bracket}}}", tex)
    found = tex2mathml(tex, inline=inline)
    found = re.sub("<mtext>([⟨⟩])</mtext>", r'<mo stretchy="false">\1</mo>', found)
    found = re.sub(r"<mo>&ApplyFunction;</mo>(?!\s*<mo[^>]*>\()", '<mo rspace="0.17em">&ApplyFunction;</mo>', found)
    found = re.sub(r"(?<=</mi>|</mn>)(?=\s*<mi>\w+</mi>\s*<mo[^>]*>&ApplyFunction)", '<mspace width="0.17em"></mspace>', found)
    return re.sub('<mo stretchy="false">([/|])</mo>', r'<mo stretchy="false" lspace="0" rspace="0">\1</mo>', found)


def visit_inline(writer, node: nodes.math) -> None:
    writer.body.append(mathml(node.astext(), inline=True))
    raise nodes.SkipNode


def side_by_side(tex: str) -> list[str]:
    """The formulas of one line, which a narrow window shows below each other: \\qquad stands between them, outside of braces."""
    formulas, depth = [""], 0
    for part in re.split(r"(\\qquad\b|\\?[{}])", tex):
        depth += (part == "{") - (part == "}")
        if part == "\\qquad" and depth == 0:
            formulas.append("")
        else:
            formulas[-1] += part
    return formulas


def visit_display(writer, node: nodes.math_block) -> None:
    formulas = "".join(mathml(each, inline=False) for each in side_by_side(node.astext()))
    writer.body.append(f'<div class="formula">{formulas}</div>')
    raise nodes.SkipNode


def setup(app):
    app.add_html_math_renderer("mathml", inline_renderers=(visit_inline, None), block_renderers=(visit_display, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
