// Compiled once for each SIMD level, see cmake/LjmdSimd.cmake.
#include "list_kernel.hpp"

#include "ljmd/core/simd_vector.hpp"

namespace ljmd {

namespace {

constexpr int lanes = simd::Floats::lanes;
using Ints = simd::RawVector<std::int32_t, lanes>;
using Reals = simd::RawVector<float, lanes>;
static_assert(lanes <= list_kernel_slack);

template <class V, class T>
LJMD_INLINE V load(const T* from) {
    V v;
    __builtin_memcpy(&v, from, sizeof v);
    return v;
}

int neighbors_of(const Candidates& candidates, const CellGrid::Run* runs, int run_count, float x, float y, float z,
                 std::int32_t self, float range2, std::int32_t* out) {
    const auto [all_x, all_y, all_z, entries] = candidates;
    int count = 0;
    for (int run = 0; run < run_count; ++run) {
        const std::int32_t k = runs[run].first;
        const Reals dx = load<Reals>(all_x + k) - x;
        const Reals dy = load<Reals>(all_y + k) - y;
        const Reals dz = load<Reals>(all_z + k) - z;
        const Reals r2 = simd::multiply_add<float, lanes>(dz, dz, simd::multiply_add<float, lanes>(dy, dy, dx * dx));
        const Ints entry = load<Ints>(entries + k);
        const Ints wanted = (r2 < range2) & ~(entry == self);
        // Behind the end of a short run lie points of other cells.
        const unsigned inside = ~0U >> (32 - runs[run].length());
        count += simd::store_selected<lanes>(out + count, entry, simd::bits_of<lanes>(wanted) & inside);
    }
    return count;
}

}  // namespace

template <>
ListKernel simd::compiled_here<ListKernel, simd::Here>() {
    return {lanes, neighbors_of};
}

}  // namespace ljmd
