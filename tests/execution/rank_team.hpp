#pragma once

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <numeric>
#include <random>
#include <span>
#include <thread>
#include <utility>
#include <vector>

#include "execution/ranks.hpp"
#include "ljmd/core/types.hpp"
#include "ljmd/execution/execution.hpp"

namespace ljmd::test {

/// Ranks that are threads of this process: the same program runs in each, and messages are copied. They arrive in an
/// order that changes from exchange to exchange. An exception in one rank reaches the others as RankLost.
class RankTeam {
  public:
    explicit RankTeam(int size)
        : size_(size),
          numbers_(static_cast<std::size_t>(size)),
          reals_(numbers_.size()),
          bytes_(numbers_.size()),
          outgoing_(numbers_.size()) {}

    /// Call work(ranks) in a thread of each rank. @throws what the first rank that failed has thrown
    void run(const std::function<void(std::shared_ptr<Ranks>)>& work) {
        std::vector<std::thread> threads;
        threads.reserve(static_cast<std::size_t>(size_));
        for (int rank = 0; rank < size_; ++rank) {
            threads.emplace_back([this, rank, &work] {
                try {
                    work(std::make_shared<Member>(*this, rank));
                } catch (...) {
                    const std::lock_guard lock(mutex_);
                    if (!failure_) {
                        failure_ = std::current_exception();
                    }
                    changed_.notify_all();
                }
            });
        }
        for (std::thread& thread : threads) {
            thread.join();
        }
        if (failure_) {
            std::rethrow_exception(std::exchange(failure_, nullptr));
        }
    }

    /// What the ranks have said to each other so far.
    struct Traffic {
        Index messages = 0;
        Index bytes = 0;
        Index reductions = 0;
    };
    [[nodiscard]] const Traffic& traffic() const { return traffic_; }

  private:
    class Member : public Ranks {
      public:
        Member(RankTeam& team, int rank)
            : Ranks(rank, team.size_), team_(team), random_(7U + static_cast<unsigned>(rank)) {}

        void sum(std::span<std::int64_t> numbers) override {
            team_.numbers_[number()] = numbers;
            team_.wait_for_all();
            std::vector<std::int64_t> total(numbers.size());
            for (const auto& of_rank : team_.numbers_) {
                for (std::size_t k = 0; k < total.size(); ++k) {
                    total[k] += of_rank[k];
                }
            }
            team_.wait_for_all();
            std::copy(total.begin(), total.end(), numbers.begin());
            note(0, 0, 1);
        }

        void largest(std::span<double> numbers) override {
            team_.reals_[number()] = numbers;
            team_.wait_for_all();
            std::vector<double> most(numbers.begin(), numbers.end());
            for (const auto& of_rank : team_.reals_) {
                for (std::size_t k = 0; k < most.size(); ++k) {
                    most[k] = std::max(most[k], of_rank[k]);
                }
            }
            team_.wait_for_all();
            std::copy(most.begin(), most.end(), numbers.begin());
            note(0, 0, 1);
        }

        [[nodiscard]] std::vector<Bytes> exchange(std::vector<Bytes> messages) override {
            if (under_way_) {
                throw ContractViolation("messages of unknown length while others are under way");
            }
            team_.bytes_[number()] = &messages;
            team_.wait_for_all();
            std::vector<Bytes> received(messages.size());
            for (const std::size_t from : shuffled(messages.size())) {
                received[from] = team_.bytes_[from]->at(number());
            }
            team_.wait_for_all();
            for (std::size_t k = 0; k < messages.size(); ++k) {
                if (k != number() && !messages[k].empty()) {
                    note(1, static_cast<Index>(messages[k].size()), 0);
                }
            }
            return received;
        }

        void begin_exchange(std::span<const Outgoing> outgoing, std::span<const Incoming> incoming) override {
            if (under_way_) {
                throw ContractViolation("an exchange begins before the last one has ended");
            }
            under_way_ = true;
            outgoing_.assign(outgoing.begin(), outgoing.end());
            incoming_.assign(incoming.begin(), incoming.end());
            // Whoever reads what has not arrived shall notice.
            for (const Incoming& each : incoming) {
                std::fill(each.numbers.begin(), each.numbers.end(), std::numeric_limits<double>::quiet_NaN());
            }
        }

        void finish_exchange() override {
            team_.outgoing_[number()] = outgoing_;
            team_.wait_for_all();
            for (const std::size_t k : shuffled(incoming_.size())) {
                const auto& [from, numbers] = incoming_[k];
                const auto& theirs = team_.outgoing_[static_cast<std::size_t>(from)];
                const auto found = std::find_if(theirs.begin(), theirs.end(),
                                                [this](const Outgoing& each) { return each.to == rank(); });
                if (found == theirs.end() || found->numbers.size() != numbers.size()) {
                    throw ContractViolation("a rank waits for a message that is not sent");
                }
                std::copy(found->numbers.begin(), found->numbers.end(), numbers.begin());
            }
            team_.wait_for_all();
            for (const Outgoing& each : outgoing_) {
                note(1, static_cast<Index>(each.numbers.size_bytes()), 0);
            }
            under_way_ = false;
        }

        [[noreturn]] void abandon(int /*exit_code*/) override { throw RankLost("a rank has abandoned the others"); }

      private:
        [[nodiscard]] std::size_t number() const { return static_cast<std::size_t>(rank()); }
        [[nodiscard]] std::vector<std::size_t> shuffled(std::size_t count) {
            std::vector<std::size_t> order(count);
            std::iota(order.begin(), order.end(), std::size_t{0});
            std::shuffle(order.begin(), order.end(), random_);
            return order;
        }
        void note(Index messages, Index bytes, Index reductions) {
            const std::lock_guard lock(team_.mutex_);
            team_.traffic_.messages += messages;
            team_.traffic_.bytes += bytes;
            team_.traffic_.reductions += reductions;
        }

        RankTeam& team_;
        std::mt19937 random_;
        bool under_way_ = false;  ///< an exchange of messages whose length is known
        std::vector<Outgoing> outgoing_;
        std::vector<Incoming> incoming_;
    };

    /// @throws RankLost once a rank has failed
    void wait_for_all() {
        std::unique_lock lock(mutex_);
        const Index turn = turn_;
        if (++waiting_ == size_) {
            waiting_ = 0;
            ++turn_;
            changed_.notify_all();
        } else {
            changed_.wait(lock, [&] { return turn_ != turn || failure_; });
        }
        if (turn_ == turn) {
            throw RankLost("another rank has failed");
        }
    }

    int size_;
    std::mutex mutex_;
    std::condition_variable changed_;
    int waiting_ = 0;
    Index turn_ = 0;
    std::exception_ptr failure_;
    Traffic traffic_;
    std::vector<std::span<std::int64_t>> numbers_;
    std::vector<std::span<double>> reals_;
    std::vector<std::vector<Ranks::Bytes>*> bytes_;
    std::vector<std::span<const Ranks::Outgoing>> outgoing_;
};

}  // namespace ljmd::test
