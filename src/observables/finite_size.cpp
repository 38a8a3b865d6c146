#include "ljmd/observables/finite_size.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ljmd {

namespace {

constexpr double lattice_sum = 2.837297;  // of a cubic box

std::optional<Estimate> find(const std::vector<ObservableAverage>& averages, const std::string& name) {
    const auto found = std::ranges::find(averages, name, &ObservableAverage::name);
    return found == averages.end() ? std::nullopt : found->estimate;
}

bool is_cubic(const Box& box) {
    return box.edges().maxCoeff() - box.edges().minCoeff() <= 1e-9 * box.edges().maxCoeff();
}

}  // namespace

std::optional<ObservableAverage> diffusion_in_infinite_system(const std::vector<ObservableAverage>& averages,
                                                              const Box& box) {
    const auto diffusion = find(averages, "diffusion");
    const auto viscosity = find(averages, "viscosity");
    const auto temperature = find(averages, "temperature");
    if (!diffusion || !viscosity || !temperature || !is_cubic(box)) {
        return std::nullopt;
    }
    const double correction =
        lattice_sum * temperature->mean / (6.0 * std::numbers::pi * viscosity->mean * box.edges()[0]);
    Estimate infinite = *diffusion;
    infinite.mean += correction;
    infinite.standard_error =
        std::hypot(diffusion->standard_error, correction * viscosity->standard_error / viscosity->mean);
    infinite.converged = diffusion->converged && viscosity->converged;
    return ObservableAverage{"diffusion_infinite_system", "D_inf", "sigma^2/tau", infinite};
}

}  // namespace ljmd
