#pragma once

#include <cmath>

namespace ljmd {

/// a b + c. Vectors of kernels have an overload that rounds once, where the processor can.
template <class Real>
Real multiply_add(Real a, Real b, Real c) {
    return a * b + c;
}

/// What one pair contributes: energy u(r) and w(r) = -u'(r)/r, so that the force on atom i is w (r_i - r_j) and the
/// pair's virial r . f is w r^2.
template <class Real>
struct PairTerm {
    Real u;  ///< [epsilon]
    Real w;  ///< [epsilon/sigma^2]
};

/// The distance of a pair as formulas take it: with what takes a processor long, so that kernels can begin it ahead of
/// the rest. A formula says as `takes_root` whether it has use for r or 1/r.
template <class Real>
struct PairDistance {
    Real r2;          ///< [sigma^2]; > 0, unchecked (hot path)
    Real inverse_r2;  ///< 1/r2
    Real r;           ///< its root
    Real inverse_r;   ///< 1/r
};

template <class Real>
PairDistance<Real> distance_from(Real r2) {
    using std::sqrt;
    const Real inverse_r2 = Real(1) / r2;
    const Real r = sqrt(r2);
    return {r2, inverse_r2, r, r * inverse_r2};
}

/// What a formula gives at a squared separation.
/// @param formula  PairTerm<double> operator()(const PairDistance<double>&) const
template <class Formula>
PairTerm<double> pair_term(const Formula& formula, double r2) {
    return formula(distance_from(r2));
}

/// What is missing beyond a radius R when g(r) = 1: the integrals behind tail corrections.
struct TailIntegrals {
    double energy;  ///< integral of u(r) r^2 dr from R to infinity [epsilon sigma^3]
    double virial;  ///< integral of w(r) r^4 dr from R to infinity [epsilon sigma^3]
};

}  // namespace ljmd
