#include "ljmd/detail/core/aligned_vector.hpp"

#include <cstdint>
#include <numeric>
#include <thread>
#include "catch.hpp"

using namespace ljmd;

namespace {

template <class T>
bool is_aligned(const AlignedVector<T>& numbers, std::size_t to) {
    return reinterpret_cast<std::uintptr_t>(numbers.data()) % to == 0;
}

}  // namespace

TEST_CASE("aligned vectors begin at a cache line, large ones at a large page, and keep what they have as they grow") {
    AlignedVector<double> numbers(5);
    CHECK(is_aligned(numbers, 64));
    std::iota(numbers.begin(), numbers.end(), 1.0);
    constexpr std::size_t large = (std::size_t{1} << 22) / sizeof(double);
    for (const std::size_t size : {large - 1, large, large + 1, 3 * large, large / 2}) {
        numbers.resize(size);
        numbers.shrink_to_fit();
        CHECK(is_aligned(numbers, size < large ? 64 : std::size_t{1} << 21));
        CHECK(std::accumulate(numbers.begin(), numbers.end(), 0.0) == 15.0);
    }
    const AlignedVector<char> bytes(1);
    CHECK(is_aligned(bytes, 64));
}

TEST_CASE("whoever shall touch the pages of large blocks first gets them before all others, from this thread alone") {
    constexpr std::size_t small = 1000;
    constexpr std::size_t large = std::size_t{1} << 23;
    std::size_t outer = 0;
    std::size_t inner = 0;
    const auto adding_to = [](std::size_t& sum) {
        return [&sum](std::byte* memory, std::size_t bytes) {
            sum += bytes;
            memory[0] = memory[bytes - 1] = std::byte{1};
        };
    };
    const auto use = [] {
        const AlignedVector<char> block(large, 'a');
        const AlignedVector<char> other(small, 'a');
        return block[0] == 'a' && block[large - 1] == 'a';
    };
    {
        const FirstTouch first(adding_to(outer));
        CHECK(use());
        CHECK(outer == large);
        {
            const FirstTouch second(adding_to(inner));
            CHECK(use());
        }
        std::thread(use).join();
        CHECK(outer == large);
        CHECK(inner == large);
        CHECK(use());
    }
    CHECK(use());
    CHECK(outer == 2 * large);
    CHECK(inner == large);
}
