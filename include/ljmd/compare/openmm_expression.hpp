#pragma once

#include <string>

#include "ljmd/potentials/pair_potential.hpp"

namespace ljmd {

/// The truncated pair energy in the language of OpenMM's custom forces, as a function of r.
///
/// Its parameters: `scale`, which multiplies r wherever the potential has it (not where it ends); `cutoff`,
/// `switch_start`; `u_cutoff` and `f_cutoff`, energy and force of the formula at the cutoff; those of the formula by
/// their keys. A parameter may occur or not.
/// Source: the language is Lepton's, OpenMM user guide, section 19
///
/// @throws InputError for a truncation that it does not know
[[nodiscard]] std::string openmm_expression(const PairPotential& potential);

/// The same without truncation.
[[nodiscard]] std::string openmm_formula(const PairPotential& potential);

}  // namespace ljmd
