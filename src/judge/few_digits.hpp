#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/core/types.hpp"

namespace ljmd {

/// A way in which numbers lose digits.
struct Rounding {
    std::string words;  ///< "6 decimals", "7 significant digits", "single precision"
    std::function<double(double)> round;
    std::function<double(double)>
        step;  ///< logarithm (base 10) of the distance of such numbers next to a number, not 0
};

/// The usual ways: 1 to 12 decimals, 3 to 13 significant digits, single precision.
[[nodiscard]] const std::vector<Rounding>& roundings();

/// The way with the longest steps by which these numbers would not change: how many digits they have. Nothing if they
/// have more, or if there are fewer than eight numbers besides 0, which may be round by chance.
[[nodiscard]] std::optional<std::string> digits_of(const std::vector<Vec3>& vectors);

}  // namespace ljmd
