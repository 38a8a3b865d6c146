#pragma once

#include "ljmd/detail/model/state.hpp"
#include "ljmd/model/lattice.hpp"

namespace ljmd {

/// Verlet's translational order parameter: how much of the initial crystal is left.
///
///     lambda = (1/3N) sum_i [cos k_x (x_i - d_x) + cos k_y (y_i - d_y) + cos k_z (z_i - d_z)],  k_a = 2 pi n_a / L_a
///
/// with n_a the number of lattice planes along edge a: 2 per fcc cell (k = 4 pi / a), 1 per simple-cubic cell; d is the
/// displacement of the centre of mass from the lattice sites' centre, so that a crystal that drifts as a whole, as
/// under a Langevin thermostat or in a uniform field, keeps its order. It is 1 on the lattice sites and fluctuates
/// about 0 by (6N)^(-1/2) in a fluid. Source: Verlet (1967), doi:10.1103/PhysRev.159.98, there with d = 0, as momentum
/// is conserved
class TranslationalOrder {
  public:
    /// @param cells   number of cubic cells along x and along y
    /// @param layers  number of cubic cells along z
    TranslationalOrder(Lattice lattice, Index cells, Index layers);

    /// @pre the state's box is the one that was filled with the lattice, possibly scaled; its atoms were in the box on
    /// the lattice sites, and crossings of walls have been counted since (State::unwrapped)
    [[nodiscard]] double operator()(const State& state) const;

  private:
    /// d, in distances of the planes.
    [[nodiscard]] Vec3 drift(const State& state) const;

    Vec3 planes_;  ///< n_a
};

}  // namespace ljmd
