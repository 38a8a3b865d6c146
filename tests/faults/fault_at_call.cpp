// A library to be preloaded: at one of the calls by which a program uses files, something happens.
//
//   LJMD_FAULT=kill:N   the program is killed instead of its call number N (counted from 1) that changes a file
//   LJMD_FAULT=tear:N   of call N, if it writes, half of the bytes are written, and then it is killed
//   LJMD_FAULT=full:N   from call N on there is no space left for what writes or makes files
//   LJMD_FAULT=late:N   from the N-th time on that a file is synced, or closed that was open for writing, it turns out
//                       that there was no space left: so do file systems over a network, and quotas
//   LJMD_FAULT=names:N, none:N, blocks:N   the power is cut instead of the N-th call that syncs, names, removes or
//                       shortens a file; what becomes of the folder LJMD_FAULT_FOLDER is told in disk.hpp
//   LJMD_FAULT=EIO:N    of all calls that may end with this error, the N-th does; so for EINTR, ENOSPC, EACCES, EMFILE,
//                       EAGAIN
//   LJMD_FAULT=look:N   the N-th look at what a file or folder is ends with EIO
//   LJMD_FAULT=short:N  the N-th call that reads or writes takes half of the bytes
//   LJMD_FAULT=clock:S  the clock on the wall jumps at each look, S seconds on and as many back
//   LJMD_FAULT=count:F  nothing happens, and at the end the file F tells the number of calls of each kind, of those
//   that
//                       change a file, and of those that may end with each error
//
// Standard input, output and error are left alone, and so are the programs that are started. The lists of functions are
// those that ljmd, libstdc++ and HDF5 import from the C library: faults of a kind that is never counted test nothing.
#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

#include "fault.hpp"

