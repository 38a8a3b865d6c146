#include "ljmd/run/output_guard.hpp"

#include <fmt/format.h>

#include "ljmd/core/errors.hpp"
#include "ljmd/io/files/file_system.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

/// Upper bound of the length of our file names, including those of growing files (ReplacementFile).
constexpr std::size_t longest_name = 64;

void require_usable(const fs::path& directory, const std::string& consequence) {
    if (files::is_too_long(directory / std::string(longest_name, 'x'))) {
        throw InputError(
            fmt::format("the path {} is too long: files in it cannot be named. {}.\n  choose a shorter one with --out",
                        directory.string(), consequence));
    }
    if (files::is_no_directory(directory)) {
        throw InputError(fmt::format("{} exists and is not a directory. {}.", directory.string(), consequence));
    }
}

}  // namespace

std::vector<fs::path> existing_outputs(const fs::path& directory, const std::vector<std::string>& names,
                                       const std::string& consequence) {
    require_usable(directory, consequence);
    std::vector<fs::path> found;
    for (const std::string& name : names) {
        const fs::path path = directory / name;
        const fs::file_type type = files::type_of(path);
        if (type == fs::file_type::regular || type == fs::file_type::symlink) {
            found.push_back(path);
        } else if (type != fs::file_type::not_found) {
            throw InputError(
                fmt::format("{} is in the way: a file of that name is to be written, and this is no file. {}.\n  "
                            "choose another directory with --out",
                            path.string(), consequence));
        }
    }
    return found;
}

void require_no_outputs(const fs::path& directory, const std::vector<std::string>& names, bool force,
                        const std::string& consequence) {
    const std::vector<fs::path> found = existing_outputs(directory, names, consequence);
    if (!force && !found.empty()) {
        throw InputError(
            fmt::format("{} is there already. {}.\n  choose another directory with --out, or replace it with --force",
                        found.front().string(), consequence));
    }
}

void require_no_run(const fs::path& directory, const std::string& consequence) {
    if (files::is_taken(directory / "run.json")) {
        throw InputError(
            fmt::format("{} is the directory of a run, whose files stay as they are. {}.\n  choose another directory "
                        "with --out",
                        directory.string(), consequence));
    }
}

}  // namespace ljmd
