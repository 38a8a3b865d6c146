"""The look that all pictures of ljmd share, and how quantities are named on their axes."""

from __future__ import annotations

import contextlib
import math
from pathlib import Path
from typing import Any, Optional

import matplotlib

matplotlib.use("Agg")
import fonts  # noqa: E402  (the backend must be chosen first)
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from ljmd import _output  # noqa: E402
from ljmd.errors import FileError  # noqa: E402
from ljmd.pictures import STYLE  # noqa: E402
from plain_text import lines, plain  # noqa: E402

# What pictures have in them beside what is seen: who drew them, by which they are known, and no date, so that the same picture is the
# same file.
METADATA = {".png": {"Software": "ljmd"}, ".pdf": {"Creator": "ljmd", "CreationDate": None}, ".svg": {"Creator": "ljmd", "Date": None}}
MARKS = {".png": b"Software\0ljmd", ".pdf": b"/Creator (ljmd)", ".svg": b"<dc:title>ljmd</dc:title>", ".gif": b"drawn by ljmd",
         ".mp4": b"drawn by ljmd"}
FORMATS = tuple(METADATA)

# The colours of the style file, Okabe and Ito's palette: one a body, or an integrator.
CYCLE = tuple(matplotlib.rc_params_from_file(STYLE, use_default_template=False)["axes.prop_cycle"].by_key()["color"])
BLUE, VERMILION, GREEN, ORANGE, PURPLE, SKY, BLACK = CYCLE
GREY = "#999999"

LABELS = {
    "step": "step",
    "time": r"$t$ / $\tau$",
    "temperature": r"$T$ / ($\epsilon/k_\mathrm{B}$)",
    "potential_energy": r"$U/N$ / $\epsilon$",
    "kinetic_energy": r"$K/N$ / $\epsilon$",
    "total_energy": r"$E/N$ / $\epsilon$",
    "pressure": r"$p$ / ($\epsilon/\sigma^3$)",
    "heat_capacity_cv": r"$c_V$ / $k_\mathrm{B}$",
    "heat_capacity_cp": r"$c_p$ / $k_\mathrm{B}$",
    "isothermal_compressibility": r"$\kappa_T$ / ($\sigma^3/\epsilon$)",
    "adiabatic_compressibility": r"$\kappa_S$ / ($\sigma^3/\epsilon$)",
    "thermal_expansion": r"$\alpha_p$ / ($k_\mathrm{B}/\epsilon$)",
    "thermal_pressure_coefficient": r"$\gamma_V$ / ($k_\mathrm{B}/\sigma^3$)",
    "speed_of_sound": r"$w$ / ($\sigma/\tau$)",
    "joule_thomson_coefficient": r"$\mu_\mathrm{JT}$ / ($\sigma^3/k_\mathrm{B}$)",
    "configurational_temperature": r"$T_\mathrm{conf}$ / ($\epsilon/k_\mathrm{B}$)",
    "coordination_number": r"$n_\mathrm{c}$",
    "diffusion": r"$D$ / ($\sigma^2/\tau$)",
    "diffusion_green_kubo": r"$D$ / ($\sigma^2/\tau$)",
    "viscosity": r"$\eta$ / ($\epsilon \tau/\sigma^3$)",
    "bulk_viscosity": r"$\eta_v$ / ($\epsilon \tau/\sigma^3$)",
    "thermal_conductivity": r"$\lambda$ / ($k_\mathrm{B}/\sigma\tau$)",
    "edge_x": r"$L_x$ / $\sigma$",
    "edge_y": r"$L_y$ / $\sigma$",
    "edge_z": r"$L_z$ / $\sigma$",
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
    fonts.use()


def colour(k: int) -> str:
    """The colour of the k-th of several like things, from 0."""
    return CYCLE[k % len(CYCLE)]


def time_axis(axes: plt.Axes, time: np.ndarray) -> bool:
    """The axis of the times of a correlation function: logarithmic where they go on to long ones, ever further apart. @return whether it is"""
    steps = np.diff(time)
    forward = steps[steps > 0.0]
    is_long = forward.size > 1 and bool(np.any(forward > 1.5 * forward[0]))
    if is_long:
        axes.set_xscale("log")
        axes.set_xlim(float(time[time > 0.0].min()), float(time.max()))
    else:
        axes.set_xlim(0.0, float(time.max()))
    return is_long


def head(figure: plt.Figure, title: str, note: str = "") -> None:
    """The title of a picture, which is a text of others, and below it, smaller, a note of ours."""
    width = int(11.5 * figure.get_figwidth())  # characters of this size in a line
    figure.suptitle(lines(title, width), fontsize=12)
    if note:
        figure.axes[0].set_title(note, fontsize=9.5, color="#444444", loc="center")


def legend_beside(axes: plt.Axes, **more: object) -> None:
    """A legend beside the panel, where it hides nothing."""
    axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), **more)


def _allowed(path: Path, force: Optional[bool], mark: bytes) -> dict[str, Any]:
    """What a file may take the place of. force: None where a script has no such option."""
    return {"force": bool(force), "mark": mark or MARKS[path.suffix], "how": "" if force is None else "--force"}


def require_writable(path: Path, force: Optional[bool] = None, mark: bytes = b"") -> None:
    """Refuse a file in whose place something else is, before it is made. mark: of a file that is neither picture nor film."""
    _output.require_writable(path, **_allowed(path, force, mark))


def replacing(path: Path, force: Optional[bool] = None, mark: bytes = b"") -> contextlib.AbstractContextManager[Path]:
    """Where a file grows until it is complete; see ljmd._output. Makes its directory."""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FileError(f"{path}: cannot be written: {error.strerror}") from None
    return _output.replacing(path, **_allowed(path, force, mark))


def save(figure: plt.Figure, path: Path, force: Optional[bool] = None) -> None:
    """Write a picture, by the ending of its name, and say where it is. It has its name only when it is complete."""
    with replacing(path, force) as half, fonts.letters_that_lack():
        figure.savefig(half, format=path.suffix[1:], metadata=METADATA[path.suffix])
    plt.close(figure)
    print(path, flush=True)


def save_text(text: str, path: Path, mark: str, force: Optional[bool] = None) -> None:
    """Write a record or a table that has `mark` in it."""
    with replacing(path, force, mark.encode()) as half:
        half.write_text(text, encoding="utf-8")


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
