#include <cmath>

#include "core/random.hpp"
#include "integrators/thermostat.hpp"
#include "integrators/thermostats/relaxation_time.hpp"
#include "integrators/thermostats/velocity_changes.hpp"
#include "ljmd/detail/core/elementary.hpp"

namespace ljmd {

namespace {

class Andersen : public Thermostat {
  public:
    Andersen(double time, const HeatBath& bath)
        : probability_(-exponential_minus_one(-bath.time_step / time)),
          temperature_(bath.temperature),
          chances_(bath.seed, RandomStream::collisions),
          velocities_(bath.seed, RandomStream::thermostat) {}

    void after_step(State& state, Index /*step_of_stage*/) const override {
        change_velocities(state, [&](const Vec3& v, double mass, Index id) -> Vec3 {
            if (chances_.uniform(state.step, id)[0] >= probability_) {
                return v;
            }
            return std::sqrt(temperature_ / mass) * velocities_.normal(state.step, id);
        });
    }

  private:
    double probability_;  ///< of a collision per step
    double temperature_;
    Random chances_;
    Random velocities_;
};

struct AndersenOptions : ThermostatOptions {
    double time = 1.0;

    void describe(Description& description) override {
        describe_relaxation_time(description, time, "mean time between two collisions of an atom");
    }
    [[nodiscard]] double kinetic_energy_relaxation() const override { return time; }
    [[nodiscard]] std::unique_ptr<Thermostat> make(const HeatBath& bath) const override {
        return std::make_unique<Andersen>(time, bath);
    }
};

}  // namespace

/// Andersen's thermostat: after each step, each atom collides with the bath with probability 1 - exp(-dt/tau_T) and
/// gets a velocity from the Maxwell distribution. Canonical; trajectories of single atoms are no longer Newtonian.
/// Source: Andersen (1980), doi:10.1063/1.439486
ThermostatMethod andersen() {
    return {.name = "andersen",
            .meaning = "atoms collide with a bath, each about once in `time` (Andersen 1980); canonical",
            .canonical = true,
            .conserves_momentum = false,
            .every_step = true,
            .deterministic = false,
            .options = [] { return std::make_unique<AndersenOptions>(); }};
}

}  // namespace ljmd
