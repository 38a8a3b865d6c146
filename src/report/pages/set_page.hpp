#pragma once

#include <vector>

#include "report/page_content.hpp"

namespace ljmd {

/// One page of several, each with a label; the script of the page puts their quantities side by side and draws charts
/// with the same id in one.
/// @pre there are at least two members
[[nodiscard]] PageContent set_page(std::vector<PageContent> members);

}  // namespace ljmd
