#pragma once

#include <string>

#include "report/page_content.hpp"

namespace ljmd {

/// A column of a CSV of ljmd with its symbol and its reduced unit; of an unknown one the name alone.
[[nodiscard]] PageColumn described(const std::string& column);

/// "p / (epsilon/sigma^3)": the label of an axis for a column.
[[nodiscard]] std::string axis_label(const std::string& column);

/// "potential energy" for "potential_energy".
[[nodiscard]] std::string in_plain_words(std::string name);

/// "Potential energy" for "potential_energy".
[[nodiscard]] std::string as_title(const std::string& name);

}  // namespace ljmd
