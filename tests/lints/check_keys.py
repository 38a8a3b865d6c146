#!/usr/bin/env python3
"""Checks that the keys of a deck stand in descriptions alone.

    check_keys.py ROOT          check the tree at ROOT
    check_keys.py --self-test   check that violations are caught, on made-up trees

A key, its range, its default and its meaning stand in one function `describe`, which binds it to a member
(docs/decisions/options-described-once.md). All other code uses members, and asks for places by member. So in src/ and
include/
- only the files in SECTIONS name the type Section, a table whose values are asked for by key;
- no value, place, entry or key is looked up by a literal (LOOK_UPS);
- no Key is made of a literal: a key that is bound to no member is a key that nothing reads.
"""

import re
import sys

import lint

# file -> what it needs sections for
SECTIONS = {
    "include/ljmd/detail/options/section.hpp": "the type itself",
    "src/options/section.cpp": "the type itself",
    "src/options/placed.hpp": "reads sections into structs",
    "include/ljmd/detail/options/table_description.hpp": "reads sections into structs",
    "src/options/table_description.cpp": "reads sections into structs",
    "src/deck/deck.cpp": "validates a deck before its tables are read",
    "src/deck/mistake_report.cpp": "places of what the engine, which knows no deck, says of its values",
    "include/ljmd/options/settings.hpp": "checks options that a program gives by key as those of a deck",
    "src/options/settings.cpp": "the same",
    "src/analyze/trajectory_analyses.cpp": "tables of analyses, with steps converted to frames",
}

SECTION = re.compile(r"\bSection\b")

# files in which names are not keys of a deck -> what they are
OTHER_NAMES = {
    "src/io/": "columns of files, members of JSON",
    "src/observables/transport/finite_size.cpp": "averages",
}

LITERAL = r'\(\s*"[^"]*"\s*'
LOOK_UPS = [
    (re.compile(r"(?:\.|->)(?:flag|integer|number|text|interval|vector|plain|sections?|has|sound|written|location)" + LITERAL + r"\)"), "use the member that the key is bound to"),
    (re.compile(r"(?:\.|->)take" + LITERAL + ","), "set the member that the key is bound to"),
    (re.compile(r"(?<![\w.>:])find\(\s*[^,;{}]*,\s*\"[^\"]*\"\s*\)"), "ask Placed<...>::key() for the name"),
    (re.compile(r"[Ss]chema(?:\([^;(){}]*\))?(?:\.|->)find" + LITERAL + r"\)"), "use the member that the key is bound to"),
    (re.compile(r"\.key\s*[!=]=\s*\""), "ask Placed<...>::key() for the name"),
    (re.compile(r"\"[^\"]*\"\s*,\s*&Key::name\b"), "give the key a property, as Key::step_interval()"),
    (re.compile(r"\bKey::\w+\(\s*\""), "describe() binds a key to its member, see Description"),
]


def check(root):
    complaints = []
    for path in lint.sources(root):
        name = path.relative_to(root).as_posix()
        text = lint.without_comments(path.read_text(encoding="utf-8"))
        rules = [] if name in SECTIONS else [(SECTION, "read the table into a struct, see Placed")]
        if not name.startswith(tuple(OTHER_NAMES)):
            rules += LOOK_UPS
        for pattern, advice in rules:
            for found in pattern.finditer(text):
                number = text.count("\n", 0, found.start()) + 1
                complaints.append(f"{name}:{number}: {' '.join(found.group().split())}: {advice}")
    return complaints


SOUND = """#include "ljmd/detail/options/section.hpp"
void describe(Description& description) {
    description.number("time", time).above(0.0);  // not section.number("time")
    description.flag("on", on);
    add(Key::number(name));
}
bool look(const Placed<Table>& table, const std::string& text) {
    const auto end = text.find("] ");
    if (table.has(&Table::time) && find(root, table.key(&Table::time)) && plugin.name == "rescale") return true;
    return section.sound(key) && std::ranges::find(names, wanted) == names.end();
}
"""

VIOLATIONS = [
    "void f(const Section& table);",
    'x = table.number("time");',
    'x = deck.system()->has("file");',
    'x = table.location(\n        "time");',
    'x = force.section().location("stiffness");',
    'description.take("time", value);',
    'const Entry* entry = find(table, "argon");',
    'x = deck_schema(kind).find("argon")->inner;',
    'std::erase_if(table, [](const Entry& e) { return e.key == "every"; });',
    'x = std::ranges::find(keys, "every", &Key::name);',
    'Schema schema("lattice", {Key::integer("cells")});',
]


def self_test():
    sound = {
        "src/run/x.cpp": SOUND,
        "src/deck/deck.cpp": VIOLATIONS[0],  # in SECTIONS
        "src/io/dump.cpp": 'x = dump.has("mass");',  # in OTHER_NAMES
    }
    return lint.self_test(check, sound, [("src/run/x.cpp", SOUND + line + "\n", "src/run/x.cpp") for line in VIOLATIONS])


if __name__ == "__main__":
    sys.exit(lint.main(sys.argv[1:], __doc__, check, self_test))
