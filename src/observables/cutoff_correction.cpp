#include "observables/cutoff_correction.hpp"

#include <cmath>

#include "execution/loops.hpp"
#include "ljmd/detail/observables/thermodynamics.hpp"
#include "ljmd/detail/potentials/pair_term.hpp"
#include "neighbors/pairs_within.hpp"
#include "observables/statistics/known_quantities.hpp"

namespace ljmd {

namespace {

// Per atom: A = u or P, the pressure without its kinetic part; d = D/N.
enum CutoffColumn : Index { energy, pressure, energy_more, pressure_more, energy_product, pressure_product };

/// Sums over pairs of what the formula has more than the truncated potential.
struct MissingPairs {
    double energy = 0.0;
    double virial = 0.0;
};

/// The pairs up to a radius. @param from  within it the two are the same
MissingPairs missing_pairs(const State& state, const PairPotential& potential, double from, double radius) {
    const PairsWithin pairs(state, radius);
    const double least = from * from;
    const auto sum_of_part = [&](Index part, Index) {
        MissingPairs sum;
        pairs.for_each(part, [&](const Neighbor& near) {
            if (near.r2 < least) {
                return;
            }
            const double r = std::sqrt(near.r2);
            const PairTerm<double> formula = potential.untruncated(r);
            const PairTerm<double> truncated = potential(r);
            // Each pair is met from both sides.
            sum.energy += 0.5 * (formula.u - truncated.u);
            sum.virial += 0.5 * (formula.w - truncated.w) * near.r2;
        });
        return sum;
    };
    return join_blocks(state.execution(), pairs.part_count(), 1, MissingPairs{}, sum_of_part,
                       [](MissingPairs& sum, const MissingPairs& part) {
                           sum.energy += part.energy;
                           sum.virial += part.virial;
                       });
}

constexpr double least_radius = 2.5;  // [sigma]
constexpr const char* short_radius = "pairs are counted up to less than 2.5 sigma: g = 1 beyond is no good assumption";
constexpr const char* not_canonical =
    "the response to the cutoff is known in the canonical ensemble alone: one sampled stage with a thermostat that "
    "holds the temperature, and no barostat";

}  // namespace

CutoffCorrection::CutoffCorrection(const SampledRun& run, double radius, Every every)
    : BlockMeans(every, columns),
      interaction_(run.interaction.value()),
      beyond_(interaction_.potential.formula_beyond(radius)),
      radius_(radius),
      atoms_(static_cast<double>(run.atoms)),
      temperature_(run.ensemble == Ensemble::canonical ? run.held_temperature : std::nullopt) {}

void CutoffCorrection::sample(const State& state, const Evaluation& evaluation) {
    const PairPotential& potential = interaction_.potential;
    const double volume = state.box().volume();
    const double density = atoms_ / volume;
    // The truncations that take no tail change the energy of all pairs, by a shift.
    const double from = PairPotential::takes_tail(potential.truncation()) ? potential.changes_from() : 0.0;
    const MissingPairs missing = missing_pairs(state, potential, from, radius_);
    Eigen::VectorXd found(columns);
    found[energy] = evaluation.potential_energy / atoms_ + interaction_.tail.energy(density);
    found[pressure] = virial_pressure(state, evaluation, interaction_.tail);
    found[energy_more] = missing.energy / atoms_ + beyond_.energy(density) - interaction_.tail.energy(density);
    found[pressure_more] =
        missing.virial / (3.0 * volume) + beyond_.pressure(density) - interaction_.tail.pressure(density);
    found[energy_product] = (found[energy] + found[energy_more]) * found[energy_more];
    found[pressure_product] = (found[pressure] + found[pressure_more]) * found[energy_more];
    means_.add(found);
}

std::vector<ObservableAverage> CutoffCorrection::observables() const {
    if (samples() == 0) {
        return {};
    }
    const Eigen::VectorXd mean = means_.mean();
    const auto result = [&](const char* name, Index a, Index more, Index product, bool direct) {
        if (!temperature_) {
            return average_of(name, std::nullopt, not_canonical);
        }
        const double factor = atoms_ / *temperature_;
        const double total = mean[a] + mean[more];  // <A_R>
        double value = -factor * (mean[product] - total * mean[energy_more]);
        Eigen::VectorXd gradient = Eigen::VectorXd::Zero(columns);
        gradient[product] = -factor;
        gradient[a] = factor * mean[energy_more];
        gradient[more] += factor * mean[energy_more];
        gradient[energy_more] += factor * total;
        if (direct) {
            value += mean[more];
            gradient[more] += 1.0;
        }
        return average_of(name, means_.estimate(value, gradient), radius_ < least_radius ? short_radius : "");
    };
    return {result("cutoff_energy", energy, energy_more, energy_product, true),
            result("cutoff_pressure", pressure, pressure_more, pressure_product, true),
            result("cutoff_energy_response", energy, energy_more, energy_product, false),
            result("cutoff_pressure_response", pressure, pressure_more, pressure_product, false)};
}

}  // namespace ljmd
