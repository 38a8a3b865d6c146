// A pair potential of one's own, as a header: Mie's, which has Lennard-Jones for repulsion = 12.
#pragma once

#include <cmath>
#include <ljmd/ljmd.hpp>

/// u(r) = C (r^-n - r^-6), w(r) = -u'(r)/r = C (n r^-n - 6 r^-6) / r^2, with C such that the depth is 1.
/// Source: G. Mie (1903), doi:10.1002/andp.19033160802
class Mie {
  public:
    explicit Mie(double repulsion) : n_(repulsion), factor_(n_ / (n_ - 6.0) * std::pow(n_ / 6.0, 6.0 / (n_ - 6.0))) {}

    ljmd::PairTerm<double> operator()(const ljmd::PairDistance<double>& d) const {
        const double attraction = factor_ * d.inverse_r2 * d.inverse_r2 * d.inverse_r2;
        const double repulsion = factor_ * std::pow(d.inverse_r, n_);
        return {repulsion - attraction, (n_ * repulsion - 6.0 * attraction) * d.inverse_r2};
    }

  private:
    double n_;
    double factor_;
};
