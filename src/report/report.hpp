#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/page_content.hpp"

namespace ljmd {

/// The content of the page about a directory: a run of a fluid or of few bodies (finished or not), a sweep, a
/// reproduced table, or a comparison. Its warnings name the files that could not be read.
/// @throws DataError  for a directory of another kind
[[nodiscard]] PageContent report_on(const std::filesystem::path& directory);

/// The content of one page about several directories. A single directory gives the page about that directory.
/// @throws InputError without a directory  @throws DataError as report_on()
[[nodiscard]] PageContent report_on(const std::vector<std::filesystem::path>& directories);

}  // namespace ljmd
