#include "io/formats/nist_format.hpp"

#include <fmt/format.h>

#include "io/formats/atom_rows.hpp"

namespace ljmd {
namespace {

/// Split the next line; it must have this many fields.
void read_line(TextFile& file, std::size_t count, std::string_view what, std::vector<std::string_view>& fields) {
    if (!file.next_line()) file.fail(fmt::format("the file ends before {}", what));
    split_fields(file.line(), fields);
    if (fields.size() != count) file.fail(fmt::format("expected {}, found {}", what, shown(file.line())));
}

}  // namespace

Configuration read_nist(TextFile& file) {
    std::vector<std::string_view> fields;
    Configuration configuration;
    read_line(file, 3, "three box edges", fields);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        configuration.edges[static_cast<Eigen::Index>(axis)] = file.number(fields[axis], "a box edge");
    }
    read_line(file, 1, "the number of atoms", fields);
    const Index count = read_atom_count(file, fields[0]);

    std::vector<Index> ids;
    std::vector<Vec3> positions;
    ids.reserve(expected_atoms(file, count));
    positions.reserve(expected_atoms(file, count));
    const Index first_line = file.line_number() + 1;
    for (Index row = 0; row < count; ++row) {
        next_atom_line(file, row, count);
        split_fields(file.line(), fields);
        if (fields.size() != 4) file.fail(fmt::format("expected 'id x y z', found {}", shown(file.line())));
        ids.push_back(file.integer(fields[0], "the id"));
        positions.push_back(read_vector(file, fields, 1));
    }
    while (file.next_line()) {
        if (!is_blank(file.line())) file.fail(fmt::format("a line follows the last of {} atoms", count));
    }

    const AtomOrder order = order_by_id(file, ids, first_line);
    configuration.positions = arranged(positions, order.rows);
    check_configuration(file, configuration, order, 1);
    return configuration;
}

}  // namespace ljmd
