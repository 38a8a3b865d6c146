#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace ljmd {

/// A number as JSON has it: null for what is not finite or not known, which JSON has no number for.
[[nodiscard]] inline nlohmann::ordered_json number_or_null(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

}  // namespace ljmd
