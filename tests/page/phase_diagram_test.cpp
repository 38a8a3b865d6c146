#include "page/phase_diagram.hpp"

#include "catch.hpp"

#include "ljmd/reference/fluid_phase.hpp"

using namespace ljmd;

TEST_CASE("the lines of the page's phase diagram are those of the equation of state") {
    const Data diagram = phase_diagram();
    const EquationOfState thol = equation_of_state("thol2016");
    const auto& saturation = diagram["saturation"].items();
    REQUIRE(saturation.size() > 50);
    double before = 0.0;
    for (std::size_t k = 0; k + 1 < saturation.size(); ++k) {
        const auto& row = saturation[k].items();
        const double temperature = row[0].number();
        CHECK(temperature > before);
        before = temperature;
        const auto phases = coexistence(thol, temperature);
        REQUIRE(phases);
        CHECK(row[1].number() == phases->vapour.density);
        CHECK(row[4].number() == phases->liquid.density);
        // Vapour, its spinodal, that of the liquid, the liquid.
        for (std::size_t line = 1; line < 4; ++line) {
            CHECK(row[line].number() < row[line + 1].number());
        }
    }
    const auto& end = saturation.back().items();
    CHECK(end[0].number() == diagram["critical"]["temperature"].number());
    CHECK(end[1].number() == end[4].number());
    for (const Data& row : diagram["freezing"].items()) {
        CHECK(row.items()[1].number() < row.items()[2].number());
    }
}

TEST_CASE("a state of the page has the pressure and the phase of the equation of state") {
    const Data liquid = state_of_fluid(0.85, 0.82);
    CHECK(liquid["pressure"].number() == properties(equation_of_state("thol2016"), 0.85, 0.82).pressure);
    CHECK(liquid["phase"].text() == "liquid");
    CHECK(liquid["stable"].flag());
    CHECK(state_of_fluid(1.5, 0.3)["phase"].text() == "supercritical fluid");
    const Data torn = state_of_fluid(0.8, 0.3);
    CHECK(torn["phase"].text() == "two phases");
    CHECK_FALSE(torn["stable"].flag());
    CHECK(torn["saturation_pressure"].number() > 0.0);
    CHECK_FALSE(torn["fluid"].flag());
    // Where a crystal is stable it is called so: it may be in the box.
    CHECK(state_of_fluid(0.75, 0.95)["phase"].text() == "crystal beside liquid");
    CHECK(state_of_fluid(0.75, 0.95)["fluid"].flag());
    CHECK(state_of_fluid(0.7, 0.97)["phase"].text() == "crystal");
    CHECK(state_of_fluid(0.7, 0.97)["stable"].flag());
    CHECK_FALSE(state_of_fluid(0.7, 0.97)["fluid"].flag());
    CHECK(state_of_fluid(0.6, 0.97)["phase"].text() == "crystal, with vapour where there is room");
    CHECK_FALSE(state_of_fluid(0.6, 0.97)["fluid"].flag());
    CHECK(state_of_fluid(0.6, 1e-4)["phase"].text() == "gas");
}
