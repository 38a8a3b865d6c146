#pragma once

#include <cmath>
#include <string_view>

#include "ljmd/detail/options/description.hpp"
#include "ljmd/detail/potentials/pair_term.hpp"

namespace ljmd {

/// Morse: u(r) = D ((1 - e)^2 - 1) = D (e^2 - 2 e) with e = exp(-a (r - r0)); w(r) = 2 D a (e^2 - e) / r.
/// Untruncated; truncations are wrappers, see truncation.hpp.
/// Source: P. M. Morse (1929), doi:10.1103/PhysRev.34.57
class Morse {
  public:
    static constexpr std::string_view name = "morse";
    static constexpr bool takes_root = true;
    static constexpr std::string_view meaning = "D (e^2 - 2 e), e = exp(-a (r - r0))";
    static constexpr std::string_view expression = "well_depth*(e^2-2*e); e=exp(-steepness*(r-minimum))";

    void describe(Description& description) {
        description.required_number("well_depth", depth_)
            .dimension(Dimension::energy)
            .unit("epsilon")
            .above(0.0)
            .meaning("D, depth of the minimum");
        description.required_number("steepness", steepness_)
            .unit("1/sigma")
            .above(0.0)
            .meaning("a; 6 gives the curvature of the Lennard-Jones minimum");
        description.required_number("minimum", minimum_)
            .dimension(Dimension::length)
            .unit("sigma")
            .above(0.0)
            .meaning("r0, position of the minimum; 2^(1/6) is that of Lennard-Jones");
    }

    template <class Real>
    PairTerm<Real> operator()(const PairDistance<Real>& d) const {
        const Real e = exp(Real(-steepness_) * (d.r - Real(minimum_)));
        return {Real(depth_) * e * (e - Real(2)), Real(2 * depth_ * steepness_) * e * (e - Real(1)) * d.inverse_r};
    }

    /// Tail integrals in closed form, from the integrals of r^2 exp(-b (r - r0)), e^(-b (R - r0)) (R^2/b + 2 R/b^2 +
    /// 2/b^3) with b = a and 2 a; and of w r^4 = -u' r^3 by parts: u(R) R^3 + 3 times the integral of u r^2.
    [[nodiscard]] TailIntegrals tail(double radius) const {
        const auto integral = [radius](double b) { return (radius * radius + (2.0 * radius + 2.0 / b) / b) / b; };
        const double e = exp(-steepness_ * (radius - minimum_));
        const double energy = depth_ * (e * e * integral(2.0 * steepness_) - 2.0 * e * integral(steepness_));
        return {energy, depth_ * e * (e - 2.0) * radius * radius * radius + 3.0 * energy};
    }

  private:
    double depth_ = 1.0;                  ///< D [epsilon]
    double steepness_ = 6.0;              ///< a [1/sigma]
    double minimum_ = 1.122462048309373;  ///< r0 [sigma]
};

}  // namespace ljmd
