"""Scattering functions and displacements of a small liquid, beside sums written out in numpy over the frames of the same run, and
beside each other: F(k, 0) is S(k), C_L is minus the second derivative of F.

    time_correlations.py --ljmd PROGRAM
"""

import argparse
import csv
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

ATOMS, EVERY, LAGS, ORIGINS, BINS, RADIUS, TIMES, BETWEEN, STEP = 108, 5, 12, 4, 20, 0.5, 3, 60, 0.004
CUTOFF, FIRST = 2.2, 6  # of the potential; times that the second derivative of C_L is found from
DECK = f"""[system]
lattice = {{ type = "fcc", cells = 3 }}
density = 0.8
temperature = 1.2
seed = 3
[potential]
type = "lennard-jones"
cutoff = {CUTOFF}
truncation = "force-shifted"
[[stage]]
name = "melt"
time_step = {STEP}
steps = 1500
thermostat = {{ type = "langevin", time = 0.5 }}
[[stage]]
name = "production"
time_step = {STEP}
steps = 12000
sample = true
[output]
thermo = {{ every = 100 }}
trajectory = {{ format = "xyz", every = {EVERY}, velocities = true }}
[analysis]
scattering = {{ every = {EVERY}, max_time = {EVERY * LAGS * STEP}, origins = {ORIGINS}, shells = 2, vectors = 3, k_max = {{k_max}} }}
van_hove = {{ every = {EVERY}, max_time = {EVERY * LAGS * STEP}, origins = {ORIGINS}, bins = {BINS}, radius = {RADIUS}, times = {TIMES} }}
van_hove_distinct = {{ every = {EVERY}, max_time = {EVERY * 4 * STEP}, between = {EVERY * BETWEEN * STEP}, bins = 25, radius = 2.5 }}
structure_factor = {{ every = {EVERY}, width = 0.01, k_max = 3.0 }}
"""


FAST = f"""scattering = {{ every = 1, max_time = {FIRST * STEP}, shells = 1, k_min = {{k}}, k_max = {{k}}, vectors = 3 }}
"""


