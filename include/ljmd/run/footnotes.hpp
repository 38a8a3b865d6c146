#pragma once

#include <string>
#include <vector>

namespace ljmd {

/// Remarks on numbers in a table, each told once below it.
class Footnotes {
  public:
    /// What stands beside the number that the remark is about, such as "[1]"; nothing for an empty remark.
    [[nodiscard]] std::string mark(const std::string& remark);

    /// "  [1] ..." and a line break for each remark.
    [[nodiscard]] std::string text() const;

  private:
    std::vector<std::string> remarks_;
};

}  // namespace ljmd
