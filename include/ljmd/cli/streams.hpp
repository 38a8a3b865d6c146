#pragma once

#include <string>

#include "ljmd/core/diagnostics.hpp"
#include "ljmd/core/document.hpp"

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

/// Print a message to stderr. Errors are ignored.
void print_message(const std::string& text) noexcept;

/// Print a warning of one line to stderr.
void warn(const std::string& text) noexcept;

/// Replace the terminal line at the cursor. An empty text clears it.
void talk_over_line(const std::string& text) noexcept;

/// Print the warnings among the diagnostics.
void print_warnings(const Diagnostics& diagnostics);

}  // namespace ljmd
