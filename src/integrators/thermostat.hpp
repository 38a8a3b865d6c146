#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ljmd/detail/model/state.hpp"
#include "ljmd/options/choice.hpp"

namespace ljmd {

/// Properties of the stage that a thermostat needs.
struct HeatBath {
    double temperature;        ///< target [epsilon/k_B]
    double time_step;          ///< [tau]
    std::uint64_t seed;        ///< seed of random numbers
    Index degrees_of_freedom;  ///< degrees of freedom of the atoms' motion
};

/// Holds a temperature by changing velocities, around the steps of an integrator or in the middle of its drift. Its
/// variables lie in State::bath, so that checkpoints contain them.
class Thermostat {
  public:
    virtual ~Thermostat() = default;

    /// State::bath at the beginning of a stage. The first number is the heat, see State::heat().
    [[nodiscard]] virtual std::vector<double> beginning() const { return {0.0}; }

    /// Called before every step of its stage.
    virtual void before_step(State& /*state*/) const {}

    /// Called in the middle of each drift if acts_mid_drift(). Forces may be stale.
    virtual void mid_drift(State& /*state*/) const {}
    [[nodiscard]] virtual bool acts_mid_drift() const { return false; }

    /// Called after every step of its stage.
    /// @param step_of_stage  1 after the first step
    virtual void after_step(State& /*state*/, Index /*step_of_stage*/) const {}

  protected:
    Thermostat() = default;
    Thermostat(const Thermostat&) = default;
    Thermostat& operator=(const Thermostat&) = default;
};

/// The options of a thermostat, see Description.
class ThermostatOptions {
  public:
    virtual ~ThermostatOptions() = default;
    virtual void describe(Description& description) = 0;
    /// The time tau_K of <dK/dt> = (<K> - K)/tau_K, by which the bath takes up a deviation of the kinetic energy [tau].
    /// 0 where there is no such time.
    [[nodiscard]] virtual double kinetic_energy_relaxation() const { return 0.0; }
    [[nodiscard]] virtual std::unique_ptr<Thermostat> make(const HeatBath& bath) const = 0;

  protected:
    ThermostatOptions() = default;
    ThermostatOptions(const ThermostatOptions&) = default;
    ThermostatOptions& operator=(const ThermostatOptions&) = default;
};

/// A thermostat, as decks select it. Each is one file in src/integrators/thermostats.
struct ThermostatMethod {
    std::string name;
    std::string meaning;
    bool canonical;           ///< samples the canonical ensemble (of a fluid at a temperature above 0)
    bool conserves_momentum;  ///< if not, the centre of mass moves thermally, as a particle of its mass
    bool every_step;          ///< acts within or around every step, see IntegratorMethod::takes_thermostat
    bool deterministic;       ///< draws no random numbers
    std::function<std::unique_ptr<ThermostatOptions>()> options;  ///< at their defaults
};

using ChosenThermostat = Chosen<ThermostatMethod, ThermostatOptions>;

/// All thermostats, in alphabetical order.
[[nodiscard]] std::vector<ThermostatMethod> all_thermostats();

/// @throws InputError for an unknown name
[[nodiscard]] ThermostatMethod find_thermostat(const std::string& name);

/// The thermostat of a choice with its options. @throws InputError see chosen()
[[nodiscard]] ChosenThermostat chosen_thermostat(const Choice& choice);

}  // namespace ljmd
