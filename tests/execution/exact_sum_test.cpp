#include "execution/exact_sum.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>
#include "catch.hpp"

using namespace ljmd;

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

bool same(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

double one_by_one(const std::vector<double>& terms) {
    ExactSum sum;
    for (const double term : terms) {
        sum.add(term);
    }
    return sum.value();
}

double in_blocks(const std::vector<double>& terms) {
    ExactSum sum;
    ExactBlock block;
    std::size_t added = 0;
    for (const double term : terms) {
        block.add(term, sum);
        if (++added % ExactBlock::most_terms == 0) {
            block.move_to(sum);
        }
    }
    block.move_to(sum);
    return sum.value();
}

/// Terms m 2^e, and their sum in units of 2^least. @pre |e - least| <= 60
struct Integers {
    std::vector<double> terms;
    Int128 sum = 0;
    int least = 0;

    void add(std::int64_t m, int e) {
        terms.push_back(std::ldexp(static_cast<double>(m), e));
        sum += static_cast<Int128>(m) << (e - least);
    }
    /// The sum, rounded once. @pre it is less than 2^64 units, so that the conversion rounds as it should
    [[nodiscard]] double value() const {
        const auto magnitude = static_cast<std::uint64_t>(sum < 0 ? -sum : sum);
        return std::ldexp(sum < 0 ? -static_cast<double>(magnitude) : static_cast<double>(magnitude), least);
    }
};

}  // namespace

TEST_CASE("an exact sum is the sum of whole numbers, rounded once") {
    std::mt19937_64 random(GENERATE(range(1U, 40U)));
    const int least = GENERATE(-1074, -1040, -90, -74, -60, -22, 0, 900);
    Integers numbers;
    numbers.least = least;
    std::uniform_int_distribution<std::int64_t> mantissa(-(std::int64_t{1} << 20), std::int64_t{1} << 20);
    std::uniform_int_distribution<int> exponent(least, least + 38);
    const int count = std::uniform_int_distribution<int>(1, 24)(random);
    for (int k = 0; k < count; ++k) {
        numbers.add(mantissa(random), exponent(random));
    }
    CHECK(same(one_by_one(numbers.terms), numbers.value()));
    CHECK(same(in_blocks(numbers.terms), numbers.value()));
}

TEST_CASE("a sum that lies between two doubles is rounded to the nearest, of two to the even one") {
    const double unit = GENERATE(1.0, 0x1p-900, 0x1p-40, 0x1p800);
    CHECK(one_by_one({unit, 0x1p-53 * unit}) == unit);
    CHECK(one_by_one({unit, 0x1p-53 * unit, 0x1p-120 * unit}) == (1.0 + 0x1p-52) * unit);
    CHECK(one_by_one({unit, 0x1p-53 * unit, -0x1p-120 * unit}) == unit);
    CHECK(one_by_one({(1.0 + 0x1p-52) * unit, 0x1p-53 * unit}) == (1.0 + 0x1p-51) * unit);
    CHECK(one_by_one({-unit, -0x1p-53 * unit, -0x1p-120 * unit}) == -(1.0 + 0x1p-52) * unit);
}

TEST_CASE("terms that cancel leave nothing of each other") {
    CHECK(one_by_one({1e300, 1.0, -1e300}) == 1.0);
    CHECK(in_blocks({1e300, 1.0, -1e300, 3e-5, -1.0}) == 3e-5);
    CHECK(one_by_one({0.1, 0.2, -0.3}) == 0x1p-55);  // 0.1 + 0.2 - 0.3 of the three doubles
    CHECK(same(one_by_one({0.1, -0.1}), 0.0));
    CHECK(same(one_by_one({-0.0}), 0.0));
    CHECK(same(one_by_one({}), 0.0));
    CHECK(one_by_one({std::numeric_limits<double>::denorm_min(), 1e-300, -1e-300}) ==
          std::numeric_limits<double>::denorm_min());
    CHECK(one_by_one({std::numeric_limits<double>::max(), std::numeric_limits<double>::max(),
                      -std::numeric_limits<double>::max()}) == std::numeric_limits<double>::max());
}

TEST_CASE("a sum is infinite or not a number as in floating point") {
    CHECK(one_by_one({1.0, endless}) == endless);
    CHECK(in_blocks({-endless, 1e300, -endless}) == -endless);
    CHECK(std::isnan(one_by_one({endless, 1.0, -endless})));
    CHECK(std::isnan(in_blocks({1.0, std::numeric_limits<double>::quiet_NaN()})));
    CHECK(one_by_one({std::numeric_limits<double>::max(), std::numeric_limits<double>::max()}) == endless);
}

TEST_CASE("no order and no division of the terms changes a sum") {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    std::uniform_int_distribution<int> exponent(-80, 60);
    std::vector<double> terms(5000);
    for (std::size_t k = 0; k < terms.size(); ++k) {
        terms[k] = k % 3 == 0 ? std::ldexp(normal(random), exponent(random)) : normal(random);
    }
    const double sum = one_by_one(terms);
    for (int turn = 0; turn < 20; ++turn) {
        std::shuffle(terms.begin(), terms.end(), random);
        CHECK(same(in_blocks(terms), sum));
        ExactSum first;
        ExactSum second;
        for (std::size_t k = 0; k < terms.size(); ++k) {
            (k % 3 == 0 ? first : second).add(terms[k]);
        }
        first.add(second);
        CHECK(same(first.value(), sum));
    }
}

TEST_CASE("many terms of the largest and smallest usual size fit into a block") {
    const double term = GENERATE(0x1.fffffffffffffp29, -0x1.fffffffffffffp29, 0x1p-21, -0x1.0000000000001p-21, 0x1p30);
    const std::vector<double> terms(ExactBlock::most_terms, term);
    CHECK(in_blocks(terms) == 1024.0 * term);
}

TEST_CASE("carries are passed on before digits overflow") {
    ExactSum sum;
    ExactSum all;
    for (int k = 0; k < 3; ++k) {
        sum.add(0x1.fffffffffffffp40);
    }
    // Doubled 60 times: 3 2^60 terms.
    all.add(sum);
    for (int k = 0; k < 60; ++k) {
        const ExactSum half = all;
        all.add(half);
    }
    CHECK(all.value() == 3.0 * 0x1.fffffffffffffp100);
}
