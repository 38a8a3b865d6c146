#include <fmt/format.h>

#include "compare/crosscheck_report.hpp"
#include "core/text.hpp"
#include "core/text_table.hpp"
#include "io/tables/json_text.hpp"
#include "judge/judge.hpp"
#include "run/run_report.hpp"

namespace ljmd {

namespace {

using Align = TextTable::Align;

std::string mean_lines(const std::vector<ComparedMean>& means) {
    constexpr std::size_t width = 10;
    TextTable table({{"average", Align::left, 20},
                     {"ljmd", Align::right, width},
                     {"error", Align::right, width},
                     {"engine", Align::right, width},
                     {"error", Align::right, width},
                     {"sigmas", Align::right, 7}});
    for (const ComparedMean& mean : means) {
        const auto [ours, our_error] = mean_and_error(mean.ours.mean, mean.ours.standard_error);
        const auto [theirs, their_error] = mean_and_error(mean.theirs.mean, mean.theirs.standard_error);
        table.add({mean.name, ours, our_error, theirs, their_error, fmt::format("{:.2f}", mean.sigmas())});
    }
    return table.text() + "energies are of an atom; pressures are (2 K + W)/(3 V) and the tail\n";
}

std::string list(const std::string& title, const std::vector<std::string>& items) {
    std::string text;
    for (const std::string& item : items) {
        text += wrapped("  " + item, screen_columns, 4) + "\n";
    }
    return text.empty() ? text : title + "\n" + text + "\n";
}

std::string speed_lines(const EngineSpeed& speed, Index atoms) {
    const auto in_words = [&](double steps) {
        return fmt::format("{:.3g} steps/s, {:.3g} atom-steps/s", steps, steps * static_cast<double>(atoms));
    };
    return fmt::format(
        "speed of the run, not judged: medians of 3 rounds of {} steps, without start-up\n"
        "  ljmd    {}\n  engine  {}; {:.3g} of ljmd's\n"
        "  the engine's start-up, not in its speed: {:.2g} s\n\n",
        speed.steps, in_words(speed.ours), in_words(speed.theirs), speed.theirs / speed.ours, speed.start_up);
}

Data estimate_data(const Estimate& estimate) {
    return {{"mean", estimate.mean}, {"standard_error", estimate.standard_error}};
}

}  // namespace

std::string judgement_table(const Judgement& found, const Deck& deck) {
    std::string text = fmt::format("{}\nagainst {}\n{} atoms, after {} steps of the deck\nljmd: {}\n\n",
                                   title_line(deck), found.engine, found.atoms, found.steps_before, found.path);
    if (!found.checks.empty()) {
        text += check_lines(found.checks) + '\n';
    }
    if (!found.means.empty()) {
        text += mean_lines(found.means) + '\n';
    }
    if (found.speed) {
        text += speed_lines(*found.speed, found.atoms);
    }
    text += list("diagnosis:", found.diagnoses) + list("not judged:", found.not_judged);
    if (found.checks.empty()) {
        return text + "nothing was judged\n";
    }
    return text + (found.passed()
                       ? fmt::format("all {} checks passed{}\n", found.checks.size(),
                                     found.own_failure.empty() ? "" : "; no verdict: ljmd's own run of the deck failed")
                       : fmt::format("{} of {} checks FAILED{}\n", found.failures(), found.checks.size(),
                                     found.diagnoses.empty() ? "; no mistake that is known explains it" : ""));
}

std::string judgement_json(const Judgement& found, const Deck& deck, const std::string& with) {
    Data averages = Data::object();
    for (const ComparedMean& mean : found.means) {
        averages[mean.name] = {
            {"ljmd", estimate_data(mean.ours)}, {"peer", estimate_data(mean.theirs)}, {"sigmas", mean.sigmas()}};
    }
    Data trajectory = Data::list();
    for (const StepApart& step : found.trajectory) {
        trajectory.push_back({{"step", step.step},
                              {"time", static_cast<double>(step.step) * found.time_step},
                              {"distance", step.distance},
                              {"allowed_distance", step.allowed},
                              {"force_difference", step.force_difference}});
    }
    return to_json({{"deck", deck.path},
                    {"with", with},
                    {"peer", found.engine},
                    {"atoms", found.atoms},
                    {"steps_before", found.steps_before},
                    {"path", found.path},
                    {"pressure_convention", "(2 K + W)/(3 V), with tail"},
                    {"checks", checks_data(found.checks)},
                    {"passed", found.passed() && !found.own_failure.empty() ? Data() : Data(found.passed())},
                    {"averages", {{"observables", averages}}},
                    {"trajectory", {{"time_step", found.time_step}, {"steps", trajectory}}},
                    {"speed", found.speed ? Data({{"steps", found.speed->steps},
                                                  {"ljmd_steps_per_second", found.speed->ours},
                                                  {"peer_steps_per_second", found.speed->theirs},
                                                  {"peer_start_up_seconds", found.speed->start_up}})
                                          : Data()},
                    {"diagnoses", found.diagnoses},
                    {"not_judged", found.not_judged},
                    {"warnings", found.warnings}});
}

}  // namespace ljmd
