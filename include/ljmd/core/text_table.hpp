#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace ljmd {

/// A table for the eye whose columns never touch, however long an entry is: a column is as wide as its longest entry,
/// at least as wide as asked, and two spaces lie between columns. A column of nothing takes no room. Entries are shown
/// as printable() shows them.
class TextTable {
  public:
    enum class Align { left, right };

    struct Column {
        std::string heading;
        Align align = Align::right;
        std::size_t width = 0;  ///< characters, at least
    };

    /// @param indent  spaces before each line
    explicit TextTable(std::vector<Column> columns, std::size_t indent = 0);

    /// Add a row; columns behind its last entry stay empty.
    /// @throws ContractViolation  for more entries than there are columns
    void add(const std::vector<std::string>& entries);

    /// The headings, unless all are empty, and the rows, each with a line end and no blanks before it.
    [[nodiscard]] std::string text() const;

  private:
    struct Entry {
        std::string shown;
        std::size_t characters;
    };

    [[nodiscard]] static Entry entry_of(const std::string& text);

    std::vector<Align> aligned_;
    std::vector<std::size_t> widths_;
    std::vector<std::vector<Entry>> rows_;  ///< the first one holds the headings
    std::size_t indent_;
};

}  // namespace ljmd
