"""Text of others (titles, names of files and keys) as pictures can show it: one line, which is read as it stands."""

from __future__ import annotations

import textwrap
import unicodedata

RIGHT_TO_LEFT = ("R", "AL")
DIGITS = ("EN", "AN")
MIRRORED = {one: other for pair in ("()", "[]", "{}", "<>", "«»") for one, other in (pair, pair[::-1])}


def plain(text: str) -> str:
    """Text that matplotlib shows as it is, on one line: a pair of dollar signs would start a formula."""
    return visual_order(cleaned(text)).replace("$", r"\$")


def lines(text: str, width: int, most: int = 2) -> str:
    """A long text on at most so many lines of `width` characters, each as plain() has it; what is left out is shown by
    three dots."""
    found = textwrap.wrap(cleaned(text), width, max_lines=most, placeholder=" ...")
    return "\n".join(plain(line) for line in found)


def cleaned(text: str) -> str:
    """The text without what has no shape of its own: controls, line ends among them, are blanks; marks of direction,
    surrogates and the like are nothing."""
    kept = "".join(" " if unicodedata.category(one) in ("Cc", "Zl", "Zp") else one
                   for one in text if unicodedata.category(one) not in ("Cf", "Cs", "Co", "Cn"))
    return " ".join(kept.split())


def visual_order(text: str) -> str:
    """The characters from left to right as they are seen: matplotlib draws a text in its logical order, in which Hebrew
    and Arabic would be read backwards.

    The Unicode Bidirectional Algorithm (UAX #9) without embeddings; Arabic letters are not joined.
    """
    kinds = [unicodedata.bidirectional(one) for one in text]
    strong = [kind for kind in kinds if kind == "L" or kind in RIGHT_TO_LEFT]
    if all(kind == "L" for kind in strong):
        return text
    base = 0 if strong[0] == "L" else 1
    levels = levels_of(kinds, base)
    characters = [MIRRORED.get(one, one) if level % 2 else one for one, level in zip(text, levels)]
    for level in range(max(levels), 0, -1):
        start = 0
        while start < len(levels):
            end = start
            while end < len(levels) and levels[end] >= level:
                end += 1
            characters[start:end] = characters[start:end][::-1]
            start = end + 1
    return "".join(characters)


def levels_of(kinds: list[str], base: int) -> list[int]:
    """The level of each character: odd is from right to left. Digits keep their order; what has no direction takes that
    of its neighbours where these agree, else that of the text."""
    directions = []
    before = "L" if base == 0 else "R"
    for kind in kinds:
        if kind == "L" or kind in RIGHT_TO_LEFT:
            before = "L" if kind == "L" else "R"
            directions.append(before)
        elif kind in DIGITS:
            directions.append("L" if before == "L" else "N")
        else:
            directions.append("")
    for k, direction in enumerate(directions):
        if direction == "":
            left = next((one for one in reversed(directions[:k]) if one), "L" if base == 0 else "R")
            right = next((one for one in directions[k:] if one), "L" if base == 0 else "R")
            left, right = ("R" if one == "N" else one for one in (left, right))
            directions[k] = left if left == right else ("L" if base == 0 else "R")
    level = {"L": 0 if base == 0 else 2, "R": 1, "N": 2}
    return [level[direction] for direction in directions]
