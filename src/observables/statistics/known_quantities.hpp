#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "ljmd/detail/observables/statistics/known_quantity.hpp"
#include "ljmd/detail/observables/statistics/observable_average.hpp"

namespace ljmd {

/// Symbol and reduced unit of a column of a table of ljmd, or of an observable in results.json; null for an unknown
/// one.
[[nodiscard]] const KnownQuantity* find_quantity(std::string_view name);

/// The symbol of an observable in results.json, "U/N"; empty for an unknown one.
[[nodiscard]] std::string symbol_of(std::string_view observable);

/// An observable with its symbol and unit. @throws ContractViolation for an unknown one
[[nodiscard]] ObservableAverage average_of(std::string_view name, const std::optional<Estimate>& estimate = {},
                                           const std::string& remark = {});

}  // namespace ljmd
