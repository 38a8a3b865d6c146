#include "ljmd/io/tables/few_body_csv.hpp"

#include <fmt/format.h>

#include <array>
#include <iterator>
#include <string>

namespace ljmd {

namespace {

constexpr std::array<char, 3> axes{'x', 'y', 'z'};

void append(std::string& line, const Vec3& vector, int dimensions) {
    for (int a = 0; a < dimensions; ++a) {
        fmt::format_to(std::back_inserter(line), ",{}", vector[a]);
    }
}

}  // namespace

FewBodyThermoCsv::FewBodyThermoCsv(const OutputPlace& place, int dimensions, std::optional<std::int64_t> kept)
    : file_(place, kept), dimensions_(dimensions) {
    if (kept) {
        return;
    }
    std::string header = "step,time,potential_energy,kinetic_energy,total_energy";
    for (int a = 0; a < dimensions; ++a) {
        header += fmt::format(",momentum_{}", axes.at(static_cast<std::size_t>(a)));
    }
    header += dimensions == 2   ? ",angular_momentum_z"
              : dimensions == 3 ? ",angular_momentum_x,angular_momentum_y,angular_momentum_z"
                                : "";
    file_.write(header + '\n');
}

void FewBodyThermoCsv::write(Index step, double time, const FewBodyTotals& totals) {
    std::string line =
        fmt::format("{},{},{},{},{}", step, time, totals.potential_energy, totals.kinetic_energy, totals.total_energy);
    append(line, totals.momentum, dimensions_);
    if (dimensions_ == 2) {
        line += fmt::format(",{}", totals.angular_momentum[2]);
    } else if (dimensions_ == 3) {
        append(line, totals.angular_momentum, 3);
    }
    file_.write(line + '\n');
}

TrajectoryCsv::TrajectoryCsv(const OutputPlace& place, Index bodies, int dimensions, bool accelerations, bool angle,
                             std::optional<std::int64_t> kept)
    : file_(place, kept), dimensions_(dimensions), accelerations_(accelerations), angle_(angle) {
    if (kept) {
        return;
    }
    std::string header = "step,time";
    for (Index body = 1; body <= bodies; ++body) {
        for (const char* prefix : {"", "v", "a"}) {
            for (int a = 0; a < dimensions && (*prefix != 'a' || accelerations); ++a) {
                header += fmt::format(",{}{}{}", prefix, axes.at(static_cast<std::size_t>(a)), body);
            }
        }
    }
    file_.write(header + (angle ? ",angle\n" : "\n"));
}

void TrajectoryCsv::write(const State& state, std::optional<double> angle) {
    std::string line = fmt::format("{},{}", state.step, state.time);
    for (const Index i : state.index_of()) {
        append(line, state.positions().col(i), dimensions_);
        append(line, state.velocities().col(i), dimensions_);
        if (accelerations_) {
            append(line, state.forces().col(i) / state.masses()[static_cast<std::size_t>(i)], dimensions_);
        }
    }
    if (angle_) {
        line += fmt::format(",{}", angle.value());
    }
    file_.write(line + '\n');
}

}  // namespace ljmd
