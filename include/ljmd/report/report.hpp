#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ljmd/report/page_content.hpp"

namespace ljmd {

/// What is said about a directory of ljmd, and drawn: a run of a fluid or of few bodies, finished or not, a sweep, a
/// reproduced table, or a comparison. Of files that cannot be read its warnings tell.
/// @throws DataError  it is none of these
[[nodiscard]] PageContent report_on(const std::filesystem::path& directory);

/// Several directories on one page; one alone as report_on().
/// @throws InputError without a directory  @throws DataError as report_on()
[[nodiscard]] PageContent report_on(const std::vector<std::filesystem::path>& directories);

}  // namespace ljmd
