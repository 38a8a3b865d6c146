#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "execution/exact_sum.hpp"
#include "execution/ranks.hpp"
#include "execution/thread_team.hpp"
#include "ljmd/core/types.hpp"
#include "ljmd/execution/execution.hpp"

namespace ljmd {

/// Loops over atoms, shared by the threads of an Execution. No result depends on their number: loops are cut into
/// blocks of fixed length, and the results of blocks are joined in their order.

/// About the number of atoms of a block in loops without a sum.
inline constexpr Index loop_block = 128;
/// Atoms per block in sums that are not exact; their last digits depend on it.
inline constexpr Index sum_block = 1024;

/// ThreadTeam::for_each_block of the execution's threads.
inline void for_each_block(const Execution& execution, Index count, Index block_length, BlockFunction function,
                           std::span<const std::int64_t> work_before = {}) {
    execution.team().for_each_block(count, block_length, function, work_before);
}

/// Call function(first, last) for ranges that cover [0, count), by all threads. Each thread has the same number of
/// atoms, as it has of tiles: in a small system, too, threads move the atoms whose forces they have just summed, and
/// hardly any data pass between cores. No two threads have a part of one cache line of a per-atom vector.
/// @pre as for_each_block
inline void for_each_range(const Execution& execution, Index count, BlockFunction function) {
    constexpr Index atoms_of_lines = static_cast<Index>(cache_lines / sizeof(double)) / vector_stride;
    const Index threads = execution.threads();
    Index length = loop_block;
    if (threads > 1 && count > loop_block) {
        const Index blocks = (count + threads * loop_block - 1) / (threads * loop_block) * threads;
        length = ((count + blocks - 1) / blocks + atoms_of_lines - 1) / atoms_of_lines * atoms_of_lines;
    }
    for_each_block(execution, count, length, function);
}

/// Call function(i) for i in [0, count), by all threads. @pre as for_each_block
template <class F>
void for_each_index(const Execution& execution, Index count, F&& function) {
    for_each_range(execution, count, [&function](Index first, Index last) {
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

/// Add to each sum the other ranks' sums. Collective.
inline void add_other_ranks(Ranks& ranks, std::span<ExactSum> sums) {
    if (ranks.alone()) {
        return;
    }
    std::vector<std::int64_t> words;
    for (const ExactSum& sum : sums) {
        const ExactSum::Words& of_sum = sum.words();
        words.insert(words.end(), of_sum.begin(), of_sum.end());
    }
    ranks.sum(words);
    auto next = words.begin();
    for (ExactSum& sum : sums) {
        ExactSum::Words of_sum;
        std::copy_n(next, of_sum.size(), of_sum.begin());
        sum = ExactSum(of_sum);
        next += static_cast<std::ptrdiff_t>(of_sum.size());
    }
}

/// The numbers that sum_over() adds up: a double itself, or the elements of an Eigen matrix of fixed size.
template <class T>
struct Summands {
    static constexpr std::size_t count = T::SizeAtCompileTime;
    [[nodiscard]] static const double* of(const T& value) { return value.data(); }
    [[nodiscard]] static double* of(T& value) { return value.data(); }
};
template <>
struct Summands<double> {
    static constexpr std::size_t count = 1;
    [[nodiscard]] static const double* of(const double& value) { return &value; }
    [[nodiscard]] static double* of(double& value) { return &value; }
};

/// Sum of term(i) for i in [0, count), by all threads, and of the terms of all other ranks. It is exact but for one
/// rounding at its end (see ExactSum), so it depends neither on the order of the terms nor on the number of threads and
/// ranks. With other ranks it is collective.
/// @tparam T    double, or an Eigen matrix of fixed size
/// @param term  T term(i); or what a T can be made from  @pre as for_each_block
template <class T = double, class Term>
[[nodiscard]] T sum_over(const Execution& execution, Index count, Term&& term) {
    constexpr std::size_t numbers = Summands<T>::count;
    struct alignas(cache_lines) OfThread {
        std::array<ExactSum, numbers> sums;
    };
    std::vector<OfThread> of_threads(static_cast<std::size_t>(execution.threads()));
    for_each_block(execution, count, static_cast<Index>(ExactBlock::most_terms), [&](Index first, Index last) {
        auto& sums = of_threads[static_cast<std::size_t>(number_in_team())].sums;
        std::array<ExactBlock, numbers> blocks;
        for (Index i = first; i < last; ++i) {
            const T value = term(i);
            for (std::size_t k = 0; k < numbers; ++k) {
                blocks[k].add(Summands<T>::of(value)[k], sums[k]);
            }
        }
        for (std::size_t k = 0; k < numbers; ++k) {
            blocks[k].move_to(sums[k]);
        }
    });
    std::array<ExactSum, numbers> sums;
    for (std::size_t k = 0; k < numbers; ++k) {
        for (const OfThread& thread : of_threads) {
            sums[k].add(thread.sums[k]);
        }
    }
    add_other_ranks(execution.ranks(), sums);
    T total;
    for (std::size_t k = 0; k < numbers; ++k) {
        Summands<T>::of(total)[k] = sums[k].value();
    }
    return total;
}

/// The exact sum of what the blocks of for_each_block yield, of all ranks.
/// @tparam T  as sum_over()  @param yield  T yield(first, last), called by all threads
template <class T, class Yield>
[[nodiscard]] T sum_over_blocks(const Execution& execution, Index count, Index block_length, Yield&& yield) {
    std::vector<T> yields(static_cast<std::size_t>((count + block_length - 1) / block_length));
    for_each_block(execution, count, block_length, [&](Index first, Index last) {
        yields[static_cast<std::size_t>(first / block_length)] = yield(first, last);
    });
    return sum_over<T>(execution, static_cast<Index>(yields.size()),
                       [&](Index k) { return yields[static_cast<std::size_t>(k)]; });
}

}  // namespace ljmd
