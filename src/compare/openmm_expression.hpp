#pragma once

#include <string>

#include "ljmd/potentials/pair_potential.hpp"

namespace ljmd {

/// The truncated pair energy as a function of r, in the expression language of OpenMM's custom forces.
///
/// Parameters that may occur: `scale`, which multiplies r everywhere except in the truncation; `cutoff`,
/// `switch_start`; `u_cutoff` and `f_cutoff`, the energy and force of the formula at the cutoff; and the parameters of
/// the formula, by their keys.
/// Source: the language is Lepton's, OpenMM user guide, section 19
///
/// @throws InputError for an unknown truncation
[[nodiscard]] std::string openmm_expression(const PairPotential& potential);

/// The same without truncation.
[[nodiscard]] std::string openmm_formula(const PairPotential& potential);

}  // namespace ljmd
