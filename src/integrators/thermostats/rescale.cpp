#include "core/schedule.hpp"
#include "integrators/thermostat.hpp"
#include "model/velocities.hpp"

namespace ljmd {

namespace {

class Rescale : public Thermostat {
  public:
    Rescale(Every every, double temperature) : every_(every), temperature_(temperature) {}

    void after_step(State& state, Index step_of_stage) const override {
        if (every_.due(step_of_stage)) {
            state.finish_kick();
            const double before = kinetic_energy(state);
            rescale_velocities(state, temperature_);
            state.bath.front() += kinetic_energy(state) - before;
        }
    }

  private:
    Every every_;
    double temperature_;
};

struct RescaleOptions : ThermostatOptions {
    Index every = 20;

    void describe(Description& description) override {
        description.integer("every", every).at_least(1).step_interval().meaning("steps between rescalings");
    }
    [[nodiscard]] std::unique_ptr<Thermostat> make(const HeatBath& bath) const override {
        return std::make_unique<Rescale>(Every(every), bath.temperature);
    }
};

}  // namespace

/// Verlet's velocity rescaling: v *= sqrt(T / T_now) every n steps. Sets the kinetic temperature exactly but samples no
/// ensemble, so it is for equilibration only.
/// Source: Verlet (1967), doi:10.1103/PhysRev.159.98
ThermostatMethod rescale() {
    return {.name = "rescale",
            .meaning = "scale all velocities to the temperature every n steps (Verlet 1967); for equilibration only",
            .canonical = false,
            .conserves_momentum = true,
            .every_step = false,
            .deterministic = true,
            .options = [] { return std::make_unique<RescaleOptions>(); }};
}

}  // namespace ljmd
