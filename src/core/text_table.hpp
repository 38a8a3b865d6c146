#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace ljmd {

/// A table for people. Each column is as wide as its longest entry and at least as wide as requested; spaces separate
/// columns. Empty columns take no room. Entries are shown as by printable().
class TextTable {
  public:
    enum class Align { left, right };

    struct Column {
        std::string heading;
        Align align = Align::right;
        std::size_t width = 0;  ///< smallest width in characters
        std::size_t gap = 2;    ///< spaces before it
    };

    /// @param indent  number of spaces before each line
    explicit TextTable(std::vector<Column> columns, std::size_t indent = 0);

    /// Add a row; columns after its last entry stay empty.
    /// @throws ContractViolation if there are more entries than columns
    void add(const std::vector<std::string>& entries);

    /// Characters in its longest line.
    [[nodiscard]] std::size_t columns() const;

    /// Heading line, unless all headings are empty, and rows, without trailing spaces, each with a line end.
    [[nodiscard]] std::string text() const;

    /// The same in lines of at most `columns` characters, as far as the first column can be made narrower: entries that
    /// are then too long for it have lines of their own above their rows.
    [[nodiscard]] std::string text_within(std::size_t columns) const;

  private:
    struct Entry {
        std::string shown;
        std::size_t characters;
    };

    [[nodiscard]] static Entry entry_of(const std::string& text);
    [[nodiscard]] std::string text_of(const std::vector<std::size_t>& widths) const;

    std::vector<Align> aligned_;
    std::vector<std::size_t> gaps_;
    std::vector<std::size_t> widths_;
    std::vector<std::vector<Entry>> rows_;  ///< the first row holds the headings
    std::size_t indent_;
};

/// A mean and its error for two columns, as with_error() has them. The error is "0" if it is 0, and "-" if unknown.
[[nodiscard]] std::pair<std::string, std::string> mean_and_error(double mean, double error);

}  // namespace ljmd
