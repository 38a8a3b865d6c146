#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "ljmd/core/errors.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

/// The content of a JSON file is wrong. read_json() adds the path.
class WrongJson : public DataError {
  public:
    using DataError::DataError;
};

// Limits, so that reading, copying and printing need little stack, memory and time. Larger values count as mistakes.
inline constexpr int deepest_json = 32;                                 ///< depth of nested arrays and objects
inline constexpr std::size_t most_json_values = 1'000'000;              ///< in all arrays and objects
inline constexpr std::size_t most_json_keys = 1000;                     ///< in an object; lookups are linear in it
inline constexpr std::size_t most_settings = 10'000;                    ///< --set arguments in a record
inline constexpr std::size_t most_json_bytes = std::size_t{64} << 20U;  ///< size of a file

/// Parse a JSON text. Objects keep their order.
/// @throws WrongJson  it is nested deeper than `deepest_json`, has more than `most_json_values` values, or has an
/// object with more than `most_json_keys` keys
/// @throws nlohmann::json::exception  it is not JSON
[[nodiscard]] nlohmann::ordered_json parse_json(std::string_view text);

/// @param name  of the value, for messages
/// @throws WrongJson when it is not an integer from `least` to `most`
[[nodiscard]] Index integer_of(const nlohmann::ordered_json& value, std::string_view name, Index least, Index most);

/// The texts of an array, at most `most`. @throws WrongJson
[[nodiscard]] std::vector<std::string> texts_of(const nlohmann::ordered_json& value, std::string_view name,
                                                std::size_t most);

/// The message of a library error, without its error number.
[[nodiscard]] std::string complaint_of(const nlohmann::json::exception& error);

/// The text of a JSON file.
/// @throws DataError  it is not a regular file, or cannot be opened  @throws WrongJson  it cannot be read, or has more
/// than `most_json_bytes`
[[nodiscard]] std::string json_text(const std::filesystem::path& path);

/// Parse a JSON file, whose objects keep their order, and convert it with `read`.
/// @param what  description of the file for messages: "the record of a run"
/// @throws DataError with the path, when it is not a regular file, too large, not JSON, beyond the limits of
/// parse_json(), or when `read` misses something in it
template <class Read>
auto read_json(const std::filesystem::path& path, std::string_view what, const Read& read) {
    const auto complain = [&](const std::string& why) {
        return DataError(fmt::format("{} is not {}: {}", path.string(), what, why));
    };
    try {
        return read(parse_json(json_text(path)));
    } catch (const nlohmann::json::exception& error) {
        throw complain(complaint_of(error));
    } catch (const WrongJson& error) {
        throw complain(error.what());
    }
}

}  // namespace ljmd
