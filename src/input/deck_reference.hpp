#pragma once

#include <string>

#include "ljmd/detail/options/schema.hpp"

namespace ljmd {

/// One section of the reference page in Markdown: a heading with the title, a table
/// | key | type | unit | allowed | default | meaning |, then a section one level deeper for each inner table.
///
/// The column `default` says "required", the default value, or what happens without the key.
///
/// @param heading_level  number of '#', 1 to 6; inner tables do not go deeper than 6
[[nodiscard]] std::string schema_markdown(const Schema& schema, int heading_level);

}  // namespace ljmd
