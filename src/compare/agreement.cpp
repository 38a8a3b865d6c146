#include "compare/agreement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ljmd/model/box.hpp"
#include "model/velocities.hpp"

namespace ljmd {

namespace {

using Limits = std::vector<Agreement::Limit>;

// The situation for which limits are written down.
constexpr double default_time_step = 0.004;  // [tau]
constexpr double default_edge = 16.0;        // coordinates below it have one unit in the last place [sigma]
constexpr double default_atoms = 864.0;

constexpr double hot = 1.0;           // [epsilon/k_B]
constexpr double cold_growth = 3.75;  // [1/tau]
constexpr double hot_growth = 7.5;

/// From this step on, the atom with the largest distance is one of few in less stable surroundings.
constexpr Index late = 500;

/// Factor by which coordinates are less exact than in a box of the usual edge.
double coarser_coordinates(const Situation& situation) {
    return std::max(1.0, situation.longest_edge / default_edge);
}

/// The same as a power of two, for units in the last place.
double coarser_last_place(const Situation& situation) {
    return std::exp2(std::max(0.0, std::ceil(std::log2(situation.longest_edge / default_edge))));
}

/// Factor by which our grid is coarser than in a box below 10.6 sigma. There, two numbers that agree up to rounding,
/// ours to the grid and theirs to the last place, differ by half a unit of both in each direction: 4.6e-15.
double coarser_grid(const Situation& situation) {
    constexpr double default_resolution = 0x1p-48;
    return std::max(1.0, Box(Vec3::Constant(situation.longest_edge)).resolution() / default_resolution);
}

/// Extra growth of differences in this many steps, compared with steps of the usual length.
double later_growth(const Situation& situation, Index steps) {
    const double growth = situation.temperature > hot ? hot_growth : cold_growth;
    return std::exp(growth * std::max(0.0, static_cast<double>(steps) * (situation.time_step - default_time_step)));
}

/// Limits for another situation; never below those written down.
/// @param coarser  factor by which rounding errors are larger
Limits limits_in(const Situation& situation, double coarser, Limits limits) {
    for (Agreement::Limit& limit : limits) {
        limit.distance *= later_growth(situation, limit.step);
        limit.distance *= coarser;
        if (limit.step >= late) {
            limit.distance *= std::max(1.0, static_cast<double>(situation.atoms) / default_atoms);
        }
    }
    return limits;
}

/// Limit of the relative difference of kinetic energies, which has two causes.
///
/// If positions of atoms differ, so do potential energies: by the sum of F dr. This grows like the distances, and is
/// larger for fewer atoms, where it cancels less. Also, a program that computes velocities from positions, as OpenMM's
/// leapfrog does with v = (r' - r)/dt, has the rounding error u of a coordinate in them, so that
///
///     |dK|/K <= (2 K)^(1/2) (sum of m dv^2)^(1/2)/K <= 2 dv/T^(1/2),   dv = u/dt
///
/// which is the same at each step, and larger for shorter steps. At T = 0 there is no limit: infinite.
/// @param written  the limit in the usual situation
double kinetic_energy_limit(const Situation& situation, double written) {
    constexpr double default_last_place = 0x1p-49;  // of coordinates from 8 to 16 sigma
    if (!(situation.temperature > 0.0)) {
        return std::numeric_limits<double>::infinity();
    }
    const double fewer = std::sqrt(default_atoms / std::min(default_atoms, static_cast<double>(situation.atoms)));
    const double from_places =
        written * coarser_coordinates(situation) * later_growth(situation, last_step_of_kinetic_energy) * fewer;
    const double last_place = default_last_place * coarser_last_place(situation);
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
            .positions = limits_in(situation, coarser,
                                   is_hot ? Limits{{1, 1e-14}, {10, 5e-13}, {100, 1e-11}, {200, 1e-9}}
                                          : Limits{{1, 1e-14}, {10, 5e-13}, {100, 1e-11}, {200, 5e-11}, {500, 5e-9}}),
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
