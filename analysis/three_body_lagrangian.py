#!/usr/bin/env python3
"""The equations of motion of three bodies, derived from their Lagrangian, against what the program computes.

    three_body_lagrangian.py --print [text|latex]     show the Lagrangian and the equations in the plane
    three_body_lagrangian.py RUNDIR...                check the accelerations in trajectory.csv

The Lagrangian is L = T - U with T = sum m_i v_i^2 / 2 and U = -G sum over pairs of m_i m_j / r_ij; the Euler-Lagrange
equations d/dt dL/dv - dL/dr = 0 are solved for the accelerations, all by sympy. For the check U has what the deck has
beside: distances r count as (r^2 + s^2)^(1/2) with a softening s, and a central mass at the origin attracts too.

RUNDIR is a run of three bodies with force newtonian-gravity whose deck asks for accelerations = true. G, softening and
masses come from the deck in run.json. For each run the largest relative difference is printed: |a - a'| of a body over
the sum of the magnitudes of the terms that its acceleration is made of (terms may cancel).
Exit codes: 0 ok, 1 a difference above 1e-12, 2 usage, 3 a file of a run is missing or damaged.
"""

from __future__ import annotations

import argparse
import itertools
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Optional, Sequence

import numpy as np
import sympy

sys.path.insert(0, str(Path(__file__).resolve().parent))
from script import reports_errors  # noqa: E402  (it finds the package ljmd)
from ljmd.errors import InputError  # noqa: E402
from ljmd.reading import decks, few_bodies, records  # noqa: E402
from ljmd.reading.few_bodies import FewBodyRun  # noqa: E402
from ljmd.reading.files import damaged  # noqa: E402

TOLERANCE = 1e-12
BODIES = 3
TIME = sympy.Symbol("t")
G = sympy.Symbol("G", positive=True)
SOFTENING = sympy.Symbol("s", nonnegative=True)
CENTRAL_MASS = sympy.Symbol("M", nonnegative=True)
MASSES = sympy.symbols("m1:4", positive=True)


@dataclass(frozen=True)
class Equations:
    """The Lagrangian, and the accelerations as [body][axis], in coordinates [body][axis] that are functions of time."""

    coordinates: list[list[Any]]
    lagrangian: Any
    accelerations: list[list[Any]]


def derive(dimensions: int = 2, softening: Any = 0, central_mass: Any = 0) -> Equations:
    """The equations of motion, from L = T - U by Euler and Lagrange."""
    r = [[sympy.Function(f"{axis}{body}")(TIME) for axis in "xyz"[:dimensions]] for body in range(1, BODIES + 1)]

    def inverse_distance(place: list[Any]) -> Any:
        return 1 / sympy.sqrt(sum(x**2 for x in place) + softening**2)

    kinetic = sum(m * x.diff(TIME) ** 2 for m, place in zip(MASSES, r) for x in place) / 2
    potential = -sum(
        G * MASSES[i] * MASSES[j] * inverse_distance([x - y for x, y in zip(r[i], r[j])])
        for i, j in itertools.combinations(range(BODIES), 2)
    )
    if central_mass != 0:
        potential -= sum(G * central_mass * m * inverse_distance(place) for m, place in zip(MASSES, r))
    lagrangian = kinetic - potential
    flat = [x for place in r for x in place]
    second = [x.diff(TIME, 2) for x in flat]
    equations = sympy.Matrix([(lagrangian.diff(x.diff(TIME))).diff(TIME) - lagrangian.diff(x) for x in flat])
    inertia = equations.jacobian(second)  # diagonal in these coordinates
    rest = [equation.subs(dict.fromkeys(second, 0)) for equation in equations]
    # Term by term: the mass of the body itself then cancels, and x1 - x2 stays one factor.
    solved = [-sum(term / inertia[k, k] for term in sympy.Add.make_args(side)) for k, side in enumerate(rest)]
    return Equations(r, lagrangian, [list(solved[k : k + dimensions]) for k in range(0, len(flat), dimensions)])


