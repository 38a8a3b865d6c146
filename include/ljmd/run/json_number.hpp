#pragma once

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace ljmd {

/// A number in JSON: null if it is unknown or not finite, for which JSON has no numbers.
[[nodiscard]] inline nlohmann::ordered_json number_or_null(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

}  // namespace ljmd
