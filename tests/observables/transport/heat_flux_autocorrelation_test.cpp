#include "observables/transport/heat_flux_autocorrelation.hpp"

#include <cmath>
#include "catch.hpp"

#include "model/velocities.hpp"
#include "neighbors/sample_states.hpp"
#include "observables/analyses/made_analysis.hpp"
#include "observables/transport/heat_flux.hpp"

using namespace ljmd;

namespace {

const LagTimes flux_lags{.every = 5, .count = 4, .spacing = 0.1};

}  // namespace

TEST_CASE("a heat flux that stays gives its square, V/T^2 of which flows up to each time") {
    State state = test::shaken_crystal(3, 0.8, 0.2, 3);
    draw_velocities(state, 1.5, 5);
    const SampledRun run = test::run_of(state);
    HeatFluxAutocorrelation analysis(run, flux_lags, 9);
    CHECK_FALSE(analysis.needs_energy());
    for (int t = 0; t < 9; ++t) {
        CHECK(analysis.tables().empty());
        CHECK(analysis.observables().empty());
        analysis.sample(state, {});
    }
    const double c = heat_flux(state, run.interaction->potential).squaredNorm() / 3.0;
    const double factor = state.box().volume() / (1.5 * 1.5);
    const auto tables = analysis.tables();
    REQUIRE(tables.size() == 1);
    CHECK(tables[0].name == "heat_flux_autocorrelation");
    REQUIRE(tables[0].rows.size() == 5);
    for (std::size_t k = 0; k < 5; ++k) {
        CHECK(tables[0].rows[k][1] == Approx(c));
        CHECK(tables[0].rows[k][3] == Approx(factor * c * 0.1 * static_cast<double>(k)).margin(1e-12));
    }
    const ObservableAverage found = analysis.observables().at(0);
    CHECK(found.name == "thermal_conductivity");
    CHECK(found.estimate.value().mean == Approx(factor * c * 0.4));
    for (int t = 0; t < 9 * 7; ++t) {  // with errors it shows that nothing decays
        analysis.sample(state, {});
    }
    CHECK_FALSE(analysis.observables().at(0).estimate.has_value());
    CHECK_THAT(analysis.observables().at(0).remark, Catch::Contains("still changes at max_time"));
}

TEST_CASE("atoms at rest have no thermal conductivity, and it says why") {
    const State state = test::shaken_crystal(3, 0.8, 0.2, 3);
    HeatFluxAutocorrelation analysis(test::run_of(state), flux_lags, 9);
    for (int t = 0; t < 9; ++t) {
        analysis.sample(state, {});
    }
    CHECK_FALSE(analysis.observables().at(0).estimate.has_value());
    CHECK_THAT(analysis.observables().at(0).remark, Catch::Contains("divided by the temperature"));
    CHECK(std::isnan(analysis.tables().at(0).rows[2][3]));
}
