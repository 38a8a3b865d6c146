#include "observables/dynamics/distinct_van_hove.hpp"

#include <cmath>
#include <numbers>
#include "catch.hpp"

#include "ideal_gas.hpp"
#include "ljmd/core/errors.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("an atom sees all others at all times, corners of the box included") {
    constexpr Index atoms = 30;
    DistinctVanHove distances(atoms, {1, 3, 0.2}, 5, {2.9, 29});
    sample_ideal_gas(distances, atoms, 6.0, 1, 4, 0.2);
    const auto tables = distances.tables();
    REQUIRE(tables.size() == 1);
    REQUIRE(tables[0].rows.size() == 4 * 29);
    for (Index time = 0; time <= 3; ++time) {
        double integral = 0.0;
        for (Index bin = 0; bin < 29; ++bin) {
            const auto& row = tables[0].rows[static_cast<std::size_t>(time * 29 + bin)];
            CHECK(row[0] == Approx(0.2 * static_cast<double>(time)));
            integral +=
                row[2] * 4.0 / 3.0 * std::numbers::pi * (std::pow(row[1] + 0.05, 3) - std::pow(row[1] - 0.05, 3));
        }
        CHECK(distances.beyond()[time] > 1.0);
        CHECK(integral + distances.beyond()[time] == Approx(atoms - 1));
    }
}

TEST_CASE("distances to where an atom was are counted, and not those to where it is") {
    // Two atoms; the second moves away along x, which moves the centre of mass by half of it.
    DistinctVanHove distances(2, {1, 2, 1.0}, 2, {4.0, 8});
    for (Index frame = 0; frame < 5; ++frame) {
        State state(2, Box(Vec3::Constant(20.0)));
        state.write_positions().col(0) = Vec3(5.0, 5.0, 5.0);
        state.write_positions().col(1) = Vec3(6.2 + static_cast<double>(frame), 5.0, 5.0);
        distances.sample(state, Evaluation{});
    }
    // Origins are frames 0 and 2, where the atoms are 1.2 and 3.2 apart. Over t frames each moves by t/2 about the
    // centre: the distances are those at the origin and t/2 more.
    const auto rows = distances.tables().at(0).rows;
    const auto counts = [&](Index time) {
        std::vector<double> found;
        for (Index bin = 0; bin < 8; ++bin) {
            const auto& row = rows[static_cast<std::size_t>(time * 8 + bin)];
            found.push_back(row[2] * 4.0 / 3.0 * std::numbers::pi *
                            (std::pow(row[1] + 0.25, 3) - std::pow(row[1] - 0.25, 3)));
        }
        return found;
    };
    const auto is = [](const std::vector<double>& found, const std::vector<double>& wanted) {
        for (std::size_t bin = 0; bin < wanted.size(); ++bin) {
            CHECK(found[bin] == Approx(wanted[bin]).margin(1e-12));
        }
    };
    is(counts(0), {0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.5, 0.0});  // 1.2; 3.2
    is(counts(1), {0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 0.5});  // 1.7; 3.7
    is(counts(2), {0.0, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0, 0.0});  // 2.2; 4.2 is beyond
    CHECK(distances.beyond()[2] == Approx(1.0));
}

TEST_CASE("origins that overlap, and distances up to nothing, are refused") {
    CHECK_THROWS_AS(DistinctVanHove(2, {1, 3, 1.0}, 2, {1.0, 10}), ContractViolation);
    CHECK_THROWS_AS(DistinctVanHove(2, {1, 3, 1.0}, 3, {0.0, 10}), ContractViolation);
}
