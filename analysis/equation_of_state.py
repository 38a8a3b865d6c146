"""Equations of state, as `ljmd eos` has them: no formula of them is written here."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from typing import Optional, Sequence

import numpy as np
import program

OBSERVABLES = ("pressure", "potential_energy", "compressibility_factor")
AT_A_TIME = 4  # each is a process, which takes some milliseconds


def values(model: str, observable: str, temperatures: Sequence[float], densities: Sequence[float]) -> Optional[np.ndarray]:
    """One of OBSERVABLES at states, in reduced units; NaN where the equation is not to be relied on: outside of its
    range, between liquid and vapour, above freezing. None where the program does not answer."""

    def value(state: tuple[float, float]) -> Optional[float]:
        found = program.answer("eos", "--model", model, "--temperature", repr(float(state[0])), "--density",
                               repr(float(state[1])), "--json")
        if found is None:
            return None
        return np.nan if found.get("warnings") or found.get(observable) is None else found[observable]

    with ThreadPoolExecutor(AT_A_TIME) as pool:
        found = list(pool.map(value, zip(temperatures, densities)))
    if all(one is None for one in found):
        return None
    return np.array([np.nan if one is None else one for one in found], float)
