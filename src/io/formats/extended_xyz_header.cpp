#include "io/formats/extended_xyz_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ranges>
#include <span>
#include <string>
#include <vector>

#include "io/formats/configuration_check.hpp"

#include "io/formats/one_kind.hpp"

namespace ljmd {
namespace {

constexpr std::string_view blanks = " \t";

/// A key of the comment line and its value, without quotes.
struct Pair {
    std::string_view key;
    std::string_view value;
    bool in_file;  ///< else it was given beside the file
};
using Pairs = std::vector<Pair>;

/// The character that closes a value with this opening character; null if a blank ends it.
char closing(char opening) {
    switch (opening) {
        case '"':
        case '\'':
            return opening;
        case '{':
            return '}';
        case '[':
            return ']';
        default:
            return '\0';
    }
}

/// The position of the closing character in the text after an opening one. A backslash escapes the next character;
/// brackets may be nested.
std::size_t closed_at(std::string_view text, char opening) {
    const char end = closing(opening);
    int open = 1;
    for (std::size_t k = 0; k < text.size(); ++k) {
        if (text[k] == '\\') {
            ++k;
        } else if (text[k] == end && --open == 0) {
            return k;
        } else if (text[k] == opening) {
            ++open;
        }
    }
    return std::string_view::npos;
}

/// Remove the value from the front of `rest`: up to its closing character, or up to the next blank.
std::string_view take_value(const TextFile& file, std::string_view& rest, std::string_view key) {
    const char opening = rest.empty() ? ' ' : rest.front();
    const bool is_closed = closing(opening) != '\0';
    if (is_closed) rest.remove_prefix(1);
    std::size_t end = is_closed ? closed_at(rest, opening) : rest.find_first_of(blanks);
    if (is_closed && end == std::string_view::npos) {
        file.fail(fmt::format("no closing {} after {}=",
                              opening == '{'   ? "brace"
                              : opening == '[' ? "bracket"
                                               : "quote",
                              shown(key)));
    }
    end = std::min(end, rest.size());
    const std::string_view value = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return value;
}

/// Words that are not key=value, such as a title or "time = 0.5,", are skipped.
void split_pairs(const TextFile& file, std::string_view rest, bool in_file, Pairs& pairs) {
    while (true) {
        rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
        if (rest.empty()) return;
        const std::size_t end = std::min(rest.find_first_of(" \t="), rest.size());
        const std::string_view key = rest.substr(0, end);
        rest.remove_prefix(end);
        if (!rest.starts_with('=')) continue;
        rest.remove_prefix(1);
        if (key.empty() || (!rest.empty() && blanks.find(rest.front()) != std::string_view::npos)) continue;
        pairs.push_back({key, take_value(file, rest, key), in_file});
    }
}

/// The value of a key; nothing if it is missing. Foreign files may have keys that differ in case alone.
std::optional<std::string_view> find(const TextFile& file, const Pairs& pairs, const std::string& key) {
    const auto is_key = [&](const Pair& pair) { return lower_case(pair.key) == key; };
    const auto first = std::ranges::find_if(pairs, is_key);
    if (first == pairs.end()) return std::nullopt;
    for (auto next = std::next(first); next != pairs.end(); ++next) {
        const Pair& other = *next;
        if (!is_key(other)) continue;
        if (other.in_file != first->in_file) {
            file.fail(fmt::format("{}= is given in the comment line and beside the file (xyz_comment)", first->key));
        }
        if (other.value != first->value) {
            file.fail(fmt::format("key {} is given twice, {}={} and {}={}", shown(key), first->key, shown(first->value),
                                  other.key, shown(other.value)));
        }
    }
    return first->value;
}

/// The elements of a list: "1 0 0", "1, 0, 0" or "[1, 0], [0, 1".
std::vector<std::string_view> split_list(std::string_view value) {
    constexpr std::string_view separators = " \t,[]{}";
    std::vector<std::string_view> fields;
    while (true) {
        value.remove_prefix(std::min(value.find_first_not_of(separators), value.size()));
        if (value.empty()) return fields;
        const std::size_t end = std::min(value.find_first_of(separators), value.size());
        fields.push_back(value.substr(0, end));
        value.remove_prefix(end);
    }
}

Vec3 parse_lattice(const TextFile& file, const std::optional<std::string_view>& value) {
    if (!value) {
        file.fail(
            "no Lattice=\"ax 0 0 0 by 0 0 0 cz\" in the comment line: the periodic box is missing. It can be given "
            "beside the file: xyz_comment in [system], --xyz-comment of analyze");
    }
    const std::vector<std::string_view> fields = split_list(*value);
    if (fields.size() != 9) file.fail(fmt::format("Lattice needs 9 numbers, found {}", fields.size()));
    Mat3 lattice;
    for (std::size_t k = 0; k < 9; ++k)
        lattice(static_cast<int>(k / 3), static_cast<int>(k % 3)) = file.number(fields[k], "Lattice");
    const Vec3 edges = lattice.diagonal();
    if (edges.minCoeff() <= 0.0 || !is_orthogonal(lattice)) {
        file.fail(
            fmt::format("only orthorhombic boxes can be read, Lattice=\"ax 0 0 0 by 0 0 0 cz\" with positive ax, by, "
                        "cz; found {}",
                        shown(*value)));
    }
    return edges;
}

struct Property {
    std::string_view name;
    std::string lower_name;
    std::string_view type;
    Index columns;
};

/// Split "species:S:1:pos:R:3" into triples.
std::vector<Property> split_properties(const TextFile& file, std::string_view text) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(':', begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    if (parts.size() % 3 != 0) {
        file.fail(fmt::format("Properties must be a list of name:type:columns, found {}", shown(text)));
    }
    constexpr Index max_columns = TextFile::longest_line;
    std::vector<Property> properties;
    for (std::size_t k = 0; k < parts.size(); k += 3) {
        const Index columns = file.integer(parts[k + 2], fmt::format("the columns of property {}", shown(parts[k])));
        if (columns < 1 || columns > max_columns) {
            file.fail(fmt::format("property {} cannot have {} columns", shown(parts[k]), columns));
        }
        properties.push_back({parts[k], lower_case(parts[k]), parts[k + 1], columns});
    }
    return properties;
}

using Names = std::span<const std::string_view>;
constexpr std::array<std::string_view, 1> position_names{"pos"};
constexpr std::array<std::string_view, 4> velocity_names{"velo", "vel", "velocity", "velocities"};
constexpr std::array<std::string_view, 1> momentum_names{"momenta"};
constexpr std::array<std::string_view, 2> forces_names{"forces", "force"};
constexpr std::array<std::string_view, 1> species_names{"species"};
constexpr std::array<std::string_view, 1> id_names{"id"};
constexpr std::array<std::string_view, 2> mass_names{"mass", "masses"};

bool is_one_of(Names names, const Property& property) {
    return std::ranges::find(names, property.lower_name) != names.end();
}

/// Vectors that somebody may take for velocities, and that no name makes ones.
bool is_unused_vector(const Property& property) {
    const bool is_known = is_one_of(position_names, property) || is_one_of(velocity_names, property) ||
                          is_one_of(momentum_names, property) || is_one_of(forces_names, property);
    return property.columns == 3 && property.type != "S" && !is_known;
}

/// The column in which a property starts; nothing if there is none of these names, in any case. Type and number of
/// columns must match.
std::optional<std::size_t> column_of(const TextFile& file, const std::vector<Property>& properties, Names names,
                                     std::string_view type, Index columns) {
    std::optional<std::size_t> column;
    std::size_t next = 0;
    for (const Property& property : properties) {
        if (is_one_of(names, property)) {
            if (column) file.fail(fmt::format("Properties gives {} twice", shown(property.name)));
            if (property.type != type || property.columns != columns) {
                file.fail(fmt::format("property {} must be {}:{}, found {}:{}", shown(property.name), type, columns,
                                      shown(property.type), property.columns));
            }
            column = next;
        }
        next += static_cast<std::size_t>(property.columns);
    }
    return column;
}

ExtendedXyzColumns parse_columns(const TextFile& file, std::string_view text) {
    const std::vector<Property> properties = split_properties(file, text);
    ExtendedXyzColumns columns;
    const std::optional<std::size_t> position = column_of(file, properties, position_names, "R", 3);
    if (!position) file.fail("Properties has no pos:R:3");
    columns.position = *position;
    static_cast<void>(column_of(file, properties, species_names, "S", 1));
    columns.velocity = column_of(file, properties, velocity_names, "R", 3);
    columns.momentum = column_of(file, properties, momentum_names, "R", 3);
    columns.force = column_of(file, properties, forces_names, "R", 3);
    columns.id = column_of(file, properties, id_names, "I", 1);
    columns.mass = column_of(file, properties, mass_names, "R", 1);
    for (const Property& property : properties) {
        if (property.columns == 1 && OneKind::distinguishes_kinds(property.name)) {
            columns.kinds.emplace(property.lower_name == "species" ? property.lower_name : property.name,
                                  columns.count);
        }
        if (property.columns == 1 && OneKind::is_charge(property.name)) {
            columns.charges.emplace(property.name, columns.count);
        }
        if (is_unused_vector(property)) {
            columns.unused.emplace_back(property.name);
        }
        columns.count += static_cast<std::size_t>(property.columns);
    }
    return columns;
}

void check_periodic(const TextFile& file, std::string_view value) {
    const std::vector<std::string_view> flags = split_list(value);
    const bool periodic = flags.size() == 3 && std::ranges::all_of(flags, [](std::string_view flag) {
                              const std::string lower = lower_case(flag);
                              return lower == "t" || lower == "true" || lower == "1";
                          });
    if (!periodic) file.fail(fmt::format("the box must be periodic, pbc=\"T T T\", found {}", shown(value)));
}

bool parse_units(const TextFile& file, std::string_view value) {
    if (value != "reduced" && value != "si") {
        file.fail(fmt::format("units must be 'reduced' or 'si', found {}", shown(value)));
    }
    return value == "si";
}

}  // namespace

ExtendedXyzHeader parse_extended_xyz_header(const TextFile& file, std::string_view comment) {
    Pairs pairs;
    split_pairs(file, file.line(), true, pairs);
    split_pairs(file, comment, false, pairs);
    const auto value_of = [&](const std::string& key) { return find(file, pairs, key); };
    ExtendedXyzHeader header;
    header.edges = parse_lattice(file, value_of("lattice"));
    header.columns = parse_columns(file, value_of("properties").value_or("species:S:1:pos:R:3"));
    check_periodic(file, value_of("pbc").value_or("T T T"));
    header.tells_unwrapped = value_of("positions") == "unwrapped";
    if (const auto units = value_of("units")) header.si = parse_units(file, *units);
    if (const auto time = value_of("time")) header.time = file.number(*time, "Time");
    if (const auto step = value_of("step")) header.step = file.integer(*step, "step");
    if (header.step && *header.step < 0) file.fail(fmt::format("step must not be negative, found {}", *header.step));
    return header;
}

}  // namespace ljmd
