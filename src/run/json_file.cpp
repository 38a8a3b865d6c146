#include "ljmd/run/json_file.hpp"

#include <array>
#include <fstream>
#include <limits>

#include "ljmd/io/files/input_file.hpp"

namespace ljmd {

namespace {

using Json = nlohmann::ordered_json;

/// Checks the limits of a JSON text while it is parsed.
class Bounds {
  public:
    /// @param depth  of the value, or of the object that a key belongs to; 0: the outermost one
    void see(int depth, Json::parse_event_t event) {
        using Event = Json::parse_event_t;
        if (event == Event::key) {
            if (++keys_.at(static_cast<std::size_t>(depth)) > most_json_keys) {
                throw WrongJson(fmt::format("an object has more than {} keys", most_json_keys));
            }
        } else if (event == Event::object_start || event == Event::array_start) {
            if (depth >= deepest_json) {
                throw WrongJson(fmt::format("it is nested deeper than {} levels", deepest_json));
            }
            keys_.at(static_cast<std::size_t>(depth) + 1) = 0;
        }
        const bool ends = event == Event::object_end || event == Event::array_end;
        if (!ends && ++values_ > most_json_values) {
            throw WrongJson(fmt::format("it has more than {} values", most_json_values));
        }
    }

  private:
    std::array<std::size_t, deepest_json + 1> keys_{};  ///< number of keys of the open object at each depth
    std::size_t values_ = 0;
};

}  // namespace

nlohmann::ordered_json parse_json(std::string_view text) {
    Bounds bounds;
    return Json::parse(text, [&](int depth, Json::parse_event_t event, const Json&) {
        bounds.see(depth, event);
        return true;
    });
}

Index integer_of(const nlohmann::ordered_json& value, std::string_view name, Index least, Index most) {
    const bool fits = value.is_number_integer() &&
                      (!value.is_number_unsigned() ||
                       value.get<std::uint64_t>() <= static_cast<std::uint64_t>(std::numeric_limits<Index>::max()));
    if (!fits || value.get<Index>() < least || value.get<Index>() > most) {
        constexpr std::size_t longest = 40;
        throw WrongJson(fmt::format("'{}' is {}, allowed: an integer from {} to {}", name,
                                    value.dump(-1, ' ', true, Json::error_handler_t::replace).substr(0, longest), least,
                                    most));
    }
    return value.get<Index>();
}

std::vector<std::string> texts_of(const nlohmann::ordered_json& value, std::string_view name, std::size_t most) {
    if (!value.is_array() || value.size() > most) {
        throw WrongJson(fmt::format("'{}' is no array, or has more than {} texts", name, most));
    }
    return value.get<std::vector<std::string>>();
}

std::string complaint_of(const nlohmann::json::exception& error) {
    const std::string_view text = error.what();
    const std::size_t end = text.find("] ");  // "[json.exception.parse_error.101] parse error at line 1, ..."
    return std::string(end == std::string_view::npos ? text : text.substr(end + 2));
}

std::string json_text(const std::filesystem::path& path) {
    constexpr std::size_t piece = std::size_t{1} << 16U;
    std::ifstream file = open_input(path);
    std::string text;
    while (file) {
        const std::size_t begin = text.size();
        text.resize(begin + piece);
        file.read(text.data() + begin, static_cast<std::streamsize>(piece));
        text.resize(begin + static_cast<std::size_t>(file.gcount()));
        if (text.size() > most_json_bytes) {
            throw WrongJson(fmt::format("it has more than {} MiB", most_json_bytes >> 20U));
        }
    }
    if (file.bad()) {
        throw WrongJson("it " + why_reading_failed());
    }
    return text;
}

}  // namespace ljmd
