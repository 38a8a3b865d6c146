"""Docstrings of the Python package as reStructuredText.

They are written to be read in a terminal: paragraphs, indented code, and lines `name: meaning` for parameters and attributes.
"""

import re

NAMED = re.compile(r"((?:\w+)(?:, \w+)*): +(.*)")
SPECIAL = re.compile(r"`[^`]*`|(\\|\*|\||_(?!\w))")


def escaped(text: str) -> str:
    """Text whose marks are text, but for `code`."""
    return SPECIAL.sub(lambda found: f"\\{found[1]}" if found[1] else f"`{found[0]}`", text)


def items(block: list[str]):
    """(name, meaning) of each line `name: meaning`, whose text may go on in indented lines; None: the block is something else."""
    found = []
    for line in block:
        named = NAMED.fullmatch(line)
        if named:
            found.append([named[1], named[2]])
        elif found and line.startswith("    "):
            found[-1][1] += " " + line.strip()
        else:
            return None
    return found


def restructured(lines: list[str]) -> list[str]:
    blocks, result = [[]], []
    for line in lines:
        if line.strip():
            blocks[-1].append(line)
        elif blocks[-1]:
            blocks.append([])
    for block in filter(None, blocks):
        named = items(block)
        if all(line.startswith("    ") for line in block):
            result += [".. code-block:: python", "", *block]
        elif named:
            result += [f"* ``{name}``: {escaped(meaning)}" for name, meaning in named]
        else:
            result += [escaped(line) for line in block]
        result.append("")
    return result


def rewrite(app, what, name, thing, options, lines) -> None:
    lines[:] = restructured(lines)


def setup(app):
    app.connect("autodoc-process-docstring", rewrite)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
