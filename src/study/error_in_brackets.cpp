#include "study/error_in_brackets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/number_text.hpp"

namespace ljmd {

std::string with_error_in_brackets(double mean, double standard_error) {
    if (!(standard_error > 0.0) || !std::isfinite(standard_error)) {
        return without_negative_zero(fmt::format("{:.4f}", mean));
    }
    constexpr int max_digits = 15;
    constexpr double three_digits = 99.5;  // values from here on would be rounded to 100
    int digits = std::clamp(1 - static_cast<int>(std::floor(std::log10(standard_error))), 0, max_digits);
    if (digits > 0 && standard_error * std::pow(10.0, digits) >= three_digits) {
        --digits;
    }
    const double in_last_digits = std::max(1.0, standard_error * std::pow(10.0, digits));  // no error rounds to 0
    return without_negative_zero(fmt::format("{:.{}f}({:.0f})", mean, digits, in_last_digits));
}

}  // namespace ljmd
