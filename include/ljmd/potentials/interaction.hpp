#pragma once

#include "ljmd/potentials/pair_potential.hpp"
#include "ljmd/potentials/tail_correction.hpp"

namespace ljmd {

/// What the atoms of a fluid feel of each other, and what its energy and pressure have beside that.
struct Interaction {
    PairPotential potential;
    TailCorrection tail;
};

}  // namespace ljmd
