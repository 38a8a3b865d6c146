#!/usr/bin/env python3
"""Checks who includes whom in include/ and src/.

    check_rooms.py ROOT          check the tree at ROOT
    check_rooms.py --self-test   check that violations are caught, on made-up trees

Rules:
- a file includes only what its room may include (ROOMS, KEPT_FROM), and files do not include each other in a circle;
- headers that are installed lie in include/ and are included as "ljmd/<room>/x.hpp", all others beside their sources,
  included as "<room>/x.hpp"; an installed one includes installed ones alone;
- in include/ is what engine.hpp and ljmd.hpp lead to, and nothing else: at most 30 headers that are documented, and what
  they need in detail/;
- every header begins with #pragma once (after comments);
- physics and engine see no file, no process and no terminal, and have no conditional compilation: what needs a library
  that may be absent is a module;
- nlohmann's headers, which take seconds to compile, are included where JSON is written and read (JSON_SOURCE), and
  nowhere else;
- a folder of src/ has at most MOST_SOURCES sources: a fuller one is divided.
"""

import os
import re
import sys
from pathlib import Path

import lint

# From the ground up. A room may include every room that stands before it, but for those that it is kept from.
ROOMS = ["core", "options", "execution", "model", "reference", "potentials", "neighbors", "forces", "integrators",
         "observables", "engine", "io", "input", "deck", "run", "analyze", "compare", "judge", "study", "report", "python", "cli", "page"]
KEPT_FROM = {
    "reference": {"execution", "model"},
    "potentials": {"execution", "reference"},
    "neighbors": {"reference", "potentials"},
    "forces": {"reference"},
    "integrators": {"reference"},
    "io": {"reference", "engine"},
    "input": {"reference", "engine"},
    "python": {"compare", "judge", "study"},
    "cli": {"python"},
    "page": {"compare", "judge", "study", "report", "python", "cli"},
}
ALLOWED = {room: set(ROOMS[:place]) - KEPT_FROM.get(room, set()) for place, room in enumerate(ROOMS)}

# What programs include is no room: it leads to all that needs no file or process, and to runs with a directory.
FRONTS = (Path("include/ljmd/engine.hpp"), Path("include/ljmd/ljmd.hpp"))

PHYSICS = {"model", "potentials", "neighbors", "forces", "integrators", "observables", "reference", "engine"}

ALLOWED["front"] = PHYSICS | {"core", "options", "execution", "deck", "run", "analyze"}

# Written by the build, not in the tree.
GENERATED = {"cli/example_deck_texts.hpp", "report/page_arrays.hpp", "execution/simd_levels.hpp", "core/version.hpp", "ljmd/detail/potentials/formula_list.hpp"}

# Headers of files, processes, signals and the terminal.
OUTSIDE = re.compile(r"fstream|filesystem|iostream|cstdio|stdio\.h|csignal|signal\.h|fcntl\.h|unistd\.h|sys/.*|spawn\.h")

JSON_SOURCE = Path("src/io/tables/json_text.cpp")

MOST_SOURCES = 24
MOST_DOCUMENTED = 30

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
CONDITIONAL = re.compile(r"^\s*#\s*(if|ifdef|ifndef|elif|elifdef|elifndef)\b")


def room_of(path):
    """Room of a path relative to the root: include/ljmd/<room>/..., include/ljmd/detail/<room>/..., src/<room>/...; None elsewhere."""
    parts = path.parts
    if path in FRONTS:
        return "front"
    if parts[:2] == ("include", "ljmd") and len(parts) > 3:
        return parts[3] if parts[2] == "detail" else parts[2]
    if parts[0] == "src" and len(parts) > 2:
        return parts[1]
    return None


def resolve(root, path, bracket, target):
    """The included file relative to the root; None for a header of another project; a string is a complaint."""
    if target.startswith("ljmd/"):
        if bracket == "<":
            return f'write "{target}", not <{target}>'
        included = Path("include") / target
    elif bracket == "<":
        return None
    elif path.parts[0] == "include":
        return f'"{target}" is not installed'
    else:
        included = Path(os.path.normpath(Path("src") / target))
    return included if target in GENERATED or (root / included).is_file() else f'"{target}" is not in the tree'


