#include "engine/mistakes/until_mistakes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "core/text.hpp"
#include "engine/mistakes/keys_of_mistakes.hpp"
#include "ljmd/engine/fluid_spec.hpp"

namespace ljmd {

namespace {

constexpr std::size_t longest_observable = 64;

/// Why the average of the run has no error of this observable, or none that a longer stage makes smaller; empty if it
/// has one. @param stage  the last of the stages
std::string why_without_error(const std::string& observable, const Stage& stage, const std::vector<Stage>& stages) {
    const Ensemble ensemble = sampled_ensemble(stages);
    if (observable == "density" && ensemble != Ensemble::constant_pressure) {
        return "is constant without a barostat";
    }
    if (observable == "total_energy" && !stage.thermostat) {
        return "is constant without a thermostat, but for errors of the integrator";
    }
    if (observable == "heat_capacity_cv" && ensemble != Ensemble::constant_energy && ensemble != Ensemble::canonical) {
        return "follows from fluctuations in one sampled stage at constant energy or with a canonical thermostat, "
               "without a barostat";
    }
    return "";
}

std::vector<Mistake> mistakes_of(const Stage& stage, std::size_t index, const std::vector<Stage>& stages) {
    std::vector<Mistake> found;
    const auto add = [&](std::vector<std::string> keys, const std::string& sentence, const std::string& hint = "") {
        found.push_back({"stage", stage.name, index, sentence, false, std::move(keys), hint});
    };
    if (index + 1 != stages.size()) {
        add({key(&Stage::until)},
            "only the last stage can end when errors are reached: a later one would begin at any step",
            "give this stage a number of steps");
    }
    if (!stage.sample) {
        add({key(&Stage::until), key(&Stage::sample)},
            "a stage that ends when errors are reached is sampled: nothing else has errors", "sample = true");
    }
    if (stage.steps == 0) {
        add({key(&Stage::until) + ".max_steps"}, "a stage that is to reach errors takes steps: max_steps is 0");
    }
    std::set<std::string> seen;
    for (const WantedError& wanted : stage.until) {
        const std::string wanted_key = key(&Stage::until) + "." + wanted.observable;
        const std::string name = printable(wanted.observable, longest_observable);
        const auto& known = until_observables();
        if (std::ranges::find(known, wanted.observable, &UntilObservable::name) == known.end()) {
            std::vector<std::string> names;
            names.reserve(known.size());
            for (const UntilObservable& each : known) {
                names.push_back(each.name);
            }
            add({key(&Stage::until)},
                fmt::format("no error of '{}' can be reached; known are {}", name, fmt::join(names, ", ")));
        } else if (!seen.insert(wanted.observable).second) {
            add({wanted_key}, fmt::format("two errors of {} are to be reached", name));
        } else if (!(wanted.error > 0.0 && std::isfinite(wanted.error))) {
            add({wanted_key},
                fmt::format("the error of {} to be reached is {}, it must be above 0", name, wanted.error));
        } else if (const std::string why = why_without_error(wanted.observable, stage, stages); !why.empty()) {
            add({wanted_key}, fmt::format("no error of {} can be reached: it {}", name, why));
        }
    }
    return found;
}

}  // namespace

const std::vector<UntilObservable>& until_observables() {
    static const std::vector<UntilObservable> known{
        {"temperature", Dimension::temperature, "epsilon/k_B"}, {"potential_energy", Dimension::energy, "epsilon"},
        {"kinetic_energy", Dimension::energy, "epsilon"},       {"total_energy", Dimension::energy, "epsilon"},
        {"pressure", Dimension::pressure, "epsilon/sigma^3"},   {"density", Dimension::none, "sigma^-3"},
        {"compressibility_factor", Dimension::none, "1"},       {"heat_capacity_cv", Dimension::none, "k_B"}};
    return known;
}

std::vector<Mistake> until_mistakes(const std::vector<Stage>& stages) {
    std::vector<Mistake> all;
    for (std::size_t k = 0; k < stages.size(); ++k) {
        if (!stages[k].until.empty()) {
            std::ranges::move(mistakes_of(stages[k], k, stages), std::back_inserter(all));
        }
    }
    return all;
}

}  // namespace ljmd
