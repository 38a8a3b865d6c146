#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "ljmd/core/text_table.hpp"
#include "ljmd/run/few_body_run.hpp"
#include "ljmd/run/footnotes.hpp"
#include "ljmd/run/json_number.hpp"
#include "ljmd/run/run_report.hpp"

namespace ljmd {

namespace {

using Json = nlohmann::ordered_json;
using Align = TextTable::Align;

/// These numbers are deterministic: a mean over the rows has no standard error, only a mean over orbits has one.
Json history_json(const FewBodyHistory& history) {
    return {{"mean", number_or_null(history.mean)},
            {"standard_error", nullptr},
            {"at_start", number_or_null(history.at_start)},
            {"at_end", number_or_null(history.at_end)},
            {"largest_deviation", number_or_null(history.largest_deviation)},
            {"unit", "the deck's own"}};
}

Json finding_json(const Finding& finding) {
    Json json = {{"value", number_or_null(finding.value)}, {"standard_error", number_or_null(finding.standard_error)}};
    if (!finding.remark.empty()) {
        json["remark"] = finding.remark;
    }
    return json;
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
    // Strings from a checkpoint may not be UTF-8, but JSON must.
    return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

std::string few_body_results_table(const Deck& deck, const FewBodyResult& result) {
    std::string text = fmt::format("{}\n{} {} in {} dimension{}, force {}\n\n", title_line(deck), result.bodies,
                                   result.bodies == 1 ? "body" : "bodies", result.dimensions,
                                   result.dimensions == 1 ? "" : "s", result.force);
    TextTable totals({{"total", Align::left, 20},
                      {"at the start", Align::right, 22},
                      {"at the end", Align::right, 22},
                      {"largest deviation", Align::right, 20}},
                     2);
    for (const FewBodyHistory& history : result.histories) {
        totals.add({history.name, fmt::format("{:.15g}", history.at_start), fmt::format("{:.15g}", history.at_end),
                    fmt::format("{:.6g}", history.largest_deviation)});
    }
    text += totals.text();
    for (const auto& [analysis, found] : result.findings) {
        Footnotes footnotes;
        TextTable findings({{"", Align::left, 30}, {"", Align::right, 22}, {"", Align::left}, {"", Align::left}}, 4);
        for (const Finding& finding : found) {
            const double deviation = finding.standard_error.value_or(std::nan(""));  // NaN for a single interval too
            findings.add(
                {finding.name, std::isfinite(finding.value) ? fmt::format("{:.13g}", finding.value) : "no value",
                 std::isfinite(deviation) ? fmt::format("+- {:.2g}", deviation) : "", footnotes.mark(finding.remark)});
        }
        text += fmt::format("\n  {}\n{}{}", analysis, findings.text(), footnotes.text());
    }
    text += '\n' + stage_lines(result.stages, "per unit of time");
    return text + fmt::format("\nfiles: {}\n", deck.directory.string());
}

}  // namespace ljmd
