#pragma once

#include <vector>

#include "ljmd/report/page_content.hpp"

namespace ljmd {

/// One page that compares others: their quantities side by side, their g(r) in one chart, and each of them.
/// @pre there are at least two members
[[nodiscard]] PageContent set_page(std::vector<PageContent> members);

}  // namespace ljmd
