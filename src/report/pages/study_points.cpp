#include <fmt/format.h>
#include <fmt/ranges.h>

#include "io/files/input_file.hpp"
#include "report/lenient_data.hpp"
#include "report/pages/study_pages.hpp"
#include "run/run_directory.hpp"

namespace ljmd {

Data study_points(const Data& runs, const std::filesystem::path& directory) {
    Data points = Data::list();
    for (const Data& run : runs.items()) {
        const std::filesystem::path place = text_in(run, {"directory"});
        const std::filesystem::path relative = place.lexically_relative(directory);
        Data& point = points.push_back({{"label", text_in(run, {"name"})},
                                        {"directory", relative.string()},
                                        {"state", text_in(run, {"state"})},
                                        {"words", text_in(run, {"words"})}});
        if (input_is_there(place / report_name)) {
            point["href"] = (relative / report_name).string();
        }
    }
    return points;
}

void add_study_state(PageContent& page, const Data& study) {
    std::vector<std::string> parts;
    const std::size_t runs = study["runs"].size();
    for (const auto& [state, count] : study["states"].members()) {
        if (count.number() > 0.0) {
            parts.push_back(fmt::format("{} {}", count.integer(), state));
        }
    }
    const bool whole = number_in(study, {"states", "finished"}) == static_cast<double>(runs);
    const bool running = flag_in(study, {"running"}) == true;
    page.state = whole ? "finished" : running ? "running" : "stopped";
    page.state_words = fmt::format("{} runs: {}", runs, fmt::join(parts, ", "));
    const auto failed = number_in(study, {"states", "failed"}).value_or(0.0);
    page.verdicts.push_back({"runs",
                             whole          ? "good"
                             : failed > 0.0 ? "bad"
                                            : "doubt",
                             whole ? fmt::format("All {} runs are finished.", runs)
                                   : fmt::format("Not all runs are finished: {}.", fmt::join(parts, ", "))});
}

}  // namespace ljmd
