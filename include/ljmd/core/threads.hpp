#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "ljmd/core/types.hpp"

namespace ljmd {

/// How many threads loops over atoms are shared among. No result depends on it: work is cut into blocks of fixed
/// length, and what blocks yield is put together in their order.

/// Nobody has use for more.
constexpr int most_threads = 4096;

/// Processors that this process may run on, at least 1.
[[nodiscard]] int available_processors();

/// As many as the environment variable OMP_NUM_THREADS says, 1 without it. On a machine that others use too, more
/// threads than free processors are slower than one, so nobody gets them who has not asked.
[[nodiscard]] int default_thread_count();

/// In use: 1 until set. @throws ContractViolation if count < 1
[[nodiscard]] int thread_count();
void set_thread_count(int count);

/// A reference to something that can be called with (first, last); it must outlive the call.
class BlockFunction {
  public:
    template <class F, class = std::enable_if_t<!std::is_same_v<std::remove_cvref_t<F>, BlockFunction>>>
    BlockFunction(F&& function)  // NOLINT(*-explicit-*): made from lambdas at calls of for_each_block
        : object_(const_cast<void*>(static_cast<const void*>(std::addressof(function)))),
          call_([](void* object, Index first, Index last) {
              (*static_cast<std::remove_reference_t<F>*>(object))(first, last);
          }) {}

    void operator()(Index first, Index last) const { call_(object_, first, last); }

  private:
    void* object_;
    void (*call_)(void*, Index, Index);
};

/// Call function(first, last) for [0, L), [L, 2 L), ... up to `count`, L = block_length, by all threads; consecutive
/// blocks go to one thread. Returns when all are done.
/// @pre blocks do not write what other blocks read or write; block_length > 0
/// @throws what the first block that threw has thrown; later blocks may not have been called
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
