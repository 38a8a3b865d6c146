#!/usr/bin/env python3
"""The pictures of what ljmd has written: of a run, also one that was stopped, has failed or goes on, of an analysis, a
sweep, a reproduced table, a comparison, or of a single table. `ljmd plot` calls this script.

    plot.py DIR|FILE [NAME ...] [--out FILE|DIR] [--against KEY] [--relative-to K] [--force]

Draws the pictures NAME, or all that suit, and prints the path of each, one a line. Of a sweep a NAME is a column of
sweep.csv, pressure by default (of few bodies total_energy), and KEY the varied key on the axis, or the last part of its
name. K is the body from which few bodies are seen. Pictures are PNG, and lie in DIR or beside FILE; with --out they are
what its ending says: .png, .svg or .pdf. Several pictures get their names added: --out a.pdf writes a-thermo.pdf. An
--out without such an ending is a directory. Earlier pictures are replaced, other files only with --force.
Exit codes: 0 ok, 2 usage, 3 a file is missing or damaged, 4 a picture cannot be written.
"""

from __future__ import annotations

import signal

signal.signal(signal.SIGINT, signal.SIG_DFL)  # Ctrl-C ends it at once, also while modules are imported

import argparse  # noqa: E402
import difflib  # noqa: E402
import sys  # noqa: E402
from importlib.util import find_spec  # noqa: E402
from pathlib import Path  # noqa: E402
from typing import Optional, Sequence  # noqa: E402

sys.path.insert(0, str(Path(__file__).resolve().parent))
absent = [name for name in ("numpy", "matplotlib") if find_spec(name) is None]
if absent:
    packages = " ".join(f"python3-{name}" for name in absent)
    print(f"error: pictures need {' and '.join(absent)}, which {sys.executable} does not have: apt-get install {packages}, or "
          f"{sys.executable} -m pip install {' '.join(absent)}", file=sys.stderr)
    sys.exit(2)

from script import reports_errors  # noqa: E402  (it finds the package ljmd)
import sources  # noqa: E402
import style  # noqa: E402
from ljmd.errors import InputError  # noqa: E402
from sources import Choice, Source  # noqa: E402


def chosen(source: Source, path: Path, names: Sequence[str]) -> list[str]:
    """The pictures that are asked for, each once, in the order in which they were named."""
    for name in names:
        if name not in source.pictures:
            near = difflib.get_close_matches(name, source.pictures, 1)
            advice = f"; did you mean '{near[0]}'?" if near else ""
            raise InputError(f"{path}: no picture '{name}' (there are: {', '.join(source.pictures)}){advice}")
    return list(dict.fromkeys(names)) or source.usual


def places(source: Source, names: Sequence[str], out: Optional[Path]) -> dict[str, Path]:
    """The file of each picture."""
    if out is None or (out.suffix not in style.FORMATS and (out.is_dir() or not out.suffix)):
        return {name: (out or source.folder) / f"{name}.png" for name in names}
    if out.suffix not in style.FORMATS:
        raise InputError(f"{out}: must end in {', '.join(style.FORMATS)}, or be a directory")
    if len(names) == 1:
        return {names[0]: out}
    return {name: out.with_name(f"{out.stem}-{name}{out.suffix}") for name in names}


@reports_errors
def main(arguments: Optional[Sequence[str]] = None) -> int:
    parser = argparse.ArgumentParser(prog="plot", description="Draw the pictures of what ljmd has written.")
    parser.add_argument("path", type=Path, metavar="DIR|FILE", help="a directory or a table that ljmd wrote")
    parser.add_argument("names", nargs="*", metavar="NAME", help="pictures to draw (all that suit)")
    parser.add_argument("--out", type=Path, metavar="FILE", help="ends in .png, .svg or .pdf, or is a directory")
    parser.add_argument("--against", metavar="KEY", help="of a sweep: varied key on the axis (the last)")
    parser.add_argument("--relative-to", type=int, metavar="K", help="of few bodies: seen from this one, counted from 1")
    parser.add_argument("--force", action="store_true", help="replace files that are no pictures of ljmd")
    options = parser.parse_args(arguments)
    style.use()
    source = sources.recognize(options.path, Choice(options.against, options.relative_to))
    names = chosen(source, options.path, options.names)
    pictures = places(source, names, options.out)
    for path in pictures.values():
        style.require_writable(path, options.force)
    for name, path in pictures.items():
        style.save(source.pictures[name](), path, options.force)
    return 0


if __name__ == "__main__":
    sys.stdout.reconfigure(errors="surrogateescape")  # names of files are bytes, which need not be UTF-8
    sys.exit(main())
