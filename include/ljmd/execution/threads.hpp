#pragma once

#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/execution/thread_team.hpp"

namespace ljmd {

/// How many threads loops over atoms are shared among. No result depends on it: work is cut into blocks of fixed
/// length, and what blocks yield is put together in their order.

/// No machine has use for more.
constexpr int most_threads = 4096;

/// Processors that this process may run on, at least 1.
[[nodiscard]] int available_processors();

/// As many as the environment variable OMP_NUM_THREADS says (the first number of a list); 1 without it.
/// @throws InputError if it says something else than a number from 1 to most_threads
[[nodiscard]] int default_thread_count();

/// Number of threads in the team of this process, which all loops here use: 1 until set.
[[nodiscard]] int thread_count();

/// Make a new team, unless that is its size already. @pre no loop is at work
/// @throws ContractViolation if count < 1, ThreadsError as ThreadTeam: the team is then the calling thread alone
void set_thread_count(int count);

/// ThreadTeam::for_each_block of the team of this process.
void for_each_block(Index count, Index block_length, BlockFunction function);

/// Atoms a block of loops that sum nothing up: so few that also the threads of a small system move the atoms whose
/// forces they have just summed up, which other cores would have to fetch.
inline constexpr Index loop_block = 128;
/// Atoms a block of sums; their last digits depend on it.
inline constexpr Index sum_block = 1024;

/// function(i) for i in [0, count), by all threads. @pre as for_each_block
template <class F>
void for_each_index(Index count, F&& function) {
    for_each_block(count, loop_block, [&function](Index first, Index last) {
        for (Index i = first; i < last; ++i) {
            function(i);
        }
    });
}

/// What the blocks of for_each_block yield, put together one after the other in their order: the same bits for any
/// number of threads.
///
///     join(...join(join(start, yield(0, L)), yield(L, 2 L))...)
///
/// @param start  what no blocks yield
/// @param yield  T yield(first, last), called by all threads
/// @param join   void join(T& so_far, const T& next), called by this thread
/// @pre as for_each_block; memory for as many T as there are blocks  @throws as for_each_block
template <class T, class Yield, class Join>
[[nodiscard]] T join_blocks(Index count, Index block_length, T start, Yield&& yield, Join&& join) {
    std::vector<T> yields(static_cast<std::size_t>((count + block_length - 1) / block_length));
    for_each_block(count, block_length, [&](Index first, Index last) {
        yields[static_cast<std::size_t>(first / block_length)] = yield(first, last);
    });
    for (const T& next : yields) {
        join(start, next);
    }
    return start;
}

/// Sum of term(i) for i in [0, count), by all threads: within blocks from `zero` on, then block by block.
/// @param term  returns something to add to a T; of Eigen's types a value, not an expression  @pre as for_each_block
template <class T, class Term>
[[nodiscard]] T sum_over(Index count, const T& zero, Term&& term) {
    const auto sum_of_block = [&](Index first, Index last) {
        T sum = zero;
        for (Index i = first; i < last; ++i) {
            sum += term(i);
        }
        return sum;
    };
    return join_blocks(count, sum_block, zero, sum_of_block, [](T& sum, const T& block) { sum += block; });
}

}  // namespace ljmd
