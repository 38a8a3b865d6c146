#include <algorithm>
#include <vector>

#include "io/formats/nist_format.hpp"
#include "io/formats/readable_format.hpp"

namespace ljmd {

/// A NIST sample configuration, see nist_format.hpp: the first line is three numbers. LAMMPS data, whose title may be
/// three numbers, are recognised before.
ReadableFormat nist_file() {
    return {.name = "a NIST sample configuration",
            .recognises =
                [](const auto&, TextFile& file) {
                    std::vector<std::string_view> fields;
                    if (file.next_line()) {
                        split_fields(file.line(), fields);
                    }
                    return fields.size() == 3 && std::ranges::all_of(fields, is_number);
                },
            .configuration =
                [](const auto& path, const ReaderOptions&) {
                    TextFile file(path);
                    return read_nist(file);
                }};
}

}  // namespace ljmd
