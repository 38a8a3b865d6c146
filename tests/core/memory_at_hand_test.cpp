#include "core/memory_at_hand.hpp"

#include <cstddef>
#include <fstream>
#include <new>
#include "catch.hpp"

namespace {

constexpr std::size_t gibibyte = std::size_t{1} << 30;

/// Of this process, mapped or not.
std::size_t address_space() {
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * 4096;
}

}  // namespace

TEST_CASE("memory that the system has is given back at once") {
    const std::size_t before = address_space();
    REQUIRE(before > 0);
    for (int i = 0; i < 3; ++i) {
        ljmd::require_memory(gibibyte);
    }
    CHECK(address_space() < before + gibibyte);
}

TEST_CASE("memory that the system does not have is refused") {
    CHECK_THROWS_AS(ljmd::require_memory(std::size_t{1} << 60), std::bad_alloc);
}
