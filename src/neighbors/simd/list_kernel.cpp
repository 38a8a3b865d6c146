// Compiled once for each SIMD level, see cmake/LjmdSimd.cmake.
#include "list_kernel.hpp"

#include "ljmd/core/simd_vector.hpp"

namespace ljmd {

namespace {

constexpr int lanes = simd::Floats::lanes;
using Ints = simd::RawVector<std::int32_t, lanes>;
using Reals = simd::RawVector<float, lanes>;
static_assert(lanes <= list_kernel_slack);

LJMD_INLINE Ints load(const std::int32_t* from) {
    Ints v;
    __builtin_memcpy(&v, from, sizeof v);
    return v;
}

int neighbors_of(const Candidates& candidates, const CellGrid::Run* runs, int run_count, std::int32_t x, std::int32_t y,
                 std::int32_t z, std::int32_t self, float range2, std::int32_t* out) {
    Ints lane_number;
    for (int k = 0; k < lanes; ++k) {
        lane_number[k] = k;
    }
    int count = 0;
    for (int run = 0; run < run_count; ++run) {
        for (std::int32_t k = runs[run].first; k < runs[run].last; k += lanes) {
            const Reals dx = __builtin_convertvector(load(candidates.x + k) - x, Reals);
            const Reals dy = __builtin_convertvector(load(candidates.y + k) - y, Reals);
            const Reals dz = __builtin_convertvector(load(candidates.z + k) - z, Reals);
            const Reals r2 =
                simd::multiply_add<float, lanes>(dz, dz, simd::multiply_add<float, lanes>(dy, dy, dx * dx));
            const Ints entry = load(candidates.entries + k);
            const Ints wanted = (r2 < range2) & (entry != self) & (lane_number < runs[run].last - k);
            count += simd::store_selected<lanes>(out + count, entry, simd::bits_of<lanes>(wanted));
        }
    }
    return count;
}

}  // namespace

template <>
ListKernel simd::compiled_here<ListKernel, simd::Here>() {
    return neighbors_of;
}

}  // namespace ljmd
