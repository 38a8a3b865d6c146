#include <cmath>

#include "core/random.hpp"
#include "integrators/thermostat.hpp"
#include "integrators/thermostats/relaxation_time.hpp"
#include "integrators/thermostats/velocity_changes.hpp"
#include "ljmd/detail/core/elementary.hpp"

namespace ljmd {

namespace {

class Langevin : public Thermostat {
  public:
    Langevin(double time, const HeatBath& bath)
        : kept_(exponential(-bath.time_step / time)),
          gained2_(-exponential_minus_one(-2.0 * bath.time_step / time) * bath.temperature),
          random_(bath.seed, RandomStream::thermostat) {}

    [[nodiscard]] bool acts_mid_drift() const override { return true; }

    void mid_drift(State& state) const override {
        change_velocities(state, [&](const Vec3& v, double mass, Index id) -> Vec3 {
            return kept_ * v + std::sqrt(gained2_ / mass) * random_.normal(state.step, id);
        });
    }

  private:
    double kept_;     ///< c = exp(-dt/tau_T)
    double gained2_;  ///< (1 - c^2) T
    Random random_;
};

struct LangevinOptions : ThermostatOptions {
    double time = 1.0;

    void describe(Description& description) override {
        describe_relaxation_time(description, time, "relaxation time of velocities by friction");
    }
    [[nodiscard]] double kinetic_energy_relaxation() const override { return 0.5 * time; }
    [[nodiscard]] std::unique_ptr<Thermostat> make(const HeatBath& bath) const override {
        return std::make_unique<Langevin>(time, bath);
    }
};

}  // namespace

/// Langevin dynamics, m dv/dt = f - m v/tau_T + noise, in the BAOAB splitting: in the middle of velocity Verlet's
/// drift,
///
///     v = c v + sqrt((1 - c^2) T/m) xi,   c = exp(-dt/tau_T),   xi normal
///
/// Canonical. Configurations are accurate to a higher order than velocities. At whole steps the kinetic energy of
/// vibrations of frequency omega is too low by a relative (omega dt)^2/4; in the middle of the drift it is correct.
/// Source: Leimkuhler and Matthews (2013), doi:10.1093/amrx/abs010; doi:10.1063/1.4802990
ThermostatMethod langevin() {
    return {.name = "langevin",
            .meaning = "friction and noise on every atom, BAOAB (Leimkuhler and Matthews 2013); canonical",
            .canonical = true,
            .conserves_momentum = false,
            .every_step = true,
            .deterministic = false,
            .options = [] { return std::make_unique<LangevinOptions>(); }};
}

}  // namespace ljmd
