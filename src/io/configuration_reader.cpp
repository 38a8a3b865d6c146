#include "ljmd/io/configuration_reader.hpp"

#include <algorithm>
#include <vector>

#include "ljmd/io/extended_xyz_reader.hpp"
#include "ljmd/io/lammps_data_reader.hpp"
#include "ljmd/io/nist_format.hpp"
#include "ljmd/io/text_file.hpp"

namespace ljmd {
namespace {

enum class Format { nist, extended_xyz, lammps_data, unknown };

/// A LAMMPS header is short; "N atoms" stands in one of its first lines.
constexpr Index longest_lammps_header = 100;

Format recognise(TextFile& file) {
    if (!file.next_line()) file.fail("the file is empty");
    std::vector<std::string_view> fields;
    split_fields(file.line(), fields);
    const bool numbers = std::all_of(fields.begin(), fields.end(), is_number);
    if (numbers && fields.size() == 3) return Format::nist;
    if (numbers && fields.size() == 1) return Format::extended_xyz;
    while (file.line_number() < longest_lammps_header && file.next_line()) {
        if (is_lammps_atom_count(file.line())) return Format::lammps_data;
    }
    return Format::unknown;
}

}  // namespace

Configuration read_configuration(const std::filesystem::path& path, const std::optional<SubstanceUnits>& units) {
    TextFile file(path);
    const Format format = recognise(file);
    file.rewind();
    switch (format) {
        case Format::nist:
            return read_nist(file);
        case Format::extended_xyz:
            return read_extended_xyz(file, units);
        case Format::lammps_data:
            return read_lammps_data(file);
        case Format::unknown:
            break;
    }
    file.fail_at(0,
                 "unknown format; a NIST sample configuration, an extended XYZ file or a LAMMPS data file can be read");
}

}  // namespace ljmd
