#!/usr/bin/env python3
"""Doxygen's input filter: lines `@throws A ...; B ...` become one list below the word Throws.

Doxygen takes the word behind @throws for the only exception, and breathe drops what it cannot tell apart.
"""

import re
import sys

inside = False
for line in open(sys.argv[1], encoding="utf-8").read().splitlines():
    found = re.fullmatch(r"(\s*)///(.*)@throws\s+(.*)", line)
    if found is None:
        inside = inside and line.lstrip().startswith("///")
        print(re.sub(r"^(\s*///) ", r"\1   ", line) if inside else line)
        continue
    margin, before, what = found.groups()
    if before.strip():
        print(f"{margin}///{before}")
    if not inside:
        print(f"{margin}/// @par Throws")
    print(f"{margin}/// - {what}")
    inside = True