def table(path):
    with open(path, encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    return {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}


def curvature(r, k, edge):
    """<sum over j of (1 - cos(k x_ij)) d^2 phi/dx^2>, mean over atoms, frames and the three axes: rho integral of g(r) (1 - cos(k x)) phi_xx."""
    def slope(at):
        return -48 * at**-13 + 24 * at**-7

    total = 0.0
    for frame in r:
        apart = frame[None, :, :] - frame[:, None, :]
        apart -= edge * np.round(apart / edge)
        distance = np.sqrt(np.sum(apart**2, axis=2))
        near = (distance > 0) & (distance < CUTOFF)
        x2, d = apart[near] ** 2, distance[near][:, None]
        first, second = slope(d) - slope(CUTOFF), 624 * d**-14 - 168 * d**-8
        along = x2 / d**2
        total += np.sum((1 - np.cos(k * apart[near])) * (second * along + first / d * (1 - along))) / (3 * ATOMS)
    return total / len(r)


def fourth_moment(check, ljmd, folder, k, edge):
    """-C_L''(0)/C_L(0) = 3 k^2 T/m + rho/m integral of g(r) (1 - cos(k x)) phi_xx: the fourth moment of S(k, w) (de Gennes 1959; Hansen and
    McDonald, section 7.4). Left: C_L at times of a few steps; right: configurations alone, so this line sees the dynamics."""
    deck = DECK[:DECK.index("scattering")] + FAST
    deck = deck.replace(f"every = {EVERY}, velocities", "every = 40, velocities").replace("{k}", repr(k))
    (folder / "fast.toml").write_text(deck, encoding="utf-8")
    subprocess.run([ljmd, "run", "fast.toml", "--quiet", "--out", "fast", "--force"], cwd=folder, check=True, capture_output=True)
    found = table(folder / "fast/fkt.csv")
    r, v = frames_of(folder / "fast/trajectory.xyz")
    c, t = found["C_L"], found["time"]
    # (1 - C(t)/C(0)) 2/t^2 is a series in t^2: its value at 0 by Richardson's rule, from 2, 4 and 6 steps.
    a, b, d = (2 * (1 - c[n] / c[0]) / t[n] ** 2 for n in (2, 4, 6))
    left = (15 * a - 6 * b + d) / 10
    right = 3 * k**2 * np.mean(v**2) * ATOMS / (ATOMS - 1) + curvature(r, k, edge)
    print(f"fourth moment at k = {k:.3f}: {left:.2f} from C_L, {right:.2f} from configurations")
    check.near(f"fourth moment at {k:.3f}", left, right, 0.02 * right)


def frames_of(path):
    """Positions and velocities about the centre of mass, (frames, atoms, 3), of the frames after the start of the production."""
    positions, velocities = [], []
    with open(path, encoding="utf-8") as file:
        while line := file.readline():
            assert int(line) == ATOMS
            comment = file.readline()
            names = comment.split("Properties=")[1].split()[0].split(":")
            columns, place = {}, 0
            for name, count in zip(names[::3], names[2::3], strict=True):
                columns[name] = place
                place += int(count)
            rows = [file.readline().split() for _ in range(ATOMS)]
            step = int(comment.split("step=")[1].split()[0])
            if step > 1500:
                positions.append([[float(x) for x in row[columns["pos"]:columns["pos"] + 3]] for row in rows])
                velocities.append([[float(x) for x in row[columns["velo"]:columns["velo"] + 3]] for row in rows])
    r, v = np.array(positions), np.array(velocities)
    return r - r.mean(axis=1, keepdims=True), v - v.mean(axis=1, keepdims=True)


class Checks:
    failed = 0

    def near(self, what, found, wanted, tolerance):
        worst = float(np.max(np.abs(np.asarray(found) - np.asarray(wanted))))
        if not worst <= tolerance:
            self.failed += 1
            print(f"FAIL {what}: differs by {worst:.3g}, allowed {tolerance:.3g}")


def windows(frames, window):
    return [slice(begin, begin + window) for begin in range(0, frames - window + 1, window)]


def correlation(series, window):
    """<x(t) x*(0)> of complex series (frames, n), window by window, averaged over all origins and windows, summed over n."""
    found = np.zeros(LAGS + 1)
    parts = windows(len(series), window)
    for part in parts:
        x = series[part]
        for lag in range(LAGS + 1):
            found[lag] += np.sum((x[lag:] * np.conj(x[:len(x) - lag])).real) / (len(x) - lag)
    return found / len(parts)


def main() -> int:
    parser = argparse.ArgumentParser()
    parser.add_argument("--ljmd", required=True)
    options = parser.parse_args()
    check = Checks()
    edge = (ATOMS / 0.8) ** (1 / 3)
    unit = 2 * np.pi / edge
    with tempfile.TemporaryDirectory(prefix="ljmd-time-correlations-") as name:
        folder = pathlib.Path(name)
        (folder / "deck.toml").write_text(DECK.replace("{k_max}", repr(2 * unit)), encoding="utf-8")
        subprocess.run([options.ljmd, "run", "deck.toml", "--quiet", "--out", "run"], cwd=folder, check=True, capture_output=True)
        run = folder / "run"
        fkt, fskt, skw = (table(run / f"{file}.csv") for file in ("fkt", "fskt", "skw"))
        gs, alpha2, gd, sk = (table(run / f"{file}.csv") for file in ("gs", "alpha2", "gd", "sk"))
        r, v = frames_of(run / "trajectory.xyz")
        for n in (2, 5):
            fourth_moment(check, options.ljmd, folder, n * unit, edge)

    window = 2 * LAGS
    times = EVERY * STEP * np.arange(LAGS + 1)
    for number, n in enumerate((1, 2)):  # (n, 0, 0) and the like
        vectors = n * unit * np.eye(3)
        rows = slice(number * (LAGS + 1), (number + 1) * (LAGS + 1))
        check.near(f"k of shell {n}", fkt["k"][rows], n * unit, 1e-12)
        check.near("times", fkt["time"][rows], times, 1e-12)
        phases = np.exp(-1j * np.einsum("tia,va->tvi", r, vectors))
        f = correlation(phases.sum(axis=2), window) / (3 * ATOMS)
        check.near(f"F, shell {n}", fkt["F"][rows], f, 1e-10)
        currents = np.einsum("tvi,tia->tva", phases, v)
        along = np.einsum("tvv->tv", currents)
        across = np.stack([currents[:, v, a] for v in range(3) for a in range(3) if a != v], axis=1)
        k2 = (n * unit) ** 2
        longitudinal = k2 * correlation(along, window) / (3 * ATOMS)
        check.near(f"C_L, shell {n}", fkt["C_L"][rows], longitudinal, 1e-9)
        check.near(f"C_T, shell {n}", fkt["C_T"][rows], k2 * correlation(across, window) / (6 * ATOMS), 1e-9)
        # Origins of the self part, as far as all times of them are known.
        between = LAGS // ORIGINS
        origins = np.arange(0, len(r) - LAGS, between)
        own = [np.mean((phases[origins + lag] * np.conj(phases[origins])).real) for lag in range(LAGS + 1)]
        check.near(f"F_s, shell {n}", fskt["F_s"][rows], own, 1e-10)
        hann = np.cos(0.5 * np.pi * np.arange(LAGS + 1) / LAGS) ** 2
        w = np.pi * np.arange(LAGS + 1) / times[-1]
        spectrum = np.trapezoid if hasattr(np, "trapezoid") else np.trapz
        check.near(f"S(k, w), shell {n}", skw["S_kw"][rows],
                   [spectrum(f * hann * np.cos(each * times), times) / np.pi for each in w], 1e-10)
        # S(k) of the same vectors, over some frames more.
        place = int(np.argmin(np.abs(sk["k"] - n * unit)))
        check.near(f"F(k, 0) and S(k), shell {n}", f[0], sk["S"][place], 0.02 * f[0])
        # C_L = -F'': to what the window's ends and the differences of second order leave.
        second = -(f[2:] - 2 * f[1:-1] + f[:-2]) / (times[1] - times[0]) ** 2
        check.near(f"C_L and -F'', shell {n}", longitudinal[1:-1] / longitudinal[0], second / longitudinal[0], 0.05)

    origins = np.arange(0, len(r) - LAGS, LAGS // ORIGINS)
    for lag in range(1, LAGS + 1):
        squares = np.sum((r[origins + lag] - r[origins]) ** 2, axis=2)
        check.near(f"alpha_2 at {lag}", alpha2["alpha_2"][lag - 1], 0.6 * np.mean(squares**2) / np.mean(squares) ** 2 - 1, 1e-10)
    edges = RADIUS / BINS * np.arange(BINS + 1)
    volumes = 4 / 3 * np.pi * np.diff(edges**3)
    for number in range(TIMES):
        lag = (number + 1) * LAGS // TIMES
        distances = np.sqrt(np.sum((r[origins + lag] - r[origins]) ** 2, axis=2))
        counts = np.histogram(distances, edges)[0] / (len(origins) * ATOMS)
        rows = slice(number * BINS, (number + 1) * BINS)
        check.near(f"time of G_s {number}", gs["time"][rows], times[lag], 1e-12)
        check.near(f"G_s {number}", gs["G_s"][rows], counts / volumes, 1e-9)
    origins = np.arange(0, len(r) - 4, BETWEEN)
    edges = np.linspace(0, 2.5, 26)
    for lag in range(5):
        counts = np.zeros(25)
        for origin in origins:
            apart = r[origin + lag][None, :, :] - r[origin][:, None, :]
            apart -= edge * np.round(apart / edge)
            distances = np.sqrt(np.sum(apart**2, axis=2))[~np.eye(ATOMS, dtype=bool)]
            counts += np.histogram(distances, edges)[0] / (len(origins) * ATOMS)
        rows = slice(lag * 25, (lag + 1) * 25)
        check.near(f"G_d at {lag}", gd["G_d"][rows], counts / (4 / 3 * np.pi * np.diff(edges**3)), 1e-9)
    print(f"{check.failed} comparisons failed")
    return 1 if check.failed else 0


if __name__ == "__main__":
    sys.exit(main())
