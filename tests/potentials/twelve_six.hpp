#pragma once

#include "ljmd/detail/potentials/pair_term.hpp"

namespace ljmd::test {

/// Lennard-Jones, written as a user of the library would write it: with the operations of the one that the library has,
/// in their order.
struct TwelveSix {
    PairTerm<double> operator()(const PairDistance<double>& d) const {
        const double s6 = d.inverse_r2 * d.inverse_r2 * d.inverse_r2;
        return {4.0 * s6 * (s6 - 1.0), 48.0 * d.inverse_r2 * s6 * (s6 - 0.5)};
    }
};

}  // namespace ljmd::test
