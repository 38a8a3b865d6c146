#pragma once

#include <memory>
#include <string>
#include <vector>

namespace ljmd {

/// A text that values are read from: a deck, or the argument of a `--set`.
struct Source {
    std::string name;  ///< file name as the user gave it, or "--set key=value"
    std::string text;  ///< the whole text, so that a message can show the line
};

/// Place of a key or value in a source.
struct Location {
    std::shared_ptr<const Source> source;  ///< null for a default, which has no place
    int line = 0;                          ///< from 1; 0: the source as a whole
    int column = 0;                        ///< from 1, in characters
    int length = 1;                        ///< characters to underline
};

enum class Severity { warning, error };

/// An error or warning with its place.
struct Diagnostic {
    Severity severity;
    Location location;
    std::string message;  ///< one line: key, what was found, what is allowed
    std::string hint;     ///< shown after the underline, e.g. "did you mean 'density'?"; may be empty
};

/// Collects all mistakes in the input, so that they are reported together.
class Diagnostics {
  public:
    void error(Location location, std::string message, std::string hint = {});
    void warning(Location location, std::string message, std::string hint = {});

    [[nodiscard]] bool has_errors() const;
    [[nodiscard]] const std::vector<Diagnostic>& entries() const { return entries_; }

    /// Throw InputError with all errors in the order of the text, followed by "n error(s). Nothing was run." Of more
    /// than 50 errors the first 50 are shown and the others counted. Warnings alone throw nothing.
    void throw_if_errors() const;

    /// The errors without their places, one a line with its hint, for callers that have no text to point at. Empty if
    /// there are none.
    [[nodiscard]] std::string errors_without_places() const;

  private:
    std::vector<Diagnostic> entries_;
};

/// A diagnostic as the user reads it:
///
///     error: argon.toml:7:1: unknown key 'densty' in [system]
///       7 | densty = 0.8442
///         | ^^^^^^ did you mean 'density'?
///
/// Tabs in the line are shown as a space, other control characters and invalid UTF-8 as '?', so that no escape sequence
/// reaches a terminal. Lines of more than 160 characters are cut around the column, messages after 400 characters. A
/// place without a line (a source as a whole, a `--set`) has no excerpt, and the hint has a line of its own:
///
///     error: --set system.densty=0.8: unknown key 'densty' in [system]
///       did you mean 'density'?
[[nodiscard]] std::string format(const Diagnostic& diagnostic);

/// The candidate nearest to `name` by optimal string alignment (insert, delete, replace, swap), the first one of
/// several; empty if none is near. Near means a distance of at most a third of the longer word, rounded up. Words of
/// more than 64 bytes are near to nothing.
[[nodiscard]] std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace ljmd
