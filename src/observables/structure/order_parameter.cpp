#include "ljmd/observables/structure/order_parameter.hpp"

#include "../simd/cosine_kernel.hpp"
#include "ljmd/execution/loops.hpp"

namespace ljmd {

TranslationalOrder::TranslationalOrder(Lattice lattice, Index cells, Index layers)
    : planes_(Eigen::Matrix<Index, 3, 1>(cells, cells, layers).cast<double>() * (lattice == Lattice::fcc ? 2.0 : 1.0)) {
}

double TranslationalOrder::operator()(const State& state) const {
    const Vec3 planes_per_length = planes_.cwiseProduct(state.box().edges().cwiseInverse());
    const Eigen::Vector4d turns(planes_per_length[0], planes_per_length[1], planes_per_length[2], 0.0);
    const CosineKernel kernel = cosine_kernel(state.execution().simd());
    const double* r = state.positions().data();  // the three coordinates of an atom are followed by a zero
    const auto sums =
        sum_over_blocks<Eigen::Vector4d>(state.execution(), state.count(), sum_block, [&](Index first, Index last) {
            Eigen::Vector4d of_block;
            kernel.sums_of_cosines(r + vector_stride * first, last - first, turns.data(), of_block.data());
            return of_block;
        });
    return sums.head<3>().sum() / (3.0 * static_cast<double>(state.total()));
}

}  // namespace ljmd
