"""Equations of state of the Lennard-Jones fluid."""

from __future__ import annotations

import numpy as np

from . import _check, _core
from ._text import html_pre
from .errors import InputError


class Properties:
    """Numbers by name, as attributes, in reduced units; energies per atom. None is what has no value."""

    def __init__(self, data: dict, text: str = ""):
        self.data, self.text = data, text
        for name, value in data.items():
            setattr(self, name, Properties(value) if isinstance(value, dict) else value)

    def __repr__(self) -> str:
        return self.text or f"Properties({', '.join(f'{k}={v!r}' for k, v in self.data.items())})"

    def _repr_html_(self) -> str:
        return html_pre(repr(self))


def _number(value, name: str, least_is_allowed: bool) -> float:
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise InputError(f"{name}: {value!r} is no number") from None
    if not np.isfinite(number) or number < 0 or (number == 0 and not least_is_allowed):
        raise InputError(f"{name}: {number} is not allowed: a finite number {'>=' if least_is_allowed else '>'} 0")
    return number


def _state(temperature, density, model) -> Properties:
    data, text = _core.state(model, _number(temperature, "temperature", False), _number(density, "density", True))
    for warning in data["warnings"]:
        _check.warn(warning)
    return Properties(data, text)


def eos(temperature, density=None, *, model: str = "thol2016") -> Properties:
    """The equation of state at a temperature [epsilon/k_B] and a density [sigma^-3]; without one, liquid and vapour at
    coexistence.

    A state has compressibility_factor, pressure, potential_energy, heat_capacity_cv, heat_capacity_cp, speed_of_sound,
    residual_helmholtz_energy, excess_chemical_potential, second_virial_coefficient and more; coexistence has pressure,
    liquid, vapour and heat_of_vaporisation. Arrays of temperatures and densities give arrays.

    model: one of `ljmd.build()["equations_of_state"]`. Numbers that are not to be relied on come with an ljmd.RunWarning.
    Raises InputError for no temperature or density, and above the critical temperature without a density.
    """
    if density is None:
        return Properties(*_core.coexistence(model, _number(temperature, "temperature", False)))
    if np.ndim(temperature) == 0 and np.ndim(density) == 0:
        return _state(temperature, density, model)
    temperatures, densities = np.broadcast_arrays(temperature, density)
    states = [_state(T, rho, model).data for T, rho in zip(temperatures.ravel(), densities.ravel())]
    names = [name for name in (states[0] if states else ()) if name not in ("model", "source", "warnings")]
    return Properties({name: np.array([np.nan if each[name] is None else each[name] for each in states],
                                      dtype=float).reshape(temperatures.shape) for name in names})


def equations() -> list:
    """All equations of state: model, meaning, source, range and critical point of each."""
    return [Properties(each) for each in _core.equations()[0]]
