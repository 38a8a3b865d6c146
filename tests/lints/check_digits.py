#!/usr/bin/env python3
"""Checks that nothing in the path of a trajectory rounds as the machine likes.

    check_digits.py ROOT          check the tree at ROOT
    check_digits.py --self-test   check that violations are caught, on made-up trees

Elementary functions of C libraries, and variates of GSL, differ in the last digit from machine to machine (docs/digits.md). The rooms
that make trajectories call those of include/ljmd/detail/core/elementary.hpp, and no std::fma; the square root is exact, and so are functions
that round to whole numbers or take exponents.
"""

import re
import sys

import lint

# What moves atoms, and what that is made of.
ROOMS = re.compile(r"(?:src|include/ljmd(?:/detail)?)/(?:core/random|core/elementary|model/|potentials/|neighbors/|forces/|integrators/)")
ALLOWED = {
    "src/potentials/pair_table.cpp": "formulas of the calling program, which computes them as it likes",
    "src/potentials/second_virial.cpp": "a number of the equation of state, which moves no atom",
    "src/integrators/reference_trajectory.cpp": "what runs are compared with",
}
FUNCTION = re.compile(r"\bstd::(?:exp|exp2|expm1|log|log2|log10|log1p|pow|cbrt|hypot|fma|sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|erf|erfc|"
                      r"tgamma|lgamma)\(|\bgsl_(?:ran|sf)_\w+\(|\busing std::(?:exp|log|pow|sin|cos);")


def check(root):
    complaints = []
    for path in lint.sources(root):
        name = path.relative_to(root).as_posix()
        if ROOMS.match(name) and name not in ALLOWED:
            for number, line in enumerate(lint.without_comments(path.read_text(encoding="utf-8")).splitlines(), 1):
                if found := FUNCTION.search(line):
                    complaints.append(f"{name}:{number}: {found.group()}: it rounds otherwise on other machines, see ljmd/detail/core/elementary.hpp")
    return complaints


SOUND = "double f(double x) {\n    return exponential(x) + std::sqrt(x) + std::floor(x) + expected(x);  // not std::exp(x)\n}\n"
VIOLATIONS = ["return std::exp(x);", "using std::log;", "x = std::pow(x, 2);", "return gsl_ran_gamma(g, a, 1.0);", "return std::fma(a, b, c);"]


def self_test():
    sound = {"src/forces/x.cpp": SOUND, "src/report/x.cpp": VIOLATIONS[0]}  # a page moves no atom
    return lint.self_test(check, sound, [("src/forces/x.cpp", SOUND + line + "\n", "src/forces/x.cpp") for line in VIOLATIONS])


if __name__ == "__main__":
    sys.exit(lint.main(sys.argv[1:], __doc__, check, self_test))
