#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "deck/deck.hpp"

namespace ljmd {

/// Write the page about one or several directories, in place of an earlier page.
/// @param force  also in place of any other file
/// @return one warning for each file that could not be read
/// @throws InputError, DataError as report_on(); OutputRefused as require_writable(); FileError
std::vector<std::string> write_report(const std::vector<std::filesystem::path>& directories,
                                      const std::filesystem::path& page, bool force = false);

/// What a page that is written again and again has become.
struct FollowedReport {
    bool is_running;                    ///< the run goes on, and the page with it
    std::vector<std::string> warnings;  ///< as of write_report()
};

/// Write the page about a run that goes on, which reads itself anew after so many seconds; of one that does not, the
/// page of write_report(). @throws  as write_report()
[[nodiscard]] FollowedReport write_followed_report(const std::filesystem::path& directory,
                                                   const std::filesystem::path& page, bool force, double seconds);

/// Write the page about a run that has ended, if its deck asks for one (`[output] report = true`). An error is only a
/// warning, because the results of the run are complete.
/// @param warn  called with the reason if there is no page
/// @return the path of the page, if it was written
std::optional<std::filesystem::path> write_asked_report(const Deck& deck,
                                                        const std::function<void(const std::string&)>& warn);

}  // namespace ljmd
