#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/files/text_file.hpp"
#include "io/formats/trajectory_reader.hpp"

namespace ljmd {

/// What a reader is told that is not in the file.
struct ReaderOptions {
    std::optional<SubstanceUnits> units;  ///< of the substance, for files in SI units
    std::string group{};                  ///< particle group of an H5MD file; empty: the only one
    std::string xyz_comment{};            ///< keys missing from the comment lines of an extended XYZ file
};

/// A format in which files are read. Each is one file in src/io/formats/readable. It is known by content, not by name.
struct ReadableFormat {
    std::string name;  ///< with its article: "a LAMMPS dump"

    /// Whether a file has this format. The file is at its start. Formats are asked in the order of
    /// all_readable_formats().
    std::function<bool(const std::filesystem::path& path, TextFile& file)> recognises;

    /// The frames of a file; empty: the format holds one configuration.
    std::function<std::unique_ptr<TrajectoryReader>(const std::filesystem::path& path, const ReaderOptions& options)>
        trajectory = {};

    /// The configuration of a file, of a trajectory the one that a run starts from. @throws DataError
    std::function<Configuration(const std::filesystem::path& path, const ReaderOptions& options)> configuration;

    bool takes_comment = false;  ///< ReaderOptions::xyz_comment
    bool has_groups = false;     ///< of particles, see ReaderOptions::group
};

/// Every format, sorted by the names of their files.
[[nodiscard]] std::vector<ReadableFormat> all_readable_formats();

/// The format of a file; none: it is unknown.
/// @throws DataError  the file is missing, not a regular file, or empty
[[nodiscard]] std::optional<ReadableFormat> format_of(const std::filesystem::path& path);

/// The last frame of a trajectory. A file that was cut off or is still being written is refused.
[[nodiscard]] Configuration last_frame(TrajectoryReader& reader, const std::filesystem::path& path);

/// "an H5MD file, a LAMMPS dump or an extended XYZ file": those that hold a trajectory, or all.
[[nodiscard]] std::string readable_formats(bool trajectories);

}  // namespace ljmd
