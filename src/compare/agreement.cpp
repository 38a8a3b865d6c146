#include "ljmd/compare/agreement.hpp"

#include <algorithm>
#include <cmath>

namespace ljmd {

namespace {

constexpr double hot = 1.0;  // [epsilon/k_B]

constexpr double time_step_of_limits = 0.004;  // [tau]
constexpr double growth = 3.75;                // of distances in a dense liquid [1/tau]

}  // namespace

Agreement double_agreement(double temperature) {
    Agreement agreement{.energy = 1e-13,
                        .largest_force = 1e-12,
                        .rms_force = 1e-13,
                        .pressure = 1e-12,
                        .kinetic_energy = 1e-12,
                        .positions = {{1, 1e-14}, {10, 5e-13}, {100, 1e-11}, {200, 5e-11}, {500, 5e-9}, {1000, 1e-5}},
                        .positions_in_the_same_order = {{1, 5e-15}, {100, 2e-13}, {500, 1e-10}}};
    if (temperature > hot) {
        agreement.positions = {{1, 1e-14}, {10, 5e-13}, {100, 1e-11}, {200, 1e-9}};
        agreement.positions_in_the_same_order = {{1, 5e-15}, {100, 2e-13}};
    }
    return agreement;
}

Agreement lammps_agreement() {
    return {.energy = 1e-12,
            .largest_force = 1e-12,
            .rms_force = 1e-12,
            .pressure = 1e-12,
            .kinetic_energy = 1e-11,
            .positions = {{100, 1e-9}},
            .positions_in_the_same_order = {{100, 1e-9}}};
}

Agreement single_agreement() {
    return {.energy = 1e-6,
            .largest_force = 5e-4,
            .rms_force = 5e-5,
            .pressure = 5e-5,
            .kinetic_energy = 5e-6,
            .positions = {{1, 1e-6}, {10, 2e-5}, {100, 2e-4}, {200, 5e-4}},
            .positions_in_the_same_order = {{1, 1e-6}, {10, 2e-5}, {100, 2e-4}, {200, 5e-4}}};
}

std::optional<double> limit_at(const std::vector<Agreement::Limit>& limits, Index step, double time_step) {
    const double later = static_cast<double>(step) * std::max(0.0, time_step - time_step_of_limits);
    for (const Agreement::Limit& limit : limits) {
        if (step <= limit.step) {
            return limit.distance * std::exp(growth * later);
        }
    }
    return std::nullopt;
}

}  // namespace ljmd
