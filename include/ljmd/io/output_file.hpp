#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace ljmd {

/// A text file being written, every call of which is checked. Nothing is lost in silence: a full disk, a file-size
/// limit or a failing device becomes a FileError that names the file and the cause.
///
/// Writes are collected and reach the file at flush(). When a write fails, the file is cut back to its length at the
/// last successful flush(), so that it never ends in half a line; after that every call throws.
class OutputFile {
  public:
    /// Create the file, or empty it if it exists; or go on with one that exists.
    /// @param kept  bytes of it that stay, as commit() told them; what is behind is cut off
    /// @throws FileError
    /// @throws CheckpointError when the file to go on with is not there or is shorter
    explicit OutputFile(std::filesystem::path path, std::optional<std::int64_t> kept = std::nullopt);

    OutputFile(OutputFile&& other) noexcept;
    OutputFile& operator=(OutputFile&&) = delete;
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Writes what is still collected, but cannot report an error: call close() first.
    ~OutputFile();

    /// Append text. @throws FileError
    void write(std::string_view text);

    /// Hand everything written so far to the operating system: it survives a kill of this process. @throws FileError
    void flush();

    /// flush(), then wait until it is on the disk: it survives a power cut. @throws FileError
    void sync();

    /// sync(). @return bytes in the file
    std::int64_t commit();

    /// flush() and close. A second call does nothing. @throws FileError
    void close();

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    void require_usable() const;
    void spill();
    [[noreturn]] void fail(const char* doing, int error);

    std::filesystem::path path_;
    std::string buffer_;
    int descriptor_ = -1;
    bool failed_ = false;
    std::int64_t written_ = 0;    // bytes in the file
    std::int64_t committed_ = 0;  // bytes in the file at the last flush
};

/// Refuse to go on with a file that is not there, is no regular file or has fewer bytes. Changes nothing.
/// @throws CheckpointError; FileError when that cannot be told
void require_bytes(const std::filesystem::path& path, std::int64_t bytes);

/// The name `PATH.tmp` of a file that is to take the place of PATH. A file of that name is removed at the beginning,
/// and at the end unless it has taken its place.
class TemporaryName {
  public:
    explicit TemporaryName(std::filesystem::path path);
    ~TemporaryName();
    TemporaryName(const TemporaryName&) = delete;
    TemporaryName& operator=(const TemporaryName&) = delete;

    [[nodiscard]] const std::filesystem::path& name() const { return name_; }

    /// From now on the file is PATH: rename, fsync of the folder. @pre the file is on the disk  @throws FileError
    void take_place();

  private:
    void remove() const;

    std::filesystem::path path_;
    std::filesystem::path name_;
    bool taken_ = false;
};

/// Write a whole file so that a reader finds either the old one or the new one: temporary name `PATH.tmp` in the same
/// folder, fsync, rename, fsync of the folder. On failure `path` is untouched and the temporary file is removed.
/// @throws FileError, and whatever `fill` throws
void write_file_atomically(const std::filesystem::path& path, const std::function<void(OutputFile&)>& fill);
void write_file_atomically(const std::filesystem::path& path, std::string_view text);

/// fsync a file or a folder by name. @throws FileError
void sync_path(const std::filesystem::path& path);

/// fsync the folder that a file is in, so that the file's name survives a power cut. @throws FileError
void sync_folder_of(const std::filesystem::path& path);

}  // namespace ljmd
