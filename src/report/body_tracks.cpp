#include "report/body_tracks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "io/tables/data_table_csv.hpp"
#include "report/base64.hpp"
#include "report/run_charts.hpp"

namespace ljmd {

namespace {

constexpr std::array<const char*, 3> axes{"x", "y", "z"};

}  // namespace

TrackShape track_shape(const DataTable& trajectory) {
    TrackShape shape{0, 0};
    while (has_column(trajectory, fmt::format("x{}", shape.bodies + 1))) {
        ++shape.bodies;
    }
    while (shape.dimensions < axes.size() && has_column(trajectory, fmt::format("{}1", axes[shape.dimensions]))) {
        ++shape.dimensions;
    }
    return shape;
}

std::vector<double> energy_errors(const DataTable& thermo) {
    std::vector<double> energies = column(thermo, "total_energy");
    if (!energies.empty()) {
        const double first = energies.front();
        const double scale = first == 0.0 ? 1.0 : std::abs(first);
        for (double& energy : energies) {
            energy = (energy - first) / scale;
        }
    }
    return energies;
}

Data body_tracks(const DataTable& trajectory, const DataTable& thermo, const std::vector<double>& masses,
                 std::size_t most) {
    const auto [bodies, dimensions] = track_shape(trajectory);
    const DataTable shown = thinned(trajectory, most);
    if (bodies == 0 || shown.rows.empty()) {
        return nullptr;
    }
    std::vector<float> positions(shown.rows.size() * bodies * axes.size(), 0.0F);
    for (std::size_t body = 0; body < bodies; ++body) {
        for (std::size_t axis = 0; axis < dimensions; ++axis) {
            const std::vector<double> values = column(shown, fmt::format("{}{}", axes.at(axis), body + 1));
            for (std::size_t frame = 0; frame < values.size(); ++frame) {
                positions[(frame * bodies + body) * axes.size() + axis] = static_cast<float>(values[frame]);
            }
        }
    }
    const std::vector<double> steps = column(thermo, "step");
    const std::vector<double> errors = energy_errors(thermo);
    Data energy_error = Data::list();
    for (const double step : column(shown, "step")) {
        const auto after = std::ranges::upper_bound(steps, step);
        energy_error.push_back(
            after == steps.begin() ? Data(nullptr) : Data(errors[static_cast<std::size_t>(after - steps.begin() - 1)]));
    }
    Data named = Data::list();
    for (std::size_t body = 0; body < bodies; ++body) {
        named.push_back({{"name", fmt::format("body {}", body + 1)},
                         {"mass", body < masses.size() ? Data(masses[body]) : Data(nullptr)}});
    }
    const std::string words = shown.rows.size() == trajectory.rows.size()
                                  ? fmt::format("{} frames.", shown.rows.size())
                                  : fmt::format("{} of {} frames are shown, to keep the page small.", shown.rows.size(),
                                                trajectory.rows.size());
    return {{"bodies", named},
            {"dimensions", dimensions},
            {"times", column(shown, "time")},
            {"positions", base64(positions)},
            {"energy_error", energy_error},
            {"words", words}};
}

}  // namespace ljmd
