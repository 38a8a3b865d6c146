#include <fmt/format.h>

#include <cmath>

#include "core/text.hpp"
#include "core/text_table.hpp"
#include "run/footnotes.hpp"
#include "run/results.hpp"
#include "run/run_report.hpp"

namespace ljmd {

namespace {

using Align = TextTable::Align;

/// These numbers are deterministic: a mean over the rows has no standard error, only a mean over orbits has one.
Data history_data(const FewBodyHistory& history) {
    return {{"mean", history.mean},
            {"standard_error", nullptr},
            {"at_start", history.at_start},
            {"at_end", history.at_end},
            {"largest_deviation", history.largest_deviation},
            {"unit", "the deck's own"}};
}

Data finding_data(const Finding& finding) {
    Data json = {{"value", finding.value}, {"standard_error", finding.standard_error}};
    if (!finding.remark.empty()) {
        json["remark"] = finding.remark;
    }
    return json;
}

}  // namespace

Document results_report(const RunPlan& plan, const FewBodyResult& result) {
    std::string text = fmt::format("{}\n{} {} in {} dimension{}, force {}\n\n", title_line(plan), result.bodies,
                                   result.bodies == 1 ? "body" : "bodies", result.dimensions,
                                   result.dimensions == 1 ? "" : "s", result.force);
    Data observables = Data::object();
    TextTable totals({{"total", Align::left}, {"at the start"}, {"at the end"}, {"largest deviation"}}, 2);
    for (const FewBodyHistory& history : result.histories) {
        observables[history.name] = history_data(history);
        totals.add({history.name, fmt::format("{:.15g}", history.at_start), fmt::format("{:.15g}", history.at_end),
                    fmt::format("{:.6g}", history.largest_deviation)});
    }
    text += totals.text_within(screen_columns);
    Data all_findings = Data::object();
    for (const auto& [analysis, found] : result.findings) {
        Data& of_analysis = all_findings[analysis] = Data::object();
        Footnotes footnotes;
        TextTable findings({{"", Align::left, 30}, {""}, {"", Align::left}, {"", Align::left}}, 4);
        for (const Finding& finding : found) {
            of_analysis[finding.name] = finding_data(finding);
            const double deviation = finding.standard_error.value_or(std::nan(""));  // NaN for a single interval too
            findings.add(
                {finding.name, std::isfinite(finding.value) ? fmt::format("{:.13g}", finding.value) : "no value",
                 std::isfinite(deviation) ? fmt::format("+- {:.2g}", deviation) : "", footnotes.mark(finding.remark)});
        }
        text += fmt::format("\n  {}\n{}{}", analysis, findings.text_within(screen_columns), footnotes.text());
    }
    text += '\n' + stage_lines(result.stages, "per unit of time");
    text += fmt::format("\nfiles: {}\n", plan.directory.string());
    Data stages = Data::list();
    for (const StageResult& stage : result.stages) {
        stages.push_back(stage_data(stage));
    }
    return {{{"title", plan.title},
             {"system",
              {{"kind", "few-body"},
               {"bodies", result.bodies},
               {"dimensions", result.dimensions},
               {"force", result.force}}},
             {"observables", observables},
             {"analysis", all_findings},
             {"stages", stages},
             {"warnings", Data::list()}},
            text};
}

}  // namespace ljmd
