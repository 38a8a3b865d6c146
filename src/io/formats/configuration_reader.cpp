#include "io/formats/configuration_reader.hpp"

#include <fmt/format.h>

#include "io/formats/readable_format.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

Configuration read_configuration(const std::filesystem::path& path, const std::optional<SubstanceUnits>& units,
                                 const std::string& xyz_comment) {
    const std::optional<ReadableFormat> format = format_of(path);
    if (!xyz_comment.empty() && !(format && format->takes_comment)) {
        throw DataError(fmt::format("{}: is no extended XYZ file, but 'xyz_comment' is given", path.string()));
    }
    if (!format) {
        throw DataError(fmt::format("{}: unknown format; {} can be read", path.string(), readable_formats(false)));
    }
    return format->configuration(path, {.units = units, .xyz_comment = xyz_comment});
}

bool holds_one_configuration(const std::filesystem::path& path) {
    const std::optional<ReadableFormat> format = format_of(path);
    return format && !format->trajectory;
}

}  // namespace ljmd
