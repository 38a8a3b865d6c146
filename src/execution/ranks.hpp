#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "ljmd/core/errors.hpp"

namespace ljmd {

/// Another rank has failed. This one cannot go on without it.
class RankLost : public Error {
  public:
    using Error::Error;
};

/// The processes that simulate one system together: ranks 0 to size() - 1. Each runs the same program and holds some of
/// the atoms. Usually there is one rank, which holds all.
///
/// All functions are collective where nothing else is said: every rank makes the same calls in the same order, with
/// messages that fit each other. @throws RankLost from all of them
class Ranks {
  public:
    virtual ~Ranks() = default;
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;

    // Not collective.
    [[nodiscard]] int rank() const { return rank_; }
    [[nodiscard]] int size() const { return size_; }
    [[nodiscard]] bool alone() const { return size_ == 1; }
    /// Whether this is rank 0, which has the files and the results.
    [[nodiscard]] bool is_root() const { return rank_ == 0; }

    /// Replace each number by its sum over all ranks. @pre no sum overflows
    virtual void sum(std::span<std::int64_t> numbers) = 0;
    /// Replace each number by the largest of all ranks. @pre no NaN
    virtual void largest(std::span<double> numbers) = 0;

    using Bytes = std::vector<std::byte>;
    /// Give every rank a message; empty ones cost little. @param messages  one for each rank, itself included
    /// @return each rank's message to this one
    [[nodiscard]] virtual std::vector<Bytes> exchange(std::vector<Bytes> messages) = 0;

    /// A message whose length both ranks know.
    struct Outgoing {
        int to;
        std::span<const double> numbers;
    };
    struct Incoming {
        int from;
        std::span<double> numbers;
    };
    /// Begin to exchange messages with some ranks, at most one in each direction, none with itself. Until
    /// finish_exchange() the numbers belong to the exchange, and only sum() and largest() may be called in between.
    virtual void begin_exchange(std::span<const Outgoing> outgoing, std::span<const Incoming> incoming) = 0;
    /// Wait until the messages have arrived.
    virtual void finish_exchange() = 0;
    /// Both at once.
    void exchange(std::span<const Outgoing> outgoing, std::span<const Incoming> incoming) {
        begin_exchange(outgoing, incoming);
        finish_exchange();
    }

    /// End all ranks at once, because this one cannot go on. Not collective.
    [[noreturn]] virtual void abandon(int exit_code) = 0;

  protected:
    Ranks(int rank, int size) : rank_(rank), size_(size) {}

  private:
    int rank_;
    int size_;
};

/// Do what every rank does by itself, and throw at all of them what it throws at one. Of several, the first rank
/// counts.
/// @throws PhysicsError  what `work` throws  Collective.
void fail_together(Ranks& ranks, const std::function<void()>& work);

/// One rank by itself.
[[nodiscard]] Ranks& no_other_ranks();

/// The share [first, last) of a rank of things that are divided evenly in their order.
struct Share {
    std::int64_t first;
    std::int64_t last;
    [[nodiscard]] std::int64_t count() const { return last - first; }
};
[[nodiscard]] inline Share even_share(std::int64_t things, int rank, int ranks) {
    const auto begin = [=](std::int64_t k) { return things / ranks * k + things % ranks * k / ranks; };
    return {begin(rank), begin(rank + 1)};
}
[[nodiscard]] inline Share even_share(std::int64_t things, const Ranks& ranks) {
    return even_share(things, ranks.rank(), ranks.size());
}

}  // namespace ljmd
