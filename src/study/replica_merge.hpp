#pragma once

#include <vector>

#include "ljmd/detail/observables/analysis.hpp"

namespace ljmd {

/// The mean of an observable in one of several independent runs of a deck.
struct ReplicaMean {
    double mean;
    double standard_error;  ///< NaN if it is unknown
    double samples;         ///< of the run; above 0
    bool converged;         ///< false: the standard error is a guess
};

/// The same observable in all of them.
struct MergedMean {
    double mean;
    double standard_error;  ///< NaN of a single run without one
    double within;          ///< standard error from the errors of the runs; NaN if one is unknown or a guess
    double between;         ///< standard error from the scatter of the means; NaN of a single run
    bool agree;             ///< false: the means scatter more than their errors let expect
};

/// Mean and error of independent runs of one deck.
///
/// The mean is weighted by the lengths of the runs, w_k = n_k / sum n: weights 1/e_k^2 would prefer runs whose error is
/// small by chance, and a run that is short because its error was small weighs less already. Its error has two
/// estimates,
///
///     within:   e_w^2 = sum w_k^2 e_k^2                       (nu_w >= 15 R degrees of freedom)
///     between:  e_b^2 = sum w_k (m_k - m)^2 / (R - 1)         (nu_b = R - 1)
///
/// e_w misses what a run does not show of itself (correlations longer than the run, a metastable state), e_b does not,
/// but it is known to 1/sqrt(2 (R - 1)) only. If they agree both estimate the same, and the error is the one with the
/// smallest scatter, e^2 = (nu_w e_w^2 + nu_b e_b^2)/(nu_w + nu_b). If e_b^2/e_w^2 is above the 99 % point of the F
/// distribution with (nu_b, nu_w), or an error of a run is unknown or a guess, e_b alone decides, with the factor of
/// Student's distribution by which mean +- error covers the truth in 68 %. nu_w: block averages use 16 blocks or more.
///
/// @pre runs is not empty
[[nodiscard]] MergedMean merged_mean(const std::vector<ReplicaMean>& runs);

/// The table of these runs: their mean, weighted by the samples of the runs, where all have the same columns and the
/// same first column; a column "x_standard_error" is merged as the error of "x". Without rows if they differ.
/// @pre as many tables as samples, at least one
[[nodiscard]] DataTable merged_table(const std::vector<DataTable>& tables, const std::vector<double>& samples);

}  // namespace ljmd
