#include "io/formats/lammps_dump.hpp"
#include "io/formats/readable_format.hpp"

namespace ljmd {

/// A LAMMPS dump, see lammps_dump.hpp: the first line begins with "ITEM:".
ReadableFormat lammps_dump_file() {
    return {
        .name = "a LAMMPS dump",
        .recognises = [](const auto&, TextFile& file) { return file.next_line() && file.line().starts_with("ITEM:"); },
        .trajectory = [](const auto& path,
                         const ReaderOptions&) { return std::make_unique<LammpsDumpTrajectory>(path); },
        .configuration =
            [](const auto& path, const ReaderOptions&) {
                LammpsDumpTrajectory reader(path);
                return last_frame(reader, path);
            }};
}

}  // namespace ljmd
