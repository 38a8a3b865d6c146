#include "io/files/open_directory.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "io/files/file_calls.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

#if !defined(O_PATH)
#define O_PATH O_SEARCH  // NOLINT(cppcoreguidelines-macro-usage): of POSIX, where it is not Linux
#endif

/// A directory that may be written to but not read can be used, but not locked or synchronised by itself.
/// @return its descriptor; negative: see errno
int open_directory(int where, const char* name, int flags) {
    const int usual = O_DIRECTORY | O_CLOEXEC | flags;
    const int descriptor = ::openat(where, name, O_RDONLY | usual);
    return descriptor < 0 && errno == EACCES ? ::openat(where, name, O_PATH | usual) : descriptor;
}

std::shared_ptr<const int> closed_at_the_end(int descriptor) {
    return {new int(descriptor), [](const int* held) {
                ::close(*held);
                delete held;
            }};
}

}  // namespace

OpenDirectory::OpenDirectory(fs::path path, int descriptor)
    : path_(std::move(path)), descriptor_(closed_at_the_end(descriptor)) {}

OpenDirectory::OpenDirectory(fs::path path, const char* doing, const fs::path& what) : path_(std::move(path)) {
    const int descriptor = open_directory(AT_FDCWD, path_.empty() ? "." : path_.c_str(), 0);
    if (descriptor < 0) {
        throw file_error(doing, what, errno);
    }
    descriptor_ = closed_at_the_end(descriptor);
}

OpenDirectory::OpenDirectory(const fs::path& path) : OpenDirectory(path, "open the directory", path) {}

OutputPlace OpenDirectory::operator/(const std::string& name) const {
    return {*this, name};
}

OpenDirectory OpenDirectory::made_within(const std::string& name) const {
    constexpr mode_t permissions = 0777;  // reduced by the umask
    if (::mkdirat(descriptor(), name.c_str(), permissions) == 0) {
        sync();
    } else if (errno != EEXIST) {
        throw file_error("create the directory", path_ / name, errno);
    }
    const int found = open_directory(descriptor(), name.c_str(), O_NOFOLLOW);
    if (found < 0) {
        throw file_error("open the directory", path_ / name, errno);
    }
    OpenDirectory within(path_ / name, found);
    within.held_alone_ = held_alone_;
    return within;
}

OpenDirectory OpenDirectory::held_alone() const {
    OpenDirectory alone = *this;
    alone.held_alone_ = true;
    return alone;
}

bool OpenDirectory::is_at_its_path() const {
    struct stat held {};
    struct stat there {};
    if (::fstat(descriptor(), &held) != 0) {
        throw file_error("look at", path_, errno);
    }
    if (::stat(path_.empty() ? "." : path_.c_str(), &there) != 0) {
        if (errno == ENOENT || errno == ENOTDIR) {
            return false;
        }
        throw file_error("look at", path_, errno);
    }
    return is_same_file(held, there);
}

void OpenDirectory::require_at_its_path() const {
    if (!is_at_its_path()) {
        throw InUseError(
            fmt::format("'{}' is not the directory any more that it was: it was renamed, removed, unmounted or "
                        "replaced meanwhile. What stands there now was not touched",
                        path_.string()));
    }
}

void OpenDirectory::sync() const {
    const int error = sync_descriptor(descriptor());
    if (error == EBADF) {  // the directory is not readable
        ::sync();
    } else if (error != 0) {
        throw file_error("write", path_, error);
    }
}

OutputPlace::OutputPlace(const fs::path& path)
    : directory(path.parent_path(), "create", path), name(path.has_filename() ? path.filename().string() : ".") {}

OutputPlace::OutputPlace(OpenDirectory in, std::string called) : directory(std::move(in)), name(std::move(called)) {}

bool OutputPlace::holds(int descriptor) const {
    struct stat held {};
    if (::fstat(descriptor, &held) != 0) {
        throw file_error("look at", path(), errno);
    }
    const auto there = status_of(*this);
    return there && is_same_file(held, *there);
}

}  // namespace ljmd
