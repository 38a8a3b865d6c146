// Compiled once for each SIMD level, see cmake/LjmdSimd.cmake.
#include "neighbors/simd/list_kernel.hpp"

#include "execution/simd_vector.hpp"

namespace ljmd {

namespace {

/// The widest registers, also at the level x86-64-v4-256: a tenth less time there.
constexpr int lanes = simd::widest_register_bytes / 4;
using Ints = simd::RawVector<std::int32_t, lanes>;
using Reals = simd::RawVector<float, lanes>;
static_assert(lanes <= list_kernel_slack);

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
    copy<Ints>(from.entry + k, to.entry + n);
}

int gather(const ConstCandidates& from, const ClusterGrid::Run* runs, int run_count, const Candidates& to) {
    int count = 0;
    for (int run = 0; run < run_count; ++run) {
        const std::int32_t first = runs[run].first;
        const std::int32_t length = runs[run].length();
        // Most runs are no longer than this. A loop over the true length would be mispredicted at its end, which costs
        // more than the surplus copies. The next run overwrites them.
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

template <int atoms, int others>
PartCounts find_parts(const ConstCandidates& candidates, int count, const RowOfAtoms& row, float range2,
                      std::int32_t* lower, std::int32_t* upper) {
    constexpr int slots = ClusterGrid::slots;
    constexpr unsigned first_of_each = 0x1111U;
    const Reals limit = range2 - Reals{};
    const std::int32_t* const begin[2] = {lower, upper};
    for (int k = 0; k < count; k += lanes) {
        const Reals x = load<Reals>(candidates.x + k);
        const Reals y = load<Reals>(candidates.y + k);
        const Reals z = load<Reals>(candidates.z + k);
        Reals least{};
        for (int n = 0; n < atoms; ++n) {
            const Reals dx = x - row.x[n];
            const Reals dy = y - row.y[n];
            const Reals dz = z - row.z[n];
            const Reals r2 =
                simd::multiply_add<float, lanes>(dz, dz, simd::multiply_add<float, lanes>(dy, dy, dx * dx));
            least = n == 0 ? r2 : simd::smaller<float, lanes>(r2, least);
        }
        unsigned near = simd::bits_of_less<lanes>(least, limit);
        for (int n = 1; n < others; n *= 2) {  // a part is near if one of its points is
            near |= near >> n;
        }
        lower += simd::pack<lanes, slots>(candidates.entry + k, near & first_of_each, lower);
        if constexpr (others == 2) {
            upper += simd::pack<lanes, slots>(candidates.entry + k + others, near >> others & first_of_each, upper);
        }
    }
    return {static_cast<int>(lower - begin[0]), static_cast<int>(upper - begin[1])};
}

PartCounts parts_near(const ConstCandidates& candidates, int count, const RowOfAtoms& row, float range2,
                      std::int32_t* lower, std::int32_t* upper) {
    if (row.shape.others == 2) {
        return row.shape.atoms == 1 ? find_parts<1, 2>(candidates, count, row, range2, lower, upper)
                                    : find_parts<2, 2>(candidates, count, row, range2, lower, upper);
    }
    return row.shape.atoms == 2 ? find_parts<2, 4>(candidates, count, row, range2, lower, upper)
                                : find_parts<4, 4>(candidates, count, row, range2, lower, upper);
}

}  // namespace

template <>
ListKernel simd::compiled_here<ListKernel, simd::Here>() {
    return {gather, parts_near};
}

}  // namespace ljmd
