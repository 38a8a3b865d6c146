#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ljmd/core/section.hpp"
#include "ljmd/integrators/operators.hpp"

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

/// An integrator of Newton's equations, as decks select it. Each is one file in src/integrators/methods.
struct IntegratorMethod {
    std::string name;       ///< as a deck selects it
    std::string meaning;    ///< one line for the reference page
    int order;              ///< order of the global error with default options: halving the step divides it by 2^order
    bool reversible;        ///< returns to its start, within rounding, when velocities are reversed
    bool adaptive = false;  ///< takes steps of its own within the time step, which hardly affects the error
    bool unbounded_only = false;  ///< only for systems without a box
    std::vector<Key> keys;        ///< options of a stage that selects it
    std::function<Scheme(double time_step, const Section& options)> scheme;
};

/// All integrators, in alphabetical order.
[[nodiscard]] std::vector<IntegratorMethod> all_integrators();

/// @throws InputError for an unknown name
[[nodiscard]] IntegratorMethod find_integrator(const std::string& name);

/// A method with one time step, applied to states.
///
/// All that it needs from one step to the next lies in the state (registered vectors and State::phase). So two
/// integrators with the same method, step and options continue each other's runs to the last bit. If anything else has
/// written positions or velocities since the last step (a thermostat, another method), it starts up again from them.
class Integrator {
  public:
    /// @param options  values of the method's keys; without them the defaults apply
    Integrator(const IntegratorMethod& method, double time_step);
    Integrator(const IntegratorMethod& method, double time_step, const Section& options);

    /// The same integrator with a change of the velocities in the middle of each drift.
    [[nodiscard]] Integrator with_half_way(const std::function<void(State&)>& change) const;

    /// Start-up of the method, unless the state continues from its last step. step() and reverse() do it themselves.
    /// Call it before them to see where the motion really begins: bit-reversible puts bodies without a box on its grid.
    void prepare(State& state, ForceField& force_field) const;

    /// Advance by one time step. The caller updates state.time and state.step.
    /// @param within  called with the states of an adaptive method after state.time and before the end of the step
    /// @return result of the last evaluation of the step, at the new positions
    /// @post forces are current
    Evaluation step(State& state, ForceField& force_field, Request request, const StateWatch& within = {}) const;

    /// Reverse the motion: velocities change sign, and the following steps lead back.
    void reverse(State& state, ForceField& force_field) const;

  private:
    std::string identity_;  ///< method, time step and options
    Scheme scheme_;
};

}  // namespace ljmd
