#pragma once

#include <cmath>

#include "ljmd/detail/core/elementary.hpp"

namespace ljmd {

/// a b + c. Kernels' vectors have an overload that rounds only once on processors that can.
template <class Real>
Real multiply_add(Real a, Real b, Real c) {
    return a * b + c;
}

/// e^x with the same bits on every machine. Kernels' vectors have an overload.
inline double exp(double x) {
    return exponential(x);
}

/// Contribution of a pair: energy u(r) and w(r) = -u'(r)/r, so that the force on atom i is w (r_i - r_j) and the virial
/// of the pair, r . f, is w r^2.
template <class Real>
struct PairTerm {
    Real u;  ///< [epsilon]
    Real w;  ///< [epsilon/sigma^2]
};

/// Distance of a pair, with the quantities that take a processor long, so that kernels can begin them ahead. A formula
/// says by `takes_root` whether it uses r or 1/r.
template <class Real>
struct PairDistance {
    Real r2;          ///< [sigma^2]; > 0, not checked (hot path)
    Real inverse_r2;  ///< 1/r2
    Real r;           ///< sqrt(r2)
    Real inverse_r;   ///< 1/r
};

template <class Real>
PairDistance<Real> distance_from(Real r2) {
    using std::sqrt;
    const Real inverse_r2 = Real(1) / r2;
    const Real r = sqrt(r2);
    return {r2, inverse_r2, r, r * inverse_r2};
}

/// Pair term of a formula at a squared separation.
/// @param formula  PairTerm<double> operator()(const PairDistance<double>&) const
template <class Formula>
PairTerm<double> pair_term(const Formula& formula, double r2) {
    return formula(distance_from(r2));
}

/// Integrals beyond a radius R for g(r) = 1, from which tail corrections are computed.
struct TailIntegrals {
    double energy;  ///< integral of u(r) r^2 dr from R to infinity [epsilon sigma^3]
    double virial;  ///< integral of w(r) r^4 dr from R to infinity [epsilon sigma^3]
};

}  // namespace ljmd
