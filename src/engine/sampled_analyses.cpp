#include "engine/sampled_analyses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include "engine/mistakes/mistakes.hpp"
#include "ljmd/core/errors.hpp"
#include "model/all_atoms.hpp"

namespace ljmd {

SampledAnalyses::SampledAnalyses(const FluidSpec& spec, FluidSystem& fluid, const std::vector<Observer*>& observers)
    : spec_(spec), fluid_(fluid), edges_(fluid.state.box().edges()) {
    for (Observer* observer : observers) {
        add(*observer);
    }
}

void SampledAnalyses::add(Observer& observer) {
    if (std::ranges::find(observers_, &observer) != observers_.end()) {
        throw InputError("this observer measures already: it would see everything twice");
    }
    observers_.push_back(&observer);
}

void SampledAnalyses::archive(Archive& a) {
    a.mark("analyses");
    for (const auto& analysis : fluid_.analyses) {
        analysis->archive(a);
    }
    std::size_t observers = observers_.size();
    a(observers);
    if (observers != observers_.size()) {
        throw CheckpointError(
            fmt::format("the checkpoint has {} observers of the program that wrote it, and {} are there: it is resumed "
                        "by that program, with the same observers",
                        observers, observers_.size()));
    }
    for (Observer* observer : observers_) {
        observer->archive(a);
    }
}

void SampledAnalyses::stage_begins(const Stage& stage) {
    const bool unused = std::ranges::all_of(fluid_.analyses, [](const auto& each) { return each->samples() == 0; });
    if (stage.sample && unused && fluid_.state.box().edges() != edges_) {
        adapt();
    }
    for (const auto& analysis : fluid_.analyses) {
        analysis->interrupt();
    }
    for (Observer* observer : observers_) {
        observer->interrupt();
    }
}

/// A barostat has changed the box since the analyses were made, which have no samples yet. Those that have some do not
/// depend on the box: with others no stage with a barostat may come after the first sampled one.
void SampledAnalyses::adapt() {
    const State& state = fluid_.state;
    const std::vector<Mistake> wrong = box_mistakes(spec_, state.total(), state.box());
    if (!wrong.empty()) {
        throw PhysicsError(fmt::format("in the box that the barostat has made: {}", in_words(wrong.front())));
    }
    fluid_.analyses = make_analyses(spec_, state);
    edges_ = state.box().edges();
}

bool SampledAnalyses::want_energy(Index step) const {
    return std::ranges::any_of(
               fluid_.analyses,
               [step](const auto& analysis) { return analysis->needs_energy() && analysis->due(step); }) ||
           std::ranges::any_of(observers_, [step](const Observer* observer) {
               return observer->needs_energy() && observer->needs(step);
           });
}

bool SampledAnalyses::are_due(Index step) const {
    return std::ranges::any_of(fluid_.analyses, [step](const auto& analysis) { return analysis->due(step); }) ||
           std::ranges::any_of(observers_, [step](const Observer* observer) { return observer->needs(step); });
}

void SampledAnalyses::sample(const Evaluation& evaluation, bool energy_known, bool always) {
    const Index step = fluid_.state.step;
    if (!always && !are_due(step)) {
        return;
    }
    look_at_all_atoms(fluid_.state, [&](const State& state) {
        for (const auto& analysis : fluid_.analyses) {
            if (always || analysis->due(step)) {
                analysis->sample(state, evaluation);
            }
        }
        const Snapshot snapshot(state, fluid_.tail, energy_known ? std::optional(evaluation) : std::nullopt);
        for (Observer* observer : observers_) {
            if (always || observer->needs(step)) {
                observer->sample(snapshot);
            }
        }
    });
}

void SampledAnalyses::add_to(RunResult& result) const {
    for (const auto& analysis : fluid_.analyses) {
        std::ranges::move(analysis->tables(), std::back_inserter(result.tables));
        std::ranges::move(analysis->observables(), std::back_inserter(result.averages));
    }
}

void SampledAnalyses::add_observed_to(RunResult& result) const {
    for (const Observer* observer : observers_) {
        if (auto average = observer->average()) {
            average->own = true;
            result.averages.push_back(std::move(*average));
        }
    }
}

}  // namespace ljmd
