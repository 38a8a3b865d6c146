#pragma once

#include <optional>
#include <vector>

#include "ljmd/detail/observables/statistics/observable_average.hpp"
#include "ljmd/observables/statistics/blocking.hpp"

namespace ljmd {

/// Coordination number: atoms within the first minimum of the density around an atom, whose position is found by a fit.
///
/// The density rho(r) = N_k/shell_k is known from the mean numbers N_k of atoms in shells of 0.02 to 0.04 sigma, up to
/// 3.2 sigma. At each r a cubic is fitted to the shells within 0.25 sigma, with weights 1 - x^2 that fall to zero
/// there. It is fitted by its integrals over the shells, so that their width does not matter. The minimum r_m is where
/// the slope of these cubics vanishes between the highest peak and twice its distance. The number of atoms is
///
///     n = sum of N_k over the shells within r_m, plus a fraction of the last one by volume
///
/// The standard error is n's as a function of all N_k (delta method, block averaging), including the position of
/// the minimum: dr_m/dN_k = -(d slope/dN_k)/(d slope/dr). There is no value without a significant minimum: the rise
/// behind it must be 5 times its standard error, from at least 16 independent configurations, and r_m must be known to
/// 0.05 sigma. Dilute and ideal gases have none. Source of the fit: Fan and Gijbels (1996), Local Polynomial Modelling,
/// section 3
class CoordinationNumber {
  public:
    /// Division of the radius into shells for the fit and into `bins` bins of equal width up to `radius`. Both consist
    /// of equal parts, which are what is counted.
    struct Division {
        Index parts;       ///< parts per bin
        Index in_a_shell;  ///< parts per shell
        Index shells;
        double width;  ///< width of a shell [sigma]
    };
    [[nodiscard]] static Division division(Index bins, double radius);

    explicit CoordinationNumber(const Division& division);

    /// Add a configuration. @param counts  pairs in each part, from pair_histogram
    void add(const std::vector<Index>& counts, Index atoms);

    /// coordination_number, with a remark if it has no value.
    [[nodiscard]] ObservableAverage observable() const;

    void archive(Archive& a) { a(shells_); }

  private:
    [[nodiscard]] std::optional<Estimate> estimate() const;

    Division division_;
    BlockingAccumulator shells_;  ///< atoms in each shell around an atom
};

}  // namespace ljmd
