#pragma once

#include "ljmd/detail/forces/force_field.hpp"
#include "ljmd/detail/model/state.hpp"

namespace ljmd {

/// Result of a relaxation.
struct Relaxation {
    Index iterations;
    double largest_force;     ///< largest |f_i| [epsilon/sigma]
    double potential_energy;  ///< U [epsilon], without tail correction
};

/// Push overlapping atoms apart before the first step, until the largest force is below `force_tolerance`. FIRE
/// minimisation in which no atom moves by more than 0.1 sigma per iteration.
///
/// @post velocities zero, images zero, atoms in the box, forces current
/// @throws PhysicsError if `max_iterations` do not suffice
/// Source: Bitzek, Koskinen, Gaehler, Moseler and Gumbsch (2006), doi:10.1103/PhysRevLett.97.170201
Relaxation relax(State& state, ForceField& force_field, double force_tolerance = 10.0, Index max_iterations = 20000);

}  // namespace ljmd
