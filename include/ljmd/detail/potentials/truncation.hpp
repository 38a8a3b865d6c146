#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

#include "ljmd/detail/options/description.hpp"
#include "ljmd/detail/potentials/pair_term.hpp"

namespace ljmd {

/// Radii of a truncation.
struct Cutoff {
    double radius = 0.0;        ///< rc [sigma]: pairs with r < rc interact
    double switch_start = 0.0;  ///< rs [sigma]: only for `switched`, 0 < rs < rc
};

// A truncation wraps a formula u(r), w(r) = -u'(r)/r and is valid for r < rc; pair sums test r < rc.
// `describe()` names the keys that it has beside the cutoff, each with the member of Cutoff that holds it.
// `changes_from(cutoff)` is the radius beyond which the truncated force differs from the formula's, where a tail
// correction begins. Source: Allen and Tildesley, Computer Simulation of Liquids, 2nd ed., section 5.2; the switching
// polynomial is the one of OpenMM and GROMACS (fifth order, two continuous derivatives).

/// Plain cut: u(r). Energy and force jump at rc.
template <class Formula>
class Cut {
  public:
    static constexpr std::string_view name = "cut";
    static constexpr bool takes_root = Formula::takes_root;
    static constexpr bool takes_tail = true;
    static constexpr bool takes_switch_start = false;
    static constexpr bool energy_jumps = true;
    static void describe(Description& /*description*/, Cutoff& /*cutoff*/) {}
    static double changes_from(const Cutoff& cutoff) { return cutoff.radius; }

    Cut(const Formula& formula, const Cutoff&) : formula_(formula) {}

    [[nodiscard]] const Formula& formula() const { return formula_; }

    template <class Real>
    PairTerm<Real> operator()(const PairDistance<Real>& d) const {
        return formula_(d);
    }

  private:
    Formula formula_;
};

/// Shifted: u(r) - u(rc). The energy is continuous, the force is the same as with `cut`.
template <class Formula>
class Shifted {
  public:
    static constexpr std::string_view name = "shifted";
    static constexpr bool takes_root = Formula::takes_root;
    static constexpr bool takes_tail = false;
    static constexpr bool takes_switch_start = false;
    static constexpr bool energy_jumps = false;
    static void describe(Description& /*description*/, Cutoff& /*cutoff*/) {}
    static double changes_from(const Cutoff& cutoff) { return cutoff.radius; }

    Shifted(const Formula& formula, const Cutoff& cutoff)
        : formula_(formula), u_cutoff_(pair_term(formula, cutoff.radius * cutoff.radius).u) {}

    template <class Real>
    PairTerm<Real> operator()(const PairDistance<Real>& d) const {
        const PairTerm<Real> full = formula_(d);
        return {full.u - Real(u_cutoff_), full.w};
    }

  private:
    Formula formula_;
    double u_cutoff_;
};

/// Force-shifted: u(r) - u(rc) + (r - rc) F(rc) with F = -u'. The force is F(r) - F(rc); energy and force are
/// continuous.
template <class Formula>
class ForceShifted {
  public:
    static constexpr std::string_view name = "force-shifted";
    static constexpr bool takes_root = true;
    static constexpr bool takes_tail = false;
    static constexpr bool takes_switch_start = false;
    static constexpr bool energy_jumps = false;
    static void describe(Description& /*description*/, Cutoff& /*cutoff*/) {}
    static double changes_from(const Cutoff& cutoff) { return cutoff.radius; }

    ForceShifted(const Formula& formula, const Cutoff& cutoff)
        : formula_(formula),
          radius_(cutoff.radius),
          u_cutoff_(pair_term(formula, cutoff.radius * cutoff.radius).u),
          f_cutoff_(pair_term(formula, cutoff.radius * cutoff.radius).w * cutoff.radius) {}

    template <class Real>
    PairTerm<Real> operator()(const PairDistance<Real>& d) const {
        const PairTerm<Real> full = formula_(d);
        return {full.u - Real(u_cutoff_) + (d.r - Real(radius_)) * Real(f_cutoff_),
                multiply_add(Real(-f_cutoff_), d.inverse_r, full.w)};
    }

  private:
    Formula formula_;
    double radius_;
    double u_cutoff_;
    double f_cutoff_;
};

/// Switched: u(r) S(x) with x = (r - rs)/(rc - rs), S = 1 - 10 x^3 + 15 x^4 - 6 x^5 for r > rs and 1 below. Energy,
/// force and the derivative of the force are continuous.
template <class Formula>
class Switched {
  public:
    static constexpr std::string_view name = "switched";
    static constexpr bool takes_root = true;
    static constexpr bool takes_tail = true;
    static constexpr bool takes_switch_start = true;
    static constexpr bool energy_jumps = false;
    static void describe(Description& description, Cutoff& cutoff) {
        description.required_number("switch_start", cutoff.switch_start)
            .dimension(Dimension::length)
            .unit("sigma")
            .above(0.0)
            .meaning(
                "radius at which the switching function starts, below `cutoff`; only with truncation = \"switched\"");
    }
    static double changes_from(const Cutoff& cutoff) { return cutoff.switch_start; }

    Switched(const Formula& formula, const Cutoff& cutoff)
        : formula_(formula),
          inverse_width_(1.0 / (cutoff.radius - cutoff.switch_start)),
          at_zero_(-0.5 * (cutoff.radius + cutoff.switch_start) * inverse_width_) {}

    /// With t = x - 1/2 and g = 1/4 - t^2, S = 1/2 + t (-1 - 2 g - 6 g^2) and dS/dx = -30 g^2, which takes fewer
    /// operations than powers of x.
    template <class Real>
    PairTerm<Real> operator()(const PairDistance<Real>& d) const {
        using std::max;
        const PairTerm<Real> full = formula_(d);
        // -1/2 below rs, where S = 1 and S' = 0 exactly.
        const Real t = max(Real(-0.5), multiply_add(d.r, Real(inverse_width_), Real(at_zero_)));
        const Real g = multiply_add(-t, t, Real(0.25));
        const Real s = multiply_add(t, multiply_add(g, multiply_add(Real(-6), g, Real(-2)), Real(-1)), Real(0.5));
        // -S'(r) u/r. The factors without g are multiplied first, because they need not wait for g.
        const Real from_descent = g * g * (Real(30 * inverse_width_) * full.u * d.inverse_r);
        return {full.u * s, multiply_add(full.w, s, from_descent)};
    }

  private:
    Formula formula_;
    double inverse_width_;
    double at_zero_;  ///< t at r = 0
};

}  // namespace ljmd
