// Compiled once for each SIMD level, see cmake/LjmdSimd.cmake.
#include "list_kernel.hpp"

#include "ljmd/core/simd_vector.hpp"

namespace ljmd {

namespace {

constexpr int lanes = simd::Floats::lanes;
using Ints = simd::RawVector<std::int32_t, lanes>;
using Reals = simd::RawVector<float, lanes>;
static_assert(lanes <= list_kernel_slack);

constexpr float nowhere = 0x1p60F;

template <class V, class T>
LJMD_INLINE V load(const T* from) {
    V v;
    __builtin_memcpy(&v, from, sizeof v);
    return v;
}

template <class V, class T>
LJMD_INLINE void copy(const T* from, T* to) {
    __builtin_memcpy(to, from, sizeof(V));
}

LJMD_INLINE void copy_vectors(const ConstCandidates& from, std::int32_t k, const Candidates& to, std::int32_t n) {
    copy<Reals>(from.x + k, to.x + n);
    copy<Reals>(from.y + k, to.y + n);
    copy<Reals>(from.z + k, to.z + n);
    copy<Ints>(from.index + k, to.index + n);
}

int gather(const ConstCandidates& from, const CellGrid::Run* runs, int run_count, const Candidates& to) {
    int count = 0;
    for (int run = 0; run < run_count; ++run) {
        const std::int32_t first = runs[run].first;
        const std::int32_t length = runs[run].length();
        // Most runs are no longer than this. A loop over their true length would end when the processor does not expect
        // it, which costs more than what is copied in vain; the next run overwrites that.
        constexpr int usual = list_kernel_slack;
        for (int k = 0; k < usual; k += lanes) {
            copy_vectors(from, first + k, to, count + k);
        }
        for (int k = usual; k < length; k += lanes) {
            copy_vectors(from, first + k, to, count + k);
        }
        count += length;
    }
    for (int k = 0; k < lanes; ++k) {
        to.x[count + k] = nowhere;
    }
    return count;
}

int neighbors_of(const Candidates& candidates, int count, float x, float y, float z, std::int32_t self, float range2,
                 std::int32_t* out) {
    const auto [all_x, all_y, all_z, indices] = candidates;
    std::int32_t* end = out;
    for (int k = 0; k < count; k += lanes) {
        const Reals dx = load<Reals>(all_x + k) - x;
        const Reals dy = load<Reals>(all_y + k) - y;
        const Reals dz = load<Reals>(all_z + k) - z;
        const Reals r2 = simd::multiply_add<float, lanes>(dz, dz, simd::multiply_add<float, lanes>(dy, dy, dx * dx));
        const Ints index = load<Ints>(indices + k);
        const Ints wanted = (r2 < range2) & (index != self);
        end += simd::store_selected<lanes>(end, index << 2, simd::bits_of<lanes>(wanted));
    }
    return static_cast<int>(end - out);
}

}  // namespace

template <>
ListKernel simd::compiled_here<ListKernel, simd::Here>() {
    return {gather, neighbors_of};
}

}  // namespace ljmd
