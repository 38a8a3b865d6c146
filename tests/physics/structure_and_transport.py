"""Structure and motion of the liquid against the literature, from the decks of inputs/verlet1967: a shortened run of
structure-and-transport.toml, and rahman-1964.toml.

Usage: structure_and_transport.py --ljmd PROGRAM --decks FOLDER

Reference figures at (rho 0.8442, T 0.722): S(k) has its highest peak, 2.81, at k = 6.78 (independent simulation of the
same state); D = 0.0320 for 864 atoms (0.0325 for 1372 and the correction for size; Meier et al. 2004,
doi:10.1063/1.1786579, and Yeh and Hummer 2004, doi:10.1021/jp0477147); viscosity 3.26 (Meier et al. 2004,
doi:10.1063/1.1770695); c_v = 2.63 and 12.65 neighbours up to the first minimum of g(r). Rahman (1964), doi:10.1103/PhysRev.136.A405, saw velocities turned
round after 0.3 ps = 0.14 tau in liquid argon a little warmer and thinner, where D = 2.43e-5 cm^2/s = 0.0452 and g(r) has its first
peak at 3.7 angstrom = 1.087 sigma. Excess chemical potential:
the equation of state of Thol et al. (2016), doi:10.1063/1.4945000, at the temperature found.
"""

import argparse
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from figures import check, exit_code  # noqa: E402


def table(path: pathlib.Path) -> list[dict[str, float]]:
    with open(path, newline="") as file:
        return [{name: float(text) for name, text in row.items() if text} for row in csv.DictReader(file)]


def interpolated(curve: list[dict[str, float]], k: float) -> float:
    after = next(i for i, row in enumerate(curve) if row["k"] >= k)
    a, b = curve[after - 1], curve[after]
    return a["S"] + (b["S"] - a["S"]) * (k - a["k"]) / (b["k"] - a["k"])


def run(ljmd: str, deck: pathlib.Path, tables: list[str], *settings: str) -> tuple[dict, list[list[dict[str, float]]]]:
    """The observables of a deck, and the tables that it leaves."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "run"
        changes = [word for setting in settings for word in ("--set", setting)]
        subprocess.run([ljmd, "run", str(deck), "--out", str(out), "--quiet", *changes], check=True)
        found = json.loads((out / "results.json").read_text())["observables"]
        return found, [table(out / f"{name}.csv") for name in tables]


def check_triple_point(ljmd: str, deck: pathlib.Path) -> None:
    found, (sk, from_rdf, vacf, spectrum) = run(
        ljmd, deck, ["sk", "sk_from_rdf", "vacf", "vibrational_spectrum"],
        "stage.production.steps=80000", "analysis.structure_factor.every=200")

    def mean(name: str) -> float:
        return found[name]["mean"]

    def error(name: str) -> float:
        return found[name]["standard_error"]

    peak = max(sk, key=lambda row: row["S"])
    check("S(k), first peak: k", peak["k"], 6.78, 0.1)
    check("S(k), first peak: height", peak["S"], 2.81, 0.1)
    # g(r) ends at 5 sigma, so that its transform is smoothed over 2 pi/5, and has ripples.
    wide = [row for row in sk if 4.0 < row["k"] < 12.0 and abs(row["k"] - peak["k"]) > 1.0]
    difference = math.sqrt(sum((row["S"] - interpolated(from_rdf, row["k"])) ** 2 for row in wide) / len(wide))
    check("S(k) against the transform of g(r), rms", difference, 0.0, 0.05)

    both = math.hypot(error("diffusion"), error("diffusion_green_kubo"))
    check("diffusion by Einstein's relation", mean("diffusion"), 0.0320, 0.0020)
    check("diffusion by Green and Kubo's", mean("diffusion_green_kubo"), 0.0320, 0.0020)
    check("their difference", mean("diffusion"), mean("diffusion_green_kubo"), min(3.0 * both, 0.05 * 0.032))
    check("standard error of the diffusion", error("diffusion"), 0.0005, 0.0005)
    check("diffusion in an infinite system", mean("diffusion_infinite_system"), 0.0353, 0.0030)
    check("viscosity", mean("viscosity"), 3.26, max(0.35, 3.0 * error("viscosity")))
    check("heat capacity", mean("heat_capacity_cv"), 2.63, 0.2)
    check("neighbours", mean("coordination_number"), 12.65, 0.4)

    check("velocity autocorrelation at zero", vacf[0]["vacf"], 3.0 * mean("temperature") * 863.0 / 864.0, 0.02)
    lowest = min(vacf, key=lambda row: row["vacf"])
    check("velocities are turned round after", lowest["time"], 0.15, 0.08)
    check("by so much", lowest["vacf_normalized"], -0.12, 0.1)
    step = spectrum[1]["angular_frequency"]
    whole = step * (sum(row["spectrum"] for row in spectrum) - 0.5 * (spectrum[0]["spectrum"] + spectrum[-1]["spectrum"]))
    check("integral of the spectrum", whole, 1.0, 1e-6)

    answer = subprocess.run([ljmd, "eos", "--temperature", str(mean("temperature")), "--density", "0.8442", "--json"],
                            check=True, capture_output=True, text=True)
    expected = json.loads(answer.stdout)["excess_chemical_potential"]
    if mean("excess_chemical_potential") is None:
        # So few insertions find room in so dense a liquid that no number may be given, but then the reason is.
        check("reason why there is no chemical potential", float("remark" in found["excess_chemical_potential"]), 1.0, 0.0)
    else:
        check("excess chemical potential", mean("excess_chemical_potential"), expected, 4.0 * error("excess_chemical_potential"))


def check_rahman(ljmd: str, deck: pathlib.Path) -> None:
    found, (rdf, vacf) = run(ljmd, deck, ["rdf", "vacf"])
    check("Rahman: diffusion", found["diffusion"]["mean"], 0.045, 0.003)
    check("Rahman: diffusion by Green and Kubo's relation", found["diffusion_green_kubo"]["mean"], 0.045, 0.003)
    check("Rahman: first peak of g(r)", max(rdf, key=lambda row: row["g"])["r"], 1.087, 0.03)
    check("Rahman: velocities are turned round after", min(vacf, key=lambda row: row["vacf"])["time"], 0.14, 0.08)


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--ljmd", required=True)
    parser.add_argument("--decks", required=True, type=pathlib.Path)
    arguments = parser.parse_args()
    check_triple_point(arguments.ljmd, arguments.decks / "structure-and-transport.toml")
    check_rahman(arguments.ljmd, arguments.decks / "rahman-1964.toml")
    return exit_code()


if __name__ == "__main__":
    sys.exit(main())
