#include <algorithm>
#include <vector>

#include "io/formats/lammps_data_reader.hpp"
#include "io/formats/readable_format.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

/// A header is short; "N atoms" is in one of its first lines.
constexpr Index longest_header = 100;

/// The first line is a title. If it consists of one or three numbers or begins with "ITEM:", as the first line of other
/// formats does, the bounds of a box are required, too: a comment of extended XYZ may be "864 atoms".
bool is_data(TextFile& file) {
    if (!file.next_line()) {
        return false;
    }
    std::vector<std::string_view> title;
    split_fields(file.line(), title);
    const bool may_be_numbers = (title.size() == 1 || title.size() == 3) && std::ranges::all_of(title, is_number);
    const bool may_be_other = may_be_numbers || file.line().starts_with("ITEM:");
    bool has_count = false;
    bool has_box = !may_be_other;
    try {
        while (file.line_number() < longest_header && !(has_count && has_box) && file.next_line()) {
            has_count = has_count || is_lammps_atom_count(file.line());
            has_box = has_box || is_lammps_box_bound(file.line());
        }
    } catch (const DataError&) {
        if (!may_be_other) {
            throw;
        }
        return false;  // the reader of the other format meets it, behind the frames before it
    }
    return has_count && has_box;
}

}  // namespace

/// LAMMPS data, see lammps_data_reader.hpp: "N atoms" is in one of the lines after the first.
ReadableFormat lammps_data_file() {
    return {.name = "a LAMMPS data file",
            .recognises = [](const auto&, TextFile& file) { return is_data(file); },
            .configuration =
                [](const auto& path, const ReaderOptions&) {
                    TextFile file(path);
                    return read_lammps_data(file);
                }};
}

}  // namespace ljmd
