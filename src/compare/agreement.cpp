#include "ljmd/compare/agreement.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ljmd/model/box.hpp"
#include "ljmd/model/velocities.hpp"

namespace ljmd {

namespace {

// The situation that limits are written down for.
constexpr double usual_time_step = 0.004;  // [tau]
constexpr double usual_edge = 16.0;        // coordinates below have one unit in the last place [sigma]
constexpr double usual_atoms = 864.0;

constexpr double hot = 1.0;           // [epsilon/k_B]
constexpr double cold_growth = 3.75;  // [1/tau]
constexpr double hot_growth = 7.5;

/// From this step on the furthest atom is one of few whose neighbourhood is less stable than the others'.
constexpr Index late = 500;

/// Limits as they are in another situation: never below those written down.
std::vector<Agreement::Limit> limits_in(const Situation& situation, std::vector<Agreement::Limit> limits) {
    const double growth = situation.temperature > hot ? hot_growth : cold_growth;
    for (Agreement::Limit& limit : limits) {
        const double later = static_cast<double>(limit.step) * (situation.time_step - usual_time_step);
        limit.distance *= std::exp(growth * std::max(0.0, later));
        limit.distance *= std::max(1.0, situation.longest_edge / usual_edge);
        if (limit.step >= late) {
            limit.distance *= std::max(1.0, static_cast<double>(situation.atoms) / usual_atoms);
        }
    }
    return limits;
}

/// Two numbers that agree but for their rounding, ours to the grid of the box, theirs to the last place: half a unit of
/// both in each direction, which is 4.6e-15 in a box below 10.6 sigma.
double after_one_rounding(const Situation& situation) {
    constexpr double usual_resolution = 0x1p-48;
    const double resolution = Box(Vec3::Constant(situation.longest_edge)).resolution();
    return 5e-15 * std::max(1.0, resolution / usual_resolution);
}

}  // namespace

double relative_difference(double a, double b) {
    return b == 0.0 ? std::abs(a) : std::abs(a - b) / std::abs(b);
}

double larger_or_nan(double a, double b) {
    return std::isnan(a) || a > b ? a : b;
}

Situation situation_of(const Fluid& fluid, double time_step) {
    const auto atoms = static_cast<Index>(fluid.masses.size());
    const Index freedom = degrees_of_freedom(atoms);
    return {.temperature = freedom > 0 ? 2.0 * kinetic_energy(fluid) / static_cast<double>(freedom) : 0.0,
            .time_step = time_step,
            .longest_edge = fluid.edges.maxCoeff(),
            .atoms = atoms};
}

Agreement double_agreement(const Situation& situation) {
    const bool is_hot = situation.temperature > hot;
    std::vector<Agreement::Limit> in_the_same_order =
        limits_in(situation, is_hot ? std::vector<Agreement::Limit>{{100, 1e-12}}
                                    : std::vector<Agreement::Limit>{{100, 2e-13}, {500, 1e-10}});
    in_the_same_order.insert(in_the_same_order.begin(), {1, after_one_rounding(situation)});
    return {.energy = 1e-13,
            .largest_force = 1e-12,
            .rms_force = 1e-13,
            .pressure = 1e-12,
            .kinetic_energy = 1e-12,
            .positions = limits_in(
                situation, is_hot ? std::vector<Agreement::Limit>{{1, 1e-14}, {10, 5e-13}, {100, 1e-11}, {200, 1e-9}}
                                  : std::vector<Agreement::Limit>{{1, 1e-14},
                                                                  {10, 5e-13},
                                                                  {100, 1e-11},
                                                                  {200, 5e-11},
                                                                  {500, 5e-9},
                                                                  {1000, 1e-5}}),
            .positions_in_the_same_order = std::move(in_the_same_order)};
}

Agreement lammps_agreement(const Situation& situation) {
    Agreement agreement = double_agreement(situation);
    agreement.energy = 1e-12;
    agreement.rms_force = 1e-12;
    agreement.kinetic_energy = 1e-11;
    agreement.positions_in_the_same_order = agreement.positions;
    return agreement;
}

Agreement single_agreement(const Situation& situation) {
    const auto limits = limits_in(situation, {{1, 1e-6}, {10, 2e-5}, {100, 2e-4}, {200, 5e-4}});
    return {.energy = 1e-6,
            .largest_force = 5e-4,
            .rms_force = 5e-5,
            .pressure = 5e-5,
            .kinetic_energy = 5e-6,
            .positions = limits,
            .positions_in_the_same_order = limits};
}

std::optional<double> limit_at(const std::vector<Agreement::Limit>& limits, Index step) {
    for (const Agreement::Limit& limit : limits) {
        if (step <= limit.step) {
            return limit.distance;
        }
    }
    return std::nullopt;
}

}  // namespace ljmd
