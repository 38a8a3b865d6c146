#pragma once

#include <string>

#include "ljmd/detail/observables/analysis.hpp"
#include "ljmd/observables/statistics/blocking.hpp"
#include "observables/transport/correlation_windows.hpp"
#include "observables/transport/lag_times.hpp"

namespace ljmd {

/// Averages over windows of the autocorrelation C of a flux, of its running integral, and of the temperature, from
/// which a Green-Kubo relation gives a transport coefficient:
///
///     coefficient(t) = factor(T) integral from 0 to t of C,   coefficient = coefficient(max_time)
///
/// Integrals by the trapezoidal rule, standard errors by block averaging over windows.
class GreenKuboAverages {
  public:
    explicit GreenKuboAverages(const LagTimes& lags);

    /// Add a window. @param correlation  C at the times 0 ... lags.count  @param temperature  mean over the window
    void add(const Eigen::VectorXd& correlation, double temperature);

    [[nodiscard]] Index windows() const { return means_.samples(); }

    /// Mean of the temperature; NaN without windows.
    [[nodiscard]] double temperature() const;

    /// A table: time [tau], `flux`, its error, `coefficient`, its error. The coefficient has no values if
    /// configurations are too far apart (see green_kubo.hpp).
    [[nodiscard]] DataTable table(const std::string& flux, const std::string& coefficient, double factor) const;

    /// The coefficient, with a remark instead of a value if configurations are too far apart, or if the factor is NaN
    /// because there is no temperature to divide by.
    /// @param named  name, symbol and unit
    [[nodiscard]] ObservableAverage coefficient(ObservableAverage named, double factor) const;

    /// Whether the running integral has levelled out at the largest time t: its change D between t/2 and t is zero
    /// within three standard errors of its own, or so small that what a geometric decay would still add after t,
    /// D^2/integral(t/2), is below the standard error of the integral. True if errors are not known.
    [[nodiscard]] bool has_levelled_out() const;

    void archive(Archive& a) { a(means_); }

  private:
    [[nodiscard]] Index times() const { return lags_.count + 1; }
    [[nodiscard]] Estimate integral(double factor) const;  ///< up to the largest time
    [[nodiscard]] double change(double factor) const;      ///< if only every second configuration is used

    LagTimes lags_;
    BlockingAccumulator means_;  ///< C, its integral, T, change at double spacing, change after half the largest time
};

/// Windows of a flux and their averages, for fluxes whose mean is zero.
class GreenKuboSeries {
  public:
    /// @param components  numbers per configuration  @param window  configurations per window, greater than lags.count
    /// @param divisor     of the sum over components, which gives C
    GreenKuboSeries(Index components, const LagTimes& lags, Index window, double divisor);

    /// Add the flux of the next configuration.
    void add(const Eigen::VectorXd& flux, double temperature, const Execution& execution);

    /// Discard the incomplete window.
    void interrupt();

    [[nodiscard]] const GreenKuboAverages& averages() const { return averages_; }

    void archive(Archive& a) { a(window_, in_window_, temperature_sum_, averages_); }

  private:
    double divisor_;
    CorrelationWindows window_;
    Index in_window_ = 0;           ///< configurations in the incomplete window
    double temperature_sum_ = 0.0;  ///< sum of their temperatures
    GreenKuboAverages averages_;
};

/// Remark on a transport coefficient whose running integral has not levelled out.
inline constexpr const char* still_changes =
    "its integral still changes at max_time: give a larger one, and a longer run";

}  // namespace ljmd
