#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "integrators/operators.hpp"
#include "ljmd/options/choice.hpp"

namespace ljmd {

/// What an integrator does, for one time step and one choice of options. Before and after every step, positions and
/// velocities of the state belong to the same time and the forces are current. Anything else that a method needs
/// (half-step velocities, the displacement of the last step) lies in vectors registered with the state.
struct Scheme {
    /// Start-up, once before the first step. Positions and velocities are synchronised, forces are current.
    std::vector<Operator> begin;
    /// Step n since the start-up applies cycle[n % cycle.size()].
    std::vector<std::vector<Operator>> cycle;
    /// Reverses the motion, for methods that keep more than positions and velocities. Empty: v = -v and a new start-up.
    std::vector<Operator> reverse;
};

/// The options of an integrator, see Description.
class IntegratorOptions {
  public:
    virtual ~IntegratorOptions() = default;
    virtual void describe(Description& /*description*/) {}
    [[nodiscard]] virtual Scheme scheme(double time_step) const = 0;

  protected:
    IntegratorOptions() = default;
    IntegratorOptions(const IntegratorOptions&) = default;
    IntegratorOptions& operator=(const IntegratorOptions&) = default;
};

/// For a method that has no options: its scheme by the time step.
[[nodiscard]] std::function<std::unique_ptr<IntegratorOptions>()> without_options(
    const std::function<Scheme(double time_step)>& scheme);

/// A way to advance Newton's equations in time. One file in src/integrators/methods each.
struct IntegratorMethod {
    std::string name;       ///< as a deck selects it
    std::string meaning;    ///< one line for the reference page
    int order;              ///< of its global error, with its default options: halving the step divides it by 2^order
    bool reversible;        ///< returns to its start, to rounding, when velocities are reversed
    bool adaptive = false;  ///< chooses steps of its own within the time step; the error hardly depends on the latter
    bool unbounded_only = false;    ///< for systems without a box
    bool takes_thermostat = false;  ///< thermostats may act within or around every step
    std::function<std::unique_ptr<IntegratorOptions>()>
        options;  ///< at their defaults; keys of a stage that selects it
};

using ChosenIntegrator = Chosen<IntegratorMethod, IntegratorOptions>;

/// Every integrator there is, in alphabetical order.
[[nodiscard]] std::vector<IntegratorMethod> all_integrators();

/// The names of those that take a thermostat.
[[nodiscard]] std::vector<std::string> integrators_with_thermostat();

/// @throws InputError for an unknown name
[[nodiscard]] IntegratorMethod find_integrator(const std::string& name);

/// The integrator of a choice with its options. @throws InputError see chosen()
[[nodiscard]] ChosenIntegrator chosen_integrator(const Choice& choice);

/// A method with one time step, applied to states.
///
/// All that it needs from one step to the next lies in the state (registered vectors and State::phase). So two
/// integrators with the same method, step and options continue each other's runs to the last bit. If anything else has
/// written positions or velocities since the last step (a thermostat, another method), it starts up again from them.
class Integrator {
  public:
    /// With all options at their defaults.
    Integrator(const IntegratorMethod& method, double time_step);
    Integrator(const ChosenIntegrator& chosen, double time_step);

    /// The same integrator with a change of the velocities in the middle of each drift.
    [[nodiscard]] Integrator with_mid_drift(const std::function<void(State&)>& change) const;

    /// Start-up of the method, unless the state continues from its last step. step() and reverse() do it themselves.
    /// Call it before them to see where the motion really begins: bit-reversible puts bodies without a box on its grid.
    void prepare(State& state, ForceField& force_field) const;

    /// Advance by one time step. The caller updates state.time and state.step.
    /// @param within  called with the states of an adaptive method after state.time and before the end of the step
    /// @return result of the last evaluation of the step, at the new positions
    /// @post forces are current
    Evaluation step(State& state, ForceField& force_field, Request request, const StateWatch& within = {}) const;

    /// The same, but a kick at the end of the step may be pending (see State::kick): faster, if velocities are not read
    /// after every step.
    Evaluation step_with_pending_kick(State& state, ForceField& force_field, Request request,
                                      const StateWatch& within = {}) const;

    /// Reverse the motion: velocities change sign, and the following steps lead back.
    void reverse(State& state, ForceField& force_field) const;

  private:
    std::string identity_;  ///< method, time step and options
    Scheme scheme_;
};

}  // namespace ljmd
