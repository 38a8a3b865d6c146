#include "io/formats/one_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "io/files/text_file.hpp"

namespace ljmd {

namespace {

constexpr std::array<std::string_view, 13> columns{"species",  "element", "type",    "types",         "typelabel",
                                                   "mass",     "masses",  "numbers", "atomic_number", "atomic_numbers",
                                                   "diameter", "radius",  "radii"};
constexpr std::string_view atomic_number = "Z";  // in a dump `z` is a coordinate

constexpr std::array<std::string_view, 4> charges{"q", "charge", "charges", "initial_charges"};

std::optional<double> number(std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc{} && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

bool same(std::string_view a, std::string_view b) {
    constexpr double rounding = 1e-6;
    if (a == b) {
        return true;
    }
    const auto x = number(a);
    const auto y = number(b);
    return x && y && std::abs(*x - *y) <= rounding * std::abs(*y);
}

}  // namespace

bool OneKind::distinguishes_kinds(std::string_view column) {
    return column == atomic_number || std::ranges::find(columns, lower_case(column)) != columns.end();
}

bool OneKind::is_charge(std::string_view column) {
    return std::ranges::find(charges, lower_case(column)) != charges.end();
}

std::string OneKind::charge_remark(std::string_view column) {
    return fmt::format("the atoms have charges ({}), which are not taken: ljmd has the pair potential alone",
                       shown(column));
}

std::string OneKind::add(std::string_view column, std::string_view value) {
    const auto known = values_.find(column);
    if (known == values_.end()) {
        values_.emplace(column, value);
        return "";
    }
    if (same(value, known->second)) {
        return "";
    }
    return fmt::format("{} {} beside {}, but ljmd has one kind of atom", column, shown(value), shown(known->second));
}

}  // namespace ljmd
