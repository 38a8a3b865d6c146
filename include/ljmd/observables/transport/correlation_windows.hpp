#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "ljmd/core/archive.hpp"
#include "ljmd/core/fourier.hpp"

namespace ljmd {

/// Autocorrelation of many series, summed over them, window by window:
///
///     C_k = 1/(W - k) * sum over series s, sum_{t=0}^{W-k-1} x_s(t) x_s(t + k),  k = 0 ... lags
///
/// W frames make a window; windows follow one another without a gap and do not overlap. Every pair of frames within
/// a window counts. By Wiener and Khinchin's theorem: series are padded with zeros to at least W + lags, so that their
/// ends do not meet, and transformed; the squares of what comes out are summed over the series and transformed back.
/// Time O(series W log W); memory 8 series W bytes. Round-off: 1e-15 of C_0. Every thread count gives the same bits.
/// Source: Allen and Tildesley, 2nd ed., section 8.3 and appendix D
class CorrelationWindows {
  public:
    /// @param series  numbers in a frame
    /// @param lags    at least 1
    /// @param window  W, more than `lags`
    /// @throws ContractViolation
    CorrelationWindows(Index series, Index lags, Index window);

    /// Add the next frame. @return C_0 ... C_lags when it completes a window
    /// @throws ContractViolation unless it has `series` numbers
    std::optional<Eigen::VectorXd> add(const Eigen::VectorXd& frame);

    /// Forget the window that has begun.
    void interrupt() { frames_.clear(); }

    /// @throws CheckpointError for a window of another size
    void archive(Archive& a);

  private:
    [[nodiscard]] Eigen::VectorXd correlate() const;

    Index series_;
    Index lags_;
    Index window_;
    RealTransform forward_;
    InverseRealTransform backward_;
    std::vector<double> frames_;  ///< one behind the other
};

/// Integral of a function from 0 to each of the equally spaced times where it is known, by the trapezoidal rule.
/// @pre at least one value
[[nodiscard]] Eigen::VectorXd running_integral(const Eigen::VectorXd& values, double spacing);

}  // namespace ljmd
