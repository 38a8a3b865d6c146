#include "ljmd/observables/widom_insertion.hpp"

#include <cmath>
#include <utility>

#include "ljmd/core/threads.hpp"
#include "ljmd/model/velocities.hpp"
#include "ljmd/observables/thermodynamics.hpp"
#include "ljmd/potentials/pair_term.hpp"

namespace ljmd {

WidomInsertion::WidomInsertion(const SampledRun& run, Index insertions, Every every)
    : interaction_(run.interaction.value()),
      held_temperature_(run.held_temperature),
      random_(run.seed, RandomStream::insertions),
      insertions_(insertions),
      every_(every),
      means_(2, Covariance::full) {}

double WidomInsertion::mean_weight(const State& state, double temperature) {
    // The grid sorts and wraps atoms, which must not happen to the running state.
    State scratch(state.count(), state.box());
    scratch.write_positions() = state.positions();
    const double cutoff = interaction_.potential.cutoff().radius;
    grid_.configure(scratch.box(), cutoff, scratch.count());
    grid_.sort(scratch, ghosts_);
    const Box& box = scratch.box();
    const ConstVectorView points = std::as_const(scratch).positions_and_ghosts();
    const double tail = 2.0 * interaction_.tail.energy(static_cast<double>(state.count()) / box.volume());

    const double sum = interaction_.potential.visit([&](const auto& pair) {
        return sum_over(insertions_, 0.0, [&](Index place) {
            const Vec3 r = random_.uniform(state.step, place).cwiseProduct(box.edges());
            double energy = tail;
            grid_.for_each_run(grid_.cell_at(r), [&](CellGrid::Run run) {
                for (std::int32_t k = run.first; k < run.last; ++k) {
                    const double r2 = (points.col(grid_.order()[static_cast<std::size_t>(k)]) - r).squaredNorm();
                    if (r2 < cutoff * cutoff) {
                        energy += pair_term(pair, r2).u;
                    }
                }
            });
            return std::exp(-energy / temperature);
        });
    });
    return sum / static_cast<double>(insertions_);
}

void WidomInsertion::sample(const State& state, const Evaluation& /*evaluation*/) {
    const double t = held_temperature_ ? *held_temperature_ : temperature(state).value_or(0.0);
    const double weight = is_above_zero(t) ? mean_weight(state, t) : 0.0;
    Eigen::VectorXd found(2);
    found << (held_temperature_ ? weight : std::pow(t, 1.5) * weight), t;
    means_.add(found);
}

std::vector<ObservableAverage> WidomInsertion::observables() const {
    if (samples() == 0) {
        return {};
    }
    const Eigen::VectorXd mean = means_.mean();
    const double t = mean[1];
    std::optional<Estimate> estimate;
    if (mean[0] > 0.0 && is_above_zero(t)) {
        const double power = held_temperature_ ? 0.0 : 1.5;
        const double logarithm = std::log(mean[0]) - power * std::log(t);
        const Eigen::Vector2d gradient(-t / mean[0], power - logarithm);
        estimate = means_.estimate(-t * logarithm, gradient);
    }
    return {{"excess_chemical_potential", "mu_ex", "epsilon", estimate, is_above_zero(t) ? "" : no_temperature}};
}

}  // namespace ljmd
