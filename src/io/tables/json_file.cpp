#include "io/tables/json_file.hpp"

#include <fstream>

#include "io/files/input_file.hpp"

namespace ljmd {

Index integer_of(const Data& value, std::string_view name, Index least, Index most) {
    const auto* integer = std::get_if<std::int64_t>(&value.value());
    if (integer == nullptr || *integer < least || *integer > most) {
        constexpr std::size_t longest = 40;
        throw WrongData(fmt::format("'{}' is {}, allowed: an integer from {} to {}", name,
                                    to_json_line(value).substr(0, longest), least, most));
    }
    return *integer;
}

std::vector<std::string> texts_of(const Data& value, std::string_view name, std::size_t most) {
    if (!value.is_list() || value.size() > most) {
        throw WrongData(fmt::format("'{}' is no array, or has more than {} texts", name, most));
    }
    std::vector<std::string> texts;
    for (const Data& item : value.items()) {
        texts.push_back(item.text());
    }
    return texts;
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
        if (text.size() > max_json_bytes) {
            throw WrongData(fmt::format("it has more than {} MiB", max_json_bytes >> 20U));
        }
    }
    if (file.bad()) {
        throw WrongData("it " + why_reading_failed());
    }
    return text;
}

}  // namespace ljmd
