#pragma once

#include <string>

namespace ljmd {

/// A printed number, alone or before an error or a unit, without the minus sign of a zero: "0.000(12)" for
/// "-0.000(12)". Rounding leaves it, and it means nothing to a reader. Other texts stay as they are.
[[nodiscard]] inline std::string without_negative_zero(std::string text) {
    if (!text.starts_with("-0")) {
        return text;
    }
    const std::size_t end = text.find_first_not_of("0.", 1);
    const bool is_zero = end == std::string::npos || text[end] < '1' || text[end] > '9';
    return is_zero ? text.substr(1) : text;
}

/// The same of a number that is to be printed in full: 0 for -0.
[[nodiscard]] constexpr double without_negative_zero(double number) {
    return number == 0.0 ? 0.0 : number;
}

}  // namespace ljmd
