#include "ljmd/io/directory_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>

#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

bool is_refused(int descriptor, int kind) {
    return ::flock(descriptor, kind | LOCK_NB) != 0 && errno == EWOULDBLOCK;
}

}  // namespace

DirectoryLock::DirectoryLock(const std::filesystem::path& directory)
    : descriptor_(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (descriptor_ < 0) {
        throw FileError(fmt::format("cannot open the directory '{}': {}", directory.string(),
                                    std::generic_category().message(errno)));
    }
    bool refused = is_refused(descriptor_, LOCK_EX);
    if (refused) {  // is_held() of somebody else has it for a moment
        constexpr std::chrono::milliseconds moment{20};
        std::this_thread::sleep_for(moment);
        refused = is_refused(descriptor_, LOCK_EX);
    }
    if (refused) {
        ::close(descriptor_);
        throw InUseError(fmt::format("another run is writing to {}. Nothing was run.", directory.string()));
    }
}

DirectoryLock::~DirectoryLock() {
    ::close(descriptor_);
}

bool DirectoryLock::is_held(const std::filesystem::path& directory) {
    const int descriptor = ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) {
        return false;
    }
    const bool held = is_refused(descriptor, LOCK_SH);
    ::close(descriptor);
    return held;
}

}  // namespace ljmd
