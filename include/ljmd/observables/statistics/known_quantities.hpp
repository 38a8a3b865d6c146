#pragma once

#include <string>
#include <string_view>

#include "ljmd/observables/statistics/sampled_quantities.hpp"

namespace ljmd {

/// Symbol and reduced unit of a column of a table of ljmd, or of an observable in results.json; null for an unknown
/// one.
[[nodiscard]] const SampledQuantity* find_quantity(std::string_view name);

/// The symbol of an observable in results.json, "U/N"; empty for an unknown one.
[[nodiscard]] std::string symbol_of(std::string_view observable);

}  // namespace ljmd
