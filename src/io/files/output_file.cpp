#include "io/files/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "io/files/file_calls.hpp"
#include "io/files/replacement_file.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 16;

}  // namespace

void require_bytes(const OutputPlace& place, std::int64_t bytes) {
    struct stat status {};
    if (::fstatat(place.directory.descriptor(), place.name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) {
        throw CheckpointError(errno == ENOENT ? fmt::format("'{}' is not there any more", place.path().string())
                                              : file_error("look at", place.path(), errno).what());
    }
    if (!S_ISREG(status.st_mode)) {  // a link leads elsewhere, and opening a pipe could block
        throw CheckpointError(fmt::format("'{}' is not the file that the run wrote", place.path().string()));
    }
    if (status.st_size < bytes) {
        throw CheckpointError(fmt::format("'{}' has {} bytes, but had {} when the checkpoint was written",
                                          place.path().string(), status.st_size, bytes));
    }
}

void overwrite_beginning(const OutputPlace& place, std::string_view bytes) {
    const int descriptor =
        ::openat(place.directory.descriptor(), place.name.c_str(), O_WRONLY | O_CLOEXEC | O_NOFOLLOW);
    if (descriptor < 0) {
        throw file_error("open", place.path(), errno);
    }
    int error = 0;
    while (!bytes.empty() && error == 0) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count >= 0) {
            bytes.remove_prefix(static_cast<std::size_t>(count));
        } else if (errno != EINTR) {
            error = errno;
        }
    }
    ::close(descriptor);
    if (error != 0) {
        throw file_error("write", place.path(), error);
    }
}

void OutputFile::open(const OutputPlace& place, std::optional<std::int64_t> kept) {
    constexpr mode_t permissions = 0666;  // reduced by the umask
    const int flags = O_RDWR | O_NOFOLLOW | O_CLOEXEC | (kept ? 0 : O_CREAT | O_TRUNC);
    descriptor_ = ::openat(place.directory.descriptor(), place.name.c_str(), flags, permissions);
    if (descriptor_ < 0) {
        throw file_error(kept ? "open" : "create", path(), errno);
    }
    buffer_.reserve(buffer_size);
}

OutputFile::OutputFile(OutputPlace place, std::optional<std::int64_t> kept) : place_(std::move(place)) {
    if (kept) {
        require_bytes(place_, *kept);
    }
    open(place_, kept);
    if (kept) {
        written_ = committed_ = *kept;
        if (::ftruncate(descriptor_, *kept) != 0 || ::lseek(descriptor_, *kept, SEEK_SET) != *kept) {
            const int error = errno;
            ::close(descriptor_);
            throw file_error("cut", path(), error);
        }
    }
}

OutputFile::OutputFile(const ReplacementFile& file) : place_(file.place()) {
    open(file.growing(), std::nullopt);
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : place_(std::move(other.place_)),
      buffer_(std::exchange(other.buffer_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)),
      failed_(other.failed_),
      written_(other.written_),
      committed_(other.committed_) {}

OutputFile::~OutputFile() {
    try {
        close();
    } catch (const FileError&) {  // a destructor cannot report it
    }
}

void OutputFile::require_usable() const {
    if (failed_) {
        throw FileError(fmt::format("cannot write '{}': an earlier write failed", path().string()));
    }
    if (descriptor_ < 0) {
        throw ContractViolation(fmt::format("'{}' is closed", path().string()));
    }
}

void OutputFile::fail(const char* doing, int error) {
    failed_ = true;
    buffer_.clear();
    // Best effort: a device cannot be cut, and the first error is the one to report.
    [[maybe_unused]] const int ignored = ::ftruncate(descriptor_, committed_);
    throw file_error(doing, path(), error);
}

void OutputFile::spill() {
    std::string_view rest = buffer_;
    while (!rest.empty()) {
        const ssize_t count = ::write(descriptor_, rest.data(), rest.size());
        if (count >= 0) {
            rest.remove_prefix(static_cast<std::size_t>(count));
            written_ += count;
        } else if (errno != EINTR) {
            fail("write", errno);
        }
    }
    buffer_.clear();
}

void OutputFile::write(std::string_view text) {
    require_usable();
    buffer_.append(text);
    if (buffer_.size() >= buffer_size) {
        spill();
    }
}

void OutputFile::flush() {
    require_usable();
    spill();
    committed_ = written_;
}

void OutputFile::sync() {
    flush();
    if (const int error = sync_descriptor(descriptor_); error != 0) {
        fail("write", error);
    }
}

std::int64_t OutputFile::commit() {
    sync();
    return committed_;
}

void OutputFile::read_back(const std::function<void(std::string_view)>& look) const {
    std::string piece(std::size_t{1} << 20, '\0');
    std::int64_t from = 0;
    for (;;) {
        const ssize_t count = ::pread(descriptor_, piece.data(), piece.size(), static_cast<off_t>(from));
        if (count == 0) {
            return;
        }
        if (count > 0) {
            look(std::string_view(piece).substr(0, static_cast<std::size_t>(count)));
            from += count;
        } else if (errno != EINTR) {
            throw file_error("read back", path(), errno);
        }
    }
}

void OutputFile::close() {
    if (descriptor_ < 0) {
        return;
    }
    try {
        flush();
    } catch (const FileError&) {
        ::close(std::exchange(descriptor_, -1));
        throw;
    }
    // After EINTR the descriptor is already closed on Linux; closing it again could hit another file.
    if (::close(std::exchange(descriptor_, -1)) != 0 && errno != EINTR) {
        failed_ = true;
        throw file_error("close", path(), errno);
    }
}

void OutputFile::close_on_disk() {
    if (descriptor_ >= 0) {
        sync();
        close();
    }
}

}  // namespace ljmd
