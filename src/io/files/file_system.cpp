#include "io/files/file_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "ljmd/core/errors.hpp"

namespace ljmd::files {

namespace {

namespace fs = std::filesystem;

void require(const std::error_code& error, const char* doing, const fs::path& path) {
    if (error) {
        throw FileError(fmt::format("cannot {} '{}': {}", doing, path.string(), error.message()));
    }
}

/// A status with a known result may also set an error code: when there is no such file.
void require_known(fs::file_type type, const std::error_code& error, const fs::path& path) {
    if (type == fs::file_type::none) {
        require(error, "look at", path);
    }
}

/// The type of the file at the end of all links.
fs::file_type type_at_end(const fs::path& path) {
    std::error_code error;
    const fs::file_type type = fs::status(path, error).type();
    require_known(type, error, path);
    return type;
}

}  // namespace

bool exists(const fs::path& path) {
    return type_at_end(path) != fs::file_type::not_found;
}

bool is_no_directory(const fs::path& path) {
    const fs::file_type type = type_at_end(path);
    return type != fs::file_type::not_found && type != fs::file_type::directory;
}

bool is_taken(const fs::path& path) {
    return type_of(path) != fs::file_type::not_found;
}

bool is_too_long(const fs::path& path) {
    std::error_code error;
    static_cast<void>(fs::symlink_status(path, error));
    return error == std::errc::filename_too_long;
}

fs::file_type type_of(const fs::path& path) {
    std::error_code error;
    const fs::file_type type = fs::symlink_status(path, error).type();
    require_known(type, error, path);
    return type;
}

bool is_directory(const fs::path& path) {
    return type_at_end(path) == fs::file_type::directory;
}

bool is_regular_file(const fs::path& path) {
    return type_at_end(path) == fs::file_type::regular;
}

std::optional<std::uintmax_t> size_of(const fs::path& path) {
    if (type_at_end(path) != fs::file_type::regular) {
        return std::nullopt;
    }
    std::error_code error;
    const std::uintmax_t bytes = fs::file_size(path, error);
    if (error == std::errc::no_such_file_or_directory) {  // removed in between
        return std::nullopt;
    }
    require(error, "look at", path);
    return bytes;
}

bool are_same(const fs::path& one, const fs::path& other) {
    if (!files::exists(one) || !files::exists(other)) {
        return false;
    }
    std::error_code error;
    const bool same = fs::equivalent(one, other, error);
    require(error, "look at", one);
    return same;
}

std::vector<fs::path> list(const fs::path& folder) {
    std::vector<fs::path> found;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        found.push_back(entry->path());
    }
    require(error, "read the directory", folder);
    std::sort(found.begin(), found.end());
    return found;
}

fs::path absolute(const fs::path& path) {
    if (path.empty()) {
        return path;
    }
    std::error_code error;
    fs::path whole = fs::absolute(path, error);
    if (error) {
        throw FileError(fmt::format("cannot find '{}' from the working directory: {}", path.string(), error.message()));
    }
    return whole;
}

fs::path canonical(const fs::path& path) {
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(files::absolute(path), error);
    require(error, "find", path);
    return whole.has_filename() ? whole : whole.parent_path();
}

fs::path read_link(const fs::path& path) {
    std::error_code error;
    fs::path target = fs::read_symlink(path, error);
    require(error, "read the link", path);
    return target;
}

fs::path temporary_folder() {
    std::error_code error;
    fs::path folder = fs::temp_directory_path(error);
    if (error) {
        throw FileError(fmt::format("no directory for temporary files: {}; does TMPDIR name one?", error.message()));
    }
    return folder;
}

void create_directories(const fs::path& directory) {
    std::error_code error;
    fs::create_directories(directory, error);
    require(error, "create the directory", directory);
}

void remove(const fs::path& path) {
    std::error_code error;
    fs::remove(path, error);
    require(error, "remove", path);
}

void try_to_remove(const fs::path& path) noexcept {
    std::error_code ignored;
    fs::remove(path, ignored);
}

void try_to_remove_all(const fs::path& directory) noexcept {
    std::error_code ignored;
    fs::remove_all(directory, ignored);
}

void rename(const fs::path& from, const fs::path& to) {
    std::error_code error;
    fs::rename(from, to, error);
    require(error, "replace", to);
}

}  // namespace ljmd::files
