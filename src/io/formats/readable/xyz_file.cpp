#include <vector>

#include "io/formats/extended_xyz_reader.hpp"
#include "io/formats/readable_format.hpp"

namespace ljmd {

/// Extended XYZ, see extended_xyz_reader.hpp: the first line is one number.
ReadableFormat xyz_file() {
    return {.name = "an extended XYZ file",
            .recognises =
                [](const auto&, TextFile& file) {
                    std::vector<std::string_view> fields;
                    if (file.next_line()) {
                        split_fields(file.line(), fields);
                    }
                    return fields.size() == 1 && is_number(fields[0]);
                },
            .trajectory =
                [](const auto& path, const ReaderOptions& options) {
                    return std::make_unique<ExtendedXyzTrajectory>(path, options.units, options.xyz_comment);
                },
            .configuration =
                [](const auto& path, const ReaderOptions& options) {
                    TextFile file(path);
                    return read_extended_xyz(file, options.units, options.xyz_comment);
                },
            .takes_comment = true};
}

}  // namespace ljmd
