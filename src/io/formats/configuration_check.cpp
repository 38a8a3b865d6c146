#include "io/formats/configuration_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "ljmd/model/box.hpp"

namespace ljmd {
namespace {

constexpr double farthest = 1e6;        // distance of an atom from the box, in edges
constexpr double largest_aspect = 1e6;  // longest edge / shortest edge
constexpr double no_tilt = 1e-12;       // in units of the shortest edge

/// The fault of the box; empty when there is none.
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

/// Why an atom is lost, to follow its name; empty when it is not.
std::string loss_of_atom(const Configuration& configuration, std::size_t k) {
    if (!configuration.positions[k].allFinite()) {
        return "has a position that is not finite in reduced units";
    }
    if ((configuration.positions[k].array().abs() > farthest * configuration.edges.array()).any()) {
        return fmt::format("is more than {} edges away from the box", farthest);
    }
    if (!configuration.velocities.empty() && !configuration.velocities[k].allFinite()) {
        return "has a velocity that is not finite in reduced units";
    }
    return "";
}

/// The fault of an atom that is not lost, in the same way.
std::string fault_of_atom(const Configuration& configuration, std::size_t k) {
    const double mass = configuration.masses.empty() ? 1.0 : configuration.masses[k];
    if (!std::isfinite(mass) || mass <= 0.0) {
        return fmt::format("has the mass {}; masses must be positive and finite", mass);
    }
    return "";
}

/// The place of an atom in the box, on the grid of the box.
std::array<double, 3> place_in(const Box& box, const Vec3& position) {
    Vec3 place = box.snap(position - box.crossings(position).cwiseProduct(box.edges()));
    for (int axis = 0; axis < 3; ++axis) {
        // Rounding may give the far wall, which is the image of the near one.
        if (place[axis] == box.edges()[axis]) place[axis] = 0.0;
    }
    return {place[0], place[1], place[2]};
}

}  // namespace

std::optional<ConfigurationFault> find_fault(const Configuration& configuration) {
    if (const std::string fault = fault_of_box(configuration.edges); !fault.empty()) {
        return ConfigurationFault{std::nullopt, fault};
    }
    if (configuration.time && !std::isfinite(*configuration.time)) {
        return ConfigurationFault{std::nullopt, "the time is not finite in reduced units"};
    }
    for (std::size_t k = 0; k < configuration.positions.size(); ++k) {
        if (const std::string loss = loss_of_atom(configuration, k); !loss.empty()) {
            return ConfigurationFault{static_cast<Index>(k), loss, true};
        }
        if (const std::string fault = fault_of_atom(configuration, k); !fault.empty()) {
            return ConfigurationFault{static_cast<Index>(k), fault};
        }
    }
    return std::nullopt;
}

std::optional<std::pair<Index, Index>> find_coincident_atoms(const Configuration& configuration) {
    const Box box(configuration.edges);
    std::vector<std::array<double, 3>> places;
    places.reserve(configuration.positions.size());
    for (const Vec3& position : configuration.positions) {
        places.push_back(place_in(box, position));
    }
    std::vector<std::size_t> sorted(places.size());
    std::iota(sorted.begin(), sorted.end(), std::size_t{0});
    std::sort(sorted.begin(), sorted.end(),
              [&](std::size_t a, std::size_t b) { return places[a] != places[b] ? places[a] < places[b] : a < b; });
    const auto same = std::adjacent_find(sorted.begin(), sorted.end(),
                                         [&](std::size_t a, std::size_t b) { return places[a] == places[b]; });
    if (same == sorted.end()) {
        return std::nullopt;
    }
    return std::pair(static_cast<Index>(*same), static_cast<Index>(*std::next(same)));
}

bool is_orthogonal(const Mat3& vectors) {
    Mat3 tilts = vectors;
    tilts.diagonal().setZero();
    return tilts.cwiseAbs().maxCoeff() <= no_tilt * vectors.diagonal().cwiseAbs().minCoeff();
}

}  // namespace ljmd
