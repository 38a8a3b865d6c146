#include "ljmd/report/report.hpp"

#include "ljmd/report/fluid_page.hpp"

namespace ljmd {

PageContent report_on(const std::filesystem::path& directory) {
    return fluid_page(run_facts(directory));
}

}  // namespace ljmd
