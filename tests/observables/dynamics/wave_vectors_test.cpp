#include "ljmd/observables/dynamics/wave_vectors.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <set>

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

TEST_CASE("of each pair of wave vectors there is one, and no vector is in two shells") {
    const Box box(Vec3(9.0, 11.0, 13.0));
    std::set<std::array<Index, 3>> found;
    std::size_t count = 0;
    for (const WaveShell& shell : wave_shells(box, 0.5, 2.0, 12, 20)) {
        for (const WaveVector& v : shell.vectors) {
            ++count;
            found.insert(v.numbers);
            found.insert({-v.numbers[0], -v.numbers[1], -v.numbers[2]});
            for (Index axis = 0; axis < 3; ++axis) {
                CHECK(v.k[axis] == Approx(2.0 * std::numbers::pi / box.edges()[axis] *
                                          static_cast<double>(v.numbers[static_cast<std::size_t>(axis)])));
            }
            CHECK(v.length == Approx(v.k.norm()));
        }
    }
    CHECK(count > 150);
    CHECK(found.size() == 2 * count);
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

TEST_CASE("shells without wave numbers, vectors or order are refused") {
    const Box box(Vec3(10.0, 10.0, 10.0));
    CHECK_THROWS_AS(wave_shells(box, 0.0, 1.0, 2, 3), ContractViolation);
    CHECK_THROWS_AS(wave_shells(box, 2.0, 1.0, 2, 3), ContractViolation);
    CHECK_THROWS_AS(wave_shells(box, 1.0, 2.0, 0, 3), ContractViolation);
    CHECK_THROWS_AS(wave_shells(box, 1.0, 2.0, 2, 0), ContractViolation);
    // Between two vectors far apart there is none left for a second shell of the same number.
    CHECK(wave_shells(Box(Vec3(1.0, 1.0, 1.0)), 1.0, 1.0, 3, 100).size() == 1);
}
