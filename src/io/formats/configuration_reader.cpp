#include "ljmd/io/formats/configuration_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "h5md_reader.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/io/files/text_file.hpp"
#include "ljmd/io/formats/configuration_check.hpp"
#include "ljmd/io/formats/extended_xyz_reader.hpp"
#include "ljmd/io/formats/lammps_data_reader.hpp"
#include "ljmd/io/formats/nist_format.hpp"

namespace ljmd {
namespace {

enum class Format { nist, extended_xyz, lammps_data, h5md, unknown };

/// A LAMMPS header is short; "N atoms" is in one of its first lines.
constexpr Index longest_lammps_header = 100;

Format recognise(TextFile& file) {
    if (!file.next_line()) file.fail("the file is empty");
    std::vector<std::string_view> fields;
    split_fields(file.line(), fields);
    const bool numbers = std::all_of(fields.begin(), fields.end(), is_number);
    const Format otherwise = numbers && fields.size() == 3   ? Format::nist
                             : numbers && fields.size() == 1 ? Format::extended_xyz
                                                             : Format::unknown;
    bool has_count = false;
    bool has_box = otherwise == Format::unknown;  // else a comment "864 atoms" in extended XYZ would match
    while (file.line_number() < longest_lammps_header && !(has_count && has_box) && file.next_line()) {
        has_count = has_count || is_lammps_atom_count(file.line());
        has_box = has_box || is_lammps_box_bound(file.line());
    }
    return has_count && has_box ? Format::lammps_data : otherwise;
}

/// The last frame of a trajectory. A file that was cut off or is still being written is refused.
Configuration read_h5md(const std::filesystem::path& path, const std::optional<SubstanceUnits>& units) {
    H5mdReader reader(path, units);
    Frame frame;
    Configuration last;
    while (reader.next(frame)) {
        last = std::move(frame.configuration);
    }
    for (const std::string& warning : reader.warnings()) {
        if (std::ranges::find(last.remarks, warning) == last.remarks.end()) {
            throw DataError(warning);
        }
    }
    if (const auto same = find_coincident_atoms(last)) {
        throw DataError(fmt::format("{}: atoms {} and {} are at the same place in the periodic box", path.string(),
                                    same->first + 1, same->second + 1));
    }
    return last;
}

}  // namespace

Configuration read_configuration(const std::filesystem::path& path, const std::optional<SubstanceUnits>& units,
                                 const std::string& xyz_comment) {
    TextFile file(path);  // refuses files that are not regular, which HDF5 would open
    const Format format = is_hdf5(path) ? Format::h5md : recognise(file);
    if (!xyz_comment.empty() && format != Format::extended_xyz) {
        file.fail_at(0, "is no extended XYZ file, but 'xyz_comment' is given");
    }
    if (format == Format::h5md) {
        return read_h5md(path, units);
    }
    file.rewind();
    switch (format) {
        case Format::nist:
            return read_nist(file);
        case Format::extended_xyz:
            return read_extended_xyz(file, units, xyz_comment);
        case Format::lammps_data:
            return read_lammps_data(file);
        default:
            break;
    }
    file.fail_at(
        0,
        "unknown format; a NIST sample configuration, an extended XYZ file, a LAMMPS data file or an H5MD file "
        "can be read");
}

bool holds_one_configuration(const std::filesystem::path& path) {
    TextFile file(path);
    if (is_hdf5(path)) {
        return false;
    }
    const Format format = recognise(file);
    return format == Format::nist || format == Format::lammps_data;
}

}  // namespace ljmd
