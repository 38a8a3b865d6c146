#pragma once

#include <memory>
#include <string>
#include <vector>

namespace ljmd {

/// A text that values were read from: a deck, or the argument of one `--set`.
struct Source {
    std::string name;  ///< file name as the user gave it, or "--set key=value"
    std::string text;  ///< the whole text, so that a message can show the line
};

/// Where in a source a key or a value stands.
struct Location {
    std::shared_ptr<const Source> source;  ///< null: no text to point at (a default)
    int line = 0;                          ///< from 1; 0: the source as a whole
    int column = 0;                        ///< from 1, in characters
    int length = 1;                        ///< characters to underline
};

enum class Severity { warning, error };

/// One mistake or doubt, tied to a place.
struct Diagnostic {
    Severity severity;
    Location location;
    std::string message;  ///< one line: key, what was found, what is allowed
    std::string hint;     ///< shown behind the underline, e.g. "did you mean 'density'?"; may be empty
};

/// Collects every mistake in the input, so that all of them are reported at once.
class Diagnostics {
  public:
    void error(Location location, std::string message, std::string hint = {});
    void warning(Location location, std::string message, std::string hint = {});

    [[nodiscard]] bool has_errors() const;
    [[nodiscard]] const std::vector<Diagnostic>& entries() const { return entries_; }

    /// Throw InputError with all errors, one under the other in the order of the text, and the closing line
    /// "n error(s). Nothing was run."; of more than 50 errors the first 50 are shown and the others counted.
    /// Does nothing when there are only warnings.
    void throw_if_errors() const;

  private:
    std::vector<Diagnostic> entries_;
};

/// One diagnostic as a user reads it:
///
///     error: argon.toml:7:1: unknown key 'densty' in [system]
///       7 | densty = 0.8442
///         | ^^^^^^ did you mean 'density'?
///
/// Tabs in the line are shown as one space, other control characters and invalid UTF-8 as '?' (no escape sequence
/// reaches a terminal); lines longer than 160 characters are cut around the column, messages behind 400 characters.
/// A place without a line (a source as a whole, a `--set`) has no excerpt, and the hint stands on a line of its own:
///
///     error: --set system.densty=0.8: unknown key 'densty' in [system]
///       did you mean 'density'?
[[nodiscard]] std::string format(const Diagnostic& diagnostic);

/// Of `candidates`, the one nearest to `name` by optimal string alignment (insert, delete, replace, swap), or an empty
/// string when none is near (distance more than a third of the longer word, rounded up; words of more than 64 bytes are
/// near to nothing). Of equally near ones the first.
[[nodiscard]] std::string nearest_name(const std::string& name, const std::vector<std::string>& candidates);

}  // namespace ljmd
