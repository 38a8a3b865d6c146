#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "ljmd/detail/core/archive.hpp"
#include "ljmd/execution/execution.hpp"
#include "observables/fourier.hpp"

namespace ljmd {

/// Autocorrelation of many series, summed over the series, window by window:
///
///     C_k = 1/(W - k) * sum over series s, sum_{t=0}^{W-k-1} x_s(t) x_s(t + k),  k = 0 ... lags
///
/// A window has W frames. Windows follow one another without gap or overlap. Every pair of frames within a window
/// counts. Computed by the Wiener-Khinchin theorem: series are padded with zeros to at least W + lags, so that
/// correlations do not wrap around, and transformed; their squares are summed over the series and transformed back.
/// Time O(series W log W); memory 8 series W bytes. Round-off: 1e-15 of C_0. The bits do not depend on the number of
/// threads.
/// Source: Allen and Tildesley, 2nd ed., section 8.3 and appendix D
class CorrelationWindows {
  public:
    /// @param series  numbers per frame
    /// @param lags    at least 1
    /// @param window  W, greater than `lags`
    /// @throws ContractViolation
    CorrelationWindows(Index series, Index lags, Index window);

    /// Add the next frame. @return C_0 ... C_lags if it completes a window
    /// @param execution  its threads compute them
    /// @throws ContractViolation unless it has `series` numbers
    std::optional<Eigen::VectorXd> add(const Eigen::VectorXd& frame, const Execution& execution);

    /// Discard the incomplete window.
    void interrupt() { frames_.clear(); }

    /// @throws CheckpointError for a window of another size
    void archive(Archive& a);

  private:
    [[nodiscard]] Eigen::VectorXd correlate(const Execution& execution) const;

    Index series_;
    Index lags_;
    Index window_;
    RealTransform forward_;
    InverseRealTransform backward_;
    std::vector<double> frames_;  ///< frame by frame
};

/// Integral of a function from 0 to each of the equally spaced times at which it is known, by the trapezoidal rule.
/// @pre at least one value
[[nodiscard]] Eigen::VectorXd running_integral(const Eigen::VectorXd& values, double spacing);

}  // namespace ljmd
