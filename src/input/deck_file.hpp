#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "ljmd/detail/options/diagnostics.hpp"
#include "ljmd/detail/options/value.hpp"

namespace ljmd {

/// A deck file: its text and its parsed contents.
struct DeckFile {
    std::shared_ptr<const Source> source;  ///< never null; the text without a byte order mark
    Table table;                           ///< empty after an error
};

/// Read a deck: TOML 1.0, UTF-8, at most 1 MiB; a byte order mark and CRLF are accepted.
///
/// Throws nothing: every mistake is reported as one error, with line and column where there is one. Mistakes are: a
/// path that is missing, not a regular file or unreadable; a text that is too large, binary, not UTF-8, nested deeper
/// than 32 levels, not TOML, or without any key. Report errors before validating the table: after an error it is empty.
///
/// @param path  shown in messages as given
[[nodiscard]] DeckFile read_deck(const std::filesystem::path& path, Diagnostics& diagnostics);

/// The same for a text in memory.
[[nodiscard]] DeckFile parse_deck(std::string name, std::string text, Diagnostics& diagnostics);

}  // namespace ljmd
