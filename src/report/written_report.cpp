#include "report/written_report.hpp"

#include <fmt/format.h>

#include "ljmd/core/errors.hpp"
#include "report/page.hpp"
#include "report/report.hpp"
#include "run/output_guard.hpp"
#include "run/run_directory.hpp"

namespace ljmd {

namespace fs = std::filesystem;

std::vector<std::string> write_report(const std::vector<fs::path>& directories, const fs::path& page, bool force) {
    const Replacing allowed{.force = force, .mark = page_mark};
    require_writable(page, allowed);
    const PageContent content = report_on(directories);
    write_output(page, allowed, page_html(content));
    return content.warnings;
}

FollowedReport write_followed_report(const fs::path& directory, const fs::path& page, bool force, double seconds) {
    const Replacing allowed{.force = force, .mark = page_mark};
    require_writable(page, allowed);
    PageContent content = report_on(directory);
    const bool is_running = content.state == "running";
    if (is_running) {
        content.reload = seconds;
    }
    write_output(page, allowed, page_html(content));
    return {is_running, content.warnings};
}

std::optional<fs::path> write_asked_report(const Deck& deck, const std::function<void(const std::string&)>& warn) {
    if (!deck.report) {
        return std::nullopt;
    }
    const fs::path page = deck.directory / report_name;
    try {
        write_report({deck.directory}, page);
    } catch (const Error& error) {
        warn(fmt::format("there is no report: {}", error.what()));
        return std::nullopt;
    }
    return page;
}

}  // namespace ljmd
