#include "judge/summed_pairs.hpp"

#include <cmath>
#include "catch.hpp"

using namespace ljmd;

namespace {

const PairPotential cut_lennard_jones = PairPotential::lennard_jones("cut", {2.5, 0.0});

}  // namespace

TEST_CASE("pairs are those of the nearest images, wherever the positions are") {
    const Vec3 edges(6.0, 7.0, 8.0);
    const SummedPairs inside({Vec3(0.5, 1.0, 1.0), Vec3(1.5, 1.0, 1.0), Vec3(5.5, 1.0, 1.0)}, edges, 1.2);
    REQUIRE(inside.pairs().size() == 2);
    CHECK(inside.pairs()[0].images == Vec3(0.0, 0.0, 0.0));
    CHECK(inside.pairs()[1].images == Vec3(-1.0, 0.0, 0.0));
    CHECK(inside.pairs()[1].separation == Vec3(1.0, 0.0, 0.0));
    const SummedPairs outside({Vec3(0.5, 1.0, 17.0), Vec3(-4.5, 1.0, 1.0), Vec3(5.5, -6.0, 1.0)}, edges, 1.2);
    REQUIRE(outside.pairs().size() == 2);
    CHECK(outside.pairs()[0].separation == inside.pairs()[0].separation);
}

TEST_CASE("sums of one pair have their closed form under every assumption") {
    const double r = 1.3;
    const SummedPairs pair({Vec3(0.1, 1.0, 1.0), Vec3(4.8, 1.0, 1.0)}, Vec3(6.0, 7.0, 8.0), 2.5);
    const auto u = [](double x) { return 4.0 * (std::pow(x, -12.0) - std::pow(x, -6.0)); };
    const auto minus_slope = [](double x) { return 24.0 * (2.0 * std::pow(x, -13.0) - std::pow(x, -7.0)); };
    const PairSums right = pair.sums(cut_lennard_jones);
    CHECK(right.potential_energy == Approx(u(r)).epsilon(1e-12));
    CHECK(right.virial == Approx(r * minus_slope(r)).epsilon(1e-12));
    CHECK(right.forces[0][0] == Approx(minus_slope(r)).epsilon(1e-12));
    CHECK(right.forces[1][0] == -right.forces[0][0]);
    const PairSums other = pair.sums(cut_lennard_jones, {.epsilon = 1.5, .sigma = 1.1});
    CHECK(other.potential_energy == Approx(1.5 * u(r / 1.1)).epsilon(1e-12));
    CHECK(other.virial == Approx(1.5 * r * minus_slope(r / 1.1) / 1.1).epsilon(1e-12));
    CHECK(other.forces[0][0] == Approx(1.5 * minus_slope(r / 1.1) / 1.1).epsilon(1e-12));
    // x_0 - x_1 < -L/2: the pair is missed on that side alone, and by one of its atoms if each sums for itself.
    const SummedPairs::MissedImages below{{{true, false}, {}, {}}};
    const SummedPairs::MissedImages above{{{false, true}, {true, true}, {true, true}}};
    CHECK(pair.sums(cut_lennard_jones, {.missed = below}).potential_energy == 0.0);
    CHECK(pair.sums(cut_lennard_jones, {.missed = above}).potential_energy == right.potential_energy);
    const PairSums half = pair.sums(cut_lennard_jones, {.missed = below, .each_atom_alone = true});
    CHECK(half.potential_energy == Approx(0.5 * u(r)).epsilon(1e-12));
    CHECK(half.virial == Approx(0.5 * r * minus_slope(r)).epsilon(1e-12));
    CHECK(half.forces[0].norm() == 0.0);
    CHECK(half.forces[1] == right.forces[1]);
    CHECK(pair.sums(with_cutoff(cut_lennard_jones, 1.2)).potential_energy == 0.0);
}
