#include "observables/simd/cosine_kernel.hpp"

#include "execution/simd_vector.hpp"

namespace ljmd {

namespace {

using Four = simd::RawVector<double, 4>;

/// cos(2 pi x) = 1 - 2 sin^2(pi f), f the distance to the nearest whole number. The library's cosine would take longer
/// than all other observables of a row together.
LJMD_INLINE Four cos_of_turns(Four x) {
    constexpr double rounding = 0x1.8p52;
    const Four f = x - ((x + rounding) - rounding);
    const Four z = f * f;
    // Taylor series of sin(pi f)/f for |f| <= 1/2; the remainder is below 4e-14.
    Four s = 7.952054001475508e-7 - Four{};  // pi^17/17!
    for (const double coefficient :
         {-2.1915353447830204e-5, 4.6630280576761234e-4, -7.370430945714348e-3, 8.214588661112819e-2,
          -0.5992645293207919, 2.550164039877345, -5.167712780049969, 3.141592653589793}) {
        s = s * z + coefficient;
    }
    return 1.0 - 2.0 * z * s * s;
}

void sums_of_cosines(const double* r, Index count, const double* turns, const double* start, double* sums) {
    Four turns_of_axes;
    Four start_of_axes;
    __builtin_memcpy(&turns_of_axes, turns, sizeof turns_of_axes);
    __builtin_memcpy(&start_of_axes, start, sizeof start_of_axes);
    // Adding and subtracting this number rounds a cosine to a multiple of 2^-42, so that the sum is exact.
    constexpr double rounding = 0x1.8p10;
    Four sum{};
    for (Index i = 0; i < count; ++i) {
        const Four cosine =
            cos_of_turns(turns_of_axes * simd::load_aligned<double, 4>(r + vector_stride * i) - start_of_axes);
        sum += (cosine + rounding) - rounding;
    }
    __builtin_memcpy(sums, &sum, sizeof sum);
}

}  // namespace

template <>
CosineKernel simd::compiled_here<CosineKernel, simd::LJMD_SIMD_LEVEL>() {
    return {sums_of_cosines};
}

}  // namespace ljmd
