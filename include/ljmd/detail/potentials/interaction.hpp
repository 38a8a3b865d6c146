#pragma once

#include "ljmd/detail/potentials/tail_correction.hpp"
#include "ljmd/potentials/pair_potential.hpp"

namespace ljmd {

/// What acts on the atoms of a fluid: the pair potential, and the correction of energy and pressure for its tail.
struct Interaction {
    PairPotential potential;
    TailCorrection tail;
    bool external = false;  ///< whether there is an external force beside it: momentum is not conserved then
};

}  // namespace ljmd
