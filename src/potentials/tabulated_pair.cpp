#include "potentials/tabulated_pair.hpp"

#include "potentials/pair_table.hpp"

namespace ljmd {

PairPotential TabulatedPair::potential() const {
    return PairPotential::custom(name, PairTable(first, cutoff.radius, energies), truncation, cutoff);
}

}  // namespace ljmd
