#include <cmath>

#include "integrators/thermostat.hpp"
#include "integrators/thermostats/relaxation_time.hpp"
#include "integrators/thermostats/velocity_changes.hpp"
#include "ljmd/detail/core/elementary.hpp"
#include "model/velocities.hpp"

namespace ljmd {

namespace {

/// Weights of the fourth-order composition of Suzuki and Yoshida with three steps.
const double outer_weight = 1.0 / (2.0 - cube_root(2.0));
const double inner_weight = 1.0 - 2.0 * outer_weight;

/// State::bath holds the heat, then velocity and position of each thermostat of the chain.
class NoseHooverChain : public Thermostat {
  public:
    NoseHooverChain(Index length, double time, const HeatBath& bath)
        : length_(static_cast<std::size_t>(length)),
          freedom_(static_cast<double>(bath.degrees_of_freedom)),
          temperature_(bath.temperature),
          mass_(bath.temperature * time * time),
          half_step_(0.5 * bath.time_step) {}

    [[nodiscard]] std::vector<double> beginning() const override { return std::vector<double>(1 + 2 * length_, 0.0); }

    void before_step(State& state) const override { advance(state); }
    void after_step(State& state, Index /*step_of_stage*/) const override { advance(state); }

  private:
    [[nodiscard]] double mass(std::size_t k) const { return k == 0 ? freedom_ * mass_ : mass_; }
    [[nodiscard]] static double& velocity(State& state, std::size_t k) { return state.bath[1 + 2 * k]; }
    [[nodiscard]] static double& position(State& state, std::size_t k) { return state.bath[2 + 2 * k]; }

    /// Acceleration of thermostat k by what it thermalises: the atoms, or the thermostat before it.
    [[nodiscard]] double acceleration(State& state, std::size_t k, double kinetic_energy) const {
        if (k == 0) {
            return (2.0 * kinetic_energy - freedom_ * temperature_) / mass(0);
        }
        const double v = velocity(state, k - 1);
        return (mass(k - 1) * v * v - temperature_) / mass(k);
    }

    /// Half a kick of thermostat k, damped by the next thermostat of the chain.
    void kick(State& state, std::size_t k, double kinetic_energy, double dt) const {
        const double damping = k + 1 < length_ ? exponential(-0.25 * dt * velocity(state, k + 1)) : 1.0;
        double& v = velocity(state, k);
        v = damping * (damping * v + 0.5 * dt * acceleration(state, k, kinetic_energy));
    }

    /// Half a step of the chain, including the velocities that it damps.
    void advance(State& state) const {
        state.finish_kick();
        const double at_first = kinetic_energy(state);
        if (!(at_first > 0.0) || freedom_ < 1.0) {
            return;
        }
        double factor = 1.0;
        for (const double weight : {outer_weight, inner_weight, outer_weight}) {
            const double dt = weight * half_step_;
            for (std::size_t k = length_; k-- > 0;) {
                kick(state, k, factor * factor * at_first, dt);
            }
            factor *= exponential(-dt * velocity(state, 0));
            for (std::size_t k = 0; k < length_; ++k) {
                position(state, k) += dt * velocity(state, k);
            }
            for (std::size_t k = 0; k < length_; ++k) {
                kick(state, k, factor * factor * at_first, dt);
            }
        }
        scale_velocities(state, factor, at_first);
        state.bath.front() = -energy(state);
    }

    /// Energy of the chain: the conserved energy of the extended system minus H.
    [[nodiscard]] double energy(State& state) const {
        double sum = 0.0;
        for (std::size_t k = 0; k < length_; ++k) {
            const double v = velocity(state, k);
            sum += 0.5 * mass(k) * v * v + (k == 0 ? freedom_ : 1.0) * temperature_ * position(state, k);
        }
        return sum;
    }

    std::size_t length_;
    double freedom_;
    double temperature_;
    double mass_;  ///< mass of every thermostat of the chain except the first
    double half_step_;
};

struct NoseHooverChainOptions : ThermostatOptions {
    double time = 0.5;
    Index length = 3;

    void describe(Description& description) override {
        describe_relaxation_time(description, time, "time scale of the oscillations of the temperature");
        description.integer("length", length).at_least(1).at_most(100).meaning("thermostats in the chain");
    }
    [[nodiscard]] std::unique_ptr<Thermostat> make(const HeatBath& bath) const override {
        return std::make_unique<NoseHooverChain>(length, time, bath);
    }
};

}  // namespace

/// Nose-Hoover chain of M thermostats: eta_1 damps the velocities, eta_(k+1) damps eta_k.
///
///     dv/dt = f/m - v_eta_1 v,   Q_1 dv_eta_1/dt = 2 K - f T - Q_1 v_eta_1 v_eta_2,
///     Q_k dv_eta_k/dt = Q_(k-1) v_eta_(k-1)^2 - T - Q_k v_eta_k v_eta_(k+1),   Q_1 = f T tau_T^2, Q_k = T tau_T^2
///
/// with f degrees of freedom. Half a step of the chain comes before each step of velocity Verlet and half a step after
/// it, in the fourth-order composition of Suzuki and Yoshida. Deterministic and time-reversible; conserves
///
///     H + sum Q_k v_eta_k^2/2 + f T eta_1 + T sum over k > 1 of eta_k
///
/// Canonical if the motion is ergodic; for a chain of 1 with one oscillator it is not.
/// Source: Martyna, Klein and Tuckerman (1992), doi:10.1063/1.463940; Martyna, Tuckerman, Tobias and Klein (1996),
/// doi:10.1080/00268979600100761
ThermostatMethod nose_hoover_chain() {
    return {.name = "nose-hoover-chain",
            .meaning =
                "a chain of thermostats with inertia, deterministic (Martyna, Klein and Tuckerman 1992); "
                "canonical",
            .canonical = true,
            .conserves_momentum = true,
            .every_step = true,
            .deterministic = true,
            .options = [] { return std::make_unique<NoseHooverChainOptions>(); }};
}

}  // namespace ljmd