namespace {

using ljmd::faults::Fate;
using ljmd::faults::fault;
using ljmd::faults::Kind;

template <class Function>
Function original(const char* name) {
    return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

Fate next(Kind kind) {
    return fault() == nullptr ? Fate::goes_on : fault()->next(kind);
}

template <class Transfer>
ssize_t transferred(Kind kind, int descriptor, size_t count, const Transfer& transfer) {
    if (descriptor <= STDERR_FILENO) {
        return transfer(count);
    }
    switch (next(kind)) {
        case Fate::is_short:
            return transfer(count > 1 ? count / 2 : count);
        case Fate::torn:
            static_cast<void>(transfer(count / 2));
            std::raise(SIGKILL);
            return -1;
        case Fate::fails:
            return -1;
        default:
            return transfer(count);
    }
}

Kind kind_of_open(int flags) {
    return (flags & (O_CREAT | O_TRUNC)) != 0 || (flags & O_TMPFILE) == O_TMPFILE ? Kind::create : Kind::open;
}

Kind kind_of_open(const char* mode) {
    return mode[0] == 'w' || mode[0] == 'a' ? Kind::create : Kind::open;
}

/// The third argument of open(), where there is one.
mode_t permissions(int flags, va_list rest) {
    return kind_of_open(flags) == Kind::create ? va_arg(rest, mode_t) : 0;
}

}  // namespace

// What has nothing special to it: FAULTY(kind, value when it fails, type, name, parameters, arguments).
#define FAULTY(kind, failure, type, name, parameters, arguments)           \
    type name parameters {                                                 \
        static const auto call = original<type(*) parameters>(#name);      \
        return next(Kind::kind) == Fate::fails ? failure : call arguments; \
    }

// What moves bytes.
#define TRANSFERRING(kind, name, parameters, arguments)                                                 \
    ssize_t name parameters {                                                                           \
        static const auto call = original<ssize_t(*) parameters>(#name);                                \
        return transferred(Kind::kind, descriptor, size, [&](size_t count) { return call arguments; }); \
    }

// With an argument more, sometimes.
#define OPENING(name, parameters, arguments)                                   \
    int name parameters {                                                      \
        static const auto call = original<int(*) parameters>(#name);           \
        va_list rest;                                                          \
        va_start(rest, flags);                                                 \
        const mode_t mode = permissions(flags, rest);                          \
        va_end(rest);                                                          \
        return next(kind_of_open(flags)) == Fate::fails ? -1 : call arguments; \
    }

#define OPENING_STREAM(name)                                                           \
    FILE* name(const char* path, const char* mode) {                                   \
        static const auto call = original<FILE* (*)(const char*, const char*)>(#name); \
        return next(kind_of_open(mode)) == Fate::fails ? nullptr : call(path, mode);   \
    }

extern "C" {

TRANSFERRING(read, read, (int descriptor, void* data, size_t size), (descriptor, data, count))
TRANSFERRING(read, pread, (int descriptor, void* data, size_t size, off_t at), (descriptor, data, count, at))
TRANSFERRING(read, pread64, (int descriptor, void* data, size_t size, off64_t at), (descriptor, data, count, at))
FAULTY(seek, -1, off_t, lseek, (int descriptor, off_t place, int from) noexcept, (descriptor, place, from))
FAULTY(seek, -1, off64_t, lseek64, (int descriptor, off64_t place, int from) noexcept, (descriptor, place, from))
TRANSFERRING(write, write, (int descriptor, const void* data, size_t size), (descriptor, data, count))
TRANSFERRING(write, pwrite, (int descriptor, const void* data, size_t size, off_t at), (descriptor, data, count, at))
TRANSFERRING(write, pwrite64, (int descriptor, const void* data, size_t size, off64_t at),
             (descriptor, data, count, at))

OPENING(open, (const char* path, int flags, ...), (path, flags, mode))
OPENING(open64, (const char* path, int flags, ...), (path, flags, mode))
OPENING(openat, (int folder, const char* path, int flags, ...), (folder, path, flags, mode))
OPENING(openat64, (int folder, const char* path, int flags, ...), (folder, path, flags, mode))
OPENING_STREAM(fopen)
OPENING_STREAM(fopen64)
FAULTY(open, nullptr, DIR*, opendir, (const char* path), (path))

FAULTY(truncate, -1, int, truncate, (const char* path, off_t length) noexcept, (path, length))
FAULTY(truncate, -1, int, truncate64, (const char* path, off64_t length) noexcept, (path, length))
FAULTY(truncate, -1, int, ftruncate, (int descriptor, off_t length) noexcept, (descriptor, length))
FAULTY(truncate, -1, int, ftruncate64, (int descriptor, off64_t length) noexcept, (descriptor, length))

FAULTY(rename, -1, int, rename, (const char* from, const char* to) noexcept, (from, to))
FAULTY(rename, -1, int, renameat, (int from_folder, const char* from, int to_folder, const char* to) noexcept,
       (from_folder, from, to_folder, to))
FAULTY(rename, -1, int, renameat2,
       (int from_folder, const char* from, int to_folder, const char* to, unsigned int flags) noexcept,
       (from_folder, from, to_folder, to, flags))
FAULTY(link, -1, int, link, (const char* from, const char* to) noexcept, (from, to))
FAULTY(link, -1, int, linkat, (int from_folder, const char* from, int to_folder, const char* to, int flags) noexcept,
       (from_folder, from, to_folder, to, flags))
FAULTY(link, -1, int, symlink, (const char* target, const char* path) noexcept, (target, path))

FAULTY(remove, -1, int, unlink, (const char* path) noexcept, (path))
FAULTY(remove, -1, int, unlinkat, (int folder, const char* path, int flags) noexcept, (folder, path, flags))
FAULTY(remove, -1, int, rmdir, (const char* path) noexcept, (path))
FAULTY(remove, -1, int, remove, (const char* path) noexcept, (path))

FAULTY(mkdir, -1, int, mkdir, (const char* path, mode_t mode) noexcept, (path, mode))
FAULTY(mkdir, -1, int, mkdirat, (int folder, const char* path, mode_t mode) noexcept, (folder, path, mode))
FAULTY(mkdir, nullptr, char*, mkdtemp, (char* pattern) noexcept, (pattern))

FAULTY(stat, -1, int, stat, (const char* path, struct stat* found) noexcept, (path, found))
FAULTY(stat, -1, int, stat64, (const char* path, struct stat64* found) noexcept, (path, found))
FAULTY(stat, -1, int, lstat, (const char* path, struct stat* found) noexcept, (path, found))
FAULTY(stat, -1, int, lstat64, (const char* path, struct stat64* found) noexcept, (path, found))
FAULTY(stat, -1, int, fstat, (int descriptor, struct stat* found) noexcept, (descriptor, found))
FAULTY(stat, -1, int, fstat64, (int descriptor, struct stat64* found) noexcept, (descriptor, found))
FAULTY(stat, -1, int, fstatat, (int folder, const char* path, struct stat* found, int flags) noexcept,
       (folder, path, found, flags))
FAULTY(stat, -1, int, fstatat64, (int folder, const char* path, struct stat64* found, int flags) noexcept,
       (folder, path, found, flags))
FAULTY(stat, -1, int, access, (const char* path, int how) noexcept, (path, how))

FAULTY(list, nullptr, struct dirent*, readdir, (DIR * folder), (folder))
FAULTY(list, nullptr, struct dirent64*, readdir64, (DIR * folder), (folder))
FAULTY(lookup, -1, ssize_t, readlink, (const char* path, char* text, size_t size) noexcept, (path, text, size))
FAULTY(lookup, nullptr, char*, realpath, (const char* path, char* text) noexcept, (path, text))
FAULTY(lookup, nullptr, char*, getcwd, (char* text, size_t size) noexcept, (text, size))
FAULTY(lock, -1, int, flock, (int descriptor, int how) noexcept, (descriptor, how))

pid_t fork() noexcept {
    static const auto call = original<pid_t (*)()>("fork");
    if (next(Kind::spawn) == Fate::fails) {
        return -1;
    }
    const pid_t id = call();
    if (id == 0 && fault() != nullptr) {
        fault()->spare_this_process();
    }
    return id;
}

int fsync(int descriptor) {
    static const auto call = original<int (*)(int)>("fsync");
    if (next(Kind::sync) == Fate::fails || (fault() != nullptr && fault()->is_too_late())) {
        return -1;
    }
    const int result = call(descriptor);
    if (result == 0 && fault() != nullptr) {
        fault()->synced(descriptor);
    }
    return result;
}

int close(int descriptor) {
    static const auto call = original<int (*)(int)>("close");
    const int flags = ::fcntl(descriptor, F_GETFL);
    const int result = call(descriptor);  // also where it fails the descriptor is gone
    const bool written = flags >= 0 && (flags & O_ACCMODE) != O_RDONLY && descriptor > STDERR_FILENO;
    if (!written) {
        return result;
    }
    return next(Kind::close) == Fate::fails || (fault() != nullptr && fault()->is_too_late()) ? -1 : result;
}

int clock_gettime(clockid_t clock, struct timespec* now) noexcept {
    static const auto call = original<int (*)(clockid_t, struct timespec*)>("clock_gettime");
    const int result = call(clock, now);
    if (clock == CLOCK_REALTIME && fault() != nullptr) {
        now->tv_sec += fault()->clock_jump();
    }
    return result;
}

}  // extern "C"
