#include "integrators/integrator.hpp"

#include <fmt/format.h>

#include <utility>
#include <variant>

#include "ljmd/options/choice.hpp"

namespace ljmd {

namespace {

struct SchemeAlone : IntegratorOptions {
    explicit SchemeAlone(std::function<Scheme(double)> of_step) : of_step_(std::move(of_step)) {}
    [[nodiscard]] Scheme scheme(double time_step) const override { return of_step_(time_step); }

  private:
    std::function<Scheme(double)> of_step_;
};

}  // namespace

std::function<std::unique_ptr<IntegratorOptions>()> without_options(const std::function<Scheme(double)>& scheme) {
    return [scheme] { return std::make_unique<SchemeAlone>(scheme); };
}

std::vector<std::string> integrators_with_thermostat() {
    std::vector<std::string> names;
    for (const IntegratorMethod& method : all_integrators()) {
        if (method.takes_thermostat) {
            names.push_back(method.name);
        }
    }
    return names;
}

IntegratorMethod find_integrator(const std::string& name) {
    return find_plugin(all_integrators(), name, "integrator");
}

ChosenIntegrator chosen_integrator(const Choice& choice) {
    return chosen(all_integrators(), choice, "integrator");
}

Integrator::Integrator(const IntegratorMethod& method, double time_step) : Integrator(choose(method), time_step) {}

Integrator::Integrator(const ChosenIntegrator& chosen, double time_step)
    : identity_(fmt::format("{} {} {}", chosen.plugin.name, time_step, settings_in_words(chosen.values))),
      scheme_(chosen.options->scheme(time_step)) {}

Integrator Integrator::with_mid_drift(const std::function<void(State&)>& change) const {
    Integrator changed = *this;
    for (std::vector<Operator>& operators : changed.scheme_.cycle) {
        std::vector<Operator> split;
        for (const Operator& op : operators) {
            if (const auto* drift = std::get_if<Drift>(&op)) {
                const Drift half{0.5 * drift->dt};
                split.insert(split.end(), {half, Thermalise{change}, half});
            } else {
                split.push_back(op);
            }
        }
        operators = std::move(split);
    }
    return changed;
}

void Integrator::prepare(State& state, ForceField& force_field) const {
    if (state.phase().integrator == identity_) {
        return;
    }
    if (!state.forces_are_current()) {
        force_field.evaluate(state, Request::forces);
    }
    apply(scheme_.begin, state, force_field, Request::forces);
    state.set_phase({identity_, 0});
}

Evaluation Integrator::step(State& state, ForceField& force_field, Request request, const StateWatch& within) const {
    const Evaluation evaluation = step_with_pending_kick(state, force_field, request, within);
    state.finish_kick();
    return evaluation;
}

Evaluation Integrator::step_with_pending_kick(State& state, ForceField& force_field, Request request,
                                              const StateWatch& within) const {
    prepare(state, force_field);
    const Index steps = state.phase().steps;
    const auto& operators = scheme_.cycle[static_cast<std::size_t>(steps) % scheme_.cycle.size()];
    const Evaluation evaluation = apply(operators, state, force_field, request, within);
    state.set_phase({identity_, steps + 1});
    return evaluation;
}

void Integrator::reverse(State& state, ForceField& force_field) const {
    if (scheme_.reverse.empty()) {
        state.write_velocities() *= -1.0;
        return;
    }
    prepare(state, force_field);
    const State::Phase phase = state.phase();
    apply(scheme_.reverse, state, force_field, Request::forces);
    state.set_phase(phase);
}

}  // namespace ljmd
