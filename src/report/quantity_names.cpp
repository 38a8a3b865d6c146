#include "report/quantity_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

#include "observables/statistics/known_quantities.hpp"

namespace ljmd {

PageColumn described(const std::string& column) {
    static constexpr std::string_view error = "_standard_error";
    if (column.ends_with(error)) {
        PageColumn of = described(column.substr(0, column.size() - error.size()));
        return {column, fmt::format("error of {}", of.label), of.unit};
    }
    const KnownQuantity* found = find_quantity(column);
    return found == nullptr ? PageColumn{column, in_plain_words(column)}
                            : PageColumn{column, std::string(found->symbol), std::string(found->unit)};
}

std::string axis_label(const std::string& column) {
    const PageColumn of = described(column);
    const bool compound = of.unit.find_first_of(" /") != std::string::npos;
    return of.unit.empty() ? of.label
           : compound      ? fmt::format("{} / ({})", of.label, of.unit)
                           : fmt::format("{} / {}", of.label, of.unit);
}

std::string in_plain_words(std::string name) {
    std::ranges::replace(name, '_', ' ');
    return name;
}

std::string as_title(const std::string& name) {
    std::string words = in_plain_words(name);
    if (!words.empty()) {
        words.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(words.front())));
    }
    return words;
}

}  // namespace ljmd
