#pragma once

#include <filesystem>
#include <string>

#include "ljmd/core/errors.hpp"

namespace ljmd {

/// A message that calls a path by another name, everywhere.
/// @param name  what the user knows in its place: "{output}" for the directory that an engine writes to
[[nodiscard]] std::string shown_as(std::string message, const std::filesystem::path& path, const std::string& name);

/// The result of `read`, which reads files in a temporary directory; what is wrong with them is said of `name`. Errors
/// of the system keep the path: where a disk is full is to be known.
template <class Read>
auto read_as(const std::filesystem::path& path, const std::string& name, const Read& read) {
    try {
        return read();
    } catch (const DataError& error) {
        throw DataError(shown_as(error.what(), path, name));
    }
}

}  // namespace ljmd
