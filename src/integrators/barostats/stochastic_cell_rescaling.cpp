#include <fmt/format.h>

#include <cmath>

#include "core/random.hpp"
#include "core/schedule.hpp"
#include "integrators/barostats/cell_rescaling_options.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/core/elementary.hpp"

namespace ljmd {

namespace {

/// Largest relative change of the square root of the volume at once. Sound runs change it by thousandths.
constexpr double largest_change = 0.05;

class StochasticCellRescaling : public Barostat {
  public:
    StochasticCellRescaling(double pressure, double mobility, Every every, const PressureBath& bath)
        : pressure_(pressure),
          mobility_(mobility * bath.time_step * static_cast<double>(every.steps())),
          every_(every),
          bath_(bath),
          random_(bath.seed, RandomStream::barostat) {}

    [[nodiscard]] bool due(Index step_of_stage) const override { return every_.due(step_of_stage); }

    void apply(State& state, const VirialPressure& of_pairs) const override {
        const double volume = state.box().volume();
        const double pressure = static_cast<double>(state.total()) * bath_.temperature / volume + of_pairs.mean;
        const double root = std::sqrt(volume);
        const double drift = -0.5 * mobility_ * root * (pressure_ - pressure - 0.5 * bath_.temperature / volume);
        const double noise = std::sqrt(0.5 * mobility_ * bath_.temperature) * random_.normal(state.step, 0)[0];
        const double change = (drift + noise) / root;
        if (!(std::abs(change) < largest_change)) {
            throw PhysicsError(fmt::format(
                "the barostat would change the volume by {:.2g} % at once: the pressure is {:.6g}, not {:.6g} "
                "epsilon/sigma^3; equilibrate at constant volume first, or give the barostat a longer time",
                100.0 * ((1.0 + change) * (1.0 + change) - 1.0), pressure, pressure_));
        }
        rescale(state, cube_root((1.0 + change) * (1.0 + change)));
    }

  private:
    void rescale(State& state, double factor) const {
        const Box box(factor * state.box().edges());
        if (box.shortest_edge() < bath_.shortest_edge) {
            throw PhysicsError(
                fmt::format("the barostat would make the box {:.6g} sigma long, less than two cutoffs: it needs more "
                            "atoms",
                            box.shortest_edge()));
        }
        state.rescale_to(box);
    }

    double pressure_;
    double mobility_;  ///< n dt beta/tau_p
    Every every_;
    PressureBath bath_;
    Random random_;
};

struct StochasticCellRescalingOptions : CellRescalingOptions {
    void describe(Description& description) override {
        describe_with(description,
                      {.pressure = "to be held; rho T + W/(3 V), with tail where the deck has it",
                       .time = "tau_p: relaxation time of the volume",
                       .compressibility = "isothermal, about that of the fluid; 0.05 is that of the liquid near its "
                                          "triple point, a gas has 1/p"});
    }
    [[nodiscard]] std::unique_ptr<Barostat> make(const PressureBath& bath) const override {
        return std::make_unique<StochasticCellRescaling>(pressure, compressibility / time, Every(every), bath);
    }
};

}  // namespace

/// Stochastic cell rescaling, isotropic. The volume V obeys
///
///     dV = -(beta V/tau_p) (p_0 - p - T/V) dt + sqrt(2 T beta V/tau_p) dW
///
/// p = N T/V + W/(3 V) with the temperature T of the thermostat. Every n steps, lambda = sqrt(V), whose noise does not
/// depend on the volume, makes a step of n dt,
///
///     d lambda = -(beta lambda/2 tau_p) (p_0 - p - T/(2 V)) dt + sqrt(T beta/(2 tau_p)) dW,
///
/// and positions are scaled by (V'/V)^(1/3). Velocities are not scaled: at constant temperature their distribution does
/// not depend on the volume. The stationary density of V and of the positions in units of the edges is V^N exp(-(U +
/// p_0 V)/T) under every canonical thermostat: the isothermal-isobaric ensemble, in which the mean of p is p_0. The
/// kinetic energy does not enter p, for two reasons: its mean is (3 N - 3) T/2 where momentum is conserved, and
/// velocities can have time-step errors that positions do not have (Langevin).
///
/// The compressibility beta need only be known roughly. With the true one, the volume relaxes within tau_p.
/// Source: Bernetti and Bussi (2020), doi:10.1063/5.0020514, who scale velocities by the inverse factor and use the
/// instantaneous kinetic energy in place of 3 N T/2.
BarostatMethod stochastic_cell_rescaling() {
    return {.name = "stochastic-cell-rescaling",
            .meaning =
                "scale the box so that its volume fluctuates as at constant pressure (Bernetti and Bussi 2020); "
                "isothermal-isobaric with a canonical thermostat",
            .options = [] { return std::make_unique<StochasticCellRescalingOptions>(); }};
}

}  // namespace ljmd
