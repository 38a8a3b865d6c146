#include "observables/structure/radial_distribution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "observables/statistics/known_quantities.hpp"
#include "observables/structure/pair_histogram.hpp"

namespace ljmd {

namespace {

/// g - 1 is padded with zeros up to this many times R, which makes the spacing of wave numbers smaller by that factor.
constexpr Index padding = 4;

/// Number of the wave number 2 pi/R.
constexpr Index smallest_known = 2 * padding;

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();
constexpr double rounding = 1e-9;

double volume_within(double r) {
    return 4.0 / 3.0 * std::numbers::pi * r * r * r;
}

}  // namespace

RadialDistribution::RadialDistribution(Index bins, double radius, Every every)
    : bins_(bins),
      radius_(radius),
      every_(every),
      sines_(padding * bins),
      division_(CoordinationNumber::division(bins, radius)),
      means_(3 * bins, Covariance::diagonal),
      neighbors_(division_),
      reach_(radius) {}

double RadialDistribution::wave_number(Index m) const {
    return std::numbers::pi * static_cast<double>(m) / (static_cast<double>(padding) * radius_);
}

Eigen::VectorXd RadialDistribution::structure_factor(const Eigen::VectorXd& g, double density) const {
    AlignedVector<double> h(static_cast<std::size_t>(padding * bins_));
    AlignedVector<double> transformed(h.size());
    for (Index k = 0; k < bins_; ++k) {
        h[static_cast<std::size_t>(k)] = width() * (static_cast<double>(k) + 0.5) * (g[k] - 1.0);
    }
    sines_(h, transformed);
    Eigen::VectorXd s(bins_);
    for (Index m = 1; m <= bins_; ++m) {
        const double integral = 0.5 * width() * transformed[static_cast<std::size_t>(m - 1)];
        s[m - 1] = 1.0 + 4.0 * std::numbers::pi * density * integral / wave_number(m);
    }
    return s;
}

void RadialDistribution::sample(const State& state, const Evaluation& /*evaluation*/) {
    reach_ = std::min(reach_, 0.5 * state.box().shortest_edge());
    const std::vector<Index> counts = pair_histogram(state, radius_, bins_ * division_.parts);
    neighbors_.add(counts, state.count());
    const auto atoms = static_cast<double>(state.count());
    const double volume = state.box().volume();
    const double ideal_pairs_per_volume = atoms * (atoms - 1.0) / volume;
    Eigen::VectorXd g(bins_);
    Eigen::VectorXd coordination(bins_);
    double pairs = 0.0;
    for (Index k = 0; k < bins_; ++k) {
        const auto begin = counts.begin() + k * division_.parts;
        const auto count =
            2.0 * static_cast<double>(std::accumulate(begin, begin + division_.parts, Index{0}));  // ordered pairs
        const double inner = width() * static_cast<double>(k);
        const double shell = volume_within(inner + width()) - volume_within(inner);
        g[k] = count / (shell * ideal_pairs_per_volume);  // NaN for a single atom, which has no pairs
        pairs += count;
        coordination[k] = pairs / atoms;
    }
    Eigen::VectorXd found(means_.width());
    found << g, coordination, structure_factor(g, (atoms - 1.0) / volume);  // S - 1 is a sum over the other atoms
    means_.add(found);
}

std::vector<DataTable> RadialDistribution::tables() const {
    if (samples() == 0) {
        return {};
    }
    DataTable rdf{
        "rdf", {"r", "g", "g_standard_error", "coordination_number", "coordination_number_standard_error"}, {}};
    DataTable sk{"sk_from_rdf", {"k", "S", "S_standard_error"}, {}};
    for (Index k = 0; k < bins_; ++k) {
        const Estimate g = means_.estimate(k);
        const Estimate neighbors = means_.estimate(bins_ + k);
        const Estimate s = means_.estimate(2 * bins_ + k);
        const double middle = width() * (static_cast<double>(k) + 0.5);
        if (middle + 0.5 * width() > reach_ * (1.0 + rounding)) {
            rdf.rows.push_back({middle, no_value, no_value, no_value, no_value});
        } else {
            rdf.rows.push_back({middle, g.mean, g.standard_error, neighbors.mean, neighbors.standard_error});
        }
        if (k + 1 >= smallest_known) {
            sk.rows.push_back({wave_number(k + 1), s.mean, s.standard_error});
        }
    }
    return sk.rows.empty() || reach_ < radius_ ? std::vector{rdf} : std::vector{rdf, sk};
}

std::vector<ObservableAverage> RadialDistribution::observables() const {
    if (samples() == 0) {
        return {};
    }
    if (reach_ < radius_) {
        return {average_of("coordination_number", std::nullopt, "the box became smaller than twice the radius of rdf")};
    }
    return {neighbors_.observable()};
}

}  // namespace ljmd
