#include "ljmd/io/extended_xyz_reader.hpp"

#include <fmt/format.h>

#include <string>

#include "ljmd/io/atom_rows.hpp"
#include "ljmd/io/extended_xyz_header.hpp"

namespace ljmd {
namespace {

/// One reduced unit in the units of the file.
struct FileUnits {
    double length = 1.0;
    double time = 1.0;
    double mass = 1.0;
};

struct Frame {
    ExtendedXyzHeader header;
    Index header_line = 0;
    FileUnits units;
    std::vector<Index> ids;
    std::vector<Vec3> positions;
    std::vector<Vec3> velocities;
    std::vector<double> masses;
    std::string species;
};

FileUnits units_of(const TextFile& file, const ExtendedXyzHeader& header, const std::optional<SubstanceUnits>& units) {
    if (!header.si) return {};
    if (!units) file.fail("the file is in SI units (units=si), which takes a substance: the deck needs [argon]");
    constexpr double angstrom_per_nanometre = 10.0;
    return {units->nanometre() * angstrom_per_nanometre, units->picosecond(), units->dalton()};
}

void reserve(Frame& frame, std::size_t size) {
    frame.positions.reserve(size);
    if (frame.header.columns.id) frame.ids.reserve(size);
    if (frame.header.columns.velocity) frame.velocities.reserve(size);
    if (frame.header.columns.mass) frame.masses.reserve(size);
}

void read_atom(const TextFile& file, const std::vector<std::string_view>& fields, Frame& frame) {
    const ExtendedXyzColumns& columns = frame.header.columns;
    if (fields.size() != columns.count) {
        file.fail(fmt::format("{} columns, but Properties has {}", fields.size(), columns.count));
    }
    if (columns.species) {
        const std::string_view species = fields[*columns.species];
        if (frame.species.empty()) frame.species = species;
        if (species != frame.species) {
            file.fail(fmt::format("species {} beside {}, but ljmd has one kind of atom", shown(species),
                                  shown(frame.species)));
        }
    }
    frame.positions.push_back(read_vector(file, fields, columns.position) / frame.units.length);
    if (columns.velocity) {
        const double unit = frame.units.length / frame.units.time;
        frame.velocities.push_back(read_vector(file, fields, *columns.velocity) / unit);
    }
    if (columns.id) frame.ids.push_back(file.integer(fields[*columns.id], "the id"));
    if (columns.mass) frame.masses.push_back(file.number(fields[*columns.mass], "the mass") / frame.units.mass);
}

/// Read one frame. The file stands at the line with its number of atoms, whose only field is given.
Frame read_frame(TextFile& file, std::string_view count_field, const std::optional<SubstanceUnits>& units) {
    const Index count = read_atom_count(file, count_field);
    file.next_line();  // the comment line; there is one, or the count would have been refused
    Frame frame;
    frame.header_line = file.line_number();
    frame.header = parse_extended_xyz_header(file);
    frame.units = units_of(file, frame.header, units);
    reserve(frame, expected_atoms(file, count));
    std::vector<std::string_view> fields;
    for (Index row = 0; row < count; ++row) {
        next_atom_line(file, row, count);
        split_fields(file.line(), fields);
        read_atom(file, fields, frame);
    }
    return frame;
}

Configuration to_configuration(const TextFile& file, const Frame& frame) {
    const auto count = static_cast<Index>(frame.positions.size());
    const Index first_line = frame.header_line + 1;
    const AtomOrder order =
        frame.ids.empty() ? file_order(count, first_line) : order_by_id(file, frame.ids, first_line);
    Configuration configuration;
    configuration.edges = frame.header.edges / frame.units.length;
    configuration.positions = arranged(frame.positions, order);
    configuration.velocities = arranged(frame.velocities, order);
    configuration.masses = arranged(frame.masses, order);
    configuration.time = frame.header.time / frame.units.time;
    configuration.step = frame.header.step;
    check_configuration(file, configuration, order, frame.header_line);
    return configuration;
}

}  // namespace

Configuration read_extended_xyz(TextFile& file, const std::optional<SubstanceUnits>& units) {
    std::optional<Frame> last;
    std::vector<std::string_view> fields;
    for (Index number = 1; file.next_line();) {
        split_fields(file.line(), fields);
        if (fields.empty()) continue;
        file.set_context(fmt::format("frame {}: ", number));
        if (fields.size() != 1) {
            file.fail(fmt::format("expected the number of atoms, found {}", shown(file.line())));
        }
        last = read_frame(file, fields[0], units);
        ++number;
    }
    if (!last) file.fail("the file has no frame");
    return to_configuration(file, *last);
}

}  // namespace ljmd
