#pragma once

#include <optional>
#include <string_view>

namespace ljmd {

/// ASE's unit of velocity, sqrt(eV/u), in angstrom/ps (CODATA 2018: e and u).
inline constexpr double ase_velocity = 98.22694750253277;

/// ASE's unit of energy, the electronvolt, in joule (exact since 2019).
inline constexpr double ase_energy = 1.602176634e-19;

/// The mass [u] that ASE gives to an element: standard atomic weights, and 1 for the species X. The symbol is
/// case-insensitive. Nothing for an unknown symbol. Source: J. Meija et al. (2016), doi:10.1515/pac-2015-0305, as in
/// ase.data.atomic_masses
[[nodiscard]] std::optional<double> ase_mass(std::string_view symbol);

}  // namespace ljmd
