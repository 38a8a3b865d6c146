#pragma once

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ljmd/core/errors.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

class GzipInput;

/// A file holds a number that is not finite, or an atom so far away that its place is lost: it was written as it is to
/// be, by a program that had lost its atoms.
class NotFinite : public DataError {
  public:
    using DataError::DataError;
};

/// A text file that is read line by line. Its error messages begin with file and line: "start.xyz:17: frame 2: ...".
///
/// Lines end in LF or CRLF; the last one may have no end. A UTF-8 byte order mark is skipped. A file compressed with
/// gzip is unpacked while it is read; more than 100 times its size plus 16 MiB is refused. One line is in memory at a
/// time; lines of more than `longest_line` bytes are refused.
class TextFile {
  public:
    static constexpr std::size_t longest_line = 65536;

    /// Open a regular file. Nothing else is opened, because a pipe or a device could block.
    /// @throws DataError when it is missing, not a regular file, or cannot be opened or read
    explicit TextFile(const std::filesystem::path& path);
    ~TextFile();

    /// Read the next line. @return false at the end of the file; line_number() is then unchanged
    /// @throws DataError when the line is too long, the file cannot be read, or it is not text (see why_no_text())
    bool next_line();

    /// Whether the end of the file was reached, by the last read or within the current line. A program that is killed
    /// while it writes leaves a last line without an end.
    [[nodiscard]] bool is_cut() const;

    /// Return to the start: the next line is line 1.
    void rewind();

    [[nodiscard]] std::string_view line() const { return line_; }     ///< without its line end; valid until next_line()
    [[nodiscard]] Index line_number() const { return line_number_; }  ///< from 1; 0 before the first line

    /// Text for messages between line number and message from now on, "frame 2: ".
    void set_context(std::string context) { context_ = std::move(context); }

    /// Bytes after the current line; for a compressed file, an upper bound.
    [[nodiscard]] Index bytes_left() const { return bytes_left_; }

    /// Check that the rest of the file is long enough for this many atoms, one per line.
    /// @throws DataError with the count and the number of non-blank lines that follow
    void require_room(Index atoms);

    /// @throws DataError always: at the current line, or at the given one (0: for the whole file)
    [[noreturn]] void fail(const std::string& message) const { fail_at(line_number_, message); }
    [[noreturn]] void fail_at(Index line, const std::string& message) const;
    /// @throws NotFinite always
    [[noreturn]] void fail_as_lost_at(Index line, const std::string& message) const;

    /// The number in a field. `what` names it in the message: "x must be a finite number, found 'a'".
    /// @throws DataError when the field is not a number, not finite (NotFinite), or out of the range of the type
    [[nodiscard]] double number(std::string_view field, std::string_view what) const;
    [[nodiscard]] Index integer(std::string_view field, std::string_view what) const;

  private:
    [[nodiscard]] std::string at(Index line, const std::string& message) const;

    std::string name_;
    std::ifstream file_;
    std::unique_ptr<GzipInput> gzip_;  ///< null for a file that is not compressed
    std::istream stream_{nullptr};     ///< the text, unpacked
    std::string no_text_;              ///< why the file is not text; empty when it is
    std::vector<char> buffer_;
    std::string_view line_;
    std::string context_;
    Index line_number_ = 0;
    Index bytes_left_ = 0;
    Index size_ = 0;
};

/// Split at spaces and tabs; `fields` is overwritten (and reused, so that reading a line allocates nothing).
void split_fields(std::string_view text, std::vector<std::string_view>& fields);

/// True when the text has only spaces and tabs.
[[nodiscard]] bool is_blank(std::string_view text);

/// True when the whole field is a number, even infinite or out of range. Exponents may be Fortran's: 1.5D+02.
[[nodiscard]] bool is_number(std::string_view field);

/// The number in a field that nobody relies on; NaN for anything that is no number.
[[nodiscard]] double number_or_nan(std::string_view field);

/// A text with its letters from A to Z in lower case.
[[nodiscard]] std::string lower_case(std::string_view text);

/// A piece of a file for messages: in quotes, unprintable bytes as \xNN, cut after 40 bytes.
[[nodiscard]] std::string shown(std::string_view text);

}  // namespace ljmd
