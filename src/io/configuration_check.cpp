#include "ljmd/io/configuration_check.hpp"

#include <fmt/format.h>

#include <cmath>

namespace ljmd {
namespace {

constexpr double farthest = 1e6;        // edges between an atom and the box
constexpr double largest_aspect = 1e6;  // longest edge over shortest

/// What is wrong with the box; empty when nothing is.
std::string fault_of_box(const Vec3& edges) {
    for (int axis = 0; axis < 3; ++axis) {
        const double edge = edges[axis];
        if (!std::isfinite(edge) || edge <= 0.0) {
            return fmt::format("the edges of the box must be positive and finite, found {}", edge);
        }
    }
    if (edges.maxCoeff() > largest_aspect * edges.minCoeff()) {
        return fmt::format("the edges of the box, {}, {} and {}, differ by more than a factor of {}", edges[0],
                           edges[1], edges[2], largest_aspect);
    }
    return std::isnormal(edges.prod()) ? "" : "the volume of the box is outside the range of numbers";
}

/// What is wrong with an atom, to stand behind its name; empty when nothing is.
std::string fault_of_atom(const Configuration& configuration, std::size_t k) {
    if (!configuration.positions[k].allFinite()) {
        return "has a position that is not finite in reduced units";
    }
    if ((configuration.positions[k].array().abs() > farthest * configuration.edges.array()).any()) {
        return fmt::format("is more than {} edges away from the box", farthest);
    }
    if (!configuration.velocities.empty() && !configuration.velocities[k].allFinite()) {
        return "has a velocity that is not finite in reduced units";
    }
    const double mass = configuration.masses.empty() ? 1.0 : configuration.masses[k];
    if (!std::isfinite(mass) || mass <= 0.0) {
        return fmt::format("has the mass {}; masses must be positive and finite", mass);
    }
    return "";
}

}  // namespace

std::optional<ConfigurationFault> find_fault(const Configuration& configuration) {
    if (const std::string fault = fault_of_box(configuration.edges); !fault.empty()) {
        return ConfigurationFault{std::nullopt, fault};
    }
    if (!std::isfinite(configuration.time)) {
        return ConfigurationFault{std::nullopt, "the time is not finite in reduced units"};
    }
    for (std::size_t k = 0; k < configuration.positions.size(); ++k) {
        if (const std::string fault = fault_of_atom(configuration, k); !fault.empty()) {
            return ConfigurationFault{static_cast<Index>(k), fault};
        }
    }
    return std::nullopt;
}

}  // namespace ljmd
