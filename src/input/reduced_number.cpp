#include "input/reduced_number.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "core/text.hpp"

namespace ljmd {

namespace {

constexpr const char* argon_in_words = "argon (sigma = 3.405 angstrom, epsilon/k_B = 119.8 K, m = 39.948 u)";

SubstanceUnits argon() {
    return {*parse_quantity("3.405 angstrom", Dimension::length), *parse_quantity("119.8 K", Dimension::energy),
            *parse_quantity("39.948 u", Dimension::mass)};
}

bool is_number(const std::string& text) {
    char* end = nullptr;
    std::strtod(text.c_str(), &end);
    return end != text.c_str() && *end == '\0';
}

}  // namespace

std::string not_reduced(const std::string& text, const std::string& unit, Dimension dimension) {
    if (is_number(text)) {
        return "";
    }
    const std::string start = fmt::format("{} is no number: give it in reduced units, {}", in_quotes(text), unit);
    const auto quantity = parse_quantity(text, dimension);
    return quantity ? fmt::format("{}, without a unit\n  for {} it is {:.6g}", start, argon_in_words,
                                  argon().reduced(*quantity, dimension))
                    : start;
}

}  // namespace ljmd
