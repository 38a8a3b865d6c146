#include "observables/configurational_temperature.hpp"

#include "observables/pair_curvature.hpp"
#include "observables/squared_forces.hpp"
#include "observables/statistics/known_quantities.hpp"

namespace ljmd {

namespace {

/// Of a configuration: the sum of f^2 and the Laplacian, both per atom.
enum RatioColumn : Index { force_column, laplacian_column, ratio_columns };

}  // namespace

ConfigurationalTemperature::ConfigurationalTemperature(const SampledRun& run, Every every)
    : BlockMeans(every, ratio_columns), interaction_(run.interaction.value()) {}

void ConfigurationalTemperature::sample(const State& state, const Evaluation& /*evaluation*/) {
    const auto atoms = static_cast<double>(state.count());
    Eigen::VectorXd found(Index{ratio_columns});
    found[force_column] = squared_forces_over_mass(state) / atoms;
    found[laplacian_column] = pair_curvature(state, interaction_.potential).laplacian / atoms;
    means_.add(found);
}

std::vector<ObservableAverage> ConfigurationalTemperature::observables() const {
    if (samples() == 0) {
        return {};
    }
    ObservableAverage average = average_of("configurational_temperature");
    const Eigen::VectorXd mean = means_.mean();
    const Estimate laplacian = means_.estimate(laplacian_column);
    if (!(laplacian.mean > 4.0 * laplacian.standard_error)) {
        average.remark = "it is divided by the curvature of the potential, which is not known to be above zero";
        return {average};
    }
    const double temperature = mean[force_column] / mean[laplacian_column];
    Eigen::VectorXd gradient(Index{ratio_columns});
    gradient[force_column] = 1.0 / mean[laplacian_column];
    gradient[laplacian_column] = -temperature / mean[laplacian_column];
    average.estimate = means_.estimate(temperature, gradient);
    return {average};
}

}  // namespace ljmd
