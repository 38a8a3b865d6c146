#include "io/formats/extended_xyz_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "io/formats/ase_units.hpp"
#include "io/formats/atom_rows.hpp"
#include "io/formats/extended_xyz_header.hpp"

namespace ljmd {
namespace {

/// One reduced unit in the units of the file.
struct FileUnits {
    double length = 1.0;
    double time = 1.0;
    double mass = 1.0;
    double ase_velocity = 1.0;
    double force = 1.0;
};

/// Options for reading a file.
struct Reading {
    const std::optional<SubstanceUnits>& units;
    std::string_view comment;
};

/// A frame in the order of its lines.
struct RawFrame {
    ExtendedXyzHeader header;
    Index header_line = 0;
    FileUnits units;
    std::vector<Index> ids;
    std::vector<Vec3> positions;
    std::vector<Vec3> velocities;
    std::vector<double> masses;
    std::vector<Vec3> forces;
    std::vector<std::string> remarks;
};

/// @param si  the units of the first frame; set by that frame
FileUnits units_of(const TextFile& file, const ExtendedXyzHeader& header, std::optional<bool>& si,
                   const std::optional<SubstanceUnits>& units) {
    const auto name = [](bool is_si) { return is_si ? "si" : "reduced"; };
    if (!si) si = header.si.value_or(false);
    if (header.si.value_or(*si) != *si) {
        file.fail(fmt::format("units={}, but the units of frame 1, which hold for all frames, are {}", name(*header.si),
                              name(*si)));
    }
    if (!*si) return {};
    if (!units)
        file.fail(
            "the file is in SI units (units=si), which takes a substance: a deck with [argon] is needed (analyze: "
            "--deck)");
    constexpr double angstrom_per_nanometre = 10.0;
    const double length = units->nanometre() * angstrom_per_nanometre;
    return {.length = length,
            .time = units->picosecond(),
            .mass = units->dalton(),
            .ase_velocity = length / units->picosecond() / ase_velocity,
            .force = units->si(Dimension::energy) / ase_energy / length};
}

void reserve(RawFrame& frame, std::size_t size) {
    frame.positions.reserve(size);
    if (frame.header.columns.id) frame.ids.reserve(size);
    if (frame.header.columns.velocity || frame.header.columns.momentum) frame.velocities.reserve(size);
    if (frame.header.columns.mass) frame.masses.reserve(size);
    if (frame.header.columns.force) frame.forces.reserve(size);
}

/// The mass [u] for ASE's momenta: the file's, else ASE's mass of the species.
double mass_of_momentum(const TextFile& file, const std::vector<std::string_view>& fields,
                        const ExtendedXyzColumns& columns) {
    if (columns.mass) return file.number(fields[*columns.mass], "the mass");
    const auto species = columns.kinds.find("species");
    const auto mass = species != columns.kinds.end() ? ase_mass(fields[species->second]) : std::nullopt;
    if (!mass) file.fail("momenta take a mass: a column masses:R:1, or a species that is an element or X");
    return *mass;
}

void remark(RawFrame& frame, const std::string& text) {
    if (std::ranges::find(frame.remarks, text) == frame.remarks.end()) frame.remarks.push_back(text);
}

void read_atom(const TextFile& file, const std::vector<std::string_view>& fields, RawFrame& frame, OneKind& kind) {
    const ExtendedXyzColumns& columns = frame.header.columns;
    if (fields.size() != columns.count) {
        file.fail(fmt::format("{} columns, but Properties has {}", fields.size(), columns.count));
    }
    for (const auto& [name, column] : columns.kinds) {
        if (const std::string fault = kind.add(name, fields[column]); !fault.empty()) file.fail(fault);
    }
    frame.positions.push_back(read_vector(file, fields, columns.position) / frame.units.length);
    if (columns.velocity) {
        const double unit = frame.units.length / frame.units.time;
        frame.velocities.push_back(read_vector(file, fields, *columns.velocity) / unit);
    } else if (columns.momentum) {
        const double unit = frame.units.ase_velocity * mass_of_momentum(file, fields, columns);
        frame.velocities.push_back(read_vector(file, fields, *columns.momentum) / unit);
    }
    if (columns.force) {
        frame.forces.push_back(read_optional_vector(fields, *columns.force) / frame.units.force);
    }
    for (const auto& [name, column] : columns.charges) {
        if (number_or_nan(fields[column]) != 0.0) remark(frame, OneKind::charge_remark(name));
    }
    if (columns.id) frame.ids.push_back(file.integer(fields[*columns.id], "the id"));
    if (columns.mass) frame.masses.push_back(file.number(fields[*columns.mass], "the mass") / frame.units.mass);
}

/// Read one frame. The file is at the line with the number of atoms, whose only field is given.
/// @param wanted  number of atoms; 0: any
RawFrame read_frame(TextFile& file, std::string_view count_field, Index wanted, const Reading& how,
                    ExtendedXyzPremises& premises) {
    const Index count = read_atom_count(file, count_field, wanted);
    file.next_line();  // the comment line; it exists, else the count would have been refused
    RawFrame frame;
    frame.header_line = file.line_number();
    frame.header = parse_extended_xyz_header(file, how.comment);
    frame.units = units_of(file, frame.header, premises.si, how.units);
    for (const std::string& name : frame.header.columns.unused) {
        remark(frame, fmt::format("the property {} of three numbers is not taken: positions are pos, velocities velo, "
                                  "vel, velocity or velocities",
                                  shown(name)));
    }
    reserve(frame, expected_atoms(file, count));
    std::vector<std::string_view> fields;
    for (Index row = 0; row < count; ++row) {
        next_atom_line(file, row, count);
        split_fields(file.line(), fields);
        read_atom(file, fields, frame, premises.kind);
    }
    return frame;
}

/// A configuration with atoms in order, not checked yet.
Configuration to_configuration(const RawFrame& frame, const AtomOrder& order) {
    Configuration configuration;
    configuration.edges = frame.header.edges / frame.units.length;
    configuration.positions = arranged(frame.positions, order.rows);
    configuration.velocities = arranged(frame.velocities, order.rows);
    configuration.masses = arranged(frame.masses, order.rows);
    if (frame.header.time) configuration.time = *frame.header.time / frame.units.time;
    configuration.step = frame.header.step;
    configuration.is_unwrapped = frame.header.tells_unwrapped;
    configuration.remarks = frame.remarks;
    return configuration;
}

AtomOrder order_of(const TextFile& file, const RawFrame& frame) {
    const Index first_line = frame.header_line + 1;
    return frame.ids.empty() ? file_order(std::ssize(frame.positions), first_line)
                             : order_by_id(file, frame.ids, first_line);
}

/// The next frame; nothing after the last one.
/// @param number  of the frame, from 1
std::optional<RawFrame> next_frame(TextFile& file, Index number, Index wanted, const Reading& how,
                                   ExtendedXyzPremises& premises) {
    std::vector<std::string_view> fields;
    while (file.next_line()) {
        split_fields(file.line(), fields);
        if (fields.empty()) continue;
        file.set_context(fmt::format("frame {}: ", number));
        if (fields.size() != 1) {
            file.fail(fmt::format("expected the number of atoms, found {}", shown(file.line())));
        }
        return read_frame(file, fields[0], wanted, how, premises);
    }
    return std::nullopt;
}

}  // namespace

Configuration read_extended_xyz(TextFile& file, const std::optional<SubstanceUnits>& units, std::string_view comment) {
    const Reading how{units, comment};
    std::optional<RawFrame> last;
    ExtendedXyzPremises premises;
    std::optional<RawFrame> frame = next_frame(file, 1, 0, how, premises);
    for (Index number = 2; frame; ++number) {
        last.swap(frame);
        frame = next_frame(file, number, 0, how, premises);
    }
    if (!last) file.fail("the file has no frame");
    const AtomOrder order = order_of(file, *last);
    Configuration configuration = to_configuration(*last, order);
    check_configuration(file, configuration, order, last->header_line);
    return configuration;
}

bool ExtendedXyzTrajectory::read(Frame& frame) {
    const std::optional<RawFrame> raw = next_frame(file_, frames() + 1, atoms(), {units_, comment_}, premises_);
    if (!raw) return false;
    if (frames() > 0 && is_cut()) file_.fail("the last line has no end");
    const AtomOrder order = order_of(file_, *raw);
    frame = {.configuration = to_configuration(*raw, order), .ids = order.ids};
    frame.forces = arranged(raw->forces, order.rows);
    check_frame(file_, frame.configuration, order, raw->header_line);
    return true;
}

}  // namespace ljmd
