#pragma once

#include <array>
#include <complex>
#include <memory>
#include <vector>

#include "ljmd/detail/model/state.hpp"
#include "observables/fourier.hpp"

namespace ljmd {

/// Fourier components of the number density at the wave vectors of a periodic box:
///
///     rho(k) = sum_j exp(-i k . r_j),   k = 2 pi (n_x/L_x, n_y/L_y, n_z/L_z)
///
/// They are computed for rods of equal n_x and n_y. rho(-k) is the complex conjugate of rho(k).
class DensityModes {
  public:
    using Numbers = std::array<Index, 3>;  ///< n_x, n_y, n_z

    virtual ~DensityModes() = default;

    /// Prepare for a configuration. The state need not be kept afterwards.
    virtual void prepare(const State& state) = 0;

    /// rho at (n_x, n_y, 0), (n_x, n_y, 1), ... (n_x, n_y, rod.size() - 1). Several threads may call it at the same
    /// time.
    /// @pre prepare() was called; no number exceeds the largest one in magnitude
    virtual void get(Index n_x, Index n_y, std::vector<std::complex<double>>& rod) const = 0;

  protected:
    DensityModes() = default;
    DensityModes(const DensityModes&) = default;
    DensityModes& operator=(const DensityModes&) = default;
};

/// Density modes by a sum over the atoms for each wave vector. Time O(atoms * wave vectors), memory 16 bytes per atom
/// for each of n_x + n_y + n_z + 3 numbers. Error: 1e-15 of the sum of absolute values, N, for each n.
[[nodiscard]] std::unique_ptr<DensityModes> direct_density_modes(const Box& box, const DensityModes::Numbers& largest);

/// Density modes by a fast Fourier transform: each atom is spread over 16^3 points of a grid by the kernel
///
///     phi(z) = exp(beta ((1 - z^2)^{1/2} - 1)),   |z| <= 1 = half its width
///
/// in each direction, and its effect on rho(k) is divided out. The grid is 1.5 times as fine as the largest wave
/// numbers require; errors are below 1e-11 N. Time O(atoms + M log M) for M grid points, memory 16 M bytes and 400
/// bytes per atom. Source: Barnett, Magland and af Klinteberg (2019), doi:10.1137/18M120885X
[[nodiscard]] std::unique_ptr<DensityModes> grid_density_modes(const Box& box, const DensityModes::Numbers& largest);

}  // namespace ljmd
