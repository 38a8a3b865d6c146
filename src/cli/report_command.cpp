#include <fmt/format.h>

#include "ljmd/cli/commands.hpp"
#include "ljmd/cli/streams.hpp"
#include "ljmd/io/tables/json_text.hpp"
#include "ljmd/report/report.hpp"

namespace ljmd {

void report_command(const ReportOptions& options) {
    const PageContent content = report_on(std::filesystem::path(options.directories.front()));
    print_result(to_json_line(page_data(content)) + "\n");
}

}  // namespace ljmd