def check_file(root, path):
    """(complaints, included files) of one file."""
    complaints, includes = [], []
    room = room_of(path)
    if room not in ALLOWED:
        return [f"{path}: in no room; allowed: {', '.join(ROOMS)}"], []
    lines = lint.without_comments((root / path).read_text(encoding="utf-8")).splitlines()
    first = next((line.strip() for line in lines if line.strip()), "")
    if path.suffix == ".hpp" and first != "#pragma once":
        complaints.append(f"{path}: a header begins with #pragma once")
    for number, line in enumerate(lines, 1):
        if room in PHYSICS and CONDITIONAL.match(line):
            complaints.append(f"{path}:{number}: conditional compilation in {room}")
        match = INCLUDE.match(line)
        if not match:
            continue
        if room in PHYSICS and OUTSIDE.fullmatch(match.group(2)):
            complaints.append(f"{path}:{number}: {room} must not see files, processes or the terminal ({match.group(2)})")
        if match.group(2).startswith("nlohmann/") and path != JSON_SOURCE:
            complaints.append(f"{path}:{number}: JSON is made of Data in {JSON_SOURCE} alone ({match.group(2)})")
        included = resolve(root, path, *match.groups())
        if isinstance(included, str):
            complaints.append(f"{path}:{number}: {included}")
        elif included is not None:
            includes.append(included)
            other = room_of(included)
            if other != room and other not in ALLOWED[room]:
                complaints.append(f"{path}:{number}: {room} must not include {other} ({match.group(2)})")
    return complaints, includes


def circles(graph):
    """One complaint for each circle found by a depth-first walk."""
    complaints, done, trail = [], set(), []

    def visit(node):
        if node in trail:
            circle = trail[trail.index(node):] + [node]
            complaints.append("circle of includes: " + " -> ".join(map(str, circle)))
        elif node not in done:
            trail.append(node)
            for following in graph.get(node, []):
                visit(following)
            trail.pop()
            done.add(node)

    for start in sorted(graph):
        visit(start)
    return complaints


def crowded(root):
    """One complaint for each folder with too many sources."""
    counts = {}
    for file in (root / "src").rglob("*.cpp"):
        counts[file.parent] = counts.get(file.parent, 0) + 1
    return [f"{folder.relative_to(root)}: {count} sources in one folder; at most {MOST_SOURCES}"
            for folder, count in sorted(counts.items()) if count > MOST_SOURCES]


def installed(root, graph):
    """Complaints on what is in include/ without need, and on too many headers to document."""
    found, reached = [front for front in FRONTS if front in graph], set()
    while found:
        header = found.pop()
        if header not in reached:
            reached.add(header)
            found += graph.get(header, [])
    formulas = Path("include/ljmd/detail/potentials/formulas")  # the generated list of them includes them
    headers = [header for header in graph if header.parts[0] == "include" and header.parent != formulas]
    documented = [header for header in headers if "detail" not in header.parts]
    return [f"{header}: no installed header needs it; its place is in src/" for header in headers if header not in reached] + \
        [f"include/: {len(documented)} documented headers; at most {MOST_DOCUMENTED}"] * (len(documented) > MOST_DOCUMENTED)


def check(root):
    complaints, graph = crowded(root), {}
    for file in lint.sources(root):
        path = file.relative_to(root)
        found, graph[path] = check_file(root, path)
        complaints += found
    return complaints + circles(graph) + installed(root, graph) if graph else [f"no sources found under {root}"]


SOUND = {
    "include/ljmd/ljmd.hpp": '#pragma once\n#include "ljmd/forces/f.hpp"\n#include "ljmd/model/b.hpp"\n',
    "include/ljmd/detail/core/a.hpp": "// A comment first.\n#pragma once\n#include <vector>\n",
    "include/ljmd/model/b.hpp": '#pragma once\n#include "ljmd/detail/core/a.hpp"\n',
    "include/ljmd/forces/f.hpp": '#pragma once\n#include "ljmd/model/b.hpp"\n// #include "deck/x.hpp"\n',
    "src/core/a.cpp": '#include "ljmd/detail/core/a.hpp"\n#include "core/version.hpp"\n#ifdef __linux__\n#endif\n',
    "src/neighbors/p.hpp": '#pragma once\n#include "ljmd/model/b.hpp"\n',
    "src/forces/p.cpp": '#include "neighbors/p.hpp"\n',
    "src/io/private.hpp": "#pragma once\n",
    "src/python/private.hpp": '#pragma once\n#include "io/private.hpp"\n',
    "src/io/h.cpp": '#include "io/private.hpp"\n',
    JSON_SOURCE.as_posix(): "#include <nlohmann/json.hpp>\n",
}

