#include "execution/ranks.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>
#include "catch.hpp"

#include "execution/loops.hpp"
#include "execution/rank_team.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;

namespace {

/// What each rank returns. Checks are made outside the threads.
template <class T, class Work>
std::vector<T> of_each(int size, const Work& work) {
    std::vector<T> results(static_cast<std::size_t>(size));
    test::RankTeam team(size);
    team.run([&](std::shared_ptr<Ranks> ranks) { results[static_cast<std::size_t>(ranks->rank())] = work(ranks); });
    return results;
}

}  // namespace

TEST_CASE("things are shared evenly, each by one rank, in the order of the ranks") {
    const std::int64_t things = GENERATE(0, 1, 5, 16, 17, 1000003);
    const int ranks = GENERATE(1, 2, 3, 7, 16);
    std::int64_t next = 0;
    for (int rank = 0; rank < ranks; ++rank) {
        const Share share = even_share(things, rank, ranks);
        CHECK(share.first == next);
        CHECK((share.count() == things / ranks || share.count() == things / ranks + 1));
        next = share.last;
    }
    CHECK(next == things);
}

TEST_CASE("without others a rank is alone, and what it says comes back to it") {
    Ranks& alone = no_other_ranks();
    CHECK(alone.alone());
    CHECK(alone.is_root());
    std::int64_t number = 3;
    alone.sum({&number, 1});
    CHECK(number == 3);
    const auto received = alone.exchange({{std::byte{5}}});
    REQUIRE(received.size() == 1);
    CHECK(received[0] == Ranks::Bytes{std::byte{5}});
}

TEST_CASE("sums and largest numbers are those of all ranks, at each of them") {
    const int size = GENERATE(1, 2, 5);
    const auto sums = of_each<std::vector<std::int64_t>>(size, [](const std::shared_ptr<Ranks>& ranks) {
        std::vector<std::int64_t> numbers{1, ranks->rank(), -10 * ranks->rank()};
        ranks->sum(numbers);
        return numbers;
    });
    const std::int64_t all = size * (size - 1) / 2;
    CHECK(sums == std::vector(static_cast<std::size_t>(size), std::vector<std::int64_t>{size, all, -10 * all}));
    const auto most = of_each<std::vector<double>>(size, [](const std::shared_ptr<Ranks>& ranks) {
        std::vector<double> numbers{0.5 * ranks->rank(), -1.0 - ranks->rank()};
        ranks->largest(numbers);
        return numbers;
    });
    CHECK(most == std::vector(static_cast<std::size_t>(size), std::vector<double>{0.5 * (size - 1), -1.0}));
}

TEST_CASE("messages come from whom they were sent by, whatever the order in which they arrive") {
    const int size = GENERATE(2, 3, 6);
    for (int turn = 0; turn < 10; ++turn) {
        const auto received = of_each<std::vector<Ranks::Bytes>>(size, [size](const std::shared_ptr<Ranks>& ranks) {
            std::vector<Ranks::Bytes> messages;
            for (int to = 0; to < size; ++to) {
                messages.emplace_back(static_cast<std::size_t>(to + ranks->rank()), std::byte(10 * ranks->rank() + to));
            }
            return ranks->exchange(messages);
        });
        bool right = true;
        for (int to = 0; to < size; ++to) {
            for (int from = 0; from < size; ++from) {
                right = right && received[static_cast<std::size_t>(to)][static_cast<std::size_t>(from)] ==
                                     Ranks::Bytes(static_cast<std::size_t>(to + from), std::byte(10 * from + to));
            }
        }
        CHECK(right);
    }
}

TEST_CASE("a sum over the terms of all ranks is the sum of one rank that has them all") {
    const auto term = [](Index i) { return std::sin(static_cast<double>(i)) * std::pow(10.0, i % 40 - 20); };
    const Index count = 5000;
    const double expected = sum_over(Execution(), count, term);
    const int size = GENERATE(2, 3, 8);
    const auto sums = of_each<double>(size, [&](const std::shared_ptr<Ranks>& ranks) {
        const Share share = even_share(count, *ranks);
        const Execution execution(ExecutionOptions{.ranks = ranks});
        return sum_over(execution, share.count(), [&](Index i) { return term(share.first + i); });
    });
    CHECK(sums == std::vector<double>(static_cast<std::size_t>(size), expected));
}

TEST_CASE("what one rank finds wrong, all throw, in the words of the first") {
    const int size = GENERATE(1, 2, 4);
    const auto said = of_each<std::string>(size, [size](const std::shared_ptr<Ranks>& ranks) -> std::string {
        fail_together(*ranks, [] {});
        try {
            fail_together(*ranks, [&] {
                if (ranks->rank() >= size / 2) {
                    throw PhysicsError("rank " + std::to_string(ranks->rank()));
                }
            });
        } catch (const PhysicsError& error) {
            return error.what();
        }
        return "nothing";
    });
    CHECK(said == std::vector<std::string>(static_cast<std::size_t>(size), "rank " + std::to_string(size / 2)));
}

TEST_CASE("ranks that wait for one that has failed do not wait for ever") {
    test::RankTeam team(3);
    int lost = 0;
    std::mutex mutex;
    CHECK_THROWS_AS(team.run([&](std::shared_ptr<Ranks> ranks) {
        if (ranks->rank() == 1) {
            throw InputError("no");
        }
        std::int64_t number = 1;
        try {
            ranks->sum({&number, 1});
        } catch (const RankLost&) {
            const std::lock_guard lock(mutex);
            ++lost;
            throw;
        }
    }),
                    InputError);
    CHECK(lost == 2);
}
