#pragma once

#include <vector>

#include "ljmd/core/types.hpp"

namespace ljmd {

/// A variance with the number of degrees of freedom that it was found from.
struct Variance {
    double value = 0.0;
    double freedom = 1.0;
};

/// How the total energy E = U + K of a run goes that is to conserve it.
///
/// Where the force has a step at the cutoff, each pair that crosses it changes E a little, up or down: E walks at
/// random, and two right programs, whose trajectories part, walk two ways. Means of E over 16 blocks tell it from the
/// noise of the time step, which is gone within a block. With m blocks of length D,
///
///     noise alone   <(E_k+1 - E_k)^2> = 2 s^2
///     a walk        <(E_k+1 - E_k)^2> = (2/3) c D,   <(E(t) - E(0))^2> = c t
///
/// so noise is what short blocks (an eighth) have, and what long ones have beyond it is the walk.
struct EnergyWalk {
    double mean = 0.0;      ///< [epsilon]
    double slope = 0.0;     ///< of the straight line through it, over the whole run [epsilon]
    double jitter = 0.0;    ///< root mean square of E_k+1 - E_k, row by row [epsilon]
    Variance of_mean{};     ///< of the mean by noise [epsilon^2]
    Variance walk{};        ///< dE^2: of the mean by the walk, c t/3 with t the length of the run [epsilon^2]
    double jitter_error{};  ///< standard error of ln(jitter)
};

/// Rows that a walk is found from, at least.
inline constexpr Index rows_of_a_walk = 64;

/// @param energy  at equal intervals  @pre at least rows_of_a_walk
[[nodiscard]] EnergyWalk energy_walk(const std::vector<double>& energy);

/// dX/dE at constant volume of a quantity X = a K + B, B a function of the configuration, from a run at constant
/// energy:
///
///     dX/dE = a - 2 cov(K, X)/(f T^2),   T = 2 <K>/f
///
/// (Lebowitz, Percus and Verlet (1967), doi:10.1103/PhysRev.153.250). Covariances are taken within 16 blocks, so that a
/// walk of the energy is not in them.
/// @param kinetic_part  a  @param freedom  f, of the kinetic energy
/// @pre both series have as many samples, at least rows_of_a_walk
[[nodiscard]] double change_with_energy(const std::vector<double>& x, double kinetic_part,
                                        const std::vector<double>& kinetic, double freedom);

}  // namespace ljmd
