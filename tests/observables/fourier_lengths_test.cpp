#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "observables/fourier.hpp"
#include "observables/fourier_lengths.hpp"

using namespace ljmd;

TEST_CASE("fast lengths are even, have small factors, and none in between was passed over") {
    CHECK(fast_length(1) == 2);
    CHECK(fast_length(2) == 2);
    CHECK(fast_length(11) == 12);
    CHECK(fast_length(12) == 12);
    CHECK(fast_length(22) == 24);
    CHECK(fast_length(97) == 98);
    CHECK(fast_length(99) == 100);
    CHECK(fast_length(102) == 108);
    CHECK_THROWS_AS(fast_length(0), ContractViolation);
}

TEST_CASE("a length that no transform has is refused") {
    CHECK(even_length(2) == 2);
    CHECK_THROWS_AS(even_length(0), ContractViolation);
    CHECK_THROWS_AS(even_length(7), ContractViolation);
    CHECK_THROWS_AS(even_length(Index{1} << 32), ContractViolation);
    CHECK(at_least(3, 3) == 3);
    CHECK_THROWS_AS(at_least(3, 2), ContractViolation);
}
