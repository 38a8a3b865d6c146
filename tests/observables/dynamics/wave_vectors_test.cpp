#include "observables/dynamics/wave_vectors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"

using namespace ljmd;

TEST_CASE("the smallest wave vectors of a cube are one along each edge") {
    const Box box(Vec3(10.0, 10.0, 10.0));
    const double unit = 2.0 * std::numbers::pi / 10.0;
    CHECK(smallest_wave_number(box) == unit);
    const auto shells = wave_shells(box, unit, unit, 1, 3);
    REQUIRE(shells.size() == 1);
    CHECK(shells[0].k == Approx(unit));
    std::set<std::array<Index, 3>> found;
    for (const WaveVector& v : shells[0].vectors) {
        found.insert(v.numbers);
    }
    CHECK(found == std::set<std::array<Index, 3>>{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
}

TEST_CASE("of each pair of wave vectors there is one, and no length is in two shells") {
    const Box box(Vec3(9.0, 11.0, 13.0));
    std::set<std::array<Index, 3>> found;
    std::size_t count = 0;
    std::set<double> numbers;
    const auto shells = wave_shells(box, 0.5, 2.0, 12, 20);
    for (const WaveShell& shell : shells) {
        numbers.insert(std::round(shell.k * 1e9));
        for (const WaveVector& v : shell.vectors) {
            ++count;
            found.insert(v.numbers);
            found.insert({-v.numbers[0], -v.numbers[1], -v.numbers[2]});
            for (Index axis = 0; axis < 3; ++axis) {
                CHECK(v.k[axis] == Approx(2.0 * std::numbers::pi / box.edges()[axis] *
                                          static_cast<double>(v.numbers[static_cast<std::size_t>(axis)])));
            }
            CHECK(v.length == Approx(v.k.norm()));
            CHECK(std::abs(v.length - shell.k) < 0.1 * shell.k);
        }
    }
    CHECK(count > 60);
    CHECK(std::ranges::is_sorted(shells, {}, &WaveShell::k));
    CHECK(found.size() == 2 * count);
    CHECK(numbers.size() == shells.size());
}

TEST_CASE("a shell has the vectors nearest to its wave number") {
    const Box box(Vec3(10.0, 10.0, 10.0));
    const double unit = 2.0 * std::numbers::pi / 10.0;
    const auto shells = wave_shells(box, unit, 7.0, 7, 3);
    REQUIRE(shells.size() == 7);
    for (std::size_t shell = 0; shell < shells.size(); ++shell) {
        const double wanted = unit + (7.0 - unit) * static_cast<double>(shell) / 6.0;
        CHECK(shells[shell].vectors.size() == 3);
        CHECK(std::abs(shells[shell].k - wanted) < 0.1);
    }
}

TEST_CASE("the smallest wave numbers of a cube are not mixed, and none comes twice") {
    // (1,0,0), (1,1,0), (1,1,1), (2,0,0), (2,1,0): 3, 6, 4, 3 and 12 vectors.
    const Box box(Vec3(10.0, 10.0, 10.0));
    const double unit = 2.0 * std::numbers::pi / 10.0;
    const auto shells = wave_shells(box, unit, std::sqrt(5.0) * unit, 20, 100);
    REQUIRE(shells.size() == 5);
    const std::array<std::size_t, 5> counts{3, 6, 4, 3, 12};
    const std::array<double, 5> squares{1.0, 2.0, 3.0, 4.0, 5.0};
    for (std::size_t k = 0; k < 5; ++k) {
        CHECK(shells[k].vectors.size() == counts[k]);
        CHECK(shells[k].k == Approx(std::sqrt(squares[k]) * unit));
    }
}

TEST_CASE("shells without wave numbers, vectors or order are refused") {
    const Box box(Vec3(10.0, 10.0, 10.0));
    CHECK_THROWS_AS(wave_shells(box, 0.0, 1.0, 2, 3), ContractViolation);
    CHECK_THROWS_AS(wave_shells(box, 2.0, 1.0, 2, 3), ContractViolation);
    CHECK_THROWS_AS(wave_shells(box, 1.0, 2.0, 0, 3), ContractViolation);
    CHECK_THROWS_AS(wave_shells(box, 1.0, 2.0, 2, 0), ContractViolation);
    // Between two vectors far apart there is none left for a second shell of the same number.
    CHECK(wave_shells(Box(Vec3(1.0, 1.0, 1.0)), 1.0, 1.0, 3, 100).size() == 1);
}
