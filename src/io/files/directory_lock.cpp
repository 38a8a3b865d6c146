#include "io/files/directory_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <thread>

#include "io/files/file_calls.hpp"
#include "io/files/replacement_file.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

enum class Answer { locked, refused, knows_no_locks };

Answer ask_for_lock(int descriptor, int kind) {
    if (::flock(descriptor, kind | LOCK_NB) == 0) {
        return Answer::locked;
    }
    return errno == EWOULDBLOCK ? Answer::refused : Answer::knows_no_locks;
}

}  // namespace

DirectoryLock::DirectoryLock(const OpenDirectory& directory) : directory_(directory) {
    Answer answer = ask_for_lock(directory_.descriptor(), LOCK_EX);
    if (answer == Answer::refused) {  // another process may hold it briefly, in is_held()
        constexpr std::chrono::milliseconds moment{20};
        std::this_thread::sleep_for(moment);
        answer = ask_for_lock(directory_.descriptor(), LOCK_EX);
    }
    if (answer == Answer::refused) {
        throw InUseError(fmt::format("another run is writing to {}. Nothing was run.", directory.path().string()));
    }
    if (answer == Answer::locked) {
        directory_ = directory.held_alone();
        remove_left_over(directory_);
    }
}

bool DirectoryLock::is_held(const std::filesystem::path& directory) {
    const int descriptor = ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) {
        if (errno == ENOENT || errno == ENOTDIR || errno == EACCES) {
            return false;
        }
        throw file_error("open", directory, errno);
    }
    const bool held = ask_for_lock(descriptor, LOCK_SH) == Answer::refused;
    ::close(descriptor);
    return held;
}

}  // namespace ljmd
