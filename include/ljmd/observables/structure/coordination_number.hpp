#pragma once

#include <optional>
#include <vector>

#include "ljmd/observables/statistics/blocking.hpp"
#include "ljmd/observables/statistics/observable_average.hpp"

namespace ljmd {

/// Atoms within the first minimum of the density around an atom, whose place is found by a fit.
///
/// The density rho(r) = N_k/shell_k is known as the mean number N_k of atoms in shells of 0.02 to 0.04 sigma, up to
/// 3.2 sigma. Around each r a cubic is fitted to the shells within 0.25 sigma, with weights that fall to zero there
/// (1 - x^2); it is compared with shells by its integral over them, so that their width does not matter. The minimum
/// r_m lies between the highest peak and twice its distance, where the slope of these cubics vanishes. The number of
/// atoms is
///
///     n = sum of N_k over the shells within r_m, of the last one the share of its volume
///
/// The standard error is that of n as a function of all N_k (delta method, blocking), where the minimum lies included:
/// dr_m/dN_k = -(d slope/dN_k)/(d slope/dr). There is no value where no minimum stands out: what rises behind it must
/// be 5 times its standard error, from 16 independent configurations at least, and r_m known to 0.05 sigma. In an ideal
/// gas or a thin one there is none. Source of the fit: Fan and Gijbels (1996), Local Polynomial Modelling, section 3
class CoordinationNumber {
  public:
    /// A division of space into bins of equal width that is a multiple of both: `bins` bins up to `radius`, and shells
    /// that suit the fit.
    struct Division {
        Index parts;       ///< of each bin, that are counted
        Index in_a_shell;  ///< parts
        Index shells;
        double width;  ///< of a shell [sigma]
    };
    [[nodiscard]] static Division division(Index bins, double radius);

    explicit CoordinationNumber(const Division& division);

    /// Add a configuration. @param counts  of pairs in each part, as from pair_histogram
    void add(const std::vector<Index>& counts, Index atoms);

    /// coordination_number, with a remark where it has no value.
    [[nodiscard]] ObservableAverage observable() const;

    void archive(Archive& a) { a(shells_); }

  private:
    [[nodiscard]] std::optional<Estimate> estimate() const;

    Division division_;
    BlockingAccumulator shells_;  ///< atoms in each shell around an atom
};

}  // namespace ljmd
