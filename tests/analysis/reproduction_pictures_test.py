#!/usr/bin/env python3
"""Tests of analysis/plot.py on made-up tables. Prints "N passed, M failed"."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import fixtures
import numpy as np
import reproduction_pictures
import style
from ljmd.reading import reproductions
from fixtures import check_error, edit, png_size, refused, plot

VERLET = [{"value": 3.5, "soundness": "sound"}, {"value": 2.0, "soundness": "suspect"}, None]


def entry(k: int) -> dict[str, Any]:
    return {"rho": 0.5 + 0.1 * k, "T": 1.0 + k, "Z": 1.0 + k, "Z_standard_error": 0.01, "Z_beyond_cutoff": 0.02,
            "Z_verlet": VERLET[k], "Z_thol2016": 0.9 + k, "Z_kolafa_nezbeda1994": 0.8 + k}


def write_table(directory: Path, rows: int = 3) -> Path:
    directory.mkdir(exist_ok=True)
    (directory / "results.json").write_text(json.dumps({"rows": [entry(k) for k in range(rows)]}))
    rho = np.tile(np.linspace(0.3, 0.9, 5), 2)
    temperature = np.repeat([0.75, 2.0], 5)
    fixtures.write_csv(directory / "isotherms.csv", {"T": temperature, "rho": rho, "Z_thol2016": rho * temperature,
                                                     "Z_kolafa_nezbeda1994": rho * temperature + 0.1})
    return directory


def test_picture(tmp: Path) -> None:
    result = plot(write_table(tmp / "table"))
    assert result.returncode == 0 and result.stderr == "", result
    assert result.stdout.splitlines() == [str(tmp / "table" / "isotherms.png")], result
    assert png_size(tmp / "table" / "isotherms.png") == (375, 400)
    result = plot(tmp / "table", "--out", tmp / "x.svg")
    assert result.returncode == 0 and (tmp / "x.svg").read_text().startswith("<?xml"), result


def test_what_is_drawn(tmp: Path) -> None:
    style.use()
    rows, isotherms = reproductions.load(write_table(tmp))
    above, below = reproduction_pictures.plot(rows, isotherms).axes[:2]
    assert len([line for line in above.lines if len(line.get_xdata()) == 5]) == 4  # two equations, two temperatures
    found, verlet = above.collections[:2]
    assert np.allclose(found.get_offsets(), [[0.5, 1.0], [0.6, 2.0], [0.7, 3.0]]), found.get_offsets()
    assert np.allclose(np.ma.filled(verlet.get_offsets(), np.nan)[:2], [[0.5, 3.5], [0.6, 2.0]]), verlet.get_offsets()
    lines = {line.get_label(): line for line in below.lines}
    assert np.allclose(lines["Verlet"].get_ydata(), [3.5 - 0.9])
    assert np.allclose(lines["Verlet, suspect or metastable"].get_ydata()[:1], [2.0 - 1.9])
    assert np.allclose(lines["Kolafa, Nezbeda"].get_ydata(), -0.1)
    bars = below.containers[0].lines[0]
    assert np.allclose(bars.get_ydata(), 0.12), bars.get_ydata()


def test_a_single_row(tmp: Path) -> None:
    rows, isotherms = reproductions.load(write_table(tmp, rows=1))
    reproduction_pictures.plot(rows, isotherms)


def test_what_cannot_be_drawn(tmp: Path) -> None:
    (tmp / "begun" / "rows").mkdir(parents=True)
    check_error(plot(tmp / "begun"), 3, "not come to its end")
    check_error(plot(write_table(tmp), "--out", tmp / "x.txt"), 2, "must end in .png")
    edit(tmp / "results.json", '"Z_thol2016": 0.9, ', "")
    refused(lambda: reproductions.load(tmp), "Z_thol2016")
    edit(write_table(tmp) / "results.json", '"value": 3.5', '"value": {}')
    refused(lambda: reproductions.load(tmp), "results.json: 'value' is {}")
    refused(lambda: reproductions.load(write_table(tmp, rows=0)), "no rows")
    (write_table(tmp) / "results.json").write_text('{"rows": [1]}')
    refused(lambda: reproductions.load(tmp), "not an object")
    edit(write_table(tmp) / "isotherms.csv", "rho", "r")
    refused(lambda: reproductions.load(tmp), "no column 'rho'")


if __name__ == "__main__":
    sys.exit(fixtures.run_tests(globals()))
