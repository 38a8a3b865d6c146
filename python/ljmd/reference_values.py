"""Values of the Lennard-Jones fluid to a wanted error, as `ljmd reference` finds them."""

from __future__ import annotations

import json
import pathlib
import re
import tempfile
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

from . import _check, _program
from ._text import NamedTables, html_lines, html_table, mixed_table, with_error
from .errors import DataError, Error, InputError
from .reading.files import field, is_there, read_json
from .reading.tables import read_numbers

if TYPE_CHECKING:
    from ._types import Path


class ReferenceValue:
    """A property: mean with its errors, one standard deviation each; None where there is none, and remark says why.

    mean, statistical_error, systematic_error, total_error: in reduced units
    equation_of_state: the same by thol2016; equations: by all equations, by name
    unit, remark
    """

    def __init__(self, name: str, data: dict, file: pathlib.Path):
        def number(key: str):
            return field(file, data, key, float, default=None)

        self.name, self.data = name, data
        self.mean, self.unit, self.remark = number("mean"), field(file, data, "unit", str), field(file, data, "remark", str, default="")
        self.statistical_error, self.systematic_error = number("statistical_error"), number("systematic_error")
        self.total_error, self.equation_of_state = number("total_error"), number("equation_of_state")
        self.equations = field(file, data, "equations_of_state", dict, default={})

    def __repr__(self) -> str:
        if self.mean is None:
            return f"{self.name}: no value ({self.remark})"
        error = self.total_error if self.total_error is not None else self.statistical_error
        return f"{self.name} = {with_error(self.mean, error)} {self.unit}".rstrip(" 1")


