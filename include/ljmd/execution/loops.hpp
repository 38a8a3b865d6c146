#pragma once

#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/execution/execution.hpp"
#include "ljmd/execution/thread_team.hpp"

namespace ljmd {

/// Loops over atoms, shared by the threads of an Execution. No result depends on their number: loops are cut into
/// blocks of fixed length, and the results of blocks are joined in their order.

/// Atoms per block in loops without a sum. Blocks are so small that the threads of a small system move the same atoms
/// whose forces they have just summed; otherwise data would pass between cores.
inline constexpr Index loop_block = 128;
/// Atoms per block in sums; the last digits of sums depend on it.
inline constexpr Index sum_block = 1024;

/// ThreadTeam::for_each_block of the execution's threads.
inline void for_each_block(const Execution& execution, Index count, Index block_length, BlockFunction function) {
    execution.team().for_each_block(count, block_length, function);
}

/// Call function(i) for i in [0, count), by all threads. @pre as for_each_block
template <class F>
void for_each_index(const Execution& execution, Index count, F&& function) {
    for_each_block(execution, count, loop_block, [&function](Index first, Index last) {
        for (Index i = first; i < last; ++i) {
            function(i);
        }
    });
}

/// Join the results of the blocks of for_each_block in their order, so that the bits do not depend on the number of
/// threads.
///
///     join(...join(join(start, yield(0, L)), yield(L, 2 L))...)
///
/// @param start  result of no blocks
/// @param yield  T yield(first, last), called by all threads
/// @param join   void join(T& so_far, const T& next), called by the calling thread
/// @pre as for_each_block; memory for one T per block  @throws as for_each_block
template <class T, class Yield, class Join>
[[nodiscard]] T join_blocks(const Execution& execution, Index count, Index block_length, T start, Yield&& yield,
                            Join&& join) {
    std::vector<T> yields(static_cast<std::size_t>((count + block_length - 1) / block_length));
    for_each_block(execution, count, block_length, [&](Index first, Index last) {
        yields[static_cast<std::size_t>(first / block_length)] = yield(first, last);
    });
    for (const T& next : yields) {
        join(start, next);
    }
    return start;
}

/// Sum of term(i) for i in [0, count), by all threads: each block is summed from `zero`, then the blocks are added in
/// order.
/// @param term  returns something that can be added to a T; an Eigen value, not an expression  @pre as for_each_block
template <class T, class Term>
[[nodiscard]] T sum_over(const Execution& execution, Index count, const T& zero, Term&& term) {
    const auto sum_of_block = [&](Index first, Index last) {
        T sum = zero;
        for (Index i = first; i < last; ++i) {
            sum += term(i);
        }
        return sum;
    };
    return join_blocks(execution, count, sum_block, zero, sum_of_block, [](T& sum, const T& block) { sum += block; });
}

}  // namespace ljmd
