#include "ljmd/report/report.hpp"

#include <fmt/format.h>

#include "ljmd/core/errors.hpp"
#include "ljmd/report/fluid_page.hpp"

namespace ljmd {

PageContent report_on(const std::filesystem::path& directory) {
    return fluid_page(run_facts(directory));
}

PageContent report_on(const std::vector<std::filesystem::path>& directories) {
    if (directories.empty()) {
        throw InputError("a report is about one directory or several");
    }
    return report_on(directories.front());
}

}  // namespace ljmd
