#include "ljmd/observables/order_parameter.hpp"

#include <numbers>

#include "ljmd/core/threads.hpp"

namespace ljmd {

TranslationalOrder::TranslationalOrder(Lattice lattice, Index cells)
    : planes_(static_cast<double>(cells) * (lattice == Lattice::fcc ? 2.0 : 1.0)) {}

double TranslationalOrder::operator()(const State& state) const {
    const Vec3 wave_vector = 2.0 * std::numbers::pi * planes_ * state.box().edges().cwiseInverse();
    const auto r = state.positions();
    const double sum =
        sum_over(state.count(), 0.0, [&](Index i) { return wave_vector.cwiseProduct(r.col(i)).array().cos().sum(); });
    return sum / (3.0 * static_cast<double>(state.count()));
}

}  // namespace ljmd
