#include "ljmd/observables/order_parameter.hpp"

#include "ljmd/core/threads.hpp"

namespace ljmd {

namespace {

/// cos(2 pi x) of four numbers as 1 - 2 sin^2(pi f), f the distance to the nearest whole number: error below 1e-13 for
/// |x| < 2^20. The library's cosine would take longer than all other observables of a row together.
Eigen::Array4d cos_of_turns(const Eigen::Array4d& x) {
    constexpr double rounding = 0x1.8p52;
    const Eigen::Array4d f = x - ((x + rounding) - rounding);
    const Eigen::Array4d z = f * f;
    // Taylor series of sin(pi f)/f at |f| <= 1/2; what is left out is below 4e-14.
    Eigen::Array4d s = Eigen::Array4d::Constant(7.952054001475508e-7);  // pi^17/17!
    for (const double coefficient :
         {-2.1915353447830204e-5, 4.6630280576761234e-4, -7.370430945714348e-3, 8.214588661112819e-2,
          -0.5992645293207919, 2.550164039877345, -5.167712780049969, 3.141592653589793}) {
        s = s * z + coefficient;
    }
    return 1.0 - 2.0 * z * s * s;
}

}  // namespace

TranslationalOrder::TranslationalOrder(Lattice lattice, Index cells)
    : planes_(static_cast<double>(cells) * (lattice == Lattice::fcc ? 2.0 : 1.0)) {}

double TranslationalOrder::operator()(const State& state) const {
    const Vec3 planes_per_length = planes_ * state.box().edges().cwiseInverse();
    const Eigen::Array4d turns(planes_per_length[0], planes_per_length[1], planes_per_length[2], 0.0);
    const auto r = state.positions();
    // Behind the three coordinates of an atom lies a zero, whose cosine is 1.
    const Eigen::Array4d sums = sum_over(state.count(), Eigen::Array4d(Eigen::Array4d::Zero()), [&](Index i) {
        return cos_of_turns(turns * Eigen::Map<const Eigen::Array4d>(r.col(i).data()));
    });
    return sums.head<3>().sum() / (3.0 * static_cast<double>(state.count()));
}

}  // namespace ljmd
