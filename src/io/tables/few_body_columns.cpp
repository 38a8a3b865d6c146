#include "io/tables/few_body_columns.hpp"

#include <fmt/format.h>

#include <array>

namespace ljmd {

namespace {

constexpr std::array<char, 3> axes{'x', 'y', 'z'};

void append(std::vector<double>& row, const Vec3& vector, int dimensions) {
    row.insert(row.end(), vector.data(), vector.data() + dimensions);
}

}  // namespace

std::vector<std::string> FewBodyThermoColumns::names() const {
    std::vector<std::string> names{"step", "time", "potential_energy", "kinetic_energy", "total_energy"};
    for (int a = 0; a < dimensions_; ++a) {
        names.push_back(fmt::format("momentum_{}", axes.at(static_cast<std::size_t>(a))));
    }
    if (dimensions_ == 2) {
        names.emplace_back("angular_momentum_z");
    } else if (dimensions_ == 3) {
        names.insert(names.end(), {"angular_momentum_x", "angular_momentum_y", "angular_momentum_z"});
    }
    return names;
}

std::vector<double> FewBodyThermoColumns::row(Index step, double time, const FewBodyTotals& totals) const {
    std::vector<double> row{static_cast<double>(step), time, totals.potential_energy, totals.kinetic_energy,
                            totals.total_energy};
    append(row, totals.momentum, dimensions_);
    if (dimensions_ == 2) {
        row.push_back(totals.angular_momentum[2]);
    } else if (dimensions_ == 3) {
        append(row, totals.angular_momentum, 3);
    }
    return row;
}

std::vector<std::string> TrajectoryColumns::names() const {
    std::vector<std::string> names{"step", "time"};
    for (Index body = 1; body <= bodies_; ++body) {
        for (const char* prefix : {"", "v", "a"}) {
            for (int a = 0; a < dimensions_ && (*prefix != 'a' || accelerations_); ++a) {
                names.push_back(fmt::format("{}{}{}", prefix, axes.at(static_cast<std::size_t>(a)), body));
            }
        }
    }
    if (angle_) {
        names.emplace_back("angle");
    }
    return names;
}

std::vector<double> TrajectoryColumns::row(const State& state, std::optional<double> angle) const {
    std::vector<double> row{static_cast<double>(state.step), state.time};
    for (const Index i : state.index_of()) {
        append(row, state.positions().col(i), dimensions_);
        append(row, state.velocities().col(i), dimensions_);
        if (accelerations_) {
            append(row, state.forces().col(i) / state.masses()[static_cast<std::size_t>(i)], dimensions_);
        }
    }
    if (angle_) {
        row.push_back(angle.value());
    }
    return row;
}

}  // namespace ljmd
