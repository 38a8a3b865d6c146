// A library to be preloaded: a file system that cannot do all that others can.
//
//   LJMD_FAULT=flock:E   files and directories cannot be locked: the error number is E
//   LJMD_FAULT=fsync:E   files and directories cannot be synchronised likewise
//   LJMD_FAULT=signal    every other call that synchronises is interrupted by a signal
#include <dlfcn.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace {

/// The error number of a fault of this name; 0: none is asked for.
int error_of(const char* name) {
    const char* text = std::getenv("LJMD_FAULT");
    const std::size_t length = std::strlen(name);
    return text != nullptr && std::strncmp(text, name, length) == 0 ? std::atoi(text + length) : 0;
}

bool is_interrupted() {
    static unsigned calls = 0;
    const char* text = std::getenv("LJMD_FAULT");
    return text != nullptr && std::strcmp(text, "signal") == 0 && ++calls % 2 == 1;
}

}  // namespace

extern "C" {

int flock(int descriptor, int operation) noexcept {
    using Function = int (*)(int, int);
    static const auto call = reinterpret_cast<Function>(::dlsym(RTLD_NEXT, "flock"));
    static const int error = error_of("flock:");
    if (error != 0) {
        errno = error;
        return -1;
    }
    return call(descriptor, operation);
}

int fsync(int descriptor) {
    using Function = int (*)(int);
    static const auto call = reinterpret_cast<Function>(::dlsym(RTLD_NEXT, "fsync"));
    static const int error = error_of("fsync:");
    if (error != 0 || is_interrupted()) {
        errno = error != 0 ? error : EINTR;
        return -1;
    }
    return call(descriptor);
}

}  // extern "C"
