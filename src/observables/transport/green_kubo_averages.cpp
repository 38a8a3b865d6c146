#include "observables/transport/green_kubo_averages.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include "ljmd/detail/observables/thermodynamics.hpp"
#include "observables/transport/green_kubo.hpp"

namespace ljmd {

namespace {

constexpr double errors_of_a_change = 3.0;

}  // namespace

GreenKuboAverages::GreenKuboAverages(const LagTimes& lags)
    : lags_(lags), means_(2 * (lags.count + 1) + 3, Covariance::diagonal) {}

void GreenKuboAverages::add(const Eigen::VectorXd& correlation, double temperature) {
    Eigen::VectorXd found(means_.width());
    found.head(times()) = correlation;
    found.segment(times(), times()) = running_integral(found.head(times()), lags_.spacing);
    found[2 * times()] = temperature;
    found[2 * times() + 1] = change_at_double_spacing(found.head(times()), lags_.spacing);
    found[2 * times() + 2] = found[times() + lags_.count] - found[times() + lags_.count / 2];
    means_.add(found);
}

double GreenKuboAverages::temperature() const {
    return means_.mean()[2 * times()];
}

Estimate GreenKuboAverages::integral(double factor) const {
    Estimate integral = means_.estimate(times() + lags_.count);
    integral.mean *= factor;
    integral.standard_error *= factor;
    return integral;
}

double GreenKuboAverages::change(double factor) const {
    return factor * means_.mean()[2 * times() + 1];
}

DataTable GreenKuboAverages::table(const std::string& flux, const std::string& coefficient, double factor) const {
    DataTable table{flux, {"time", flux, flux + "_standard_error", coefficient, coefficient + "_standard_error"}, {}};
    const bool has_integrals = frames_are_close(integral(factor), change(factor));
    const double shown = has_integrals ? factor : std::numeric_limits<double>::quiet_NaN();
    for (Index k = 0; k < times(); ++k) {
        const Estimate c = means_.estimate(k);
        const Estimate integral = means_.estimate(times() + k);
        table.rows.push_back(
            {lags_.time(k), c.mean, c.standard_error, shown * integral.mean, shown * integral.standard_error});
    }
    return table;
}

ObservableAverage GreenKuboAverages::coefficient(ObservableAverage named, double factor) const {
    if (std::isnan(factor)) {
        named.remark = no_temperature;
        return named;
    }
    named.estimate = integral(factor);
    return green_kubo_integral(std::move(named), change(factor));
}

bool GreenKuboAverages::has_levelled_out() const {
    const Estimate whole = integral(1.0);
    const Estimate late = means_.estimate(2 * times() + 2);
    if (!std::isfinite(whole.standard_error) || !std::isfinite(late.standard_error)) {
        return true;
    }
    const double early = whole.mean - late.mean;
    return std::abs(late.mean) <= errors_of_a_change * late.standard_error ||
           late.mean * late.mean <= whole.standard_error * std::abs(early);
}

GreenKuboSeries::GreenKuboSeries(Index components, const LagTimes& lags, Index window, double divisor)
    : divisor_(divisor), window_(components, lags.count, window), averages_(lags) {}

void GreenKuboSeries::add(const Eigen::VectorXd& flux, double temperature, const Execution& execution) {
    ++in_window_;
    temperature_sum_ += temperature;
    if (const std::optional<Eigen::VectorXd> sum = window_.add(flux, execution)) {
        averages_.add(*sum / divisor_, temperature_sum_ / static_cast<double>(in_window_));
        in_window_ = 0;
        temperature_sum_ = 0.0;
    }
}

void GreenKuboSeries::interrupt() {
    window_.interrupt();
    in_window_ = 0;
    temperature_sum_ = 0.0;
}

}  // namespace ljmd