def show(form: str) -> str:
    """The Lagrangian and the equations of motion in the plane, with r12, r13, r23 for the distances."""
    latex = form == "latex"
    equations = derive()
    short: dict[Any, Any] = {}
    for (i, one), (j, other) in itertools.combinations(enumerate(equations.coordinates, 1), 2):
        distance = sympy.Symbol(f"r_{{{i}{j}}}" if latex else f"r{i}{j}", positive=True)
        short[sum((x - y) ** 2 for x, y in zip(one, other))] = distance**2
    plain: dict[Any, Any] = {}
    for body, place in enumerate(equations.coordinates, 1):
        for axis, x in zip("xyz", place):
            plain[x.diff(TIME)] = sympy.Symbol(rf"\dot{{{axis}}}_{body}" if latex else f"{axis}{body}'")
            plain[x] = sympy.Symbol(f"{axis}_{body}" if latex else f"{axis}{body}")

    def written(expression: Any) -> str:
        expression = expression.subs(short).subs(plain)
        return sympy.latex(expression) if latex else sympy.sstr(expression)

    lines = [f"L = {written(equations.lagrangian)}"]
    for body, (place, acceleration) in enumerate(zip(equations.coordinates, equations.accelerations), 1):
        for axis, value in zip("xyz", acceleration):
            name = rf"\ddot{{{axis}}}_{body}" if latex else f"{axis}{body}''"
            lines.append(f"{name} = {written(value)}")
    return "\n".join(lines)


def number(run: FewBodyRun, table: Any, key: str, default: Optional[float] = None) -> float:
    """A number of the deck; without a default it must be there."""
    value = table.get(key, default) if isinstance(table, dict) else None
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise damaged(run.path / "run.json", f"the deck has no number '{key}'")
    return float(value)


def constants(run: FewBodyRun) -> dict[Any, float]:
    """G, softening, central mass and masses of a run, by their symbols."""
    used = decks.of_run(records.read(run.path))
    force, bodies = used.get("force", {}), used.get("body", [])
    if len(bodies) != BODIES:
        raise damaged(run.path / "run.json", f"the deck has {len(bodies)} [[body]] tables, must have {BODIES}")
    return {
        G: number(run, force, "gravitational_constant"),
        SOFTENING: number(run, force, "softening", 0.0),
        CENTRAL_MASS: number(run, force, "central_mass", 0.0),
        **{mass: number(run, body, "mass") for mass, body in zip(MASSES, bodies)},
    }


def largest_difference(run: FewBodyRun) -> float:
    """Between the program's accelerations and the derived ones, relative to the size of the terms."""
    if run.bodies != BODIES or run.force != "newtonian-gravity" or run.dimensions < 2:
        what = f"{run.bodies} bodies with force {run.force} in {run.dimensions} dimensions"
        raise InputError(f"{run.path}: {what}; three with newtonian-gravity in 2 or 3 are needed")
    if run.trajectory is None or run.trajectory.accelerations is None:
        raise damaged(run.path / "trajectory.csv", "no accelerations: set accelerations = true in the deck")
    values = constants(run)
    # A body may pass through an empty centre, where the term of a central mass of 0 would have no value.
    equations = derive(run.dimensions, SOFTENING, CENTRAL_MASS if values[CENTRAL_MASS] != 0.0 else 0)
    arguments = [*values, *(x for place in equations.coordinates for x in place)]
    positions = run.trajectory.positions.reshape(len(run.trajectory.time), -1).T
    worst = np.zeros(len(run.trajectory.time))
    for body, acceleration in enumerate(equations.accelerations):
        terms = [sympy.lambdify(arguments, sympy.Add.make_args(component), "numpy") for component in acceleration]
        found = np.array([term(*values.values(), *positions) for term in terms])  # axis, term, frame
        differences = np.linalg.norm(run.trajectory.accelerations[:, body].T - found.sum(axis=1), axis=0)
        sizes = np.linalg.norm(np.abs(found).sum(axis=1), axis=0)
        worst = np.maximum(worst, differences / sizes)
    return float(worst.max())  # not a number, if any is


@reports_errors
def main(arguments: Optional[Sequence[str]] = None) -> int:
    parser = argparse.ArgumentParser(description="Derive the motion of three bodies, and check runs against it.")
    parser.add_argument("rundirs", type=Path, nargs="*", metavar="RUNDIR", help="directory that `ljmd run` wrote")
    parser.add_argument("--print", choices=("text", "latex"), nargs="?", const="text", help="show the equations")
    options = parser.parse_args(arguments)
    if not options.rundirs and not options.print:
        parser.error("give run directories, or --print")
    if options.print:
        print(show(options.print))
    failed = False
    for path in options.rundirs:
        difference = largest_difference(few_bodies.load(path))
        verdict = "ok" if difference <= TOLERANCE else f"FAILED, above {TOLERANCE:g}"
        failed |= verdict != "ok"
        print(f"{path}: largest relative difference {difference:.3g} {verdict}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
