#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/core/types.hpp"
#include "ljmd/detail/core/data.hpp"

namespace ljmd {

inline constexpr std::size_t max_json_bytes = std::size_t{64} << 20U;  ///< size of a file

/// @param name  of the value, for messages
/// @throws WrongData when it is not an integer from `least` to `most`
[[nodiscard]] Index integer_of(const Data& value, std::string_view name, Index least, Index most);

/// The texts of a list, at most `most`. @throws WrongData
[[nodiscard]] std::vector<std::string> texts_of(const Data& value, std::string_view name, std::size_t most);

/// The text of a JSON file.
/// @throws DataError  it is not a regular file, or cannot be opened  @throws WrongData  it cannot be read, or has more
/// than `max_json_bytes`
[[nodiscard]] std::string json_text(const std::filesystem::path& path);

/// Parse a JSON file, whose objects keep their order, and convert it with `read`.
/// @param what  description of the file for messages: "the record of a run"
/// @throws DataError with the path, when it is not a regular file, too large, not JSON, beyond the limits of
/// parse_json(), or when `read` misses something in it
template <class Read>
auto read_json(const std::filesystem::path& path, std::string_view what, const Read& read) {
    try {
        return read(parse_json(json_text(path)));
    } catch (const WrongData& error) {
        throw DataError(fmt::format("{} is not {}: {}", path.string(), what, error.what()));
    }
}

}  // namespace ljmd
