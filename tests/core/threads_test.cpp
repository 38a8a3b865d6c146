#include "ljmd/core/threads.hpp"

#include <atomic>
#include <catch2/catch.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/thread_guard.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;

TEST_CASE("blocks cover every index once, for any number of threads") {
    const test::ThreadGuard threads(GENERATE(1, 2, 3, 8));
    const Index count = GENERATE(0, 1, 63, 64, 65, 1000);
    std::vector<int> times(static_cast<std::size_t>(count));
    std::atomic<int> blocks = 0;
    std::atomic<bool> sound = true;
    for_each_block(count, 64, [&](Index first, Index last) {
        ++blocks;
        sound = sound && first % 64 == 0 && first < last && (last == count || last == first + 64);
        for (Index i = first; i < last; ++i) {
            ++times[static_cast<std::size_t>(i)];
        }
    });
    CHECK(sound);
    CHECK(blocks == (count + 63) / 64);
    CHECK(times == std::vector<int>(times.size(), 1));
}

TEST_CASE("for_each_index calls for each index") {
    const test::ThreadGuard threads(GENERATE(1, 2));
    std::vector<Index> squares(5000);
    for_each_index(5000, [&](Index i) { squares[static_cast<std::size_t>(i)] = i * i; });
    CHECK(squares[4999] == Index{4999} * 4999);
    CHECK(squares[1] == 1);
}

TEST_CASE("what the first failing block throws leaves the loop") {
    const test::ThreadGuard threads(GENERATE(1, 2, 5));
    const auto fail_from_third = [](Index first, Index) {
        if (first >= 30) {
            throw std::runtime_error(std::to_string(first));
        }
    };
    CHECK_THROWS_WITH(for_each_block(100, 10, fail_from_third), "30");
}

TEST_CASE("a number of threads below one is refused") {
    CHECK_THROWS_AS(set_thread_count(0), ContractViolation);
    CHECK(thread_count() >= 1);
    CHECK(default_thread_count() >= 1);
    CHECK(available_processors() >= 1);
}
