#include "ljmd/io/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "ljmd/core/errors.hpp"
#include "ljmd/io/file_system.hpp"

namespace ljmd {

namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 16;

FileError file_error(const char* doing, const std::filesystem::path& path, int error) {
    return FileError(fmt::format("cannot {} '{}': {}", doing, path.string(), std::generic_category().message(error)));
}

/// fsync; 0 or the error number. Pipes and devices cannot be synced, which is no failure.
int sync_descriptor(int descriptor) {
    if (::fsync(descriptor) == 0 || errno == EINVAL || errno == EROFS || errno == ENOTSUP) {
        return 0;
    }
    return errno;
}

}  // namespace

void require_bytes(const std::filesystem::path& path, std::int64_t bytes) {
    const std::filesystem::file_type type = files::type_of(path);
    if (type == std::filesystem::file_type::not_found) {
        throw CheckpointError(fmt::format("'{}' is not there any more", path.string()));
    }
    if (type != std::filesystem::file_type::regular) {  // a link leads elsewhere, opening a pipe would wait for ever
        throw CheckpointError(fmt::format("'{}' is not the file that the run wrote", path.string()));
    }
    const auto size = static_cast<std::int64_t>(files::size_of(path).value_or(0));
    if (size < bytes) {
        throw CheckpointError(
            fmt::format("'{}' has {} bytes, but had {} when the checkpoint was written", path.string(), size, bytes));
    }
}

OutputFile::OutputFile(std::filesystem::path path, std::optional<std::int64_t> kept) : path_(std::move(path)) {
    constexpr mode_t permissions = 0666;  // less what the user's umask takes away
    if (kept) {
        require_bytes(path_, *kept);
    }
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC | (kept ? 0 : O_CREAT | O_TRUNC), permissions);
    if (descriptor_ < 0) {
        throw file_error(kept ? "open" : "create", path_, errno);
    }
    if (kept) {
        written_ = committed_ = *kept;
        if (::ftruncate(descriptor_, *kept) != 0 || ::lseek(descriptor_, *kept, SEEK_SET) != *kept) {
            const int error = errno;
            ::close(descriptor_);
            throw file_error("cut", path_, error);
        }
    }
    buffer_.reserve(buffer_size);
}

OutputFile::OutputFile(OutputFile&& other) noexcept
    : path_(std::move(other.path_)),
      buffer_(std::exchange(other.buffer_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)),
      failed_(other.failed_),
      written_(other.written_),
      committed_(other.committed_) {}

OutputFile::~OutputFile() {
    try {
        close();
    } catch (const FileError&) {  // a destructor has nobody to tell
    }
}

void OutputFile::require_usable() const {
    if (failed_) {
        throw FileError(fmt::format("cannot write '{}': an earlier write failed", path_.string()));
    }
    if (descriptor_ < 0) {
        throw ContractViolation(fmt::format("'{}' is closed", path_.string()));
    }
}

void OutputFile::fail(const char* doing, int error) {
    failed_ = true;
    buffer_.clear();
    // Best effort: a device has no length to cut, and the first error is the one worth telling.
    [[maybe_unused]] const int ignored = ::ftruncate(descriptor_, committed_);
    throw file_error(doing, path_, error);
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
    // After EINTR the descriptor is gone on Linux: closing again could hit another file.
    if (::close(std::exchange(descriptor_, -1)) != 0 && errno != EINTR) {
        failed_ = true;
        throw file_error("close", path_, errno);
    }
}

TemporaryName::TemporaryName(std::filesystem::path path) : path_(std::move(path)), name_(path_) {
    // A fixed name: what a killed program left behind is replaced by the next write. It is removed first, so that a
    // link of that name is never followed.
    name_ += ".tmp";
    remove();
}

TemporaryName::~TemporaryName() {
    if (!taken_) {
        remove();
    }
}

void TemporaryName::remove() const {
    files::try_to_remove(name_);
}

void TemporaryName::take_place() {
    if (::rename(name_.c_str(), path_.c_str()) != 0) {
        throw file_error("replace", path_, errno);
    }
    taken_ = true;
    sync_folder_of(path_);
}

void write_file_atomically(const std::filesystem::path& path, const std::function<void(OutputFile&)>& fill) {
    TemporaryName temporary(path);
    OutputFile file(temporary.name());
    fill(file);
    file.sync();
    file.close();
    temporary.take_place();
}

void write_file_atomically(const std::filesystem::path& path, std::string_view text) {
    write_file_atomically(path, [text](OutputFile& file) { file.write(text); });
}

void sync_path(const std::filesystem::path& path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) {
        throw file_error("open", path, errno);
    }
    const int error = sync_descriptor(descriptor);
    ::close(descriptor);
    if (error != 0) {
        throw file_error("write", path, error);
    }
}

void sync_folder_of(const std::filesystem::path& path) {
    sync_path(path.has_parent_path() ? path.parent_path() : ".");
}

}  // namespace ljmd
