#include "ljmd/io/trajectory_reader.hpp"

#include <fmt/format.h>

#include <vector>

#include "h5md_reader.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/io/extended_xyz_reader.hpp"
#include "ljmd/io/lammps_dump.hpp"
#include "ljmd/io/text_file.hpp"

namespace ljmd {

bool TrajectoryReader::next(Frame& frame) {
    try {
        if (!read(frame)) {
            return false;
        }
    } catch (const DataError& error) {
        if (frames_ == 0 || !is_cut()) {
            throw;
        }
        warn(fmt::format("{}; the {} {} before it {} used", error.what(), frames_, frames_ == 1 ? "frame" : "frames",
                         frames_ == 1 ? "is" : "are"));
        return false;
    }
    const auto atoms = static_cast<Index>(frame.configuration.positions.size());
    if (frames_ == 0) {
        atoms_ = atoms;
        has_step_ = frame.has_step;
        has_time_ = frame.has_time;
    } else if (atoms != atoms_) {
        fail(fmt::format("{} atoms, but frame 1 has {}", atoms, atoms_));
    } else if (frame.has_step != has_step_) {
        fail(frame.has_step ? "a step, which frame 1 has not" : "no step, which frame 1 has");
    } else if (frame.has_time != has_time_) {
        fail(frame.has_time ? "a time, which frame 1 has not" : "no time, which frame 1 has");
    }
    ++frames_;
    return true;
}

std::unique_ptr<TrajectoryReader> open_trajectory(const std::filesystem::path& path,
                                                  const std::optional<SubstanceUnits>& units,
                                                  const std::string& group) {
    TextFile file(path);  // refuses what is no regular file, which HDF5 would open
    if (is_hdf5(path)) {
        return std::make_unique<H5mdReader>(path, units, group);
    }
    if (!group.empty()) {
        file.fail_at(0, fmt::format("only an H5MD file has groups of particles, such as {}", shown(group)));
    }
    if (!file.next_line()) {
        file.fail_at(0, "the file is empty");
    }
    if (file.line().starts_with("ITEM:")) {
        return std::make_unique<LammpsDumpTrajectory>(path);
    }
    std::vector<std::string_view> fields;
    split_fields(file.line(), fields);
    if (fields.size() == 1 && is_number(fields[0])) {
        return std::make_unique<ExtendedXyzTrajectory>(path, units);
    }
    file.fail_at(0, "unknown format; an H5MD file, an extended XYZ file or a LAMMPS dump can be read");
}

}  // namespace ljmd
