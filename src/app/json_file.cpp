#include "ljmd/app/json_file.hpp"

#include <limits>

namespace ljmd {

Index integer_of(const nlohmann::ordered_json& value, std::string_view name, Index least, Index most) {
    const bool fits = value.is_number_integer() &&
                      (!value.is_number_unsigned() ||
                       value.get<std::uint64_t>() <= static_cast<std::uint64_t>(std::numeric_limits<Index>::max()));
    if (!fits || value.get<Index>() < least || value.get<Index>() > most) {
        constexpr std::size_t longest = 40;
        throw WrongJson(
            fmt::format("'{}' is {}, allowed: an integer from {} to {}", name,
                        value.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace).substr(0, longest),
                        least, most));
    }
    return value.get<Index>();
}

std::string complaint_of(const nlohmann::json::exception& error) {
    const std::string_view text = error.what();
    const std::size_t end = text.find("] ");  // "[json.exception.parse_error.101] parse error at line 1, ..."
    return std::string(end == std::string_view::npos ? text : text.substr(end + 2));
}

}  // namespace ljmd
