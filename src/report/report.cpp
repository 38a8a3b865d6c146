#include "report/report.hpp"

#include <fmt/format.h>

#include "compare/recorded_comparison.hpp"
#include "io/files/input_file.hpp"
#include "ljmd/core/errors.hpp"
#include "report/pages/few_body_page.hpp"
#include "report/pages/fluid_page.hpp"
#include "report/pages/set_page.hpp"
#include "report/pages/study_pages.hpp"
#include "study/study_report.hpp"
#include "study/sweep_record.hpp"

namespace ljmd {

PageContent report_on(const std::filesystem::path& directory) {
    if (!input_is_directory(directory)) {
        throw DataError(
            fmt::format("{} is no directory; a report is about that of a run, a sweep, a reference, a reproduced "
                        "table or a comparison",
                        directory.string()));
    }
    if (holds_study(directory)) {
        if (input_is_there(directory / reference_file)) {
            return reference_page(directory);
        }
        const auto sweep = recorded_sweep(directory);
        return !sweep                ? reproduction_page(directory)
               : sweep->replicas > 0 ? replicas_page(directory)
                                     : sweep_page(directory);
    }
    if (!input_is_there(directory / "run.json") && holds_comparison(directory)) {
        return comparison_page(directory);
    }
    const RunFacts facts = run_facts(directory);
    return facts.is_few_body() ? few_body_page(facts) : fluid_page(facts);
}

PageContent report_on(const std::vector<std::filesystem::path>& directories) {
    if (directories.empty()) {
        throw InputError("a report is about one directory or several");
    }
    if (directories.size() == 1) {
        return report_on(directories.front());
    }
    std::vector<PageContent> members;
    members.reserve(directories.size());
    for (const std::filesystem::path& directory : directories) {
        members.push_back(report_on(directory));
    }
    return set_page(std::move(members));
}

}  // namespace ljmd
