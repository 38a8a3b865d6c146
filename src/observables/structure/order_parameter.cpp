#include "observables/structure/order_parameter.hpp"

#include "execution/loops.hpp"
#include "observables/simd/cosine_kernel.hpp"

namespace ljmd {

TranslationalOrder::TranslationalOrder(Lattice lattice, Index cells, Index layers)
    : planes_(Eigen::Matrix<Index, 3, 1>(cells, cells, layers).cast<double>() * (lattice == Lattice::fcc ? 2.0 : 1.0)) {
}

/// The planes along an edge are as far apart as the edge has room for, the first one at 0: their centre of mass lies at
/// (planes - 1)/2 of their distances.
Vec3 TranslationalOrder::drift(const State& state) const {
    const Vec3 planes_per_length = planes_.cwiseQuotient(state.box().edges());
    const Vec3 sum = sum_over<Vec3>(state.execution(), state.count(), [&](Index i) -> Vec3 {
        return state.unwrapped(i).cwiseProduct(planes_per_length);
    });
    return (sum / static_cast<double>(state.total())).array() - 0.5 * (planes_.array() - 1.0);
}

double TranslationalOrder::operator()(const State& state) const {
    const Vec3 planes_per_length = planes_.cwiseQuotient(state.box().edges());
    const Eigen::Vector4d turns(planes_per_length[0], planes_per_length[1], planes_per_length[2], 0.0);
    const Vec3 moved = drift(state);
    const Vec3 part_of_turn = moved - Vec3(moved.array().round());
    const Eigen::Vector4d start(part_of_turn[0], part_of_turn[1], part_of_turn[2], 0.0);
    const CosineKernel kernel = cosine_kernel(state.execution().simd());
    const double* r = state.positions().data();  // the three coordinates of an atom are followed by a zero
    const auto sums =
        sum_over_blocks<Eigen::Vector4d>(state.execution(), state.count(), sum_block, [&](Index first, Index last) {
            Eigen::Vector4d of_block;
            kernel.sums_of_cosines(r + vector_stride * first, last - first, turns.data(), start.data(),
                                   of_block.data());
            return of_block;
        });
    return sums.head<3>().sum() / (3.0 * static_cast<double>(state.total()));
}

}  // namespace ljmd
