#include "io/files/file_calls.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace ljmd {

FileError file_error(const char* doing, const std::filesystem::path& path, int error) {
    return FileError(fmt::format("cannot {} '{}': {}", doing, path.string(), std::generic_category().message(error)));
}

int sync_descriptor(int descriptor) {
#if defined(F_FULLFSYNC)
    // On macOS fsync() leaves data in the cache of the drive.
    if (::fcntl(descriptor, F_FULLFSYNC) == 0) {
        return 0;
    }
#endif
    while (::fsync(descriptor) != 0) {
        if (errno == EINVAL || errno == EROFS || errno == ENOTSUP) {
            return 0;
        }
        if (errno != EINTR) {
            return errno;
        }
    }
    return 0;
}

std::optional<struct stat> status_of(const OutputPlace& place) {
    struct stat status {};
    if (::fstatat(place.directory.descriptor(), place.name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0) {
        return status;
    }
    if (errno != ENOENT) {
        throw file_error("look at", place.path(), errno);
    }
    return std::nullopt;
}

bool is_same_file(const struct stat& a, const struct stat& b) {
    return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

}  // namespace ljmd
