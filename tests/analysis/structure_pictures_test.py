#!/usr/bin/env python3
"""Tests of the pictures of structure and motion on made-up runs. Prints "N passed, M failed"; exit code 1 if any failed."""

from __future__ import annotations

import sys
from pathlib import Path

import fixtures
import numpy as np
import structure_pictures
import time_pictures
from fixtures import edit, plot, png_size
from fluid_pictures_test import write_run

TIME = np.linspace(0.0, 4.0, 41)
K = np.linspace(0.6, 15.0, 60)


def write_tables(run: Path) -> Path:
    """The tables of structure and motion of a liquid, roughly."""
    error = np.full(K.size, 0.02)
    peak = 1.0 + 1.8 * np.exp(-(((K - 6.8) / 0.5) ** 2))
    fixtures.write_csv(run / "sk.csv", {"k": K, "S": peak, "S_standard_error": error, "vectors": 8.0 * K})
    fixtures.write_csv(run / "sk_from_rdf.csv", {"k": 2.0 * K, "S": np.ones(K.size), "S_standard_error": error})
    error = np.full(TIME.size, 0.01)
    fixtures.write_csv(run / "msd.csv", {"time": TIME, "msd": 0.2 * TIME, "msd_standard_error": error})
    decay = np.exp(-3.0 * TIME)
    fixtures.write_csv(run / "vacf.csv", {"time": TIME, "vacf": 2.2 * decay, "vacf_standard_error": error,
                                          "vacf_normalized": decay, "diffusion": 0.2 * (1.0 - decay),
                                          "diffusion_standard_error": error})
    fixtures.write_csv(run / "vibrational_spectrum.csv", {"angular_frequency": 10.0 * TIME, "spectrum": 0.05 * decay,
                                                          "spectrum_standard_error": 0.1 * error})
    fixtures.write_csv(run / "stress_autocorrelation.csv",
                       {"time": TIME, "stress_autocorrelation": decay, "stress_autocorrelation_standard_error": error,
                        "viscosity": 3.0 * (1.0 - decay), "viscosity_standard_error": error})
    z = np.linspace(-19.75, 19.75, 80)
    surfaces = np.exp(-((np.abs(z) - 6.0) ** 2))
    error = np.full(z.size, 0.01)
    fixtures.write_csv(run / "film.csv",
                       {"z": z, "density": 0.8 / (1.0 + np.exp(np.abs(z) - 6.0)), "density_standard_error": error,
                        "normal_pressure": 0.0 * z, "normal_pressure_standard_error": error,
                        "tangential_pressure": -0.3 * surfaces, "tangential_pressure_standard_error": error})
    k = np.array([6.8, 7.8, 11.1, 11.1])  # two families of one length
    factor = np.exp(-0.006 * k**2)
    fixtures.write_csv(run / "bragg.csv",
                       {"k": k, "miller_h": np.array([1, 2, 2, 3]), "miller_k": np.array([1, 0, 2, 1]), "miller_l": np.array([1, 0, 0, 1]),
                        "vectors": np.array([4, 3, 6, 12]),
                        "S": 500.0 * factor, "S_standard_error": factor, "debye_waller_factor": factor,
                        "debye_waller_factor_standard_error": 0.01 * factor, "debye_waller_gaussian": factor,
                        "debye_waller_gaussian_standard_error": 0.01 * factor})
    for flux, coefficient in (("pressure", "bulk_viscosity"), ("heat_flux", "thermal_conductivity")):
        fixtures.write_csv(run / f"{flux}_autocorrelation.csv",
                           {"time": TIME, f"{flux}_autocorrelation": decay, f"{flux}_autocorrelation_standard_error": error,
                            coefficient: 2.0 * (1.0 - decay), f"{coefficient}_standard_error": error})
    return run


