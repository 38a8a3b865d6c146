#include "compare/trajectory_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "integrators/integrator.hpp"
#include "model/velocities.hpp"
#include "observables/statistics/linear_trend.hpp"

namespace ljmd {

namespace {

/// The divergence rate is fitted to distances in this range: below is rounding, above is the size of the cages.
constexpr double min_distance = 1e-12;
constexpr double largest_distance_fitted = 1e-2;
constexpr Index min_rows = 8;

double furthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest = larger_or_nan(largest, (a[i] - b[i]).norm());
    }
    return largest;
}

/// Difference relative to the kinetic energy now or at the start, whichever is larger: if few atoms are all at turning
/// points, their kinetic energy is too small a reference.
double kinetic_difference(const PeerFrame& ours, const PeerFrame& theirs, const PeerFrame& start) {
    const double size = std::max(theirs.kinetic_energy, start.kinetic_energy);
    const double difference = std::abs(ours.kinetic_energy - theirs.kinetic_energy);
    return size > 0.0 ? difference / size : difference;
}

std::vector<Vec3> unwrapped_by_id(const State& state) {
    std::vector<Vec3> positions(static_cast<std::size_t>(state.count()));
    for (Index i = 0; i < state.count(); ++i) {
        positions[static_cast<std::size_t>(state.ids()[static_cast<std::size_t>(i)])] = state.unwrapped(i);
    }
    return positions;
}

}  // namespace

std::vector<PeerFrame> follow(const Fluid& fluid, ForceField& force_field, const std::string& integrator,
                              double time_step, const std::vector<Index>& steps, const Execution& execution) {
    State state = state_of(fluid, execution);
    const Integrator method(find_integrator(integrator), time_step);
    Evaluation evaluation = force_field.evaluate(state, Request::forces_and_energy);
    method.prepare(state, force_field);
    std::vector<PeerFrame> frames;
    Index done = 0;
    for (const Index step : steps) {
        for (; done < step; ++done) {
            evaluation = method.step(state, force_field, {.energy = done + 1 == step, .order_independent = false});
        }
        frames.push_back({step, evaluation.potential_energy, kinetic_energy(state), unwrapped_by_id(state)});
    }
    return frames;
}

std::optional<double> TrajectoryComparison::divergence_rate() const {
    LinearTrend trend;
    for (const Row& row : rows) {
        const double distance = row.distances.front();
        if (distance > min_distance && distance < largest_distance_fitted) {
            trend.add(row.time, std::log(distance));
        }
    }
    return trend.samples() >= min_rows ? trend.slope() : std::nullopt;
}

TrajectoryComparison compare_trajectories(const Fluid& fluid, const MakeForceField& make_force_field, Peer& peer,
                                          double time_step, const std::vector<Index>& steps,
                                          const Execution& execution) {
    TrajectoryComparison comparison;
    comparison.time_step = time_step;
    for (const Index step : steps) {
        comparison.rows.push_back({step, static_cast<double>(step) * time_step, {}, 0.0, 0.0});
    }
    for (const PeerMethod& method : peer.methods()) {
        const std::vector<PeerFrame> theirs = peer.follow(method.name, time_step, steps);
        for (const std::string& integrator : method.ours) {
            const auto force_field = make_force_field();
            const std::vector<PeerFrame> ours = follow(fluid, *force_field, integrator, time_step, steps, execution);
            const bool first = comparison.pairings.empty();
            comparison.pairings.push_back({integrator, method.name, method.ours.size() == 1});
            for (std::size_t k = 0; k < steps.size(); ++k) {
                TrajectoryComparison::Row& row = comparison.rows[k];
                row.distances.push_back(furthest(ours[k].positions, theirs[k].positions));
                if (first) {
                    row.potential_difference =
                        relative_difference(ours[k].potential_energy, theirs[k].potential_energy);
                    row.kinetic_difference = kinetic_difference(ours[k], theirs[k], theirs.front());
                }
            }
        }
    }
    return comparison;
}

std::vector<Check> checks_of(const TrajectoryComparison& comparison, const std::vector<Index>& judged,
                             const Agreement& agreement) {
    std::vector<Check> checks;
    for (const TrajectoryComparison::Row& row : comparison.rows) {
        if (row.step == 0 || std::find(judged.begin(), judged.end(), row.step) == judged.end()) {
            continue;
        }
        for (std::size_t k = 0; k < row.distances.size(); ++k) {
            const auto& [ours, theirs, same_order] = comparison.pairings[k];
            const auto limit =
                limit_at(same_order ? agreement.positions_in_the_same_order : agreement.positions, row.step);
            if (limit) {
                checks.push_back({fmt::format("step {}: {} and {}", row.step, ours, theirs), row.distances[k], *limit});
            }
        }
        if (row.step <= last_step_of_kinetic_energy && std::isfinite(agreement.kinetic_energy)) {
            checks.push_back(
                {fmt::format("step {}: kinetic energy", row.step), row.kinetic_difference, agreement.kinetic_energy});
        }
    }
    return checks;
}

}  // namespace ljmd
