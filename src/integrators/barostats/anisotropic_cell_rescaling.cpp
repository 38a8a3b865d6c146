#include <fmt/format.h>

#include <cmath>

#include "core/random.hpp"
#include "core/schedule.hpp"
#include "integrators/barostats/cell_rescaling_options.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

/// Largest relative change of an edge at once. Sound runs change it by thousandths.
constexpr double largest_change = 0.1;

class AnisotropicCellRescaling : public Barostat {
  public:
    AnisotropicCellRescaling(double pressure, double mobility, Vec3 free, Every every, const PressureBath& bath)
        : pressure_(pressure),
          mobility_(mobility * bath.time_step * static_cast<double>(every.steps())),
          free_(std::move(free)),
          every_(every),
          bath_(bath),
          random_(bath.seed, RandomStream::barostat) {}

    [[nodiscard]] bool due(Index step_of_stage) const override { return every_.due(step_of_stage); }

    void apply(State& state, const VirialPressure& of_pairs) const override {
        const double volume = state.box().volume();
        const Vec3 pressure = of_pairs.along.array() + static_cast<double>(state.total()) * bath_.temperature / volume;
        const Vec3 drift = mobility_ * (pressure.array() - pressure_);
        const Vec3 noise = std::sqrt(2.0 * mobility_ * bath_.temperature / volume) * random_.normal(state.step, 0);
        const Vec3 change = free_.cwiseProduct(drift + noise);
        if (!(change.array().abs() < largest_change).all()) {  // not one that is NaN, either
            throw PhysicsError(fmt::format(
                "the barostat would change an edge by {:.2g} % at once: the pressures along the edges are {:.6g}, "
                "{:.6g} and {:.6g}, not {:.6g} epsilon/sigma^3; equilibrate at constant volume first, or give the "
                "barostat a longer time",
                100.0 * change.cwiseAbs().maxCoeff(), pressure[0], pressure[1], pressure[2], pressure_));
        }
        const Box box(state.box().edges().cwiseProduct(Vec3(change.array().exp())));
        if (box.shortest_edge() < bath_.shortest_edge) {
            throw PhysicsError(fmt::format(
                "the barostat would make an edge {:.6g} sigma long, less than two cutoffs: a fluid does not keep the "
                "shape of its box, and a crystal needs more atoms",
                box.shortest_edge()));
        }
        state.rescale_to(box);
    }

  private:
    double pressure_;
    double mobility_;  ///< n dt beta/(3 tau_p)
    Vec3 free_;        ///< 1 for edges that change, 0 for others
    Every every_;
    PressureBath bath_;
    Random random_;
};

struct AnisotropicCellRescalingOptions : CellRescalingOptions {
    std::string edges = "xyz";

    void describe(Description& description) override {
        describe_with(description,
                      {.pressure = "to be held along each edge; rho T + W_aa/V, with tail where the deck has it",
                       .time = "tau_p: relaxation time of the volume, if all edges change",
                       .compressibility = "isothermal, about that of the crystal"});
        description.choice("edges", {"xyz", "xy", "xz", "yz", "x", "y", "z"}, edges)
            .meaning("the edges that change, each by itself; the others keep their lengths");
    }
    [[nodiscard]] double volume_mobility() const override {
        return CellRescalingOptions::volume_mobility() * static_cast<double>(edges.size()) / 3.0;
    }
    [[nodiscard]] std::unique_ptr<Barostat> make(const PressureBath& bath) const override {
        const auto is_free = [&](char axis) { return edges.find(axis) == std::string::npos ? 0.0 : 1.0; };
        return std::make_unique<AnisotropicCellRescaling>(pressure, compressibility / (3.0 * time),
                                                          Vec3(is_free('x'), is_free('y'), is_free('z')), Every(every),
                                                          bath);
    }
};

}  // namespace

/// Stochastic cell rescaling in which each edge L_a changes by itself; angles stay right. With x_a = ln L_a,
///
///     dx_a = (beta/3 tau_p) (p_aa - p_0) dt + sqrt(2 T beta/(3 tau_p V)) dW_a,
///
/// p_aa = N T/V + W_aa/V with the temperature T of the thermostat. Every n steps the edges make a step of n dt, and
/// positions are scaled with them; velocities are not, see stochastic_cell_rescaling.cpp. The stationary density of
/// edges and of positions in units of them is
///
///     V^(N + 1) exp(-(U + p_0 V)/T) dx_x dx_y dx_z
///
/// because the drift is M T d ln(density)/dx_a + T dM/dx_a with the mobility M = beta/(3 tau_p V). So the volume has
/// the distribution of the isotropic method, V^N dV: dx_x dx_y dx_z is dV/V times what describes the shape. A crystal
/// resists a change of shape, and its edges fluctuate about those without shear stress. A fluid does not: its box
/// becomes ever flatter or longer, until an edge is shorter than two cutoffs and the run ends.
/// Source: Bernetti and Bussi (2020), doi:10.1063/5.0020514; for all components of the cell: Del Tatto et al. (2022),
/// doi:10.3390/app12031139
BarostatMethod anisotropic_cell_rescaling() {
    return {.name = "anisotropic-cell-rescaling",
            .meaning =
                "scale each edge of the box by itself, for crystals (Bernetti and Bussi 2020, Del Tatto et al. 2022); "
                "isothermal-isobaric with a canonical thermostat",
            .changes_shape = true,
            .options = [] { return std::make_unique<AnisotropicCellRescalingOptions>(); }};
}

}  // namespace ljmd
