#include "ljmd/io/extended_xyz_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "ljmd/io/one_kind.hpp"

namespace ljmd {
namespace {

constexpr std::string_view blanks = " \t";

using Pairs = std::map<std::string, std::string_view>;  // key in lower case -> value without quotes

std::string lower_case(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return lower;
}

/// Where the text has its first quote that no backslash makes part of the text.
std::size_t closing_quote(std::string_view text) {
    std::size_t k = 0;
    while (k < text.size() && text[k] != '"') k += text[k] == '\\' ? 2U : 1U;
    return k < text.size() ? k : std::string_view::npos;
}

/// Cut the value off the front of `rest`: up to the closing quote, or up to the next blank.
std::string_view take_value(const TextFile& file, std::string_view& rest, const std::string& key) {
    const bool in_quotes = rest.starts_with('"');
    if (in_quotes) rest.remove_prefix(1);
    std::size_t end = in_quotes ? closing_quote(rest) : rest.find_first_of(blanks);
    if (in_quotes && end == std::string_view::npos) file.fail(fmt::format("no closing quote after {}=", shown(key)));
    end = std::min(end, rest.size());
    const std::string_view value = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return value;
}

Pairs split_pairs(const TextFile& file) {
    Pairs pairs;
    std::string_view rest = file.line();
    while (true) {
        rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
        if (rest.empty()) return pairs;
        const std::size_t end = std::min(rest.find_first_of(" \t="), rest.size());
        const std::string key = lower_case(rest.substr(0, end));
        rest.remove_prefix(end);
        if (!rest.starts_with('=')) continue;  // a word that is no pair
        rest.remove_prefix(1);
        const std::string_view value = take_value(file, rest, key);
        if (!pairs.emplace(key, value).second) file.fail(fmt::format("key {} is given twice", shown(key)));
    }
}

std::optional<std::string_view> find(const Pairs& pairs, const std::string& key) {
    const auto found = pairs.find(key);
    return found == pairs.end() ? std::nullopt : std::optional(found->second);
}

Vec3 parse_lattice(const TextFile& file, const std::optional<std::string_view>& value) {
    if (!value) file.fail("no Lattice=\"ax 0 0 0 by 0 0 0 cz\" in the comment line: the periodic box is missing");
    std::vector<std::string_view> fields;
    split_fields(*value, fields);
    if (fields.size() != 9) file.fail(fmt::format("Lattice needs 9 numbers, found {}", fields.size()));
    Mat3 lattice;
    for (std::size_t k = 0; k < 9; ++k)
        lattice(static_cast<int>(k / 3), static_cast<int>(k % 3)) = file.number(fields[k], "Lattice");
    const Vec3 edges = lattice.diagonal();
    if ((lattice - Mat3(edges.asDiagonal())).cwiseAbs().maxCoeff() > 0.0 || edges.minCoeff() <= 0.0) {
        file.fail(
            fmt::format("only orthorhombic boxes can be read, Lattice=\"ax 0 0 0 by 0 0 0 cz\" with positive ax, by, "
                        "cz; found {}",
                        shown(*value)));
    }
    return edges;
}

struct Property {
    std::string_view name;
    std::string_view type;
    Index columns;
};

/// "species:S:1:pos:R:3" in triples.
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
    constexpr Index most_columns = TextFile::longest_line;
    std::vector<Property> properties;
    for (std::size_t k = 0; k < parts.size(); k += 3) {
        const Index columns = file.integer(parts[k + 2], fmt::format("the columns of property {}", shown(parts[k])));
        if (columns < 1 || columns > most_columns) {
            file.fail(fmt::format("property {} cannot have {} columns", shown(parts[k]), columns));
        }
        properties.push_back({parts[k], parts[k + 1], columns});
    }
    return properties;
}

/// Where a property starts; empty when there is none of that name. It must have the given type and columns.
std::optional<std::size_t> column_of(const TextFile& file, const std::vector<Property>& properties,
                                     std::initializer_list<std::string_view> names, std::string_view type,
                                     Index columns) {
    std::optional<std::size_t> column;
    std::size_t next = 0;
    for (const Property& property : properties) {
        if (std::find(names.begin(), names.end(), property.name) != names.end()) {
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
    const std::optional<std::size_t> position = column_of(file, properties, {"pos"}, "R", 3);
    if (!position) file.fail("Properties has no pos:R:3");
    columns.position = *position;
    columns.species = column_of(file, properties, {"species"}, "S", 1);
    columns.velocity = column_of(file, properties, {"velo", "vel"}, "R", 3);
    columns.id = column_of(file, properties, {"id"}, "I", 1);
    columns.mass = column_of(file, properties, {"mass", "masses"}, "R", 1);
    for (const Property& property : properties) {
        if (property.columns == 1 && OneKind::is_told_by(property.name)) {
            columns.kinds.emplace(property.name, columns.count);
        }
        columns.count += static_cast<std::size_t>(property.columns);
    }
    return columns;
}

void check_periodic(const TextFile& file, std::string_view value) {
    std::vector<std::string_view> fields;
    split_fields(value, fields);
    const bool periodic = fields.size() == 3 && std::all_of(fields.begin(), fields.end(), [](std::string_view flag) {
                              return flag == "T" || flag == "True" || flag == "true";
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

ExtendedXyzHeader parse_extended_xyz_header(const TextFile& file) {
    const Pairs pairs = split_pairs(file);
    ExtendedXyzHeader header;
    header.edges = parse_lattice(file, find(pairs, "lattice"));
    header.columns = parse_columns(file, find(pairs, "properties").value_or("species:S:1:pos:R:3"));
    check_periodic(file, find(pairs, "pbc").value_or("T T T"));
    header.tells_unwrapped = find(pairs, "positions") == "unwrapped";
    if (const auto units = find(pairs, "units")) header.si = parse_units(file, *units);
    if (const auto time = find(pairs, "time")) header.time = file.number(*time, "Time");
    if (const auto step = find(pairs, "step")) header.step = file.integer(*step, "step");
    if (header.step && *header.step < 0) file.fail(fmt::format("step must not be negative, found {}", *header.step));
    return header;
}

}  // namespace ljmd
