#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "core/document.hpp"
#include "ljmd/detail/options/diagnostics.hpp"

namespace ljmd {

/// Make stdin, stdout and stderr safe to use. Call it once, before any file is opened.
///
/// A standard stream that was closed before the start is opened on /dev/null, so that no output file can get its number
/// and receive messages for a terminal; writing results to it fails. A reader that goes away, or a file-size limit,
/// does not end the program in the middle of a run: the write fails and is reported.
void prepare_standard_streams();

// The text for these functions may contain names of files, titles and output of other programs. Control characters,
// except line ends and tabs, and invalid UTF-8 never reach a terminal; '?' replaces them.

/// Print results to stdout. If the reader has gone away (`ljmd info | head -1`), the program ends here silently by
/// SIGPIPE, as filters do.
/// @throws FileError when the results cannot be written
void print_result(const std::string& text);

/// Print a report as text or as JSON, as print_result().
void print_document(const Document& document, bool as_json);

/// The end of a report: where its files are, and how to draw them.
[[nodiscard]] std::string told_files(const std::filesystem::path& directory);

/// Print a message to stderr. Errors are ignored.
void print_message(const std::string& text) noexcept;

/// Print a warning of one line to stderr.
void warn(const std::string& text) noexcept;

/// Width of the terminal that messages go to, as it is now; nothing if they go to no terminal, or to one that cannot
/// move its cursor (TERM=dumb). A terminal that does not know its width has 80 columns.
[[nodiscard]] std::optional<std::size_t> message_columns();

/// Width of the terminal that results go to; nothing if they go to no terminal: a file or a pipe gets tables in full.
[[nodiscard]] std::optional<std::size_t> result_columns();

/// Whether messages and results go to one terminal, where both are read.
[[nodiscard]] bool messages_stand_beside_results();

/// Replace the terminal line at the cursor, and leave the cursor at its beginning: a terminal that is made narrower
/// wraps the line or cuts it, and in both cases it begins at the cursor. An empty text clears the line.
/// @pre the text is shorter than the line
void talk_over_line(const std::string& text);

/// Print the warnings among the diagnostics.
void print_warnings(const Diagnostics& diagnostics);

}  // namespace ljmd
