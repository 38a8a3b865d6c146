#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/deck/deck.hpp"

namespace ljmd {

/// Write the page about one or several directories, in place of the one that is there.
/// @return what could not be read of them, a text each
/// @throws InputError, DataError as report_on(); OutputError
std::vector<std::string> write_report(const std::vector<std::filesystem::path>& directories,
                                      const std::filesystem::path& page);

/// Write the page about a run that has ended, if its deck asks for one (`[output] report = true`). The run is done: a
/// page that cannot be made is no reason to fail.
/// @param warn  told why there is no page
/// @return the page, if there is one
std::optional<std::filesystem::path> write_asked_report(const Deck& deck,
                                                        const std::function<void(const std::string&)>& warn);

}  // namespace ljmd
