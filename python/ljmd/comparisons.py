"""Comparisons with independent programs, as `ljmd compare` makes them."""

from __future__ import annotations

import json
import pathlib
import tempfile
from collections.abc import Iterable
from typing import Any

import numpy as np

from . import _check, _program
from ._text import NamedTables, html_lines, html_table, mixed_table, with_error
from .errors import Error, InputError
from .reading.files import is_there
from .reading.tables import read_numbers

PROGRAMS = ("openmm", "lammps", "gsl")
ENGINES = ("command:", "files:")
_NAMES = {"": "errors", "trajectory": "trajectory", "rdf": "rdf"}


class Comparison(NamedTables):
    """What `Deck.compare` found.

    passed: whether all checks have passed; of few bodies, whether the reference conserves the energy and can be relied on
    data: all numbers, as in compare-PROGRAM.json (docs/crosscheck.md)
    directory: where its files are; None: nowhere
    tables: "trajectory" (distances of atoms at each step) and "rdf" of a fluid, "errors" of few bodies
    """

    def __init__(self, data: dict[str, Any], tables: dict[str, Any], directory: pathlib.Path | None = None):
        self.data, self._tables, self.directory = data, tables, directory

    @property
    def passed(self) -> bool:
        """Whether all checks have passed."""
        return bool(self.data["passed"])

    def __bool__(self) -> bool:
        raise InputError("a comparison is no truth value: look at its `passed`")

    @property
    def checks(self) -> Any:
        """A row for each check: name, value, tolerance, passed."""
        rows = self.data["checks"]
        return mixed_table({key: [row[key] for row in rows] for key in ("name", "value", "tolerance", "passed")})

    @property
    def failures(self) -> list[str]:
        """Names of the checks that have failed."""
        return [check["name"] for check in self.data["checks"] if not check["passed"]]

    @property
    def diagnoses(self) -> list[str]:
        """Of an engine: known mistakes that explain what has failed (docs/judge.md)."""
        return list(self.data.get("diagnoses", []))

    @property
    def not_judged(self) -> list[str]:
        """Of an engine: parts that its answer lacks, or is too short for."""
        return list(self.data.get("not_judged", []))

    @property
    def averages(self) -> Any:
        """Of a fluid: a row for each average, with name, ljmd and peer, their standard errors, and the difference in its errors."""
        rows = self.data.get("averages", {}).get("observables", {})
        return mixed_table({
            "name": list(rows), **{f"{who}{suffix}": [_or_nan(row[who][key]) for row in rows.values()]
                                   for who in ("ljmd", "peer") for suffix, key in (("", "mean"), ("_standard_error", "standard_error"))},
            "sigmas": [_or_nan(row["sigmas"]) for row in rows.values()]})

    def _heading(self) -> str:
        return f"ljmd against {self.data.get('peer', self.data.get('with', 'gsl'))}"

    def _verdict(self) -> str:
        checks = self.data["checks"]
        if not checks:
            return "nothing was judged"
        return f"all {len(checks)} checks passed" if self.passed else f"{len(self.failures)} of {len(checks)} checks FAILED"

    def _check_rows(self) -> list:
        return [(check["name"], f"{_or_nan(check['value']):.2e}", f"{_or_nan(check['tolerance']):.1e}",
                 "" if check["passed"] else "FAILED") for check in self.data["checks"]]

    def _average_rows(self) -> list:
        rows = self.data.get("averages", {}).get("observables", {})
        return [(name, *(with_error(_or_nan(row[who]["mean"]), _or_nan(row[who]["standard_error"])) for who in ("ljmd", "peer")),
                 f"{_or_nan(row['sigmas']):.2f}") for name, row in rows.items()]

    def _remarks(self) -> list:
        return [f"diagnosis: {text}" for text in self.diagnoses] + [f"not judged: {text}" for text in self.not_judged]

    def _error_rows(self) -> list:
        return [(key, f"{value:.3e}") for key, value in self.data.items() if key.startswith("largest_")]

    def __repr__(self) -> str:
        lines = [self._heading()]
        for rows in (self._check_rows(), self._average_rows(), self._error_rows()):
            widths = [max(len(row[k]) for row in rows) for k in range(len(rows[0]))] if rows else []
            lines += ["  " + "  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in rows]
        return "\n".join([*lines, *self._remarks(), self._verdict()])

    def _repr_html_(self) -> str:
        html = html_table(("check", "found", "allowed", ""), self._check_rows(), self._heading())
        if self._error_rows():
            html += html_table((), self._error_rows())
        if self._average_rows():
            html += html_table(("average", "ljmd", self.data["with"], "sigmas"), self._average_rows())
        return html + html_lines([*self._remarks(), self._verdict()])


def _or_nan(value) -> float:
    return np.nan if value is None else float(value)


def compare(deck, program, *, parts, steps, frames, platform, directory, threads, simd, precision, timeout, force) -> Comparison:
    """See `Deck.compare`."""
    if program is None:
        program = "gsl" if "force" in deck._tables else "openmm"
    program = _check.text(program, "program")
    if program not in PROGRAMS and not program.startswith(ENGINES):
        raise InputError(f"unknown program {_check.shown(program)} to compare with; there are {', '.join(PROGRAMS)}, "
                         "command:./engine {input} {output}, files:DIR")
    options = [f"--with={program}"]  # one word: a value is no option, whatever it begins with
    if parts is not None:
        names = [parts] if isinstance(parts, str) else _check.listed(parts, "parts")
        options.append("--parts=" + ",".join(_check.text(each, "parts") for each in names))
    if frames is not None:
        one = not isinstance(frames, Iterable) or getattr(frames, "ndim", 1) == 0
        options.append("--frames=" + ",".join(str(_check.whole(each, "frames", 1))
                                              for each in ([frames] if one else _check.listed(frames, "frames"))))
    if steps is not None:
        options.append(f"--steps={_check.whole(steps, 'steps', 0)}")
    if threads is not None:
        options.append(f"--threads={_check.whole(threads, 'threads', 1)}")
    options += [f"--{name}={_check.text(value, name)}" for name, value in (("platform", platform), ("simd", simd), ("precision", precision),
                                                                         ("timeout", timeout)) if value is not None]
    with tempfile.TemporaryDirectory(prefix="ljmd-") as folder:
        out = pathlib.Path(folder) / "found" if directory is None else _check.directory_of(directory)
        deck_file, settings = deck._in_file(pathlib.Path(folder))

        def shown(text: str) -> str:
            """In words of whoever calls, who knows no file of the deck and no temporary directory."""
            text = text.replace(str(deck_file), "Deck")
            if directory is None:
                text = text.replace(str(out / "exchange" / "answer"), "{output}").replace(str(out / "exchange" / "problem"), "{input}")
            return text

        try:
            code, text, said = _program.call(["compare", deck_file, "--json", "--out", out, *options, *settings,
                                           *(["--force"] if _check.truth(force, "force") else [])], allowed=(0, 5))
        except Error as error:
            raise type(error)(shown(str(error)).replace("--force", "force=True")) from None
        if not text.strip():
            _program.raise_error(code, said)
        _program.warned(shown(line) for line in said)
        tables = {}
        for ending, name in _NAMES.items():
            path = out / f"compare-{program}{'-' if ending else ''}{ending}.csv"
            if program in PROGRAMS and is_there(path):
                tables[name] = read_numbers(path)
    data = json.loads(text)
    data.update(deck=deck.title, **{"with": program})
    return Comparison(data, tables, None if directory is None else out)
