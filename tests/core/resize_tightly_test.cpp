#include "core/resize_tightly.hpp"

#include <vector>
#include "catch.hpp"

using namespace ljmd;

TEST_CASE("a vector that grows tightly gets a sixteenth more room, and keeps it when it shrinks") {
    std::vector<int> numbers(1600, 7);
    resize_tightly(numbers, 1601);
    CHECK(numbers.size() == 1601);
    CHECK(numbers.capacity() == 1701);
    CHECK(numbers.front() == 7);
    CHECK(numbers.back() == 0);
    const int* before = numbers.data();
    resize_tightly(numbers, 1701);
    resize_tightly(numbers, 10);
    CHECK(numbers.size() == 10);
    CHECK(numbers.data() == before);
}
