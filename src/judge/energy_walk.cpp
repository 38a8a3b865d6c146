#include "judge/energy_walk.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ljmd/observables/statistics/blocking.hpp"

namespace ljmd {

namespace {

constexpr std::size_t blocks_of_walk = 16;
constexpr std::size_t most_parts_of_block = 8;

double mean_between(const std::vector<double>& x, std::size_t first, std::size_t end) {
    return std::accumulate(x.begin() + static_cast<std::ptrdiff_t>(first), x.begin() + static_cast<std::ptrdiff_t>(end),
                           0.0) /
           static_cast<double>(end - first);
}

/// Mean of (x_k+1 - x_k)^2 of the means over `count` blocks, which take all samples but a remainder at the start.
double mean_square_step(const std::vector<double>& x, std::size_t count) {
    const std::size_t length = x.size() / count;
    const std::size_t skipped = x.size() - length * count;
    double squares = 0.0;
    double last = mean_between(x, skipped, skipped + length);
    for (std::size_t k = 1; k < count; ++k) {
        const std::size_t first = skipped + k * length;
        const double next = mean_between(x, first, first + length);
        squares += (next - last) * (next - last);
        last = next;
    }
    return squares / static_cast<double>(count - 1);
}

double slope_over_all(const std::vector<double>& x) {
    const auto n = static_cast<double>(x.size());
    double along = 0.0;
    double squares = 0.0;
    for (std::size_t k = 0; k < x.size(); ++k) {
        const double t = (static_cast<double>(k) - 0.5 * (n - 1.0)) / n;
        along += t * x[k];
        squares += t * t;
    }
    return along / squares;
}

}  // namespace

EnergyWalk energy_walk(const std::vector<double>& energy) {
    EnergyWalk found;
    const double reference = energy.front();  // energies are large, and their changes small
    std::vector<double> e;
    e.reserve(energy.size());
    BlockingAccumulator steps(1, Covariance::diagonal);
    for (const double x : energy) {
        if (!e.empty()) {
            steps.add(Eigen::VectorXd::Constant(1, std::pow(x - reference - e.back(), 2)));
        }
        e.push_back(x - reference);
    }
    const Estimate step = steps.estimate(0);
    found.mean = reference + mean_between(e, 0, e.size());
    found.slope = slope_over_all(e);
    found.jitter = std::sqrt(step.mean);
    found.jitter_error = step.mean > 0.0 ? 0.5 * step.standard_error / step.mean : 0.0;
    const std::size_t parts = std::min(most_parts_of_block, e.size() / blocks_of_walk);
    const auto m = static_cast<double>(blocks_of_walk);
    const auto p = static_cast<double>(parts);
    const double of_parts = mean_square_step(e, blocks_of_walk * parts);
    const double of_blocks = mean_square_step(e, blocks_of_walk);
    found.of_mean = {.value = 0.5 * of_parts / (m * p), .freedom = m * p - 1.0};
    // of_blocks = 2 s^2/p + (2/3) c D, of_parts = 2 s^2 + (2/3) c D/p
    const double of_walk = std::max(0.0, (of_blocks - of_parts / p) / (1.0 - 1.0 / (p * p)));
    found.walk = {.value = 0.5 * m * of_walk,
                  .freedom = 0.75 * m};  // neighbouring steps of a walk's means are correlated
    return found;
}

double change_with_energy(const std::vector<double>& x, double kinetic_part, const std::vector<double>& kinetic,
                          double freedom) {
    const std::size_t length = x.size() / blocks_of_walk;
    double covariance = 0.0;
    for (std::size_t k = 0; k < blocks_of_walk; ++k) {
        const std::size_t first = k * length;
        const double mean_x = mean_between(x, first, first + length);
        const double mean_k = mean_between(kinetic, first, first + length);
        for (std::size_t i = first; i < first + length; ++i) {
            covariance += (x[i] - mean_x) * (kinetic[i] - mean_k);
        }
    }
    covariance /= static_cast<double>(blocks_of_walk * (length - 1));
    const double temperature = 2.0 * mean_between(kinetic, 0, kinetic.size()) / freedom;
    return kinetic_part - 2.0 * covariance / (freedom * temperature * temperature);
}

}  // namespace ljmd
