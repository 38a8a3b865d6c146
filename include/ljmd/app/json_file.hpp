#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "ljmd/core/errors.hpp"
#include "ljmd/core/types.hpp"
#include "ljmd/io/input_file.hpp"

namespace ljmd {

/// A JSON file is not what it should be. read_json() adds the path.
class WrongJson : public DataError {
  public:
    using DataError::DataError;
};

/// @param name  of the value, for messages
/// @throws WrongJson when it is no integer, or below `least` or above `most`
[[nodiscard]] Index integer_of(const nlohmann::ordered_json& value, std::string_view name, Index least, Index most);

/// What the library says of a mistake, without its own number for it.
[[nodiscard]] std::string complaint_of(const nlohmann::json::exception& error);

/// What `read` makes of a JSON file, whose objects keep their order.
/// @param what  it should be, for messages: "the record of a run"
/// @throws DataError naming the file, when it is not a regular file, not JSON, or `read` misses something in it
template <class Read>
auto read_json(const std::filesystem::path& path, std::string_view what, const Read& read) {
    const std::string text = read_input(path);
    const auto complain = [&](const std::string& why) {
        return DataError(fmt::format("{} is not {}: {}", path.string(), what, why));
    };
    try {
        return read(nlohmann::ordered_json::parse(text));
    } catch (const nlohmann::json::exception& error) {
        throw complain(complaint_of(error));
    } catch (const WrongJson& error) {
        throw complain(error.what());
    }
}

}  // namespace ljmd
