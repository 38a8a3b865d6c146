"""Decks: what a run does, read by the same reader as on the command line."""

from __future__ import annotations

import copy
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, overload

from . import _check, _core, _output
from ._text import html_pre, html_table
from .comparisons import Comparison, compare
from .errors import InputError
from .potentials import Pair
from .replicas import Replicas, run_replicas
from .runs import Run
from .simulation import Simulation
from .sweeps import Sweep, sweep
from .tables import Analyses, Attribute, Stage, Table, stage_of

if TYPE_CHECKING:
    from ._keys import Body, Force, Neighbors, Output, Performance, Potential, Substance, System
    from ._types import Function, Functions, Path, Points, Progress, Walltime

_Assigned = Mapping[str, Any]
_ATTRIBUTES = {"argon": "substance"}  # of a deck, by the key
_TABLES = frozenset(("system", "potential", "neighbors", "performance", "output", "argon", "force"))


def _table(key: str, meaning: str) -> Any:
    """A table of decks as an attribute of them."""
    return Attribute(lambda deck: deck._table(key), lambda deck, value: deck._put(key, value), None, meaning)


class Deck(_check.Loadable):
    """What a run does: atoms, forces, stages, analyses and outputs.

    A deck comes from a file (`Deck.load`), a text in TOML (`Deck.parse`) or keywords (`Deck.fluid`, `Deck.few_body`).
    Its tables are attributes, `deck.system.density = 0.8`; docs/deck-reference.md lists all keys. `print(deck)` shows the
    whole as TOML. Mistakes are found by `check()` and `run()`, all at once, each with its place.
    """

    __slots__ = ("_tables", "_origin", "_pair")

    def __init__(self, tables: _Assigned | None = None):
        self._tables: dict = {}
        self._origin: tuple | None = None  # name, text, settings and tables, as text, of what was read
        self._pair: Pair | None = None
        for name, value in _check.table(tables, "tables").items():
            self._put(name, value)

    @classmethod
    def load(cls, path: Path, *, set: _Assigned | None = None) -> "Deck":  # noqa: A002, the word of the command line
        """The deck in a file. `set` replaces values as --set does: {"stage.production.steps": 500}.

        Raises InputError for a file that cannot be read, or that is no TOML.
        """
        path = _check.path(path, "path")
        return cls._read(path, _core.read_file(path), set)

    @classmethod
    def parse(cls, text: str, *, set: _Assigned | None = None, name: str = "Deck") -> "Deck":  # noqa: A002
        """The deck in a text. `name` stands before its lines in messages."""
        return cls._read(_check.text(name, "name"), _check.text(text, "text"), set)

    @classmethod
    def _read(cls, name, text, changes):
        settings = [f"{_check.text(key, 'set')}={_core.value_text(value, key)}" for key, value in _check.table(changes, "set").items()]
        deck = cls(_core.parse(name, text, settings))
        deck._origin = (name, text, settings, deck._written())
        return deck

    @classmethod
    def fluid(cls, atoms: int = 864, density: float | str = 0.8442, temperature: float | str = 0.722, *, substance: _Assigned | None = None,
              lattice: str = "fcc", file: Path | None = None, potential: str = "lennard-jones", cutoff: float | str = 2.5,
              truncation: str = "cut", tail: bool | None = None, seed: int = 1, title: str | None = None, **parameters: float | str) -> "Deck":
        """A fluid in a periodic box.

        atoms, density, temperature: N, N/V [sigma^-3], T [epsilon/k_B]; also with a unit where there is a substance: "86 K"
        substance: `ljmd.ARGON`, or a table with sigma, epsilon and mass
        lattice: "fcc", "simple-cubic" or "random"
        file: a configuration or the directory of a run to start from, instead of a lattice
        potential, parameters: one of `ljmd.build()["potentials"]` and its parameters
        cutoff: [sigma]
        truncation: "cut", "shifted", "force-shifted" or "switched" (with switch_start=...)
        tail: whether energy and pressure are corrected for what the truncation removes; True for "cut" and "switched"
        seed: of all random numbers

        The deck has no stages yet: `deck.stages = [ljmd.Stage(...), ...]`.
        """
        start: dict = {"file": file} if file is not None else {"lattice": {"type": lattice, "atoms": atoms}, "density": density}
        if tail is not None:
            tail = _check.truth(tail, "tail")
        elif isinstance(truncation, str) and truncation in ("cut", "switched"):
            tail = True
        forces = {"type": potential, "cutoff": cutoff, "truncation": truncation, "tail": tail, **parameters}
        return cls({"title": title, "argon": substance, "system": {**start, "temperature": temperature, "seed": seed},
                    "potential": {key: value for key, value in forces.items() if value is not None}})

    @classmethod
    def few_body(cls, force: str, bodies: Iterable[_Assigned], *, title: str | None = None, **options: float) -> "Deck":
        """A few bodies without a box, in units of your own.

        force: "newtonian-gravity", "pendulum", "radial-kepler" or "harmonic"; options are its keys
        bodies: tables with mass, position and velocity

            Deck.few_body("newtonian-gravity", [dict(mass=1.0, position=[1.0, 0.0], velocity=[0.0, 1.2])],
                          gravitational_constant=1.0, central_mass=1.0)
        """
        return cls({"title": title, "force": {"type": force, **options}, "body": bodies})

    def _put(self, name, value) -> None:
        if name in _TABLES and not isinstance(value, (Mapping, type(None))):
            raise InputError(f"{_ATTRIBUTES.get(name, name)}: {_check.shown(value)}: a table is needed, {{...}}")
        if name == "title" and value is not None:
            value = _check.text(value, name)
        elif name == "stage" and value is not None:
            if not isinstance(value, (list, tuple)) or not all(isinstance(stage, Mapping) for stage in value):
                raise InputError("stages: a list of ljmd.Stage is needed")
            value = [stage if isinstance(stage, Stage) else stage_of(stage) for stage in value]
        elif name == "analysis" and value is not None:
            if not (isinstance(value, Mapping) and all(isinstance(options, Mapping) for options in value.values())):
                raise InputError(f"analysis: {_check.shown(value)}: a table with the options of each analysis is needed, " + '{"rdf": {"bins": 200}}')
            value = Analyses({key: Table(options) for key, options in value.items()})
        elif isinstance(value, dict):
            value = Table({key: Table(each) if isinstance(each, dict) else each for key, each in value.items()})
        elif isinstance(value, (list, tuple)):
            value = [Table(each) if isinstance(each, dict) else each for each in value]
        if value is None:
            self._tables.pop(name, None)
        else:
            self._tables[name] = value

    def __getitem__(self, name: str) -> Any:
        return self._tables[name]

    @property
    def title(self) -> str:
        """One line about the run."""
        return self._tables.get("title", "")

    @title.setter
    def title(self, text: str | None) -> None:
        self._put("title", text)

    def _get_stages(self) -> list[Stage]:
        """What is done, one stage after the other."""
        return self._tables.setdefault("stage", [])

    def _give_stages(self, stages: Stage | Iterable[_Assigned]) -> None:
        self._put("stage", [stages] if isinstance(stages, Mapping) else _check.listed(stages, "stages"))

    stages = Attribute(_get_stages, _give_stages)

    def _get_bodies(self) -> list[Body]:
        """Of a few-body deck: tables with mass, position, velocity."""
        return self._tables.setdefault("body", [])

    def _give_bodies(self, bodies: Iterable[_Assigned] | None) -> None:
        self._put("body", bodies)

    bodies = Attribute(_get_bodies, _give_bodies)

    def _get_potential(self) -> Potential:
        """How pairs of atoms interact: a table, or an `ljmd.Pair`, a function of your own."""
        return self._table("potential") if self._pair is None else self._pair  # type: ignore[return-value]  # who gave a Pair knows it

    def _give_potential(self, potential: Pair | _Assigned | None) -> None:
        self._pair = potential if isinstance(potential, Pair) else None
        self._put("potential", self._pair.stand_in if self._pair else potential)

    potential = Attribute(_get_potential, _give_potential)
    system: Attribute[System, _Assigned | None] = _table("system", "Atoms and box: lattice or file, density, temperature, seed.")
    neighbors: Attribute[Neighbors, _Assigned | None] = _table("neighbors", "How pairs are found.")
    performance: Attribute[Performance, _Assigned | None] = _table("performance", "How forces are computed: precision.")
    output: Attribute[Output, _Assigned | None] = _table("output", "Files: thermo, trajectory, checkpoint.")
    analysis: Attribute[Analyses, _Assigned | None] = _table("analysis", "What is measured in the sampled stages: deck.analysis.rdf(bins=200).")
    substance: Attribute[Substance, _Assigned | None] = _table("argon", "A real substance, with sigma, epsilon and mass: adds SI units.")
    force: Attribute[Force, _Assigned | None] = _table("force", "Of a few-body deck.")

    def _table(self, name) -> Any:
        if name not in self._tables:
            self._put(name, {})
        return self._tables[name]

    def set(self, key: str, value: Any) -> "Deck":
        """Replace one value as `--set key=value` does: deck.set("stage.production.steps", 500)."""
        name, source, settings = self._source()
        source = _core.deck_text(source, None)  # as it is now
        settings = [*settings, f"{_check.text(key, 'key')}={_core.value_text(value, key)}"]
        changed = type(self)(_core.parse(name, source, settings))
        self._tables, self._origin = changed._tables, (name, source, settings, changed._written())
        return self

    def copy(self) -> "Deck":
        """A deck that can be changed without changing this one."""
        return self.__copy__()

    def __copy__(self):
        try:
            return copy.deepcopy(self)
        except RecursionError:
            raise InputError("the deck holds lists or tables that are too deep within one another") from None

    def __eq__(self, other):
        return isinstance(other, Deck) and (self.text, self._pair) == (other.text, other._pair)

    __hash__ = None  # type: ignore

    def _source(self) -> tuple:
        """Name, text and settings for the reader: those of the file; or the tables, when they were changed in Python."""
        if self._origin is not None and self._pair is None:
            name, text, settings, tables = self._origin
            if self._written() == tables:
                return name, text, settings
        return "Deck", self._tables, []

    def _written(self) -> str:
        """All tables but those that were only asked for, to see whether they have changed."""
        return _core.deck_text({name: table for name, table in self._tables.items() if not (isinstance(table, (dict, list)) and not table)}, None)

    @property
    def text(self) -> str:
        """The deck as TOML."""
        _, source, settings = self._source()
        return _core.deck_text(self._tables if settings else source, self._core_pair())

    def save(self, path: Path, *, force: bool = False) -> None:
        """Write the deck to a file, for the command line.

        force: replace a file that is there; a link is replaced itself, never what it leads to

        Raises InputError with a pair potential of your own, and for a name that is taken; FileError, which leaves the earlier file.
        """
        if self._pair is not None:
            raise InputError("a pair potential in Python cannot be written to a deck")
        _output.write_text(_check.directory_of(path, "path"), self.text, force=_check.truth(force, "force"))

    def _core_pair(self):
        return None if self._pair is None else self._pair._core

    def _require_stages(self) -> None:
        if self._tables and not self._tables.get("stage"):
            raise InputError('this deck has no stages: deck.stages = [ljmd.Stage("production", 1000, sample=True)]')

    def _loaded(self, force: bool = False):
        self._require_stages()
        pair = self._pair
        if pair is not None and pair.stand_in != {k: v for k, v in self["potential"].items() if v is not None}:
            raise InputError("the deck's potential was changed after an ljmd.Pair was given: give it one with these values")
        name, source, settings = self._source()
        return _core.load(name, source, settings, _check.truth(force, "force"), self._core_pair())

    def check(self, *, threads: int | None = None, simd: str | None = None, force: bool = False) -> "Check":
        """Find all mistakes, and estimate memory, disk and time. Nothing is run.

        Raises InputError with every mistake and its place. `force` accepts unlikely values.
        """
        data, text, warnings = _core.check(self._loaded(force), _check.threads_of(threads), _check.simd_of(simd))
        return Check(data, text, warnings)

    @overload
    def run(self, directory: Path | None = ..., *, observables: Functions = ..., external: Function | None = ..., threads: int | None = ...,
            simd: str | None = ..., progress: Progress = ..., replace: bool = ..., force: bool = ..., walltime: Walltime = ...,
            replicas: None = ..., jobs: None = ...) -> Run: ...

    @overload
    def run(self, directory: Path, *, replicas: int, jobs: int | None = ..., progress: Progress = ..., replace: bool = ...,
            force: bool = ...) -> Replicas: ...

    def run(self, directory: Path | None = None, *, observables: Functions = (), external: Function | None = None, threads: int | None = None,
            simd: str | None = None, progress: Progress = True, replace: bool = False, force: bool = False, walltime: Walltime = None,
            replicas: int | None = None, jobs: int | None = None) -> Run | Replicas:
        """Run all stages.

        directory: where results, tables and checkpoints are written, so that the run can be resumed; None: nowhere
        observables: measurements of your own, see `ljmd.observable`
        external: a force of your own on the atoms, see `ljmd.external_force`
        threads: no result depends on it; OMP_NUM_THREADS or 1 by default
        simd: instruction set of the kernels, one of `ljmd.build()["simd_levels"]`
        progress: a line with per cent and speed; or a function that is called with the number of steps done, 20 times a second
        replace: an earlier run in the directory
        force: accept unlikely values
        walltime: stop after that long with a checkpoint: seconds or "2h"; with a directory
        replicas: as many independent runs, each with a seed of its own and one thread in a process of its own, in the directory; the
            result is that of all, merged (`ljmd run --replicas`, docs/sweeps.md). The same call resumes them
        jobs: replicas at a time; one for each processor by default

        Ctrl-C stops the run after a step; in a directory it writes a checkpoint first, see `ljmd.resume`.
        Raises InputError, DataError, PhysicsError, InUseError, FileError, Interrupted (its wall time is over).
        """
        if replicas is not None:
            if observables or external is not None or threads is not None or simd is not None or walltime is not None:
                raise InputError("replicas run in processes of their own: without observables, external, threads, simd and walltime")
            return run_replicas(self, directory, replicas, jobs=jobs, progress=progress, replace=replace, force=force)
        if jobs is not None:
            raise InputError("jobs is for replicas")
        if directory is None:
            if walltime is not None or _check.truth(replace, "replace"):
                raise InputError("walltime and replace are for a run with a directory")
            simulation = Simulation(self, observables=observables, external=external, threads=threads, simd=simd, force=force)
            return simulation.run(progress=progress)
        return Run.in_directory(self._loaded(force), directory, observables=observables, external=external, threads=threads, simd=simd,
                                progress=progress, replace=replace, walltime=walltime)

    def sweep(self, points: Points, *, jobs: int | None = None, directory: Path | None = None, progress: Progress = True,
              force: bool = False) -> Sweep:
        """Run this deck at many settings, several points at a time, each with one thread in a process of its own: `ljmd sweep`.

            sweep = deck.sweep({"system.temperature": [1.0, 1.5, 2.0], "system.density": [0.2, 0.5]}, jobs=2, directory="runs/gas")
            sweep.to_dataframe()

        points: {"key": values}, all combinations are run, the last key fastest; or a list of {"key": value}, one for each point.
            Keys are those of `Deck.set`
        jobs: points at a time; one for each processor by default
        directory: where the runs are kept; None: a temporary one, which lives as long as the sweep
        progress: a line with per cent and speed; or a function that is called with the number of points done
        force: accept unlikely values, and replace another sweep in the directory, but for points that both have

        The same call continues an interrupted sweep, and tries failed points again. Ctrl-C stops all points with
        checkpoints. A point that fails is a warning, and does not stop the others. Raises InputError with all mistakes of all points
        before anything is run, InUseError, FileError.
        """
        return sweep(self, points, jobs=jobs, directory=directory, progress=progress, force=force)

    def compare(self, program: str | None = None, *, parts: str | Iterable[str] | None = None, steps: int | None = None,
                frames: int | Iterable[int] | None = None, platform: str | None = None, directory: Path | None = None, threads: int | None = None, simd: str | None = None, precision: str | None = None,
                timeout: str | None = None, force: bool = False) -> Comparison:
        """Compare with an independent program, number by number: `ljmd compare`, see docs/crosscheck.md.

            found = deck.compare("openmm", parts=["point", "trajectory"])
            found.passed, found.checks

        program: "openmm" or "lammps" for a fluid; "gsl", an adaptive solution, for few bodies. By default openmm or gsl.
            "command:./engine {input} {output}" or "files:DIR" judge any engine, see docs/judge.md
        parts: of "point", "trajectory", "averages", "speed"; all by default
        steps, frames: length of the trajectories, 1000 by default, and the steps at which they are judged
        platform: of OpenMM: "Reference" (default), "CPU", "OpenCL"
        timeout: wall time of an engine, "90s", "30min"; "1h" by default
        directory: where tables and numbers are written; None: nowhere
        force: accept unlikely values, and replace an earlier comparison in the directory

        Checks that fail are no exception: see `passed`. Ctrl-C ends it at once. Raises InputError for mistakes of the deck, and where
        the program is missing: also where ljmd was built without OpenMM.
        """
        return compare(self, program, parts=parts, steps=steps, frames=frames, platform=platform, directory=directory, threads=threads,
                       simd=simd, precision=precision, timeout=timeout, force=force)

    def _in_file(self, folder) -> tuple:
        """The deck for the command line: a file that is written into the folder, and arguments of --set."""
        if self._pair is not None:
            raise InputError("a pair potential in Python is not known to the program: it runs in memory alone")
        self._require_stages()
        _, source, settings = self._source()
        path = folder / "deck.toml"
        path.write_text(_core.deck_text(source, None), encoding="utf-8")
        return path, [argument for setting in settings for argument in ("--set", setting)]

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        what = f" {self.title!r}" if self.title else ""
        return f"<ljmd.Deck{what}: {'; '.join(self._summary())}>"

    def _summary(self) -> list:
        parts = []
        system = self._tables.get("system", {})
        if system:
            lattice = system.get("lattice", {})
            parts.append(f"start {system['file']}" if "file" in system else
                         f"{lattice.get('atoms', '')} {lattice.get('type', '')}".strip())
            parts += [f"{name} {system[name]}" for name in ("density", "temperature") if name in system]
        if self._pair is not None:
            parts.append(f"pair potential {self._pair.name!r} of Python")
        elif "potential" in self._tables:
            forces = self._tables["potential"]
            parts.append(f"{forces.get('type')} {forces.get('truncation')} at {forces.get('cutoff')}"
                         f"{' with tail' if forces.get('tail') else ''}")
        if "force" in self._tables:
            parts.append(f"{len(self.bodies)} {'body' if len(self.bodies) == 1 else 'bodies'}, "
                         f"{self._tables['force'].get('type')}")
        parts += [f"{stage.get('name')} {stage.get('steps')}" for stage in self._tables.get("stage", [])] or ["no stages"]
        return parts

    def _repr_html_(self) -> str:
        rows = [(part,) for part in self._summary()]
        return html_table((), rows, self.title or "ljmd.Deck") + html_pre(self.text)


class Check:
    """What `Deck.check()` found: `data` has atoms, box, memory, disk, seconds; `warnings` the remarks on the deck."""

    def __init__(self, data: dict[str, Any], text: str, warnings: list[str]):
        self.data, self.text = data, text
        self.warnings = [warning.removeprefix("warning: ").rstrip() for warning in warnings]

    def __repr__(self) -> str:
        return self.text + "".join(f"warning: {warning}\n" for warning in self.warnings)

    def _repr_html_(self) -> str:
        return html_pre(repr(self))
