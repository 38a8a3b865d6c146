"""Equations of state of the Lennard-Jones fluid."""

from __future__ import annotations

from typing import Any

import numpy as np

from . import _check, _core
from ._text import html_pre
from .errors import InputError


class Properties:
    """Numbers by name, as attributes, in reduced units; energies per atom. None is what has no value."""

    # For type checkers, which know these names and no others. Each object has some of them, a number where one state was asked for.
    model: str
    meaning: str
    source: str
    warnings: list[str]
    liquid: Properties
    vapour: Properties
    temperature: Any
    density: Any
    pressure: Any
    compressibility_factor: Any
    potential_energy: Any
    heat_capacity_cv: Any
    heat_capacity_cp: Any
    speed_of_sound: Any
    isothermal_compressibility: Any
    thermal_expansion: Any
    joule_thomson_coefficient: Any
    residual_heat_capacity_cv: Any
    residual_heat_capacity_cp: Any
    residual_helmholtz_energy: Any
    excess_chemical_potential: Any
    pressure_density_slope: Any
    pressure_temperature_slope: Any
    second_virial_coefficient: Any
    heat_of_vaporisation: Any
    phase: Any
    metastable: Any
    lowest_temperature: Any
    highest_temperature: Any
    highest_density: Any
    highest_pressure: Any
    critical_temperature: Any
    critical_density: Any
    critical_pressure: Any

    def __init__(self, data: dict[str, Any], text: str = ""):
        self.data, self.text = data, text
        for name, value in data.items():
            setattr(self, name, Properties(value) if isinstance(value, dict) else value)

    def __repr__(self) -> str:
        return self.text or f"Properties({', '.join(f'{k}={v!r}' for k, v in self.data.items())})"

    def _repr_html_(self) -> str:
        return html_pre(repr(self))


def _given(values, name: str):
    """An array of finite numbers above 0, for a density also 0; None: not given."""
    if values is None:
        return None
    found = _check.array_of(values, name, object)
    if found.size == 0:
        raise InputError(f"{name}: the array is empty, there is no state to compute")
    for value in found.flat:
        _check.number(value, name, least=0.0) if name == "density" else _check.positive(value, name)
    return found


def _document(model, T, rho, p) -> Properties:
    """One point: what is None is not given."""
    if T is None:
        data, text = _core.saturation(model, p)
    elif p is not None:
        data, text = _core.state_at_pressure(model, T, p)
    elif rho is not None:
        data, text = _core.state(model, T, rho)
    else:
        data, text = _core.coexistence(model, T)
    for warning in data["warnings"]:
        _check.warn(warning)
    return Properties(data, text)


def _arrays(data: list, shape: tuple) -> dict:
    """Numbers of many points as arrays, by name; what is no number is left out."""
    found: dict = {}
    for name, value in data[0].items():
        each = [one[name] for one in data]
        if isinstance(value, dict):
            found[name] = _arrays(each, shape)
        elif name == "phase":
            found[name] = np.array(each).reshape(shape)
        elif not isinstance(value, (str, list)):
            found[name] = np.array([np.nan if one is None else one for one in each], dtype=float).reshape(shape)
    return found


def eos(temperature: Any = None, density: Any = None, *, pressure: Any = None, model: str = "thol2016") -> Properties:
    """The equation of state at a temperature [epsilon/k_B] and a density [sigma^-3] or a pressure [epsilon/sigma^3];
    from a temperature or a pressure alone, liquid and vapour at coexistence.

    A state has compressibility_factor, pressure, potential_energy, heat_capacity_cv, heat_capacity_cp, speed_of_sound,
    isothermal_compressibility, thermal_expansion, joule_thomson_coefficient, residual_helmholtz_energy,
    excess_chemical_potential, second_virial_coefficient and more, None where no phase is stable. From a pressure it is the
    most stable one, named by phase, and metastable lists the others with their gibbs_energy_difference. Coexistence has
    temperature, pressure, liquid, vapour and heat_of_vaporisation. Arrays give arrays, without what is metastable.

    model: one of `ljmd.build()["equations_of_state"]`. Numbers that are not to be relied on come with an ljmd.RunWarning.
    Raises InputError for what is no temperature, density or pressure, for a density together with a pressure, and for
    coexistence at and above the critical point; PhysicsError where the equation gives no such state.
    """
    if density is not None and pressure is not None:
        raise InputError("density and pressure: the equation gives one from the other, give one of them")
    if temperature is None and (density is not None or pressure is None):
        raise InputError("eos() wants a temperature, or a pressure alone")
    _check.text(model, "model")
    given = [_given(temperature, "temperature"), _given(density, "density"), _given(pressure, "pressure")]
    arrays = [value for value in given if value is not None]
    if all(value.ndim == 0 for value in arrays):
        return _document(model, *(None if value is None else value.item() for value in given))
    shape = np.broadcast_shapes(*(value.shape for value in arrays))
    columns = [np.full(shape, None, dtype=object) if value is None else np.broadcast_to(value, shape) for value in given]
    points = [_document(model, *values).data for values in zip(*(column.ravel() for column in columns))]
    return Properties(_arrays(points, shape))


def equations() -> list[Properties]:
    """All equations of state: model, meaning, source, range and critical point of each."""
    return [Properties(each) for each in _core.equations()[0]]
