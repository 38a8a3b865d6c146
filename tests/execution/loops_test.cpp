#include "execution/loops.hpp"

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>
#include "catch.hpp"

#include "execution/test_execution.hpp"

using namespace ljmd;

TEST_CASE("blocks cover every index once, for any number of threads") {
    const Execution execution = test::with_threads(GENERATE(1, 2, 3, 8));
    const Index count = GENERATE(0, 1, 63, 64, 65, 1000);
    std::vector<int> times(static_cast<std::size_t>(count));
    std::atomic<int> blocks = 0;
    std::atomic<bool> sound = true;
    for_each_block(execution, count, 64, [&](Index first, Index last) {
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

TEST_CASE("ranges give each thread as many atoms as the others, in whole cache lines") {
    const int threads = GENERATE(1, 2, 3);
    const Execution execution = test::with_threads(threads);
    for (const Index count : {0, 1, 4, 127, 128, 129, 500, 864, 4000, 32001}) {
        CAPTURE(threads, count);
        std::mutex mutex;
        std::map<Index, Index> ranges;
        for_each_range(execution, count, [&](Index first, Index last) {
            const std::lock_guard lock(mutex);
            ranges[first] = last;
        });
        Index end = 0;
        Index longest = 0;
        for (const auto& [first, last] : ranges) {
            CHECK(first == end);
            CHECK(first % 4 == 0);
            longest = std::max(longest, last - first);
            end = last;
        }
        CHECK(end == count);
        CHECK(longest <= loop_block);
        if (count > loop_block) {
            const auto blocks = static_cast<Index>(ranges.size());
            CHECK(blocks * longest - count < threads * longest);
        }
        if (count == 864) {  // seven blocks would give one of two threads a seventh more
            CHECK(static_cast<Index>(ranges.size()) % threads == 0);
        }
    }
}

TEST_CASE("for_each_index calls for each index") {
    const Execution execution = test::with_threads(GENERATE(1, 2));
    std::vector<Index> squares(5000);
    for_each_index(execution, 5000, [&](Index i) { squares[static_cast<std::size_t>(i)] = i * i; });
    CHECK(squares[4999] == Index{4999} * 4999);
    CHECK(squares[1] == 1);
}

TEST_CASE("what blocks yield is joined in their order") {
    const Execution execution = test::with_threads(GENERATE(1, 2, 3, 8));
    const Index count = GENERATE(0, 1, 9, 10, 11, 95);
    const auto indices = [](Index first, Index last) {
        std::string text;
        for (Index i = first; i < last; ++i) {
            text += std::to_string(i) + ' ';
        }
        return text;
    };
    const auto append = [](std::string& so_far, const std::string& next) { so_far += "| " + next; };
    std::string expected = "start ";
    for (Index i = 0; i < count; ++i) {
        expected += (i % 10 == 0 ? "| " : "") + std::to_string(i) + ' ';
    }
    CHECK(join_blocks(execution, count, 10, std::string("start "), indices, append) == expected);
}

TEST_CASE("a sum over indices is the same bits for any number of threads") {
    const Index count = 10 * static_cast<Index>(ExactBlock::most_terms) + 7;
    // Of very different sizes: in floating point they add up to something else in another order.
    const auto term = [](Index i) { return (i % 2 == 0 ? 1.0 : -1.0) / static_cast<double>(1 + i * i % 1009); };
    const auto sum_with = [&](int threads) { return sum_over(test::with_threads(threads), count, term); };
    double serial = 0.0;
    for (Index i = 0; i < count; ++i) {
        serial += term(i);
    }
    const double one = sum_with(1);
    CHECK(one == Approx(serial).epsilon(1e-12));
    for (const int threads : {2, 3, 8}) {
        CHECK(sum_with(threads) == one);
    }
    CHECK(sum_over(test::with_threads(2), 0, term) == 0.0);
}

TEST_CASE("vectors are summed as numbers are") {
    const Execution execution = test::with_threads(GENERATE(1, 2));
    const auto term = [](Index i) -> Vec3 { return Vec3(1.0, 2.0, 3.0) * static_cast<double>(i); };
    CHECK(sum_over<Vec3>(execution, 3000, term) == Vec3(1.0, 2.0, 3.0) * (3000.0 * 2999.0 / 2.0));
}

TEST_CASE("what the first failing block throws leaves the loop") {
    const Execution execution = test::with_threads(GENERATE(1, 2, 5));
    const auto fail_from_third = [](Index first, Index) {
        if (first >= 30) {
            throw std::runtime_error(std::to_string(first));
        }
    };
    CHECK_THROWS_WITH(for_each_block(execution, 100, 10, fail_from_third), "30");
    const auto yield = [&](Index first, Index last) {
        fail_from_third(first, last);
        return first;
    };
    CHECK_THROWS_WITH(join_blocks(execution, 100, 10, Index{0}, yield, [](Index&, Index) {}), "30");
}
