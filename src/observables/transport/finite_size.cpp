#include "observables/transport/finite_size.hpp"
#include "observables/statistics/known_quantities.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ljmd {

namespace {

constexpr double lattice_sum = 2.837297;  // for a cubic box

const ObservableAverage* find(const std::vector<ObservableAverage>& averages, const std::string& name) {
    const auto found = std::ranges::find(averages, name, &ObservableAverage::name);
    return found == averages.end() ? nullptr : &*found;
}

bool is_cubic(const Box& box) {
    return box.edges().maxCoeff() - box.edges().minCoeff() <= 1e-9 * box.edges().maxCoeff();
}

}  // namespace

std::optional<ObservableAverage> diffusion_in_infinite_system(const std::vector<ObservableAverage>& averages,
                                                              const Box& box) {
    const ObservableAverage* const found = find(averages, "diffusion");
    const ObservableAverage* const resistance = find(averages, "viscosity");
    const ObservableAverage* const motion = find(averages, "temperature");
    if (found == nullptr || resistance == nullptr || motion == nullptr || !is_cubic(box)) {
        return std::nullopt;
    }
    ObservableAverage result = average_of("diffusion_infinite_system");
    const std::optional<Estimate>& diffusion = found->estimate;
    const std::optional<Estimate>& viscosity = resistance->estimate;
    const std::optional<Estimate>& temperature = motion->estimate;
    if (!diffusion || !viscosity || !temperature || !(viscosity->mean > 0.0)) {
        result.remark = "it takes diffusion, a viscosity above zero and temperature together";
        return result;
    }
    const double correction =
        lattice_sum * temperature->mean / (6.0 * std::numbers::pi * viscosity->mean * box.edges()[0]);
    Estimate infinite = *diffusion;
    infinite.mean += correction;
    infinite.standard_error =
        std::hypot(diffusion->standard_error, correction * viscosity->standard_error / viscosity->mean);
    infinite.converged = diffusion->converged && viscosity->converged;
    result.estimate = infinite;
    return result;
}

}  // namespace ljmd
