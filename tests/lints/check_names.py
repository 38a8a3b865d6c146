#!/usr/bin/env python3
"""Checks that one name is one type, so that no program has two of a name.

    check_names.py ROOT          check the tree at ROOT
    check_names.py --self-test   check that violations are caught, on made-up trees

Two headers may define types of one name, as long as no source includes both: compilers accept that, and the linker takes the
constructors and destructors of one for both. The same holds for functions in headers. What one source alone knows is in an unnamed
namespace. Each folder of tests is a program, with the sources of the project.
"""

import re
import sys

import lint

END = re.compile(r"^\}  // namespace.*$", re.M)
NAMESPACE = re.compile(r"namespace ?([\w:]*) ?\{$")
TYPE = re.compile(r"(?:template <.*> )?(?:struct|class|enum class|enum|union) (?:\[\[\w+\]\] |alignas\([^)]*\) )?([\w:]+)(?: final)?(?: : .*)? ?\{")
FUNCTION = re.compile(r"(?:template <.*> )?(?:\[\[nodiscard\]\] )?(?:inline|constexpr) [^=;{]*?\b(\w+)\(([^{;]*)\)[^{;()]*\{")
# A program is linked with one of two sources that define this name.
ALTERNATIVES = {"ljmd::detail::FourierPlan": "src/page/fourier.cpp"}


def named(text):
    """(line, name with its namespaces) of the types and inline functions outside of unnamed namespaces; functions with their parameters."""
    spaces = []
    for number, line in enumerate(lint.without_comments(END.sub("\0", text)).splitlines(), 1):
        if line == "\0":
            spaces.pop()
        elif opened := NAMESPACE.match(line):
            spaces.append(opened[1])
        elif "" in spaces:
            continue
        elif found := TYPE.match(line):
            yield number, "::".join([*spaces, found[1]])
        elif found := FUNCTION.match(line):
            yield number, "::".join([*spaces, f"{found[1]}({found[2]})"])


def check(root):
    complaints = []

    def look_at(path, places):
        name = path.relative_to(root).as_posix()
        for number, what in named(path.read_text(encoding="utf-8")):
            if ALTERNATIVES.get(what) == name:
                continue
            place = f"{name}:{number}"
            if (earlier := places.setdefault(what, place)) != place:
                complaints.append(f"{place}: {what} is at {earlier}, too: another name, or an unnamed namespace")

    of_project = {}
    for path in lint.sources(root):
        look_at(path, of_project)
    for folder in sorted(path for path in (root / "tests").glob("*") if path.is_dir()):
        places = dict(of_project)
        for path in sorted(folder.rglob("*.[ch]pp")):
            look_at(path, places)
    return complaints


SOUND = {
    "src/judge/pairs.hpp": "namespace ljmd {\n\nstruct Pairs {\n    int count;\n};\n\n}  // namespace ljmd\n",
    "src/judge/pairs.cpp": "namespace ljmd {\n\nnamespace {\n\nstruct Row {\n};\n\n}  // namespace\n\nstruct Pairs::Parts {\n};\n\n}  // namespace ljmd\n",
    "src/io/rows.cpp": "namespace ljmd::io {\n\nnamespace {\n\nclass Row {\n};\n\n}  // namespace\n\nclass Pairs {\n};\n\n}  // namespace ljmd::io\n",
    "tests/judge/a_test.cpp": "namespace {\nstruct Log {\n};\n}  // namespace\n",
    "tests/judge/b_test.cpp": "struct Log {\n};\n",
    "tests/io/c_test.cpp": "struct Log {\n};\n",
}
VIOLATIONS = [
    ("include/ljmd/pairs.hpp", "namespace ljmd {\n\nclass Pairs final : public Base {\n};\n\n}  // namespace ljmd\n", "ljmd::Pairs is at"),
    ("src/io/pairs.cpp", "namespace ljmd {\n\nenum class Pairs { none };\n\n}  // namespace ljmd\n", "ljmd::Pairs is at"),
    ("src/io/parts.cpp", "namespace ljmd {\n\nstruct Pairs::Parts {\n};\n\n}  // namespace ljmd\n", "ljmd::Pairs::Parts is at"),
    ("tests/judge/c_test.cpp", "struct Log : Base {\n};\n", "Log is at tests/judge/b_test.cpp:1"),
    ("tests/judge/c_test.cpp", "namespace ljmd {\nstruct Pairs {\n};\n}  // namespace ljmd\n", "ljmd::Pairs is at src/judge/pairs.hpp:3"),
]


def self_test():
    twice = "namespace ljmd {{\n\n{}inline double half(double x) {{\n    return {} * x;\n}}\n\n}}  // namespace ljmd\n"
    sound = {**SOUND, "src/core/half.hpp": twice.format("", 0.5)}
    return lint.self_test(check, sound, [*VIOLATIONS, ("src/io/half.hpp", twice.format("[[nodiscard]] ", 0.4), "half(double x) is at")])


if __name__ == "__main__":
    sys.exit(lint.main(sys.argv[1:], __doc__, check, self_test))
