#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "ljmd/io/files/open_directory.hpp"

namespace ljmd {

class ReplacementFile;

/// A text file being written, every call of which is checked. Nothing is lost in silence: a full disk, a file-size
/// limit or a failing device becomes a FileError that names the file and the cause.
///
/// Writes are collected and reach the file at flush(). When a write fails, the file is cut back to its length at the
/// last successful flush(), so that it never ends in half a line; after that every call throws.
class OutputFile {
  public:
    /// Create the file, or empty it if it exists; or go on with one that exists. No link is followed.
    /// @param kept  bytes of it that stay, as commit() told them; what is behind is cut off
    /// @throws FileError
    /// @throws CheckpointError when the file to go on with is not there or is shorter
    explicit OutputFile(OutputPlace place, std::optional<std::int64_t> kept = std::nullopt);

    /// Write to a file that is to take the place of another one, which messages name. @throws FileError
    explicit OutputFile(const ReplacementFile& file);

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

    /// Whether the file holds these bytes from there on. @pre they were flushed  @throws FileError
    [[nodiscard]] bool holds(std::string_view bytes, std::int64_t from) const;

    /// flush() and close. A second call does nothing. @throws FileError
    void close();

    /// sync() and close. A second call does nothing. @throws FileError
    void close_on_disk();

    [[nodiscard]] std::filesystem::path path() const { return place_.path(); }

  private:
    void open(const OutputPlace& place, std::optional<std::int64_t> kept);
    void require_usable() const;
    void spill();
    [[noreturn]] void fail(const char* doing, int error);

    OutputPlace place_;  // that messages name
    std::string buffer_;
    int descriptor_ = -1;
    bool failed_ = false;
    std::int64_t written_ = 0;    // bytes in the file
    std::int64_t committed_ = 0;  // bytes in the file at the last flush
};

/// Refuse to go on with a file that is not there, is no regular file or has fewer bytes. Changes nothing.
/// @throws CheckpointError
void require_bytes(const OutputPlace& place, std::int64_t bytes);

/// Write over the first bytes of a file that is there, and leave the rest. No link is followed. @throws FileError
void overwrite_beginning(const OutputPlace& place, std::string_view bytes);

}  // namespace ljmd
