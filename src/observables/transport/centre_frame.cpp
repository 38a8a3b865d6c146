#include "observables/transport/centre_frame.hpp"

#include <algorithm>
#include <array>

#include "execution/loops.hpp"

namespace ljmd {

namespace {

constexpr std::array<const char*, 2> coefficients{"diffusion", "diffusion_green_kubo"};

/// Vectors of all atoms by id, relative to their mean by mass. @param vector  of the atom with this index in memory
template <class Vector>
Eigen::Matrix3Xd about_mean(const State& state, const Vector& vector) {
    const auto mass = [&](Index i) { return state.masses()[static_cast<std::size_t>(i)]; };
    const Vec3 sum =
        sum_over<Vec3>(state.execution(), state.count(), [&](Index i) -> Vec3 { return mass(i) * vector(i); });
    const Vec3 mean = sum / sum_over(state.execution(), state.count(), mass);
    Eigen::Matrix3Xd found(3, state.count());
    for_each_index(state.execution(), state.count(),
                   [&](Index i) { found.col(state.ids()[static_cast<std::size_t>(i)]) = vector(i) - mean; });
    return found;
}

}  // namespace

Eigen::Matrix3Xd positions_about_centre(const State& state) {
    return about_mean(state, [&](Index i) { return state.unwrapped(i); });
}

Eigen::Matrix3Xd velocities_about_centre(const State& state) {
    const auto v = state.velocities();
    return about_mean(state, [&](Index i) -> Vec3 { return v.col(i); });
}

void withdraw_diffusion(std::vector<ObservableAverage>& averages, const std::string& why) {
    for (ObservableAverage& average : averages) {
        if (std::ranges::find(coefficients, average.name) != coefficients.end()) {
            average.estimate.reset();
            average.remark = why;
        }
    }
}

}  // namespace ljmd
