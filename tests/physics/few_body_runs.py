"""Runs ljmd on the few-body decks and reads what it writes. Holds what was found against rows of reference figures."""

import csv
import json
import pathlib
import re
import subprocess
from dataclasses import dataclass
from decimal import Decimal

import numpy as np

ROUNDING = 2e-15  # relative, of a few operations


@dataclass
class Run:
    folder: pathlib.Path
    results: dict

    def found(self, analysis: str, quantity: str) -> float:
        return self.results["analysis"][analysis][quantity]["value"]

    def at_start(self, total: str) -> float:
        return self.results["observables"][total]["at_start"]

    def largest_deviation(self, total: str) -> float:
        return self.results["observables"][total]["largest_deviation"]

    def table(self, name: str) -> dict[str, np.ndarray]:
        with open(self.folder / name, newline="") as file:
            header, *rows = csv.reader(file)
        columns = np.array(rows, dtype=float).T
        return dict(zip(header, columns))

    def trajectory(self) -> dict[str, np.ndarray]:
        return self.table("trajectory.csv")


class Program:
    """The program, with the decks that it is run on; the results go to a folder of their own each."""

    def __init__(self, path: str, decks: pathlib.Path, folder: pathlib.Path):
        self.path = path
        self.decks = decks
        self.folder = folder
        self.runs = 0

    def ask(self, *arguments: str) -> str:
        process = subprocess.run([self.path, *arguments], capture_output=True, text=True)
        if process.returncode != 0:
            raise SystemExit(f"{' '.join(arguments)}: {process.stderr}")
        return process.stdout

    def arguments(self, deck: str, step: float, steps: int, settings: dict) -> list[str]:
        """Settings whose keys have no dot belong to the deck's one stage."""
        path = self.decks / f"{deck}.toml"
        stage = re.search(r'^\[\[stage\]\]\s+name = "(.+)"', path.read_text(), re.MULTILINE).group(1)
        settings = {"time_step": step, "steps": steps} | settings
        values = {key if "." in key else f"stage.{stage}.{key}": value for key, value in settings.items()}
        return [str(path), "--quiet", *(text for key, value in values.items() for text in ("--set", f"{key}={value}"))]

    def run(self, deck: str, step: float, steps: int, settings: dict = {}) -> Run:
        self.runs += 1
        folder = self.folder / f"run-{self.runs}"
        self.ask("run", *self.arguments(deck, step, steps, settings), "--out", str(folder))
        return Run(folder, json.loads((folder / "results.json").read_text()))

    def compare(self, deck: str, step: float, steps: int, settings: dict = {}) -> dict:
        return json.loads(self.ask("compare", *self.arguments(deck, step, steps, settings), "--with", "gsl", "--json"))


class Reference:
    """Rows of figures, each to be checked once, or excused."""

    def __init__(self, path: pathlib.Path):
        with open(path, newline="") as file:
            lines = [line for line in file if not line.startswith("#")]
        self.rows = {(row["system"], row["quantity"], row["parameters"]): row for row in csv.DictReader(lines)}
        self.open = set(self.rows)
        self.passed = 0
        self.failed = 0

    def say(self, good: bool, name: str, found: str, expected: str) -> None:
        print(f"{'ok  ' if good else 'FAIL'} {name}: found {found}, reference {expected}")
        self.passed += good
        self.failed += not good

    def check(self, system: str, quantity: str, parameters: str, *found: float, program: float = 0.0) -> None:
        """Each value within the row's error and, on top of that, the error `program` that the program's method has."""
        key = (system, quantity, parameters)
        row = self.rows[key]
        self.open.remove(key)
        texts = row["values"].split(";")
        tolerances = [error_of(text, row["error"]) + program for text in texts]
        good = len(found) == len(texts) and all(
            abs(value - float(text)) <= tolerance for value, text, tolerance in zip(found, texts, tolerances))
        name = ", ".join(part for part in key if part)
        self.say(good, name, "; ".join(f"{value:.12g}" for value in found),
                 f"{row['values']} +- {max(tolerances):.2g}")

    def expect(self, name: str, found: float, expected: float, tolerance: float) -> None:
        """A figure that follows from the theory and has no row."""
        self.say(abs(found - expected) <= tolerance, name, f"{found:.12g}", f"{expected:.12g} +- {tolerance:.2g}")

    def excuse(self, reasons: dict[tuple[str, str, str], str]) -> None:
        for key, reason in reasons.items():
            self.open.remove(key)
            print(f"not  {', '.join(part for part in key if part)}: not checked, {reason}")

    def finish(self) -> bool:
        for key in sorted(self.open):
            print(f"FAIL {', '.join(part for part in key if part)}: neither checked nor excused")
        print(f"{self.passed} passed, {self.failed + len(self.open)} failed")
        return self.passed > 0 and not self.failed and not self.open


def error_of(text: str, error: str) -> float:
    """The error given, or half a unit of the last digit; no less than rounding."""
    given = float(error) if error else 0.5 * 10.0 ** Decimal(text).as_tuple().exponent
    return max(given, ROUNDING * abs(float(text)))


def order(coarse: float, fine: float) -> float:
    """The order of a method from its errors at a step and at half of it."""
    return float(np.log2(coarse / fine))
