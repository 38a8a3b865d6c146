"""The look that all pictures of ljmd share, and how quantities are named on their axes."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Optional

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402  (the backend must be chosen first)
from checked_files import RunDirectoryError  # noqa: E402

FORMATS = (".png", ".pdf", ".svg")

# The colours of the style file, Okabe and Ito's palette: one a body, or an integrator.
STYLE = Path(__file__).resolve().parent / "ljmd.mplstyle"
CYCLE = tuple(matplotlib.rc_params_from_file(STYLE, use_default_template=False)["axes.prop_cycle"].by_key()["color"])
BLUE, VERMILION, GREEN, ORANGE, PURPLE, SKY, BLACK = CYCLE
GREY = "#999999"

LABELS = {
    "time": r"$t$ / $\tau$",
    "temperature": r"$T$ / ($\epsilon/k_\mathrm{B}$)",
    "potential_energy": r"$U/N$ / $\epsilon$",
    "kinetic_energy": r"$K/N$ / $\epsilon$",
    "total_energy": r"$E/N$ / $\epsilon$",
    "pressure": r"$p$ / ($\epsilon/\sigma^3$)",
    "density": r"$\rho$ / $\sigma^{-3}$",
    "compressibility_factor": r"$Z = p / \rho k_\mathrm{B} T$",
    "r": r"$r$ / $\sigma$",
    "g": r"$g(r)$",
    "time_ps": r"$t$ / ps",
    "temperature_K": r"$T$ / K",
    "pressure_bar": r"$p$ / bar",
    "r_nm": r"$r$ / nm",
}


def use() -> None:
    """Apply the style to all pictures made from here on."""
    plt.style.use(STYLE)


def colour(k: int) -> str:
    """The colour of the k-th of several like things, from 0."""
    return CYCLE[k % len(CYCLE)]


def check_format(path: Optional[Path]) -> None:
    """Refuse the name of a picture in a format that is not drawn."""
    if path is not None and path.suffix not in FORMATS:
        raise RunDirectoryError(f"{path}: must end in {', '.join(FORMATS)}", exit_code=2)


def save(figure: plt.Figure, path: Path) -> None:
    """Write a picture and say where it is."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        figure.savefig(path)
    except OSError as error:
        raise RunDirectoryError(f"{path}: cannot be written: {error.strerror}", exit_code=4) from None
    plt.close(figure)
    print(path)


def plain(text: str) -> str:
    """Text that matplotlib shows as it is: without this, a pair of dollar signs starts a formula."""
    return text.replace("$", r"\$")


def with_uncertainty(mean: float, standard_error: float) -> str:
    """A number with two digits of its standard error behind it: 0.7218(12) means 0.7218 +- 0.0012."""
    if not 1e-12 * abs(mean) < standard_error < math.inf:  # none, unknown, or round-off
        return f"{mean:.6g}"
    decimals = 1 - math.floor(math.log10(standard_error))
    digits = round(standard_error * 10**decimals)
    if digits == 100:  # 0.0996 rounds up to 0.10: one decimal less
        decimals, digits = decimals - 1, 10
    if decimals <= 0:
        return f"{round(mean, decimals):.0f}({digits * 10**-decimals})"
    return f"{mean:.{decimals}f}({digits})"
