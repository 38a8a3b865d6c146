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

/// A JSON file is not what it should be. read_json() adds the path.
class WrongJson : public DataError {
  public:
    using DataError::DataError;
};

// More is taken for a mistake: what is read, copied or printed later then needs little stack, memory and time.
inline constexpr int deepest_json = 32;                                 ///< arrays and objects in each other
inline constexpr std::size_t most_json_values = 1'000'000;              ///< of all arrays and objects
inline constexpr std::size_t most_json_keys = 1000;                     ///< of an object, which is searched for each
inline constexpr std::size_t most_settings = 10'000;                    ///< --set, in records
inline constexpr std::size_t most_json_bytes = std::size_t{64} << 20U;  ///< of a file

/// The value that a JSON text holds. Objects keep their order.
/// @throws WrongJson  it is nested deeper than `deepest_json`, or has more than `most_json_values` values, or an object
///                    of more than `most_json_keys` keys
/// @throws nlohmann::json::exception  it is no JSON
[[nodiscard]] nlohmann::ordered_json parse_json(std::string_view text);

/// @param name  of the value, for messages
/// @throws WrongJson when it is no integer, or below `least` or above `most`
[[nodiscard]] Index integer_of(const nlohmann::ordered_json& value, std::string_view name, Index least, Index most);

/// The texts of an array, no more than `most`. @throws WrongJson
[[nodiscard]] std::vector<std::string> texts_of(const nlohmann::ordered_json& value, std::string_view name,
                                                std::size_t most);

/// What the library says of a mistake, without its own number for it.
[[nodiscard]] std::string complaint_of(const nlohmann::json::exception& error);

/// All that a JSON file holds.
/// @throws DataError  it is not a regular file, or cannot be read  @throws WrongJson  it has more than
/// `most_json_bytes`
[[nodiscard]] std::string json_text(const std::filesystem::path& path);

/// What `read` makes of a JSON file, whose objects keep their order.
/// @param what  it should be, for messages: "the record of a run"
/// @throws DataError naming the file, when it is not a regular file, too large, not JSON, beyond the bounds of
///                   parse_json(), or `read` misses something in it
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
