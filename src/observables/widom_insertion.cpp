#include "observables/widom_insertion.hpp"

#include <cmath>
#include <utility>

#include "execution/loops.hpp"
#include "ljmd/detail/observables/thermodynamics.hpp"
#include "ljmd/detail/potentials/pair_term.hpp"
#include "model/velocities.hpp"
#include "observables/statistics/known_quantities.hpp"

namespace ljmd {

namespace {

/// Of a configuration: w = T^(3/2) exp(-psi/T), or exp(-psi/T) if T is held; T; psi w; energy of an atom.
enum Column : Index { weight_column, temperature_column, weighted_energy_column, atom_energy_column, columns };

constexpr double largest_error = 0.25;      // [T]
constexpr double largest_energy_gap = 1.0;  // [T]

}  // namespace

WidomInsertion::WidomInsertion(const SampledRun& run, Index insertions, Every every)
    : BlockMeans(every, columns),
      interaction_(run.interaction.value()),
      held_temperature_(run.held_temperature),
      is_film_(run.is_film),
      random_(run.seed, RandomStream::insertions),
      insertions_(insertions) {}

WidomInsertion::Weights WidomInsertion::mean_weights(const State& state, double temperature) {
    // The grid sorts and wraps atoms, so it works on a copy of the state.
    State scratch(state.count(), state.box(), state.execution());
    scratch.write_positions() = state.positions();
    const double cutoff = interaction_.potential.cutoff().radius;
    grid_.configure(scratch.box(), cutoff, scratch.count());
    grid_.sort(scratch, ghosts_);
    const Box& box = scratch.box();
    const ConstVectorView points = std::as_const(scratch).positions_and_ghosts();
    const double tail = 2.0 * interaction_.tail.energy(static_cast<double>(state.count()) / box.volume());

    const auto sum = interaction_.potential.visit([&](const auto& pair) {
        return sum_over<Eigen::Vector2d>(state.execution(), insertions_, [&](Index place) -> Eigen::Vector2d {
            const Vec3 r = random_.uniform(state.step, place).cwiseProduct(box.edges());
            double energy = 0.0;
            grid_.for_each_run(grid_.cell_at(r), [&](CellGrid::Run run) {
                for (std::int32_t k = run.first; k < run.last; ++k) {
                    const double r2 = (points.col(grid_.order()[static_cast<std::size_t>(k)]) - r).squaredNorm();
                    if (r2 < cutoff * cutoff) {
                        energy += pair_term(pair, r2).u;
                    }
                }
            });
            const double weight = std::exp(-(energy + tail) / temperature);
            return {weight, weight > 0.0 ? energy * weight : 0.0};
        });
    });
    return {sum[0] / static_cast<double>(insertions_), sum[1] / static_cast<double>(insertions_)};
}

void WidomInsertion::sample(const State& state, const Evaluation& evaluation) {
    const double t = held_temperature_ ? *held_temperature_ : temperature(state).value_or(0.0);
    const Weights weights = is_above_zero(t) ? mean_weights(state, t) : Weights();
    const double factor = held_temperature_ ? 1.0 : std::pow(t, 1.5);
    Eigen::VectorXd found(Index{columns});
    found[weight_column] = factor * weights.weight;
    found[temperature_column] = t;
    found[weighted_energy_column] = factor * weights.weighted_energy;
    found[atom_energy_column] = 2.0 * evaluation.potential_energy / static_cast<double>(state.count());
    means_.add(found);
}

bool WidomInsertion::tail_was_sampled(const Estimate& found) const {
    const Eigen::VectorXd mean = means_.mean();
    const double t = mean[temperature_column];
    const double gap = mean[weighted_energy_column] / mean[weight_column] - mean[atom_energy_column];
    return !(found.standard_error > largest_error * t) && gap <= largest_energy_gap * t;
}

std::vector<ObservableAverage> WidomInsertion::observables() const {
    if (samples() == 0) {
        return {};
    }
    const Eigen::VectorXd mean = means_.mean();
    const double t = mean[temperature_column];
    ObservableAverage average = average_of("excess_chemical_potential");
    if (!is_above_zero(t)) {
        average.remark = no_temperature;
        return {average};
    }
    if (mean[weight_column] > 0.0) {
        const double power = held_temperature_ ? 0.0 : 1.5;
        const double logarithm = std::log(mean[weight_column]) - power * std::log(t);
        Eigen::VectorXd gradient = Eigen::VectorXd::Zero(Index{columns});
        gradient[weight_column] = -t / mean[weight_column];
        gradient[temperature_column] = power - logarithm;
        const Estimate found = means_.estimate(-t * logarithm, gradient);
        if (tail_was_sampled(found)) {
            average.estimate = found;
        }
    }
    if (average.estimate && is_film_) {
        average.remark = "of the whole box: mu - T ln(Lambda^3 N/V) with N/V of liquid and vapour together";
    }
    if (!average.estimate) {
        average.remark = "too few insertions at low energies: try more insertions";
    }
    return {average};
}

}  // namespace ljmd
