#include "io/formats/h5md_reader.hpp"
#include "io/formats/readable_format.hpp"

namespace ljmd {

/// H5MD, see h5md_reader.hpp: an HDF5 file.
ReadableFormat h5md_file() {
    return {.name = "an H5MD file",
            .recognises = [](const auto& path, TextFile&) { return is_hdf5(path); },
            .trajectory =
                [](const auto& path, const ReaderOptions& options) {
                    return std::make_unique<H5mdReader>(path, options.units, options.group);
                },
            .configuration =
                [](const auto& path, const ReaderOptions& options) {
                    H5mdReader reader(path, options.units, options.group);
                    return last_frame(reader, path);
                },
            .has_groups = true};
}

}  // namespace ljmd