# what is wrong: (file, its text, what the complaint must say)
VIOLATIONS = [
    ("include/ljmd/model/b.hpp", '#pragma once\n#include "ljmd/forces/f.hpp"\n', "model must not include forces"),
    ("src/core/a.cpp", '#include "ljmd/model/b.hpp"\n', "core must not include model"),
    ("src/potentials/q.cpp", '#include "neighbors/p.hpp"\n', "potentials must not include neighbors"),
    ("src/model/q.cpp", '#include "neighbors/p.hpp"\n', "model must not include neighbors"),
    ("src/reference/q.cpp", '#include "ljmd/model/b.hpp"\n', "reference must not include model"),
    ("src/io/q.cpp", '#include "../../../outside.hpp"\n', "is not in the tree"),
    ("src/io/q.cpp", '#include "private.hpp"\n', "is not in the tree"),
    ("src/model/q.cpp", '#include "ljmd/detail/potentials/formula_list.hpp"\n', "model must not include potentials"),
    ("src/forces/q.cpp", '#include "io/private.hpp"\n', "forces must not include io"),
    ("src/core/a.cpp", "#include <ljmd/detail/core/a.hpp>\n", 'not <ljmd/detail/core/a.hpp>'),
    ("src/core/a.cpp", '#include "ljmd/core/gone.hpp"\n', "is not in the tree"),
    ("include/ljmd/detail/core/a.hpp", "#include <vector>\n", "begins with #pragma once"),
    ("include/ljmd/detail/core/a.hpp", "#ifndef A_HPP\n#define A_HPP\n#endif\n", "begins with #pragma once"),
    ("src/model/b.cpp", "#ifdef LJMD_WITH_MPI\n#endif\n", "conditional compilation"),
    ("src/model/b.cpp", "#  if defined(X)\n#endif\n", "conditional compilation"),
    ("src/magic/b.cpp", "", "in no room"),
    ("src/cli/q.cpp", '#include "python/private.hpp"\n', "cli must not include python"),
    ("src/engine/e.cpp", '#include "io/private.hpp"\n', "engine must not include io"),
    ("src/engine/e.cpp", "#include <filesystem>\n", "engine must not see files"),
    ("src/model/b.cpp", "#include <unistd.h>\n", "model must not see files"),
    ("src/run/r.cpp", "#include <nlohmann/json.hpp>\n", "JSON is made of Data"),
    ("src/run/r.hpp", "#pragma once\n#include <nlohmann/json_fwd.hpp>\n", "JSON is made of Data"),
    ("include/ljmd/all.hpp", "#pragma once\n", "in no room"),
    ("include/ljmd/ljmd.hpp", '#pragma once\n#include "io/private.hpp"\n', "is not installed"),
    ("include/ljmd/model/needless.hpp", "#pragma once\n", "no installed header needs it"),
    ("src/neighbors/p.hpp", '#pragma once\n#include "neighbors/p.hpp"\n', "circle of includes"),
]


def self_test():
    crowd = {f"src/io/s{k}.cpp": "" for k in range(MOST_SOURCES - 1)}  # with h.cpp as many as are allowed
    one_more = ("src/io/more.cpp", "", f"{MOST_SOURCES + 1} sources in one folder")
    headers = {f"include/ljmd/model/h{k}.hpp": "#pragma once\n" for k in range(MOST_DOCUMENTED - 3)}
    sound = {**SOUND, **crowd, **headers}
    sound["include/ljmd/ljmd.hpp"] += "".join(f'#include "{header[8:]}"\n' for header in headers)
    one_documented = ("include/ljmd/engine.hpp", '#pragma once\n', f"{MOST_DOCUMENTED + 1} documented headers")
    return lint.self_test(check, sound, [*VIOLATIONS, one_more, one_documented])


if __name__ == "__main__":
    sys.exit(lint.main(sys.argv[1:], __doc__, check, self_test))
