#include "observables/dynamics/wave_vectors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>

#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

constexpr double width = 0.05;  // of a shell, as a fraction of its wave number

/// Lengths that differ by rounding are equal.
double rounded(double length) {
    return std::round(length * 1e9);
}

bool is_of_pair(const std::array<Index, 3>& n) {
    const auto first = std::ranges::find_if(n, [](Index number) { return number != 0; });
    return first != n.end() && *first > 0;
}

/// The vectors with lengths between two numbers.
std::vector<WaveVector> vectors_between(const Box& box, double least, double largest) {
    const Vec3 unit = 2.0 * std::numbers::pi / box.edges().array();
    std::array<Index, 3> most{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        most[axis] = static_cast<Index>(largest / unit[static_cast<Index>(axis)]);
    }
    std::vector<WaveVector> found;
    for (Index x = 0; x <= most[0]; ++x) {
        for (Index y = -most[1]; y <= most[1]; ++y) {
            for (Index z = -most[2]; z <= most[2]; ++z) {
                const std::array<Index, 3> n{x, y, z};
                const Vec3 k(static_cast<double>(x) * unit[0], static_cast<double>(y) * unit[1],
                             static_cast<double>(z) * unit[2]);
                const double length = std::sqrt(k[0] * k[0] + k[1] * k[1] + k[2] * k[2]);
                if (is_of_pair(n) && length >= least && length <= largest) {
                    found.push_back({n, k, length});
                }
            }
        }
    }
    return found;
}

/// The axis along which a vector is longest.
std::size_t main_axis(const WaveVector& v) {
    std::size_t axis = 0;
    for (std::size_t other = 1; other < 3; ++other) {
        if (std::abs(v.k[static_cast<Index>(other)]) > std::abs(v.k[static_cast<Index>(axis)]) * (1.0 + 1e-9)) {
            axis = other;
        }
    }
    return axis;
}

}  // namespace

double smallest_wave_number(const Box& box) {
    return 2.0 * std::numbers::pi / box.edges().maxCoeff();
}

std::vector<WaveShell> wave_shells(const Box& box, double k_min, double k_max, Index shells, Index most) {
    if (!(k_min > 0.0) || !(k_max >= k_min) || shells < 1 || most < 1) {
        throw ContractViolation(
            fmt::format("no {} shells of {} wave vectors from k = {} to {}", shells, most, k_min, k_max));
    }
    // Neighbours of a wave number lie within the smallest ones along the edges.
    const double reach = 2.0 * std::numbers::pi / box.edges().minCoeff();
    std::vector<WaveShell> all;
    std::set<double> taken;  // lengths, rounded
    for (Index shell = 0; shell < shells; ++shell) {
        const double wanted =
            shells == 1 ? k_min
                        : k_min + (k_max - k_min) * static_cast<double>(shell) / static_cast<double>(shells - 1);
        std::vector<WaveVector> near = vectors_between(box, wanted - reach, wanted + reach);
        const auto distance = [&](const WaveVector& v) { return rounded(std::abs(v.length - wanted)); };
        std::array<Index, 3> turn{};
        std::vector<std::tuple<double, Index, std::size_t, std::size_t>> order;
        std::ranges::sort(near, {}, [&](const WaveVector& v) {
            return std::tuple(distance(v), -v.numbers[0], -v.numbers[1], -v.numbers[2]);
        });
        double of = -1.0;
        for (std::size_t place = 0; place < near.size(); ++place) {
            if (distance(near[place]) != of) {
                of = distance(near[place]);
                turn = {};
            }
            const std::size_t axis = main_axis(near[place]);
            order.emplace_back(of, turn[axis]++, axis, place);
        }
        std::ranges::sort(order);
        WaveShell found{0.0, {}};
        for (const auto& [apart, round, axis, place] : order) {
            if (static_cast<Index>(found.vectors.size()) == most) {
                break;
            }
            const double length = near[place].length;
            const bool is_taken = taken.contains(rounded(length));
            if (found.vectors.empty() && is_taken) {
                break;  // it would be a shell once more
            }
            if (is_taken || (!found.vectors.empty() &&
                             std::abs(length - found.vectors.front().length) > width * found.vectors.front().length)) {
                continue;
            }
            found.vectors.push_back(near[place]);
            found.k += length;
        }
        if (!found.vectors.empty()) {
            for (const WaveVector& vector : found.vectors) {
                taken.insert(rounded(vector.length));
            }
            found.k /= static_cast<double>(found.vectors.size());
            all.push_back(std::move(found));
        }
    }
    return all;
}

}  // namespace ljmd
