#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "io/files/open_directory.hpp"

namespace ljmd {

class ReplacementFile;

/// A file being written, with every call checked. A full disk, a file-size limit or a failing device becomes a
/// FileError that names file and cause.
///
/// Writes are buffered; flush() hands them to the system. When a write fails, the file is cut back to its length at the
/// last successful flush(), so that it never ends within a line. After that every call throws.
class OutputFile {
  public:
    /// Create the file, emptying it if it exists; or continue an existing one. Links are not followed.
    /// @param kept  bytes of an existing file to keep, as returned by commit(); the rest is cut off
    /// @throws FileError
    /// @throws CheckpointError when the file to continue is missing, not a regular file, or shorter than `kept`
    explicit OutputFile(OutputPlace place, std::optional<std::int64_t> kept = std::nullopt);

    /// Write to a replacement file; messages name the file that it will replace. @throws FileError
    explicit OutputFile(const ReplacementFile& file);

    OutputFile(OutputFile&& other) noexcept;
    OutputFile& operator=(OutputFile&&) = delete;
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    /// Writes what is still buffered, but cannot report an error: call close() first.
    ~OutputFile();

    /// Append text. @throws FileError
    void write(std::string_view text);

    /// Hand everything written so far to the system: it then survives a kill of this process. @throws FileError
    void flush();

    /// flush(), then wait until the data are on the disk: they then survive a power cut. @throws FileError
    void sync();

    /// sync(). @return length of the file in bytes  @throws FileError
    std::int64_t commit();

    /// Read back what was flushed. @param look  gets it piece by piece  @throws FileError
    void read_back(const std::function<void(std::string_view)>& look) const;

    /// flush() and close. Does nothing when closed. @throws FileError
    void close();

    /// sync() and close. Does nothing when closed. @throws FileError
    void close_on_disk();

    [[nodiscard]] std::filesystem::path path() const { return place_.path(); }

  private:
    void open(const OutputPlace& place, std::optional<std::int64_t> kept);
    void require_usable() const;
    void spill();
    [[noreturn]] void fail(const char* doing, int error);

    OutputPlace place_;  // the name used in messages
    std::string buffer_;
    int descriptor_ = -1;
    bool failed_ = false;
    std::int64_t written_ = 0;    // bytes in the file
    std::int64_t committed_ = 0;  // bytes in the file at the last flush
};

/// Check that a file can be continued: it exists, is a regular file and has at least this many bytes.
/// @throws CheckpointError
void require_bytes(const OutputPlace& place, std::int64_t bytes);

/// Overwrite the first bytes of an existing file and keep the rest. Links are not followed. @throws FileError
void overwrite_beginning(const OutputPlace& place, std::string_view bytes);

}  // namespace ljmd
