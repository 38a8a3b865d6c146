"""What `ljmd plot` is given: a directory or a table of ljmd, known by what is in it, and the pictures that suit it."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Callable, Optional

import comparison_pictures
import few_body_pictures
import fluid_pictures
import reproduction_pictures
import structure_pictures
import sweep_pictures
import table_pictures
from ljmd.errors import InputError
from ljmd.reading import fluids, records
from ljmd.reading.files import damaged, is_there
from ljmd.reading.tables import header_of
from style import plt

COMPARISONS = re.compile(r"compare-(\w+?)(-trajectory|-rdf)?\.(json|csv)")
# Tables of a run that are part of other pictures than one of their own name, by kind of run.
OF_RUN = {"fluid": {"thermo": ["thermo"]}, "few-body": {"thermo": ["energy", "momentum"],
                                                       "trajectory": ["orbit", "phase", "relative"]}}


@dataclass(frozen=True)
class Choice:
    """What the pictures depend on beside the data."""

    against: Optional[str] = None  # of a sweep: the key on the axis
    relative_to: Optional[int] = None  # of few bodies: the body they are seen from, counted from 1


@dataclass(frozen=True)
class Source:
    """What can be drawn of a path."""

    kind: str
    pictures: dict[str, Callable[[], plt.Figure]]  # each draws when it is called
    usual: list[str]  # those that are drawn where none is asked for
    folder: Path  # where pictures go


def recognize(path: Path, choice: Choice) -> Source:
    """The pictures of a directory or file.

    Raises InputError when there is nothing at `path` or an option does not suit it, DataError when nothing there is of
    ljmd, or a file is missing or damaged.
    """
    if not is_there(path):
        raise InputError(f"{path}: no such file or directory")
    source = of_directory(path, choice) if path.is_dir() else of_file(path, choice)
    for option, value, kind in (("--against", choice.against, "sweep"), ("--relative-to", choice.relative_to, "few-body")):
        if value is not None and source.kind != kind:
            raise InputError(f"{path}: {option} is for a {'run of few bodies' if kind == 'few-body' else kind}")
    if not source.pictures:
        raise damaged(path, "there is nothing to draw")
    return source


def of_directory(path: Path, choice: Choice) -> Source:
    if is_there(path / "sweep.json"):
        pictures = sweep_pictures.pictures(path, choice.against)
        tables = fluid_pictures.pictures_of_tables(fluids.tables_of_analysis(path))  # of replicas, merged
        return Source("sweep", pictures | tables, [*sweep_pictures.usual(list(pictures)), *tables], path)
    if is_there(path / "run.json"):
        kind = records.read(path).kind
        pictures = (fluid_pictures.pictures(path) if kind == "fluid" else
                    few_body_pictures.pictures(path, choice.relative_to or 1))
    elif is_there(path / "judge.json") or any(path.glob("compare-*.json")):
        kind, pictures = "comparison", comparison_pictures.pictures(path)
    elif is_there(path / "isotherms.csv") or (path / "rows").is_dir():
        kind, pictures = "reproduction", reproduction_pictures.pictures(path)
    elif any(is_there(path / f"{name}.csv") for name in ("rdf", *structure_pictures.PICTURES)):
        kind, pictures = "analysis", fluid_pictures.pictures_of_tables(fluids.tables_of_analysis(path))
    else:
        tables = sorted(path.glob("*.csv"))
        if not tables:
            raise damaged(path, "holds no run, analysis, sweep, reproduced table or comparison of ljmd, and no table")
        kind = "tables"
        pictures = {one.stem: partial(table_pictures.plot_table, one, one.stem) for one in tables}
    return Source(kind, pictures, list(pictures), path)


def of_file(path: Path, choice: Choice) -> Source:
    """A file is part of a directory; a table that is part of none is drawn by itself."""
    folder = path.parent
    comparison = COMPARISONS.fullmatch(path.name)
    if path.name == "judge.json":
        return narrowed(of_comparisons(folder), ["judge"])
    if path.name in ("sweep.csv", "sweep.json") and is_there(folder / "sweep.json"):
        return of_directory(folder, choice)
    if path.name in ("run.json", "results.json", "results.txt", "rows.csv", "isotherms.csv"):
        return of_directory(folder, choice)
    if comparison and is_there(folder / f"compare-{comparison[1]}.json"):
        return narrowed(of_comparisons(folder), [f"compare-{comparison[1]}"])
    if path.suffix != ".csv":
        raise damaged(path, "is no table of ljmd (.csv), nor part of a run, a sweep, a reproduced table or a comparison")
    if is_there(folder / "run.json"):
        names = OF_RUN[records.read(folder).kind].get(path.stem)
        if names:
            return narrowed(of_directory(folder, choice), names)
    return of_table(path)


def of_comparisons(folder: Path) -> Source:
    pictures = comparison_pictures.pictures(folder)
    return Source("comparison", pictures, list(pictures), folder)


def narrowed(source: Source, names: list[str]) -> Source:
    """Only some of the pictures."""
    kept = {name: draw for name, draw in source.pictures.items() if name in names}
    return Source(source.kind, kept, list(kept), source.folder)


def of_table(path: Path) -> Source:
    """A table with the columns of g(r), S(k) and so on, whatever its name is; else each column."""
    folder = path.parent
    in_run = is_there(folder / "run.json") and records.read(folder).kind == "fluid"
    run = fluids.load(folder) if in_run else fluids.tables_of_analysis(folder, path.stem)
    header = header_of(path)
    if set(fluid_pictures.RDF_COLUMNS) <= set(header):
        table = fluid_pictures.read_rdf(path)
        draw = partial(fluid_pictures.plot_rdf, run, table) if table is not None else None
    else:
        draw = structure_pictures.of_table(run, path, header)
    if draw is None:
        draw = partial(table_pictures.plot_table, path, run.title if in_run else path.stem)
    return Source("table", {path.stem: draw}, [path.stem], folder)
