#pragma once

#include <string>
#include <vector>

namespace ljmd {

/// Remarks on numbers in a table, listed once each below it.
class Footnotes {
  public:
    /// The mark beside the number that a remark is about, such as "[1]"; empty for an empty remark.
    [[nodiscard]] std::string mark(const std::string& remark);

    /// A paragraph "  [1] ..." for each remark, in lines that fit the screen.
    [[nodiscard]] std::string text() const;

  private:
    std::vector<std::string> remarks_;
};

}  // namespace ljmd
