#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "ljmd/core/diagnostics.hpp"
#include "ljmd/core/value.hpp"

namespace ljmd {

/// A deck as it was read: its text, and what the text holds.
struct DeckFile {
    std::shared_ptr<const Source> source;  ///< never null; the text without a byte order mark
    Table table;                           ///< empty after an error
};

/// Read a deck (TOML 1.0, UTF-8, at most 1 MiB; a byte order mark and CRLF are accepted).
///
/// Nothing is thrown. A path that is missing, a directory, a device or unreadable, a text that is too large, binary, no
/// UTF-8, nested deeper than 32 levels, no TOML, or without any key gives one error, with line and column where there
/// is one. Report errors before validating the table: after one it is empty.
///
/// @param path  shown in messages as it stands
[[nodiscard]] DeckFile read_deck(const std::filesystem::path& path, Diagnostics& diagnostics);

/// The same for a text that is already in memory.
[[nodiscard]] DeckFile parse_deck(std::string name, std::string text, Diagnostics& diagnostics);

}  // namespace ljmd
