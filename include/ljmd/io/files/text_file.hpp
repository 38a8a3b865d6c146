#pragma once

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ljmd/core/types.hpp"

namespace ljmd {

class GzipInput;

/// A text file that is read line by line, and that words every complaint about itself: "start.xyz:17: frame 2: ...".
///
/// Lines end in LF or CRLF, the last one possibly in nothing; a UTF-8 byte order mark at the start is dropped. A file
/// that is compressed with gzip is unpacked while it is read, to at most 100 times its size and 16 MiB: more is
/// refused. One line is in memory at a time; lines of more than `longest_line` bytes are refused.
class TextFile {
  public:
    static constexpr std::size_t longest_line = 65536;

    /// Open a regular file. Nothing else is opened, so that a pipe or a device cannot block.
    /// @throws DataError when it is missing, a directory, a pipe, a device, or cannot be opened
    explicit TextFile(const std::filesystem::path& path);
    ~TextFile();

    /// Go to the next line. @return false at the end of the file; line_number() then stays.
    /// @throws DataError when the line is too long, the file cannot be read, or is no text (see why_no_text())
    bool next_line();

    /// Whether the file has ended: behind its last line, or in it where that has no end, as when a program was killed
    /// while it wrote.
    [[nodiscard]] bool is_cut() const;

    /// Back to the start: the next line is line 1.
    void rewind();

    [[nodiscard]] std::string_view line() const { return line_; }     ///< without its end; valid until next_line()
    [[nodiscard]] Index line_number() const { return line_number_; }  ///< from 1; 0 before the first line

    /// What stands between line number and message from now on, "frame 2: ".
    void set_context(std::string context) { context_ = std::move(context); }

    /// Behind the current line; of a compressed file how many there can be at most.
    [[nodiscard]] Index bytes_left() const { return bytes_left_; }

    /// Refuse a number of atoms, one a line, for which the rest of the file is too short whatever it holds.
    /// @throws DataError with the count and the number of lines, not counting blank ones, that follow
    void require_room(Index atoms);

    /// @throws DataError always: at the current line, or at the given one (0: the file as a whole)
    [[noreturn]] void fail(const std::string& message) const { fail_at(line_number_, message); }
    [[noreturn]] void fail_at(Index line, const std::string& message) const;

    /// The number that a field holds, all of it. `what` names it in the message: "x must be a finite number, found
    /// 'a'".
    /// @throws DataError when it is no number, not finite, or beyond the range of the type
    [[nodiscard]] double number(std::string_view field, std::string_view what) const;
    [[nodiscard]] Index integer(std::string_view field, std::string_view what) const;

  private:
    std::string name_;
    std::ifstream file_;
    std::unique_ptr<GzipInput> gzip_;  ///< nothing where the file is not compressed
    std::istream stream_{nullptr};     ///< the text
    std::string no_text_;              ///< why it is none
    std::vector<char> buffer_;
    std::string_view line_;
    std::string context_;
    Index line_number_ = 0;
    Index bytes_left_ = 0;
    Index size_ = 0;
};

/// Split at spaces and tabs; `fields` is overwritten (and reused, so that reading a line allocates nothing).
void split_fields(std::string_view text, std::vector<std::string_view>& fields);

/// True when there is nothing but spaces and tabs.
[[nodiscard]] bool is_blank(std::string_view text);

/// True when the whole field is a number, finite or not, in range or not. Exponents may have the D of Fortran: 1.5D+02.
[[nodiscard]] bool is_number(std::string_view field);

/// A piece of a file as messages show it: in quotes, bytes that do not print as \xNN, cut after 40 bytes.
[[nodiscard]] std::string shown(std::string_view text);

}  // namespace ljmd
