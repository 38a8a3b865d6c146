#include "execution/first_touch.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <vector>
#include "catch.hpp"

#include "execution/test_execution.hpp"

using namespace ljmd;

TEST_CASE("threads touch every page of a block, and no other") {
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    const int threads = GENERATE(1, 2, 3);
    const std::size_t pages = GENERATE(1U, 2U, 7U, 400U);
    const std::size_t bytes = pages * page - GENERATE(0U, 1U, 4000U);
    constexpr std::size_t around = 100;
    const std::size_t all = (pages + 2 * around) * page;
    void* memory = mmap(nullptr, all, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    REQUIRE(memory != MAP_FAILED);
    static_cast<void>(madvise(memory, all, MADV_NOHUGEPAGE));  // not every system knows of large pages
    touched_by_threads(test::with_threads(threads))(static_cast<std::byte*>(memory) + around * page, bytes);
    std::vector<unsigned char> resident(pages + 2 * around);
    REQUIRE(mincore(memory, all, resident.data()) == 0);
    munmap(memory, all);
    std::vector<unsigned char> expected(resident.size(), 0);
    std::fill_n(expected.begin() + around, pages, 1);
    CHECK(resident == expected);
}
