#include "io/files/claimed_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <string_view>
#include <thread>
#include <utility>

#include "io/files/file_calls.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

bool refuses(int descriptor, int kind) {
    return ::flock(descriptor, kind | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

/// Ask twice: a process that looks whether the lock is held, as ClaimedFile::is_held() does, holds it for a moment.
bool refuses_twice(int descriptor, int kind) {
    constexpr std::chrono::milliseconds moment{20};
    if (!refuses(descriptor, kind)) {
        return false;
    }
    std::this_thread::sleep_for(moment);
    return refuses(descriptor, kind);
}

}  // namespace

ClaimedFile::ClaimedFile(fs::path path, int descriptor)
    : path_(std::move(path)), descriptor_(new int(descriptor), [](const int* held) {
          ::close(*held);
          delete held;
      }) {}

std::optional<ClaimedFile> ClaimedFile::claim(const fs::path& path) {
    constexpr mode_t permissions = 0666;  // reduced by the umask
    const int descriptor =
        ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, permissions);
    if (descriptor < 0) {
        throw file_error("open", path, errno);
    }
    ClaimedFile file(path, descriptor);
    return refuses_twice(descriptor, LOCK_EX) ? std::nullopt : std::optional(std::move(file));
}

bool ClaimedFile::is_held(const fs::path& path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) {
        if (errno == ENOENT || errno == ENOTDIR || errno == EACCES || errno == ELOOP) {
            return false;
        }
        throw file_error("open", path, errno);
    }
    const bool held = refuses(descriptor, LOCK_SH);
    ::close(descriptor);
    return held;
}

void ClaimedFile::clear() const {
    if (::ftruncate(descriptor(), 0) != 0) {
        throw file_error("write", path_, errno);
    }
}

void ClaimedFile::append(const std::string& text) const {
    for (std::string_view rest = text; !rest.empty();) {
        const ssize_t written = ::write(descriptor(), rest.data(), rest.size());
        if (written >= 0) {
            rest.remove_prefix(static_cast<std::size_t>(written));
        } else if (errno != EINTR) {
            throw file_error("write", path_, errno);
        }
    }
}

SharedDirectory::SharedDirectory(OpenDirectory directory) : directory_(std::move(directory)) {
    if (refuses_twice(directory_.descriptor(), LOCK_SH)) {
        throw InUseError(
            fmt::format("{} is being prepared by another process. Nothing was run.", directory_.path().string()));
    }
}

}  // namespace ljmd
