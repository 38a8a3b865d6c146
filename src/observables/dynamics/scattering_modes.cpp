#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "observables/dynamics/hydrodynamic_modes.hpp"
#include "observables/dynamics/scattering.hpp"
#include "observables/statistics/known_quantities.hpp"

// The modes of sound, heat, shear and diffusion that scattering functions are fitted by, with errors by a jackknife.

namespace ljmd {

namespace {

constexpr Index least_times = 8;        // that modes are fitted to
constexpr double resolved_self = 0.02;  // F_s whose logarithm has a meaning

double mean_square_of_lengths(const WaveShell& shell) {
    double sum = 0.0;
    for (const WaveVector& vector : shell.vectors) {
        sum += vector.length * vector.length;
    }
    return sum / static_cast<double>(shell.vectors.size());
}

}  // namespace

/// F and C_T at all times, C_L at the first.
Index Scattering::collective_width(const LagTimes& lags) {
    return 2 * (lags.count + 1) + 1;
}

double Scattering::bytes_of_modes(Index shells, const LagTimes& lags, Index windows, Index origins) {
    return JackknifeBlocks::bytes(shells * collective_width(lags), windows) +
           JackknifeBlocks::bytes(2 * shells, origins);
}

/// Each is a product of three powers of exp(-2 pi i x/L), one for each coordinate.
void Scattering::add_to_modes(const Eigen::VectorXd& found) {
    const Index times = lags_.count + 1;
    const Index width = collective_width(lags_);
    Eigen::VectorXd collective(width * static_cast<Index>(shells_.size()));
    for (Index shell = 0; shell < static_cast<Index>(shells_.size()); ++shell) {
        const auto of = found.segment(functions * shell * times, functions * times);
        collective.segment(width * shell, width) << of.head(times), of.segment(2 * times, times), of.segment(times, 1);
    }
    collective_.add(collective);
}

/// c, Gamma and eta of each shell.
Eigen::VectorXd Scattering::modes_of(const Eigen::VectorXd& collective) const {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const Index times = lags_.count + 1;
    const Index width = collective_width(lags_);
    Eigen::VectorXd all(3 * static_cast<Index>(shells_.size()));
    for (Index shell = 0; shell < static_cast<Index>(shells_.size()); ++shell) {
        const double k = std::sqrt(mean_square_of_lengths(shells_[static_cast<std::size_t>(shell)]));
        const Eigen::VectorXd f = collective.segment(width * shell, times);
        const Eigen::VectorXd transverse = collective.segment(width * shell + times, times);
        const double begin = std::sqrt(collective[width * shell + 2 * times] / f[0]);
        const auto sound = fitted_sound(f, lags_.spacing, begin);
        const auto viscosity = transverse_viscosity(transverse, lags_.spacing, k, density_);
        all.segment(3 * shell, 3) << (sound ? sound->frequency / k : nan), (sound ? sound->damping / (k * k) : nan),
            viscosity.value_or(nan);
    }
    return all;
}

/// D of each shell.
Eigen::VectorXd Scattering::diffusion_of(const Eigen::VectorXd& self) const {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    Eigen::VectorXd all(static_cast<Index>(shells_.size()));
    for (Index shell = 0; shell < all.size(); ++shell) {
        const double k2 = mean_square_of_lengths(shells_[static_cast<std::size_t>(shell)]);
        const double passed = lags_.time(lags_.count - lags_.count / 2);
        const double end = self[2 * shell + 1];
        all[shell] = end >= resolved_self ? std::log(self[2 * shell] / end) / (k2 * passed) : nan;
    }
    return all;
}

std::optional<DataTable> Scattering::modes() const {
    if (lags_.count + 1 < least_times || collective_.samples() == 0 || halves_.samples() == 0) {
        return std::nullopt;
    }
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const auto collective = [this](const Eigen::VectorXd& means) { return modes_of(means); };
    const auto self = [this](const Eigen::VectorXd& means) { return diffusion_of(means); };
    const Eigen::VectorXd values = modes_of(collective_.mean());
    const Eigen::VectorXd errors = collective_.errors(collective);
    const Eigen::VectorXd diffusion = diffusion_of(halves_.mean());
    // Origins that are less than the largest time apart have frames in common.
    const Index shared = (lags_.count + frames_between_origins_ - 1) / frames_between_origins_;
    const Eigen::VectorXd diffusion_errors = halves_.errors(self, shared);
    DataTable table{"modes",
                    {"k", "sound_velocity", "sound_velocity_standard_error", "sound_attenuation",
                     "sound_attenuation_standard_error", "transverse_viscosity", "transverse_viscosity_standard_error",
                     "self_diffusion", "self_diffusion_standard_error"},
                    {}};
    for (Index shell = 0; shell < diffusion.size(); ++shell) {
        std::vector<double> row{shells_[static_cast<std::size_t>(shell)].k};
        const auto add = [&](double value, double error) {
            const bool is_known = std::isfinite(error);  // not what some of the blocks lack
            row.push_back(is_known ? value : nan);
            row.push_back(is_known ? error : nan);
        };
        for (Index column = 3 * shell; column < 3 * shell + 3; ++column) {
            add(values[column], errors[column]);
        }
        add(diffusion[shell], diffusion_errors[shell]);
        table.rows.push_back(std::move(row));
    }
    return table;
}

std::vector<ObservableAverage> Scattering::observables() const {
    const std::optional<DataTable> table = modes();
    if (!table) {
        return {};
    }
    const std::vector<double>& first = table->rows.front();  // k, c, its error
    if (std::isfinite(first[1])) {
        const auto blocks = static_cast<double>(collective_.blocks());
        return {average_of("sound_velocity", Estimate{first[1], first[2], blocks, collective_.samples(), true})};
    }
    return {
        average_of("sound_velocity", std::nullopt,
                   fmt::format("no side peak of S(k, w) stands out at the smallest k, {:.3g}: it takes a larger box, "
                               "or a longer run or max_time",
                               first[0]))};
}

}  // namespace ljmd
