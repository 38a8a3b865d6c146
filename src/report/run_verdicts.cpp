#include "report/run_verdicts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/text.hpp"
#include "engine/result_doubts.hpp"
#include "ljmd/detail/observables/statistics/observable_average.hpp"
#include "report/lenient_data.hpp"
#include "report/quantity_names.hpp"

namespace ljmd {

namespace {

constexpr double farthest_errors = 3.0;

std::string percent(double part) {
    return fmt::format("{:.2g} %", 100.0 * part);
}

Verdict energy_verdict(const Data& results) {
    const Data* stages = value_in(results, {"stages"});
    const double kinetic = number_in(results, {"observables", "kinetic_energy", "mean"}).value_or(std::nan(""));
    std::string words;
    std::string level = "unknown";
    if (stages != nullptr && stages->is_list()) {
        for (const Data& stage : stages->items()) {
            const auto drift = number_in(stage, {"energy_drift"});
            const auto time_step = number_in(stage, {"time_step"});
            const auto steps = number_in(stage, {"steps"});
            if (flag_in(stage, {"sampled"}) != true || !drift || !time_step || !steps) {
                continue;
            }
            const bool large = !text_in(stage, {"energy_drift_remark"}).empty();
            const double change = *drift * *time_step * *steps;
            words += fmt::format(
                "{}In stage '{}' the energy per atom drifts by {:.1e} epsilon per tau: {:.1e} epsilon in {:.4g} tau, "
                "{} of the kinetic energy.",
                words.empty() ? "" : " ", text_in(stage, {"name"}), *drift, change, *time_step * *steps,
                percent(std::abs(change) / kinetic));
            level = large || level == "bad" ? "bad" : "good";
        }
    }
    if (words.empty()) {
        words = "Conservation of energy cannot be judged: no sampled stage has a conserved energy.";
    } else {
        words = (level == "good" ? "Energy is conserved. " : "Energy is not conserved well enough. ") + words;
    }
    return {"energy", level, words};
}

Verdict error_bar_verdict(const Data& results) {
    const Data* observables = value_in(results, {"observables"});
    std::vector<std::string> guesses;
    double fewest = std::numeric_limits<double>::infinity();
    std::string of;
    if (observables != nullptr && observables->is_object()) {
        for (const auto& [name, entry] : observables->members()) {
            if (!is_in_table({name, "", "", std::nullopt, "", flag_in(entry, {"own"}).value_or(false)}) ||
                !number_in(entry, {"standard_error"})) {
                continue;
            }
            if (flag_in(entry, {"error_is_converged"}) == false) {
                guesses.push_back(in_plain_words(name));
            }
            const double samples = number_in(entry, {"independent_samples"}).value_or(fewest);
            if (samples < fewest) {
                fewest = samples;
                of = in_plain_words(name);
            }
        }
    }
    if (!guesses.empty()) {
        return {"error bars", "doubt",
                fmt::format("Error bars of {} are guesses: the run is too short for its correlations.",
                            fmt::join(guesses, ", "))};
    }
    if (of.empty()) {
        return {"error bars", "unknown", "There are no error bars: nothing was sampled, or too little."};
    }
    return {"error bars", "good",
            fmt::format("Error bars are reliable: at least {:.0f} independent samples (of {}).", fewest, of)};
}

void add_time_step_verdict(std::vector<Verdict>& verdicts, const Data& results) {
    const Data* stages = value_in(results, {"stages"});
    if (stages == nullptr || !stages->is_list()) {
        return;
    }
    for (const Data& stage : stages->items()) {
        const auto error = number_in(stage, {"time_step_error"});
        if (!error) {
            continue;
        }
        const std::string remark = text_in(stage, {"time_step_remark"});
        verdicts.push_back(
            {"time step", remark.empty() ? "good" : "bad",
             remark.empty()
                 ? fmt::format("The time step of stage '{}' is short enough: it sets the temperatures of "
                               "velocities and of configurations about {} apart.",
                               text_in(stage, {"name"}), percent(std::abs(*error)))
                 : fmt::format("The time step of stage '{}' is too long: {}.", text_in(stage, {"name"}), remark)});
    }
}

void add_temperature_verdict(std::vector<Verdict>& verdicts, const Data& results) {
    const auto asked = number_in(results, {"asked_temperature"});
    const auto found = number_in(results, {"observables", "temperature", "mean"});
    const auto error = number_in(results, {"observables", "temperature", "standard_error"});
    if (!asked || !found || !error) {
        return;
    }
    const bool is_off = std::abs(*found - *asked) > farthest_errors * *error;
    const bool is_converted = number_in(results, {"at_asked_temperature", "temperature"}).has_value();
    verdicts.push_back(
        {"temperature", is_off ? "doubt" : "good",
         fmt::format("The deck asks for temperature {:.6g}, and {} was found{}.{}", *asked, with_error(*found, *error),
                     is_off ? "" : ", which agrees within three errors",
                     is_converted ? " Energy and pressure are also given at the temperature that was asked." : "")});
}

}  // namespace

Verdict equilibrium_verdict(const ThermoReport& report, const std::optional<double>& crystal) {
    if (crystal) {
        return {
            "equilibrium", "bad",
            fmt::format("Not in equilibrium: {:.0f} % of the crystal was left when sampling began.", 100.0 * *crystal)};
    }
    std::vector<std::string> changing;
    bool too_short = false;
    Index latest = 0;
    double fewest = std::numeric_limits<double>::infinity();
    for (const ThermoReport::Column& column : report.columns) {
        if (column.conserved || !std::isfinite(column.found.inefficiency)) {
            continue;
        }
        fewest = std::min(fewest, static_cast<double>(report.rows) / column.found.inefficiency);
        if (column.found.changes) {
            changing.push_back(in_plain_words(column.average.name));
        } else if (!column.found.start) {
            too_short = true;
        } else {
            latest = std::max(latest, *column.found.start);
        }
    }
    if (!std::isfinite(fewest)) {
        return {"equilibrium", "unknown", "Equilibrium cannot be judged: temperature and energy have no fluctuations."};
    }
    if (!changing.empty()) {
        return {"equilibrium", "bad",
                fmt::format("Not in equilibrium: {} still changed in the second half of the samples.",
                            fmt::join(changing, ", "))};
    }
    if (latest > 0) {
        return {"equilibrium", "doubt",
                fmt::format("Not in equilibrium when sampling began: the first {} of the samples differ from the later "
                            "ones.",
                            percent(static_cast<double>(latest) / static_cast<double>(report.rows)))};
    }
    if (too_short) {
        return {"equilibrium", "doubt",
                fmt::format("Too short to judge equilibrium: {:.0f} independent samples, 16 are needed.", fewest)};
    }
    return {"equilibrium", "good",
            fmt::format("Equilibrated: temperature, energy and pressure do not change after sampling began; at "
                        "least {:.0f} independent samples.",
                        fewest)};
}

std::vector<Verdict> result_verdicts(const RunFacts& facts) {
    std::vector<Verdict> verdicts{energy_verdict(facts.results), error_bar_verdict(facts.results)};
    add_temperature_verdict(verdicts, facts.results);
    add_time_step_verdict(verdicts, facts.results);
    return verdicts;
}

Verdict reference_verdict(const std::vector<Quantity>& quantities, const std::string& equation) {
    std::vector<std::string> scores;
    double farthest = 0.0;
    for (const Quantity& each : quantities) {
        if (!each.reference || !each.error || (each.name != "potential_energy" && each.name != "pressure")) {
            continue;
        }
        const double error = std::hypot(*each.error, each.reference_error.value_or(0.0));
        const double score = error > 0.0 ? (each.value - *each.reference) / error : std::nan("");
        scores.push_back(fmt::format("{} by {:+.2g} ({:+.1f} errors)", in_plain_words(each.name),
                                     each.value - *each.reference, score));
        farthest = std::isnan(score) ? farthest : std::max(farthest, std::abs(score));
    }
    if (scores.empty()) {
        return {"equation of state", "unknown", fmt::format("Not compared with an equation of state: {}.", equation)};
    }
    const bool agrees = farthest <= farthest_errors;
    return {"equation of state", agrees ? "good" : "doubt",
            fmt::format(
                "{} the equation of state {}: differs in {}. Errors of the run and those known of the equation count.",
                agrees ? "Agrees with" : "Not within three errors of", equation, fmt::join(scores, ", "))};
}

}  // namespace ljmd
