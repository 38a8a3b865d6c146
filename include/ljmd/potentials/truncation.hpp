#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include "ljmd/core/section.hpp"
#include "ljmd/potentials/pair_term.hpp"

namespace ljmd {

/// Where a potential ends.
struct Cutoff {
    double radius = 0.0;        ///< rc [sigma]: pairs with r < rc interact
    double switch_start = 0.0;  ///< rs [sigma]: only for `switched`, 0 < rs < rc
};

// Each truncation wraps a formula u(r), w(r) = -u'(r)/r and is valid for r < rc; who sums over pairs tests r < rc.
// `changes_from(cutoff)` is the radius from which the truncated potential differs from the formula in its force, so
// that a tail correction can make up for it. Source: Allen and Tildesley, Computer Simulation of Liquids, 2nd ed.,
// section 5.2; the switching polynomial is OpenMM's and GROMACS' (fifth order, two continuous derivatives).

/// u(r): the plain truncation. Energy and force jump at rc.
template <class Formula>
class Cut {
  public:
    static constexpr std::string_view name = "cut";
    static constexpr bool takes_root = Formula::takes_root;
    static constexpr bool takes_tail = true;
    static std::vector<Key> keys() { return {}; }
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

/// u(r) - u(rc): the energy is continuous, the force is that of `cut`.
template <class Formula>
class Shifted {
  public:
    static constexpr std::string_view name = "shifted";
    static constexpr bool takes_root = Formula::takes_root;
    static constexpr bool takes_tail = false;
    static std::vector<Key> keys() { return {}; }
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

/// u(r) - u(rc) + (r - rc) F(rc) with F = -u': energy and force are continuous, the force is F(r) - F(rc).
template <class Formula>
class ForceShifted {
  public:
    static constexpr std::string_view name = "force-shifted";
    static constexpr bool takes_root = true;
    static constexpr bool takes_tail = false;
    static std::vector<Key> keys() { return {}; }
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

/// u(r) S(x), x = (r - rs)/(rc - rs), S = 1 - 10 x^3 + 15 x^4 - 6 x^5 for r > rs and 1 before: energy, force and the
/// force's slope are continuous.
template <class Formula>
class Switched {
  public:
    static constexpr std::string_view name = "switched";
    static constexpr bool takes_root = true;
    static constexpr bool takes_tail = true;
    static std::vector<Key> keys() {
        return {Key::number("switch_start")
                    .dimension(Dimension::length)
                    .unit("sigma")
                    .above(0.0)
                    .meaning("radius at which the switching function starts, below `cutoff`; only with truncation = "
                             "\"switched\"")};
    }
    static double changes_from(const Cutoff& cutoff) { return cutoff.switch_start; }

    Switched(const Formula& formula, const Cutoff& cutoff)
        : formula_(formula), start_(cutoff.switch_start), inverse_width_(1.0 / (cutoff.radius - cutoff.switch_start)) {}

    template <class Real>
    PairTerm<Real> operator()(const PairDistance<Real>& d) const {
        using std::max;
        const PairTerm<Real> full = formula_(d);
        const Real x = max(Real(0), (d.r - Real(start_)) * Real(inverse_width_));  // 0 below rs: S = 1, S' = 0
        const Real s =
            multiply_add(x * x * x, multiply_add(x, multiply_add(Real(-6), x, Real(15)), Real(-10)), Real(1));
        const Real y = x - x * x;
        // -S'(r) = 30 y^2 / (rc - rs). What does not depend on x is multiplied first: it need not wait for x.
        const Real from_descent = y * y * (Real(30 * inverse_width_) * full.u * d.inverse_r);
        return {full.u * s, multiply_add(full.w, s, from_descent)};
    }

  private:
    Formula formula_;
    double start_;
    double inverse_width_;
};

}  // namespace ljmd
