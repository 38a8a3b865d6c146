#pragma once

#include <array>

namespace ljmd {

/// A quantity with its symbol and its reduced unit.
struct KnownQuantity {
    const char* name;
    const char* symbol;
    const char* unit;
};

/// What `RunAverages` averages of each sample, in the order of its columns; names as in results.json and thermo.csv.
inline constexpr std::array<KnownQuantity, 13> sampled_quantities{{{"temperature", "T", "epsilon/k_B"},
                                                                   {"potential_energy", "U/N", "epsilon"},
                                                                   {"kinetic_energy", "K/N", "epsilon"},
                                                                   {"total_energy", "E/N", "epsilon"},
                                                                   {"pressure", "p", "epsilon/sigma^3"},
                                                                   {"density", "rho", "sigma^-3"},
                                                                   {"pressure_xx", "p_xx", "epsilon/sigma^3"},
                                                                   {"pressure_yy", "p_yy", "epsilon/sigma^3"},
                                                                   {"pressure_zz", "p_zz", "epsilon/sigma^3"},
                                                                   {"pressure_xy", "p_xy", "epsilon/sigma^3"},
                                                                   {"pressure_xz", "p_xz", "epsilon/sigma^3"},
                                                                   {"pressure_yz", "p_yz", "epsilon/sigma^3"},
                                                                   {"virial", "W", "epsilon"}}};

}  // namespace ljmd
