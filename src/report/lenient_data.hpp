#pragma once

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

#include "ljmd/detail/core/data.hpp"

namespace ljmd {

// Values of a record that may lack them: written by an older version, or damaged. Nothing is thrown for what is missing
// or of another kind.

using DataPath = std::initializer_list<std::string_view>;

/// The value below these keys; nullptr if there is none.
[[nodiscard]] const Data* value_in(const Data& data, DataPath path);

/// A number there; nothing for null.
[[nodiscard]] std::optional<double> number_in(const Data& data, DataPath path);

/// A text there, or a number or flag in words; empty if there is none.
[[nodiscard]] std::string text_in(const Data& data, DataPath path);

/// A flag there; nothing if there is none.
[[nodiscard]] std::optional<bool> flag_in(const Data& data, DataPath path);

/// A JSON file as it is. @throws DataError  it is missing or not JSON
[[nodiscard]] Data read_any_json(const std::filesystem::path& path);

}  // namespace ljmd
