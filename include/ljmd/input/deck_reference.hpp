#pragma once

#include <string>

#include "ljmd/core/schema.hpp"

namespace ljmd {

/// One section of the reference page in Markdown: a heading with the title, a table
/// | key | type | unit | allowed | default | meaning |, and after it one section for each inner table, a level deeper.
///
/// The column `default` says "required", the value that a missing key takes, or what happens without it.
///
/// @param heading_level  number of '#', 1 to 6; inner tables stay at 6 where they would go deeper
[[nodiscard]] std::string schema_markdown(const Schema& schema, int heading_level);

}  // namespace ljmd
