#include "judge/net_force.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ljmd {

namespace {

/// A constant force explains all of a difference but this part.
constexpr double unexplained_of_net_force = 1e-3;

/// A sum of single-precision forces is zero up to this part of their root mean square times sqrt(N).
constexpr double rounding_of_sum = 1e-4;

/// A component of the constant force is zero up to this part of its length.
constexpr double vanishing_component = 1e-6;

std::string vector_in_words(Vec3 force) {
    const double least = vanishing_component * force.norm();
    for (double& component : force) {
        component = std::abs(component) > least ? component : 0.0;
    }
    for (int k = 0; k < 3; ++k) {
        if (std::abs(force[k]) == force.norm()) {
            return fmt::format("{:.6g} along {}", force[k], "xyz"[k]);
        }
    }
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", force[0], force[1], force[2]);
}

}  // namespace

std::optional<std::string> net_force(const std::vector<Vec3>& found, const std::vector<Vec3>& right, double noise) {
    const auto atoms = static_cast<double>(found.size());
    Vec3 sum = Vec3::Zero();   // of F'
    Vec3 mean = Vec3::Zero();  // of F' - F
    double squares = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        sum += found[i];
        mean += (found[i] - right[i]) / atoms;
        squares += right[i].squaredNorm();
    }
    double off = 0.0;
    double rest = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        off += (found[i] - right[i]).squaredNorm();
        rest += (found[i] - right[i] - mean).squaredNorm();
    }
    if (!(std::sqrt(off) > noise)) {
        return std::nullopt;
    }
    if (std::sqrt(rest) <= std::max(noise, unexplained_of_net_force * std::sqrt(off))) {
        return fmt::format(
            "constant force: the same force of {} is added on every atom, as by an external field; without it the "
            "forces are right",
            vector_in_words(mean));
    }
    if (sum.norm() > rounding_of_sum * std::sqrt(squares)) {
        return fmt::format(
            "net force: forces do not sum to zero, their sum is {}: an external field, or pairs that act on one of "
            "their two atoms only",
            vector_in_words(sum));
    }
    return std::nullopt;
}

}  // namespace ljmd
