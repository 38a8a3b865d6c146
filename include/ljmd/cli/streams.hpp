#pragma once

#include <string>

#include "ljmd/core/diagnostics.hpp"

namespace ljmd {

/// Make stdin, stdout and stderr safe to use. Call it once, before any file is opened.
///
/// A standard stream that was closed before the start is given a place, so that no output file can take its number and
/// receive what was meant for a terminal; writing results to it fails. A reader that goes away, or
/// a file-size limit, no longer ends the program in the middle of a run: the write fails, and is reported.
void prepare_standard_streams();

// What these functions write may hold names of files, titles and words of other programs. No control character of
// theirs but the end of a line and the tab reaches a terminal, nor what is no UTF-8: '?' stands in its place.

/// Print results to stdout.
/// @throws FileError when they do not arrive. If the reader has gone away (`ljmd info | head -1`) the program ends
/// here, quietly, by SIGPIPE, as filters do.
void print_result(const std::string& text);

/// Say something to the user on stderr. That nobody listens is no reason to stop.
void talk(const std::string& text) noexcept;

/// The same for a warning, of one line.
void warn(const std::string& text) noexcept;

/// Write over the line of the terminal that the cursor is in. An empty text clears it.
void talk_over_line(const std::string& text) noexcept;

/// Say what is to be warned of.
void talk_of_warnings(const Diagnostics& diagnostics);

}  // namespace ljmd
