#include "ljmd/compare/agreement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ljmd/model/box.hpp"
#include "ljmd/model/velocities.hpp"

namespace ljmd {

namespace {

using Limits = std::vector<Agreement::Limit>;

// The situation that limits are written down for.
constexpr double usual_time_step = 0.004;  // [tau]
constexpr double usual_edge = 16.0;        // coordinates below have one unit in the last place [sigma]
constexpr double usual_atoms = 864.0;

constexpr double hot = 1.0;           // [epsilon/k_B]
constexpr double cold_growth = 3.75;  // [1/tau]
constexpr double hot_growth = 7.5;

/// From this step on the furthest atom is one of few whose neighbourhood is less stable than the others'.
constexpr Index late = 500;

/// How much coarser their coordinates are than those in a box of the usual edge.
double coarser_coordinates(const Situation& situation) {
    return std::max(1.0, situation.longest_edge / usual_edge);
}

/// The same in whole powers of two, as last places go.
double coarser_last_place(const Situation& situation) {
    return std::exp2(std::max(0.0, std::ceil(std::log2(situation.longest_edge / usual_edge))));
}

/// How much coarser our grid is than in a box below 10.6 sigma. There two numbers that agree but for their rounding,
/// ours to the grid, theirs to the last place, are half a unit of both apart in each direction: 4.6e-15.
double coarser_grid(const Situation& situation) {
    constexpr double usual_resolution = 0x1p-48;
    return std::max(1.0, Box(Vec3::Constant(situation.longest_edge)).resolution() / usual_resolution);
}

/// By how much differences grow in so many steps more than in as many of the usual length.
double later_growth(const Situation& situation, Index steps) {
    const double growth = situation.temperature > hot ? hot_growth : cold_growth;
    return std::exp(growth * std::max(0.0, static_cast<double>(steps) * (situation.time_step - usual_time_step)));
}

/// Limits as they are in another situation: never below those written down.
/// @param coarser  by how much roundings are larger
Limits limits_in(const Situation& situation, double coarser, Limits limits) {
    for (Agreement::Limit& limit : limits) {
        limit.distance *= later_growth(situation, limit.step);
        limit.distance *= coarser;
        if (limit.step >= late) {
            limit.distance *= std::max(1.0, static_cast<double>(situation.atoms) / usual_atoms);
        }
    }
    return limits;
}

/// A limit of the relative difference of kinetic energies, which comes about in two ways.
///
/// Atoms whose places differ have taken up another potential energy: sum of F dr. That grows as distances do, and is
/// the larger the fewer atoms there are for it to cancel over. And a program that takes velocities from places, as
/// OpenMM's leapfrog does, v = (r' - r)/dt, has the rounding u of a coordinate in them, so that
///
///     |dK|/K <= (2 K)^(1/2) (sum of m dv^2)^(1/2)/K <= 2 dv/T^(1/2),   dv = u/dt
///
/// which is as much at each step, and the more the shorter the step. At T = 0 it says nothing: infinite.
/// @param written  the limit in the usual situation
double kinetic_energy_limit(const Situation& situation, double written) {
    constexpr double usual_last_place = 0x1p-49;  // of coordinates from 8 to 16 sigma
    if (!(situation.temperature > 0.0)) {
        return std::numeric_limits<double>::infinity();
    }
    const double fewer = std::sqrt(usual_atoms / std::min(usual_atoms, static_cast<double>(situation.atoms)));
    const double from_places =
        written * coarser_coordinates(situation) * later_growth(situation, last_step_of_kinetic_energy) * fewer;
    const double last_place = usual_last_place * coarser_last_place(situation);
    return std::max(from_places, 2.0 * last_place / (situation.time_step * std::sqrt(situation.temperature)));
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
    const double coarser = coarser_coordinates(situation);
    return {.energy = 1e-13 * coarser,
            .largest_force = 1e-12 * coarser,
            .rms_force = 1e-13 * coarser,
            .pressure = 1e-12 * coarser,
            .kinetic_energy = kinetic_energy_limit(situation, 1e-12),
            .positions = limits_in(
                situation, coarser,
                is_hot ? Limits{{1, 1e-14}, {10, 5e-13}, {100, 1e-11}, {200, 1e-9}}
                       : Limits{{1, 1e-14}, {10, 5e-13}, {100, 1e-11}, {200, 5e-11}, {500, 5e-9}, {1000, 1e-5}}),
            .positions_in_the_same_order =
                limits_in(situation, coarser_grid(situation),
                          is_hot ? Limits{{1, 5e-15}, {100, 1e-12}} : Limits{{1, 5e-15}, {100, 2e-13}, {500, 1e-10}})};
}

Agreement lammps_agreement(const Situation& situation) {
    Agreement agreement = double_agreement(situation);
    agreement.energy *= 10.0;
    agreement.rms_force *= 10.0;
    agreement.kinetic_energy = kinetic_energy_limit(situation, 1e-11);
    agreement.positions_in_the_same_order = agreement.positions;
    return agreement;
}

Agreement single_agreement(const Situation& situation) {
    const double coarser = coarser_coordinates(situation);
    const Limits limits = limits_in(situation, coarser, {{1, 1e-6}, {10, 2e-5}, {100, 2e-4}, {200, 5e-4}});
    return {.energy = 1e-6 * coarser,
            .largest_force = 5e-4 * coarser,
            .rms_force = 5e-5 * coarser,
            .pressure = 5e-5 * coarser,
            .kinetic_energy = kinetic_energy_limit(situation, 5e-6),
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
