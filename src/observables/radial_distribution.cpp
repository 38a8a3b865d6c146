#include "ljmd/observables/radial_distribution.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ljmd/core/threads.hpp"

namespace ljmd {

namespace {

/// Each block counts into a histogram of its own: enough blocks for many threads, few enough for long histograms.
constexpr Index most_blocks = 64;
using Histogram = Eigen::Matrix<Index, Eigen::Dynamic, 1>;

double sphere(double r) {
    return 4.0 / 3.0 * std::numbers::pi * r * r * r;
}

}  // namespace

RadialDistribution::RadialDistribution(Index bins, double radius, Every every)
    : bins_(bins), radius_(radius), every_(every), histogram_(bins, Covariance::diagonal) {}

void RadialDistribution::sample(const State& state) {
    // The search sorts and wraps atoms, which must not happen to the running state.
    State scratch(state.count(), state.box());
    scratch.write_positions() = state.positions();
    search_.prepare(scratch, radius_);

    const double per_length = static_cast<double>(bins_) / radius_;
    const auto count_pairs = [&](Index first, Index last) {
        Histogram counts = Histogram::Zero(bins_);
        for (Index part = first; part < last; ++part) {
            search_.for_each_candidate(scratch, part, [&](const PairVisit& pair) {
                const double r2 = pair.dx * pair.dx + pair.dy * pair.dy + pair.dz * pair.dz;
                if (r2 < radius_ * radius_) {
                    ++counts[std::min(static_cast<Index>(std::sqrt(r2) * per_length), bins_ - 1)];
                }
            });
        }
        return counts;
    };
    const Index parts = search_.part_count(scratch);
    const Histogram counts = join_blocks(parts, std::max((parts + most_blocks - 1) / most_blocks, Index{1}),
                                         Histogram(Histogram::Zero(bins_)), count_pairs,
                                         [](Histogram& sum, const Histogram& block) { sum += block; });

    Eigen::VectorXd pairs = counts.cast<double>();
    atoms_ = state.count();
    ideal_pairs_per_volume_ = static_cast<double>(atoms_) * static_cast<double>(atoms_ - 1) / state.box().volume();
    const double width = radius_ / static_cast<double>(bins_);
    for (Index k = 0; k < bins_; ++k) {
        const double shell = sphere(width * static_cast<double>(k + 1)) - sphere(width * static_cast<double>(k));
        pairs[k] = ideal_pairs_per_volume_ > 0.0 ? pairs[k] / (shell * ideal_pairs_per_volume_) : 0.0;
    }
    histogram_.add(pairs);
}

DataTable RadialDistribution::result() const {
    DataTable table{"rdf", {"r", "g", "g_standard_error", "coordination_number"}, {}};
    const double width = radius_ / static_cast<double>(bins_);
    double neighbors = 0.0;
    for (Index k = 0; k < bins_; ++k) {
        const Estimate g = histogram_.estimate(k);
        const double inner = width * static_cast<double>(k);
        const double shell = sphere(inner + width) - sphere(inner);
        neighbors += g.mean * shell * ideal_pairs_per_volume_ / static_cast<double>(atoms_);
        table.rows.push_back({inner + 0.5 * width, g.mean, g.standard_error, neighbors});
    }
    return table;
}

}  // namespace ljmd
