// A library to be preloaded: at one of the calls by which a program changes files, something happens.
//
//   LJMD_FAULT=kill:N   the program is killed instead of its call number N (counted from 1)
//   LJMD_FAULT=tear:N   of call N, if it writes, half of the bytes are written, and then it is killed
//   LJMD_FAULT=full:N   from call N on there is no space left for what writes
//   LJMD_FAULT=late:N   from the N-th time on that a file is synced, or closed that was open for writing, it turns out
//                       that there was no space left: so do file systems over a network, and quotas
//   LJMD_FAULT=names:N, none:N, blocks:N   the power is cut instead of the N-th call that syncs, names, removes or
//   shortens
//                       a file; what becomes of the folder LJMD_FAULT_FOLDER is told in disk.hpp
//   LJMD_FAULT=clock:S  the clock on the wall jumps at each look, S seconds on and as many back
//   LJMD_FAULT=count:F  nothing happens, and at the end the file F tells the number of calls
//
// Standard input, output and error are left alone.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/types.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <optional>

#include "disk.hpp"

namespace {

using ljmd::faults::Disk;

enum class Mode { nothing, kill, tear, full, late, cut, clock, count };

struct Fault {
    Mode mode = Mode::nothing;
    long at = 0;
    const char* file = nullptr;
    std::atomic<long> calls = 0;
    Disk::Rest left = Disk::Rest::names;
    std::optional<Disk> disk;  // where the power is cut

    Fault() {
        const char* text = std::getenv("LJMD_FAULT");
        if (text == nullptr) {
            return;
        }
        const char* rest = std::strchr(text, ':');
        if (rest == nullptr) {
            std::abort();
        }
        at = std::atol(rest + 1);
        file = rest + 1;
        const auto is = [&](const char* name) { return std::strncmp(text, name, std::strlen(name)) == 0; };
        mode = is("kill:")    ? Mode::kill
               : is("tear:")  ? Mode::tear
               : is("full:")  ? Mode::full
               : is("late:")  ? Mode::late
               : is("clock:") ? Mode::clock
               : is("count:") ? Mode::count
                              : Mode::cut;
        if (mode == Mode::cut) {
            left = is("none:") ? Disk::Rest::none : is("blocks:") ? Disk::Rest::blocks : Disk::Rest::names;
            disk.emplace(std::getenv("LJMD_FAULT_FOLDER"));
        }
    }

