#pragma once

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

/// What a formula gives at a squared separation. It takes 1/r^2, too, which kernels compute ahead of the rest.
/// @param formula  PairTerm<double> operator()(double r2, double inverse_r2) const
template <class Formula>
PairTerm<double> pair_term(const Formula& formula, double r2) {
    return formula(r2, 1.0 / r2);
}

/// What is missing beyond a radius R when g(r) = 1: the integrals behind tail corrections.
struct TailIntegrals {
    double energy;  ///< integral of u(r) r^2 dr from R to infinity [epsilon sigma^3]
    double virial;  ///< integral of w(r) r^4 dr from R to infinity [epsilon sigma^3]
};

}  // namespace ljmd
