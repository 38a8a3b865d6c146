#pragma once

#include <cmath>
#include <string_view>

#include "ljmd/detail/options/description.hpp"
#include "ljmd/detail/potentials/pair_term.hpp"

namespace ljmd {

/// Lennard-Jones 12-6: u(r) = 4 (r^-12 - r^-6), w(r) = -u'(r)/r = 24 r^-2 (2 r^-12 - r^-6), in units of sigma and
/// epsilon. Untruncated; truncations are wrappers, see truncation.hpp. Source: J. E. Jones (1924),
/// doi:10.1098/rspa.1924.0082
class LennardJones {
  public:
    static constexpr std::string_view name = "lennard-jones";
    static constexpr bool takes_root = false;
    static constexpr std::string_view meaning = "4 (r^-12 - r^-6)";
    static constexpr std::string_view expression = "4*(r^-12-r^-6)";

    /// No parameters: sigma and epsilon are the units.
    void describe(Description& /*description*/) {}

    template <class Real>
    PairTerm<Real> operator()(const PairDistance<Real>& d) const {
        const Real s6 = d.inverse_r2 * d.inverse_r2 * d.inverse_r2;
        return {Real(4) * s6 * (s6 - Real(1)), Real(48) * d.inverse_r2 * s6 * (s6 - Real(0.5))};
    }

    /// Tail integrals in closed form: of u r^2, 4 (R^-9/9 - R^-3/3); of w r^4, 24 (2 R^-9/9 - R^-3/3).
    [[nodiscard]] TailIntegrals tail(double radius) const {
        const double r3 = 1.0 / (radius * radius * radius);
        const double r9 = r3 * r3 * r3;
        return {4.0 * (r9 / 9.0 - r3 / 3.0), 24.0 * (2.0 * r9 / 9.0 - r3 / 3.0)};
    }
};

}  // namespace ljmd
