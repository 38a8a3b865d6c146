#include "io/tables/csv_text.hpp"

#include <algorithm>

#include "core/text.hpp"

namespace ljmd {

namespace {

/// Remove a quoted field from the front of a text. @return false when it is not closed
bool take_quoted(std::string_view& rest, std::string& field) {
    for (rest.remove_prefix(1); !rest.empty(); rest.remove_prefix(1)) {
        if (rest.front() == '"') {
            rest.remove_prefix(1);
            if (!rest.starts_with('"')) {
                return true;
            }
        }
        field += rest.front();
    }
    return false;
}

}  // namespace

std::optional<std::vector<std::string>> csv_fields(std::string_view line) {
    std::vector<std::string> fields;
    for (std::string_view rest = line;;) {
        rest = trimmed(rest);
        std::string& field = fields.emplace_back();
        std::size_t comma = 0;
        if (rest.starts_with('"')) {
            if (!take_quoted(rest, field)) {
                return std::nullopt;
            }
            rest = trimmed(rest);
            if (!rest.empty() && rest.front() != ',') {
                return std::nullopt;
            }
        } else {
            comma = std::min(rest.find(','), rest.size());
            field = trimmed(rest.substr(0, comma));
        }
        if (comma >= rest.size()) {
            return fields;
        }
        rest.remove_prefix(comma + 1);
    }
}

std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) {
        return text;
    }
    std::string quoted = "\"";
    for (const char c : text) {
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    }
    return quoted + '"';
}

}  // namespace ljmd
