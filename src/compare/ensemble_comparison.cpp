#include "compare/ensemble_comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "compare/point_comparison.hpp"
#include "integrators/integrator.hpp"
#include "model/velocities.hpp"
#include "observables/structure/radial_distribution.hpp"

namespace ljmd {

namespace {

/// Sample size for which rdf_difference was measured.
constexpr double measured_frames = 300.0;
constexpr double measured_atoms = 864.0;

/// Samples of one program: temperature, potential energy per atom, pressure and g(r).
class Side {
  public:
    Side(const Fluid& fluid, const EnsembleOptions& options)
        : fluid_(fluid),
          freedom_(static_cast<double>(degrees_of_freedom(static_cast<Index>(fluid.masses.size())))),
          rdf_(std::max<Index>(options.bins, 1), options.radius, Every{1}) {}

    void add(const Totals& totals) {
        const auto atoms = static_cast<double>(fluid_.masses.size());
        Eigen::VectorXd row(3);
        row << (freedom_ > 0.0 ? 2.0 * totals.kinetic_energy / freedom_ : 0.0), totals.potential_energy / atoms,
            pressure(totals, fluid_);
        series_.add(row);
    }

    void add(const State& state) { rdf_.sample(state, {}); }

    [[nodiscard]] EnsembleAverages averages() const {
        return {{series_.estimate(0), series_.estimate(1), series_.estimate(2)},
                rdf_.samples() > 0 ? rdf_.tables().front() : DataTable{},
                rdf_.samples(),
                freedom_ > 0.0};
    }

  private:
    const Fluid& fluid_;
    double freedom_;
    BlockingAccumulator series_{3, Covariance::diagonal};
    RadialDistribution rdf_;
};

/// A state for g(r), from positions that may be outside the box.
State configuration_of(const Fluid& fluid, const std::vector<Vec3>& positions, const Execution& execution) {
    State state(static_cast<Index>(positions.size()), Box(fluid.edges), execution);
    auto r = state.write_positions();
    for (Index i = 0; i < state.count(); ++i) {
        const Vec3& place = positions[static_cast<std::size_t>(i)];
        r.col(i) = state.snapped(place - state.box().crossings(place).cwiseProduct(fluid.edges));
    }
    state.wrap();
    return state;
}

}  // namespace

EnsembleAverages our_averages(const Fluid& fluid, ForceField& force_field, const EnsembleOptions& options) {
    Side side(fluid, options);
    State state = state_of(fluid, options.execution);
    const Integrator method(find_integrator(options.integrator), options.time_step);
    force_field.evaluate(state, Request::forces_and_energy);
    method.prepare(state, force_field);
    for (Index step = 1; step <= options.steps; ++step) {
        const bool due = step % options.every == 0;
        const Evaluation evaluation = method.step(state, force_field, {.energy = due, .order_independent = false});
        if (due) {
            side.add(Totals{evaluation.potential_energy, kinetic_energy(state), evaluation.virial.trace()});
        }
        if (options.frame_every > 0 && step % options.frame_every == 0) {
            side.add(state);
        }
    }
    return side.averages();
}

EnsembleAverages their_averages(const Fluid& fluid, Peer& peer, const EnsembleOptions& options) {
    Side side(fluid, options);
    peer.sample(options.time_step, options.steps, options.every, options.frame_every,
                [&](Index, const Totals& totals, const std::vector<Vec3>* positions) {
                    side.add(totals);
                    if (positions != nullptr) {
                        side.add(configuration_of(fluid, *positions, options.execution));
                    }
                });
    return side.averages();
}

double EnsembleComparison::Row::sigmas() const {
    const double error = std::hypot(ours.standard_error, theirs.standard_error);
    const double difference = std::abs(ours.mean - theirs.mean);
    return difference == 0.0 ? 0.0 : difference / error;
}

double EnsembleComparison::largest_rdf_difference() const {
    double largest = 0.0;
    for (const Bin& bin : rdf) {
        largest = larger_or_nan(largest, std::abs(bin.ours - bin.theirs));
    }
    return largest;
}

EnsembleComparison compare_ensembles(const EnsembleAverages& ours, const EnsembleAverages& theirs) {
    EnsembleComparison comparison;
    constexpr std::array<std::array<const char*, 2>, 3> observables{
        {{"temperature", "T"}, {"potential_energy", "U/N"}, {"pressure", "p"}}};
    for (std::size_t k = 0; k < observables.size(); ++k) {
        if (k == 0 && !ours.has_temperature) {
            continue;
        }
        const auto& [name, symbol] = observables[k];
        comparison.rows.push_back({name, symbol, ours.estimates[k], theirs.estimates[k]});
    }
    comparison.frames = std::min(ours.frames, theirs.frames);
    const std::size_t bins = std::min(ours.rdf.rows.size(), theirs.rdf.rows.size());
    for (std::size_t k = 0; k < bins; ++k) {
        const std::vector<double>& a = ours.rdf.rows[k];
        const std::vector<double>& b = theirs.rdf.rows[k];
        comparison.rdf.push_back({a[0], a[1], a[2], b[1], b[2]});
    }
    return comparison;
}

std::vector<Check> checks_of(const EnsembleComparison& comparison, const Fluid& fluid) {
    std::vector<Check> checks;
    for (const EnsembleComparison::Row& row : comparison.rows) {
        checks.push_back({"mean " + row.name + ", standard errors apart", row.sigmas(), max_sigmas});
    }
    if (comparison.frames > 0) {
        const double pairs = static_cast<double>(comparison.frames) * static_cast<double>(fluid.masses.size());
        const double noise = std::sqrt(std::max(1.0, measured_frames * measured_atoms / pairs));
        checks.push_back({"g(r)", comparison.largest_rdf_difference(), rdf_difference * noise});
    }
    return checks;
}

}  // namespace ljmd
