#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "ljmd/app/few_body_run.hpp"
#include "ljmd/app/json_number.hpp"
#include "ljmd/app/run_report.hpp"

namespace ljmd {

namespace {

using Json = nlohmann::ordered_json;

/// The numbers follow from the deck without chance: a mean over the rows has no standard error, only a mean over
/// orbits.
Json history_json(const FewBodyHistory& history) {
    return {{"mean", number_or_null(history.mean)},
            {"standard_error", nullptr},
            {"at_start", number_or_null(history.at_start)},
            {"at_end", number_or_null(history.at_end)},
            {"largest_deviation", number_or_null(history.largest_deviation)},
            {"unit", "the deck's own"}};
}

Json finding_json(const Finding& finding) {
    return {{"value", number_or_null(finding.value)}, {"standard_error", number_or_null(finding.standard_error)}};
}

}  // namespace

std::string few_body_results_json(const Deck& deck, const FewBodyResult& result) {
    Json observables = Json::object();
    for (const FewBodyHistory& history : result.histories) {
        observables[history.name] = history_json(history);
    }
    Json findings = Json::object();
    for (const auto& [analysis, found] : result.findings) {
        findings[analysis] = Json::object();
        for (const Finding& finding : found) {
            findings[analysis][finding.name] = finding_json(finding);
        }
    }
    Json stages = Json::array();
    for (const StageResult& stage : result.stages) {
        stages.push_back(stage_json(stage));
    }
    const Json json = {
        {"title", deck.title},
        {"system",
         {{"kind", "few-body"}, {"bodies", result.bodies}, {"dimensions", result.dimensions}, {"force", result.force}}},
        {"observables", observables},
        {"analysis", findings},
        {"stages", stages},
        {"warnings", Json::array()}};
    // What came from a checkpoint need not be UTF-8, as JSON must.
    return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string few_body_results_table(const Deck& deck, const FewBodyResult& result) {
    std::string text = fmt::format("{}\n{} {} in {} dimension{}, force {}\n\n", title_line(deck), result.bodies,
                                   result.bodies == 1 ? "body" : "bodies", result.dimensions,
                                   result.dimensions == 1 ? "" : "s", result.force);
    text += fmt::format("  {:<22}{:>24}{:>24}{:>22}\n", "total", "at the start", "at the end", "largest deviation");
    for (const FewBodyHistory& history : result.histories) {
        text += fmt::format("  {:<22}{:>24.15g}{:>24.15g}{:>22.6g}\n", history.name, history.at_start, history.at_end,
                            history.largest_deviation);
    }
    for (const auto& [analysis, found] : result.findings) {
        text += fmt::format("\n  {}\n", analysis);
        for (const Finding& finding : found) {
            const double deviation = finding.standard_error.value_or(std::nan(""));  // NaN for a single interval too
            const std::string error = std::isfinite(deviation) ? fmt::format(" +- {:.2g}", deviation) : "";
            text += fmt::format("    {:<32}{:>22.13g}{}\n", finding.name, finding.value, error);
        }
    }
    text += '\n' + stage_lines(result.stages, "per unit of time");
    return text + fmt::format("\nfiles: {}\n", deck.directory.string());
}

}  // namespace ljmd
