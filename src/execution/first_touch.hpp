#pragma once

#include <cstddef>

#include "execution/loops.hpp"
#include "ljmd/detail/core/aligned_vector.hpp"

namespace ljmd {

/// For FirstTouch: each thread of an execution touches its equal share of the pages of a block, about as
/// for_each_range() gives it the atoms. @pre the execution outlives it
[[nodiscard]] inline FirstTouch::Function touched_by_threads(const Execution& execution) {
    return [&execution](std::byte* memory, std::size_t bytes) {
        constexpr Index page = 4096;  // if pages are larger, each is touched several times
        const Index pages = (static_cast<Index>(bytes) + page - 1) / page;
        const Index threads = execution.threads();
        for_each_block(execution, threads, 1, [&](Index share, Index) {
            for (Index k = share * pages / threads; k < (share + 1) * pages / threads; ++k) {
                memory[k * page] = std::byte{0};
            }
        });
    };
}

}  // namespace ljmd