    ~Fault() {
        if (mode == Mode::count) {
            std::FILE* out = std::fopen(file, "w");
            std::fprintf(out, "%ld\n", calls.load());
            std::fclose(out);
        }
    }
};

Fault& fault() {
    static Fault the_one;
    return the_one;
}

[[maybe_unused]] const Fault& made_at_load = fault();

enum class Call { goes_on, torn, fails };

/// What becomes of the next call.
Call next(bool writes) {
    Fault& f = fault();
    if (f.mode == Mode::cut && writes) {  // does not change what is on the disk
        return Call::goes_on;
    }
    const long number = ++f.calls;
    if (f.mode == Mode::cut && number == f.at) {
        f.disk->cut(f.left, static_cast<std::uint64_t>(number));
        std::raise(SIGKILL);
    }
    if ((f.mode == Mode::kill || (f.mode == Mode::tear && !writes)) && number == f.at) {
        std::raise(SIGKILL);
    }
    if (f.mode == Mode::tear && number == f.at) {
        return Call::torn;
    }
    if (f.mode == Mode::full && number >= f.at && writes) {
        errno = ENOSPC;
        return Call::fails;
    }
    return Call::goes_on;
}

/// Whether it turns out now that what was written has found no space.
bool too_late() {
    static std::atomic<long> times = 0;
    if (fault().mode != Mode::late || ++times < fault().at) {
        return false;
    }
    errno = ENOSPC;
    return true;
}

template <class Function>
Function original(const char* name) {
    return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

template <class Write>
ssize_t write_or_not(int descriptor, size_t count, const Write& write) {
    if (descriptor <= STDERR_FILENO) {
        return write(count);
    }
    switch (next(true)) {
        case Call::torn:
            static_cast<void>(write(count / 2));
            std::raise(SIGKILL);
            return -1;
        case Call::fails:
            return -1;
        default:
            return write(count);
    }
}

}  // namespace

extern "C" {

ssize_t write(int descriptor, const void* data, size_t count) {
    static const auto call = original<ssize_t (*)(int, const void*, size_t)>("write");
    return write_or_not(descriptor, count, [&](size_t n) { return call(descriptor, data, n); });
}

ssize_t pwrite(int descriptor, const void* data, size_t count, off_t offset) {
    static const auto call = original<ssize_t (*)(int, const void*, size_t, off_t)>("pwrite");
    return write_or_not(descriptor, count, [&](size_t n) { return call(descriptor, data, n, offset); });
}

ssize_t pwrite64(int descriptor, const void* data, size_t count, off64_t offset) {
    static const auto call = original<ssize_t (*)(int, const void*, size_t, off64_t)>("pwrite64");
    return write_or_not(descriptor, count, [&](size_t n) { return call(descriptor, data, n, offset); });
}

int fsync(int descriptor) {
    static const auto call = original<int (*)(int)>("fsync");
    static_cast<void>(next(false));
    if (too_late()) {
        return -1;
    }
    const int result = call(descriptor);
    if (result == 0 && fault().disk) {
        fault().disk->synced(descriptor);
    }
    return result;
}

int close(int descriptor) {
    static const auto call = original<int (*)(int)>("close");
    const int flags = ::fcntl(descriptor, F_GETFL);
    const bool written = flags >= 0 && (flags & O_ACCMODE) != O_RDONLY && descriptor > STDERR_FILENO;
    const int result = call(descriptor);
    return written && too_late() ? -1 : result;
}

int ftruncate(int descriptor, off_t length) noexcept {
    static const auto call = original<int (*)(int, off_t)>("ftruncate");
    static_cast<void>(next(false));
    return call(descriptor, length);
}

int ftruncate64(int descriptor, off64_t length) noexcept {
    static const auto call = original<int (*)(int, off64_t)>("ftruncate64");
    static_cast<void>(next(false));
    return call(descriptor, length);
}

int rename(const char* from, const char* to) noexcept {
    static const auto call = original<int (*)(const char*, const char*)>("rename");
    static_cast<void>(next(false));
    return call(from, to);
}

int renameat(int from_where, const char* from, int to_where, const char* to) noexcept {
    static const auto call = original<int (*)(int, const char*, int, const char*)>("renameat");
    static_cast<void>(next(false));
    return call(from_where, from, to_where, to);
}

int unlinkat(int where, const char* name, int flags) noexcept {
    static const auto call = original<int (*)(int, const char*, int)>("unlinkat");
    static_cast<void>(next(false));
    return call(where, name, flags);
}

int mkdirat(int where, const char* name, mode_t mode) noexcept {
    static const auto call = original<int (*)(int, const char*, mode_t)>("mkdirat");
    static_cast<void>(next(false));
    return call(where, name, mode);
}

int clock_gettime(clockid_t clock, struct timespec* now) noexcept {
    static const auto call = original<int (*)(clockid_t, struct timespec*)>("clock_gettime");
    const int result = call(clock, now);
    if (fault().mode == Mode::clock && clock == CLOCK_REALTIME) {
        static std::atomic<long> looks = 0;
        now->tv_sec += ++looks % 2 == 0 ? fault().at : -fault().at;
    }
    return result;
}

int unlink(const char* path) noexcept {
    static const auto call = original<int (*)(const char*)>("unlink");
    static_cast<void>(next(false));
    return call(path);
}

}  // extern "C"
