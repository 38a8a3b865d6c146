#include <cmath>
#include "catch.hpp"

#include "judge/shaken_liquid.hpp"
#include "judge/summed_pairs.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

/// Sums in which some pairs count with another factor.
template <class Factor>
PairSums sums_with(const Fluid& fluid, const Factor& factor) {
    PairSums sums;
    sums.forces.assign(fluid.positions.size(), Vec3::Zero());
    const SummedPairs near(fluid.positions, fluid.edges, fluid.potential.cutoff().radius);
    for (const SummedPairs::Pair& pair : near.pairs()) {
        const PairTerm<double> term = fluid.potential(pair.distance);
        const double c = factor(pair);
        sums.potential_energy += c * term.u;
        sums.virial += c * term.w * pair.distance * pair.distance;
        sums.forces[pair.i] += c * term.w * pair.separation;
        sums.forces[pair.j] -= c * term.w * pair.separation;
    }
    return sums;
}

}  // namespace

TEST_CASE("a pair that is left out is named by its ids") {
    const Fluid fluid = shaken_liquid();
    const auto pair = SummedPairs(fluid.positions, fluid.edges, 1.5).pairs().at(7);
    const PairSums sums =
        sums_with(fluid, [&](const SummedPairs::Pair& p) { return p.i == pair.i && p.j == pair.j ? 0.0 : 1.0; });
    CHECK_THAT(first_diagnosis(fluid, point_with(expected_point_of(fluid), sums)),
               StartsWith("missing pair: 1 pair within the cutoff is left out, of the ids " +
                          std::to_string(pair.i + 1) + " and " + std::to_string(pair.j + 1)));
}

TEST_CASE("an odd atom is named by its id") {
    const Fluid fluid = shaken_liquid();
    const auto with_atom = [&](double c) {
        return sums_with(fluid, [=](const SummedPairs::Pair& p) { return p.i == 40 || p.j == 40 ? c : 1.0; });
    };
    const ExpectedPoint expected = expected_point_of(fluid);
    CHECK_THAT(first_diagnosis(fluid, point_with(expected, with_atom(1.25))),
               StartsWith("one atom: all pairs of the one of id 41 are 1.25 times as strong"));
    CHECK_THAT(first_diagnosis(fluid, point_with(expected, with_atom(0.0))),
               StartsWith("one atom: the one of id 41 acts on no other"));
    PointAnswer answer = right_point(expected);
    answer.forces[40] *= 1.5;
    CHECK_THAT(first_diagnosis(fluid, answer), StartsWith("one atom: the force on the one of id 41 alone is wrong"));
}

TEST_CASE("digits that the start or the box has lost are named") {
    const Fluid fluid = shaken_liquid();
    const ExpectedPoint expected = expected_point_of(fluid);
    Fluid coarse = fluid;
    for (Vec3& r : coarse.positions) {
        r = r.unaryExpr([](double x) { return std::round(x * 1e5) / 1e5; });
    }
    const auto answer_of = [&](const Fluid& other) {
        return point_with(
            expected, SummedPairs(other.positions, other.edges, fluid.potential.cutoff().radius).sums(fluid.potential));
    };
    CHECK_THAT(first_diagnosis(fluid, answer_of(coarse)),
               StartsWith("digits of the start: ") && Contains("positions with 5 decimals"));
    coarse = fluid;
    coarse.edges = fluid.edges.unaryExpr([](double x) { return std::round(x * 1e3) / 1e3; });
    CHECK_THAT(first_diagnosis(fluid, answer_of(coarse)),
               StartsWith("edges of the box: ") && Contains("edges with 3 decimals"));
}