class Reference(NamedTables):
    """What `reference()` found: `found["pressure"].mean`, `.total_error`; `found.table("rdf")` and `"sk"`, if they were asked for;
    `found.values` as a table.

    phase: "gas", "liquid", "supercritical fluid", ...
    warnings: what a reader must know
    citation: a paragraph to cite
    data: all numbers, as in results.json (docs/reference.md)
    directory: where the runs are; None: nowhere any more
    """

    def __init__(self, data: dict, tables: dict, directory):
        file = pathlib.Path("results.json") if directory is None else directory / "results.json"
        self.data, self._tables, self.directory = data, tables, directory
        self.phase, self.warnings, self.citation = field(file, data, "phase", str), field(file, data, "warnings", list), field(file, data, "citation", str)
        self._values = {name: ReferenceValue(name, value, file) for name, value in data.items()
                        if isinstance(value, dict) and "statistical_error" in value}
        self._temperature, density = field(file, data, "temperature", float), data.get("density")
        self._density = field(file, density, "mean", float) if isinstance(density, dict) else field(file, data, "density", float)

    @classmethod
    def open(cls, directory: Path) -> "Reference":
        """See `ljmd.open`. Raises DataError where the errors asked for have not been reached yet."""
        directory = _check.directory_of(directory)
        if not is_there(directory / "results.json"):
            raise DataError(f"{directory}: the reference values have not been found yet; the same ljmd.reference(...) with this "
                            "directory goes on")
        return cls(read_json(directory / "results.json"), _tables_in(directory), directory)

    def __getitem__(self, name: str) -> ReferenceValue:
        if not isinstance(name, str) or name not in self._values:
            raise KeyError(f"no {_check.shown(name)}; there are {', '.join(self._values)}")
        return self._values[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def keys(self) -> Iterable[str]:
        """Names of the values."""
        return self._values.keys()

    @property
    def values(self) -> Any:
        """A row for each value: name, mean, errors, equation of state, unit."""
        rows = list(self._values.values())
        numbers = ("mean", "statistical_error", "systematic_error", "total_error", "equation_of_state")
        return mixed_table({"name": [row.name for row in rows],
                            **{each: [float("nan") if getattr(row, each) is None else getattr(row, each) for row in rows] for each in numbers},
                            "unit": [row.unit for row in rows]})

    def _heading(self) -> str:
        return f"Lennard-Jones fluid at T = {self._temperature}, rho = {self._density:.6g}: {self.phase}"

    def __repr__(self) -> str:
        return "\n".join([self._heading(), *(f"  {value!r}" for value in self._values.values()),
                          *(f"  warning: {each}" for each in self.warnings)])

    def _repr_html_(self) -> str:
        rows = [(row.name, "" if row.mean is None else f"{row.mean:.6g}",
                 *("" if each is None else f"{each:.2g}" for each in (row.statistical_error, row.systematic_error)),
                 "" if row.equation_of_state is None else f"{row.equation_of_state:.5g}", row.unit) for row in self._values.values()]
        return html_table(("", "value", "statistical", "systematic", "thol2016", "unit"), rows, self._heading()) + html_lines(self.warnings)


def _tables_in(directory: pathlib.Path) -> dict:
    return {name: read_numbers(directory / f"{name}.csv") for name in ("rdf", "sk") if is_there(directory / f"{name}.csv")}


def reference(temperature: float, density: float | None = None, *, pressure: float | None = None, properties: str | Iterable[str] | None = (),
              errors: Mapping[str, float] | None = None, atoms: int | None = None, replicas: int | None = None, max_steps: int | None = None,
              seed: int | None = None, metastable: bool = False, jobs: int | None = None, directory: Path | None = None,
              progress: Callable[[str], object] | None = print, force: bool = False) -> Reference:
    """Energy, pressure and other properties of the full Lennard-Jones fluid at a temperature and a density or a pressure.

        found = ljmd.reference(1.2, 0.7, properties=["c_v", "D"], errors={"energy": 0.002}, directory="runs/liquid")
        found["pressure"].mean, found["pressure"].total_error

    properties: names of docs/reference.md beside energy, pressure and Z, which are always found; "all"
    errors: statistical errors to reach, by name
    directory: where the runs go; the same call resumes them, with smaller errors makes them longer. None: they are removed
    progress: called with each line that tells how far it is; None: nothing

    Raises InputError for what makes no sense, PhysicsError for states that cannot be vouched for.
    """
    options = ["--temperature", repr(_check.positive(temperature, "temperature"))]
    for name, value in (("density", density), ("pressure", pressure)):
        options += [] if value is None else [f"--{name}", repr(_check.number(value, name))]
    properties = () if properties is None else properties
    names = [properties] if isinstance(properties, str) else _check.listed(properties, "properties")
    options += ["--properties", ",".join(_check.text(name, "properties") for name in names)] if names else []
    if not isinstance(errors, (Mapping, type(None))):
        raise InputError(f"errors: {_check.shown(errors)}: a table of errors by name is needed, " + '{"energy": 0.002}')
    if errors:
        options += ["--error", ",".join(f"{name}={_check.number(error, name)!r}" for name, error in errors.items())]
    for name, number in (("atoms", atoms), ("replicas", replicas), ("max_steps", max_steps), ("seed", seed), ("jobs", jobs)):
        options += [] if number is None else [f"--{name.replace('_', '-')}", str(_check.whole(number, name, 0))]
    options += [f"--{name}" for name, wanted in (("metastable", metastable), ("force", force)) if _check.truth(wanted, name)]
    if progress is not None and not callable(progress):
        raise InputError(f"progress: {_check.shown(progress)} cannot be called")
    with tempfile.TemporaryDirectory(prefix="ljmd-") as folder:
        out = pathlib.Path(folder) / "reference" if directory is None else _check.directory_of(directory)
        try:
            _, text, _ = _program.call(["reference", *options, "--out", out, "--json"], told=progress,
                                       note="runs that had begun have checkpoints: the same call resumes them" if directory else "")
        except Error as error:
            text = re.sub(r"--([a-z]+)", r"\1", str(error))
            if directory is None:  # nothing is left there to be resumed
                text = re.sub("; to try them again: ljmd resume .*", "", text)
            raise type(error)(text) from None
        tables = _tables_in(out)
    found = Reference(json.loads(text), tables, None if directory is None else out)
    for warning in found.warnings:
        _check.warn(warning)
    return found