def test_every_table_has_its_picture(tmp: Path) -> None:
    run = write_tables(write_run(tmp / "run"))
    result = plot(run)
    assert result.returncode == 0, result.stderr
    tables = [name for name in structure_pictures.PICTURES if name not in time_pictures.PICTURES]
    names = ["thermo", "rdf", *tables]
    assert result.stdout.splitlines() == [str(run / f"{name}.png") for name in names], result.stdout
    for name in tables:
        width, height = png_size(run / f"{name}.png")
        assert width == 350 and height >= 225, (name, width, height)


def test_tables_that_are_not_there_have_none(tmp: Path) -> None:
    run = write_tables(write_run(tmp / "run"))
    for name in ("msd", "sk_from_rdf", "stress_autocorrelation", "pressure_autocorrelation", "heat_flux_autocorrelation"):
        (run / f"{name}.csv").unlink()
    result = plot(run)
    assert result.returncode == 0, result.stderr
    made = [Path(line).stem for line in result.stdout.splitlines()]
    assert made == ["thermo", "rdf", "sk", "vacf", "vibrational_spectrum", "film", "bragg"], made


def test_errors_that_are_not_known_are_no_obstacle(tmp: Path) -> None:
    run = write_tables(write_run(tmp / "run"))
    fixtures.write_csv(run / "msd.csv", {"time": TIME, "msd": TIME, "msd_standard_error": np.full(TIME.size, np.nan)})
    assert plot(run).returncode == 0


def test_what_has_no_value_has_no_picture(tmp: Path) -> None:
    """A single atom has no g(r), no spectrum and no viscosity: columns without any number, and a word instead of a picture."""
    run = write_tables(write_run(tmp / "run"))
    none = np.full(TIME.size, np.nan)
    fixtures.write_csv(run / "rdf.csv", {"r": K, "g": np.full(K.size, np.nan), "g_standard_error": np.full(K.size, np.nan)})
    fixtures.write_csv(run / "vacf.csv", {"time": TIME, "vacf": 0.0 * TIME, "vacf_standard_error": none, "vacf_normalized": none,
                                          "diffusion": 0.0 * TIME, "diffusion_standard_error": none})
    fixtures.write_csv(run / "vibrational_spectrum.csv", {"angular_frequency": TIME, "spectrum": none,
                                                          "spectrum_standard_error": none})
    fixtures.write_csv(run / "stress_autocorrelation.csv",
                       {"time": TIME, "stress_autocorrelation": 0.0 * TIME, "stress_autocorrelation_standard_error": none,
                        "viscosity": none, "viscosity_standard_error": none})
    result = plot(run)
    assert result.returncode == 0, result.stderr
    made = [Path(line).stem for line in result.stdout.splitlines()]
    assert made == ["thermo", "sk", "msd", "film", "bragg", "pressure_autocorrelation", "heat_flux_autocorrelation"], result.stdout
    said = [line.partition(": ")[2] for line in result.stderr.splitlines()]
    assert said == [f"'{name}' has no value in this run, no picture of it"
                    for name in ("g", "vacf_normalized", "spectrum", "viscosity")], result.stderr


def test_damaged_tables(tmp: Path) -> None:
    for name, old, new, words in (
        ("sk", "k,S,", "k,s,", "no column 'S'"),
        ("msd", "time,", "t,", "no column 'time'"),
        ("vacf", "0.1,", "-0.1,", "column 'time' has no number above the one before"),
    ):
        run = write_tables(write_run(tmp / name))
        edit(run / f"{name}.csv", old, new)
        fixtures.check_error(plot(run), 3, f"{name}.csv", words)
    run = write_tables(write_run(tmp / "gap"))
    lines = (run / "sk.csv").read_text().splitlines()
    fields = lines[5].split(",")
    lines[5] = ",".join([fields[0], "", *fields[2:]])
    (run / "sk.csv").write_text("\n".join(lines) + "\n")
    fixtures.check_error(plot(run), 3, "sk.csv", "line 6", "'S' has no number")


if __name__ == "__main__":
    sys.exit(fixtures.run_tests(globals()))
