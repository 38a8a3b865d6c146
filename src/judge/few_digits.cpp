#include "judge/few_digits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ljmd {

namespace {

constexpr int most_decimals = 12;
constexpr int least_significant = 3;
constexpr int most_significant = 13;

double to_decimals(double x, int decimals) {
    const double scale = std::pow(10.0, decimals);
    return std::round(x * scale) / scale;
}

/// Decimals of a number, not 0, that has so many significant digits.
int decimals_of(double x, int significant) {
    return significant - 1 - static_cast<int>(std::floor(std::log10(std::abs(x))));
}

double to_significant(double x, int digits) {
    return x == 0.0 ? 0.0 : to_decimals(x, decimals_of(x, digits));
}

std::vector<Rounding> made_roundings() {
    std::vector<Rounding> all;
    for (int d = 1; d <= most_decimals; ++d) {
        all.push_back({fmt::format("{} decimal{}", d, d == 1 ? "" : "s"), [=](double x) { return to_decimals(x, d); },
                       [=](double) { return -static_cast<double>(d); }});
    }
    for (int d = least_significant; d <= most_significant; ++d) {
        all.push_back({fmt::format("{} significant digits", d), [=](double x) { return to_significant(x, d); },
                       [=](double x) { return -static_cast<double>(decimals_of(x, d)); }});
    }
    constexpr double bits = 24.0;
    all.push_back({"single precision", [](double x) { return static_cast<double>(static_cast<float>(x)); },
                   [](double x) { return std::log10(std::abs(x)) - bits * std::log10(2.0); }});
    return all;
}

}  // namespace

const std::vector<Rounding>& roundings() {
    static const std::vector<Rounding> all = made_roundings();
    return all;
}

std::optional<std::string> digits_of(const std::vector<Vec3>& vectors) {
    constexpr double rounding_of_double = 4e-16;
    constexpr std::size_t enough = 8;
    std::vector<double> numbers;
    for (const Vec3& vector : vectors) {
        std::ranges::copy_if(vector, std::back_inserter(numbers), [](double x) { return x != 0.0; });
    }
    if (numbers.size() < enough) {
        return std::nullopt;
    }
    std::optional<std::string> found;
    double longest = 0.0;
    for (const Rounding& way : roundings()) {
        double steps = 0.0;
        const bool is_fixed = std::ranges::all_of(numbers, [&](double x) {
            steps += way.step(x);
            return std::abs(way.round(x) - x) <= rounding_of_double * std::abs(x);
        });
        if (is_fixed && (!found || steps > longest)) {
            found = way.words;
            longest = steps;
        }
    }
    return found;
}

}  // namespace ljmd
