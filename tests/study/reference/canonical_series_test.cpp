#include "study/reference/canonical_series.hpp"

#include <fstream>
#include <random>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "study/reference/made_reference.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("rows of the sampled stage are read, with the pressure at the temperature that is held") {
    const MadeUpReplicas replicas({-5.0}, {1.0}, 1.19);
    const CanonicalSeries series = canonical_series(replicas.folder().runs.front(), 0.75, 1.2);
    REQUIRE(series.energy.size() == 2000);
    CHECK(series.energy.front() == Approx(-5.01).epsilon(1e-14));
    // p = 1.01 at T = 1.18
    CHECK(series.pressure.front() == Approx(1.01 + 0.75 * 0.02).epsilon(1e-14));
    CHECK(series.pressure.back() == Approx(0.99 + 0.75 * 0.0).epsilon(1e-14));
    std::ofstream(replicas.folder().runs.front() / "thermo.csv") << "step,temperature,potential_energy,pressure\n";
    CHECK_THROWS_WITH(canonical_series(replicas.folder().runs.front(), 0.75, 1.2), Contains("no row behind step 100"));
}

TEST_CASE("the run that takes longest says when equilibrium begins") {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    const auto settling = [&](int rows) {
        CanonicalSeries series;
        for (int k = 0; k < 1000; ++k) {
            series.energy.push_back((k < rows ? 20.0 : 0.0) + normal(random));
            series.pressure.push_back(normal(random));
        }
        return series;
    };
    const FoundEquilibration found = found_equilibration({settling(0), settling(300), settling(50)});
    CHECK(found.rows >= 300);
    CHECK(found.rows <= 600);
    CHECK(found.independent > 100.0);
    CHECK(found.inefficiency >= 1.0);
}

TEST_CASE("halves that differ are told from halves that scatter") {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    const auto series = [&](double step) {
        std::vector<double> values;
        for (int k = 0; k < 4000; ++k) {
            values.push_back(normal(random) + (k >= 2000 ? step : 0.0));
        }
        return values;
    };
    CHECK(std::abs(difference_of_halves({series(0.0), series(0.0), series(0.0)})) < 4.5);
    CHECK(difference_of_halves({series(0.2), series(0.2), series(0.2)}) > 4.5);
    CHECK(difference_of_halves({{1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0, 1.0}}) == 0.0);
}
