#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "integrators/thermostat.hpp"
#include "integrators/thermostats/relaxation_time.hpp"
#include "integrators/thermostats/velocity_changes.hpp"
#include "ljmd/detail/core/elementary.hpp"
#include "model/velocities.hpp"

namespace ljmd {

namespace {

class StochasticRescaling : public Thermostat {
  public:
    StochasticRescaling(double time, const HeatBath& bath)
        : kept_(exponential(-bath.time_step / time)),
          freedom_(static_cast<double>(bath.degrees_of_freedom)),
          temperature_(bath.temperature),
          random_(bath.seed, RandomStream::thermostat) {}

    void after_step(State& state, Index /*step_of_stage*/) const override {
        state.finish_kick();
        const double now = kinetic_energy(state);
        if (!(now > 0.0) || freedom_ < 1.0) {
            return;
        }
        const double gained = 0.5 * (1.0 - kept_) * temperature_;  // per degree of freedom
        const double one = random_.normal(state.step, 0)[0];
        const double others = freedom_ > 1.0 ? 2.0 * random_.gamma(state.step, 1, 0.5 * (freedom_ - 1.0)) : 0.0;
        const double along = std::sqrt(kept_ * now) + std::sqrt(gained) * one;
        const double wanted = along * along + gained * others;
        scale_velocities(state, std::copysign(std::sqrt(wanted / now), along), now);
    }

  private:
    double kept_;  ///< c = exp(-dt/tau_T)
    double freedom_;
    double temperature_;
    Random random_;
};

struct StochasticRescalingOptions : ThermostatOptions {
    double time = 0.5;

    void describe(Description& description) override {
        describe_relaxation_time(description, time, "relaxation time of the kinetic energy");
    }
    [[nodiscard]] double kinetic_energy_relaxation() const override { return time; }
    [[nodiscard]] std::unique_ptr<Thermostat> make(const HeatBath& bath) const override {
        return std::make_unique<StochasticRescaling>(time, bath);
    }
};

}  // namespace

/// Stochastic velocity rescaling: after a step all velocities are scaled so that the kinetic energy becomes
///
///     K' = (sqrt(c K) + sqrt((1 - c) T/2) R)^2 + (1 - c) T/2 S,   c = exp(-dt/tau_T)
///
/// with R normal, S the sum of f - 1 squared normal numbers, and f the degrees of freedom. The scaling factor has the
/// sign of the bracket. This is the kinetic energy of f velocities under friction and noise, so K relaxes within tau_T
/// and has the canonical distribution. Trajectories of single atoms are hardly disturbed.
/// Source: Bussi, Donadio and Parrinello (2007), doi:10.1063/1.2408420; Bussi and Parrinello (2008),
/// doi:10.1016/j.cpc.2008.01.006
ThermostatMethod stochastic_rescaling() {
    return {.name = "stochastic-rescaling",
            .meaning =
                "scale all velocities to a kinetic energy from the canonical distribution (Bussi, Donadio and "
                "Parrinello 2007); canonical",
            .canonical = true,
            .conserves_momentum = true,
            .every_step = true,
            .deterministic = false,
            .options = [] { return std::make_unique<StochasticRescalingOptions>(); }};
}

}  // namespace ljmd
