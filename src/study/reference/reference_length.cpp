#include "study/reference/reference_length.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ljmd {

namespace {

constexpr double largest_growth = 8.0;
constexpr double margin = 1.1;
constexpr double multiple = 1000.0;  // lengths are rounded up to it

}  // namespace

std::vector<ReachedError> reached_errors(const std::vector<WantedError>& wanted,
                                         const std::vector<ReferenceValue>& values) {
    std::vector<ReachedError> errors;
    for (const ReferenceValue& value : values) {
        const auto found = std::ranges::find(wanted, value.name, &WantedError::observable);
        const double part = reference_property(value.name).default_error;
        if (value.withheld || (found == wanted.end() && part == 0.0)) {
            continue;
        }
        const double unknown = std::numeric_limits<double>::quiet_NaN();
        const double error = found != wanted.end() ? found->error : part * std::abs(value.mean.value_or(unknown));
        const Estimate estimate{value.mean.value_or(0.0), value.statistical_error, value.independent, 0,
                                value.converged && value.mean.has_value()};
        errors.push_back({{value.name, error}, value.statistical_error, is_reached(estimate, error)});
    }
    return errors;
}

std::optional<Index> next_length(const std::vector<ReachedError>& errors, Index steps, Index max_steps) {
    double growth = 0.0;
    for (const ReachedError& one : errors) {
        if (!one.reached) {
            const double ratio = one.error / one.wanted.error;
            growth = std::max(growth, std::isfinite(ratio) ? margin * ratio * ratio : 2.0);
        }
    }
    if (growth == 0.0 || steps >= max_steps) {
        return std::nullopt;
    }
    growth = std::clamp(growth, std::numbers::sqrt2, largest_growth);
    const double next = std::ceil(growth * static_cast<double>(steps) / multiple) * multiple;
    return std::min(static_cast<Index>(next), max_steps);
}

}  // namespace ljmd
