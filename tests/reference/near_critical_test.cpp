#include "reference/near_critical.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <vector>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"
#include "ljmd/reference/pressure_states.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

namespace {

struct Saturated {
    std::string equation;
    double temperature;
    double vapour;
    double liquid;
    double pressure;
};

/// The equations solved with 60 digits (mpmath): equal pressure and equal chemical potential at 1 - T/T_c = 1e-12,
/// 1e-10, 1e-8 and 1e-6.
const std::vector<Saturated> exact{
    {"thol2016", 1.3200003469808343, 0.3131934918671592, 0.3132069439859658, 0.13006040472955864},
    {"thol2016", 1.3200003468501544, 0.3131325933227662, 0.3132671200392932, 0.13006040465810193},
    {"thol2016", 1.3200003337821509, 0.312485164847635, 0.3138408658397786, 0.13006039751280489},
    {"thol2016", 1.3199990269818074, 0.3019226002277478, 0.3184551167374642, 0.13005968791670184},
    {"thol2015", 1.0859999830966154, 0.3189982356075172, 0.3190017347225736, 0.10076582987212334},
    {"thol2015", 1.0859999829891014, 0.318982490789293, 0.3190174814796316, 0.1007658298118239},
    {"thol2015", 1.0859999722377016, 0.3188251298631274, 0.3191750362867533, 0.10076582378187936},
    {"thol2015", 1.0859988970977184, 0.3172604499631978, 0.3207590800775088, 0.1007652207830146},
    {"kolafa-nezbeda1994", 1.3396478264588092, 0.3108031305955822, 0.3108046713300642, 0.14053037648509277},
    {"kolafa-nezbeda1994", 1.339647826326184, 0.3107961971375865, 0.3108116048212151, 0.14053037641160618},
    {"kolafa-nezbeda1994", 1.3396478130636704, 0.3107268642338869, 0.3108809410404322, 0.14053036906295321},
    {"kolafa-nezbeda1994", 1.3396464868123223, 0.3100336849100887, 0.3115744519165694, 0.14052963419898968},
    {"johnson1993", 1.3130000571778326, 0.309998965767848, 0.310000987954909, 0.12993537705601852},
    {"johnson1993", 1.3130000570478455, 0.3099898658573527, 0.3100100879968908, 0.12993537698406859},
    {"johnson1993", 1.313000044049145, 0.3098988728456946, 0.3101010941571869, 0.12993536978908324},
    {"johnson1993", 1.3129987441790885, 0.30898954101368, 0.3110117408040318, 0.12993465029216207}};

}  // namespace

TEST_CASE("just below the critical temperature vapour and liquid are those of exact arithmetic but for rounding") {
    for (const Saturated& expected : exact) {
        INFO(expected.equation << ", temperature " << expected.temperature);
        const EquationOfState equation = equation_of_state(expected.equation);
        const auto found = coexistence(equation, expected.temperature);
        REQUIRE(found);
        // Slopes dp/drho, of the order T_c - T, are rounded to 1e-15 (johnson1993, with larger terms, to 1e-14).
        const double below = 1.0 - expected.temperature / critical_point(equation).temperature;
        const double rounding = (expected.equation == "johnson1993" ? 2e-14 : 2e-15) / below;
        const double distance = expected.liquid - expected.vapour;
        CHECK(found->liquid.density - found->vapour.density == Approx(distance).epsilon(rounding + 1e-10));
        CHECK(found->liquid.density == Approx(expected.liquid).epsilon(0.0).margin(rounding * distance + 1e-8));
        CHECK(found->vapour.density == Approx(expected.vapour).epsilon(0.0).margin(rounding * distance + 1e-8));
        CHECK(found->pressure == Approx(expected.pressure).epsilon(3e-13));
        CHECK(found->liquid.pressure == Approx(found->vapour.pressure).epsilon(3e-13));
    }
}

TEST_CASE("just below the critical pressure the temperature of coexistence is that of exact arithmetic") {
    for (const Saturated& expected : exact) {
        INFO(expected.equation << ", pressure " << expected.pressure);
        const EquationOfState equation = equation_of_state(expected.equation);
        try {
            const Coexistence found = coexistence_at_pressure(equation, expected.pressure);
            CHECK(found.pressure == Approx(expected.pressure).epsilon(3e-13));
            CHECK(found.liquid.temperature == Approx(expected.temperature).epsilon(1e-13));
        } catch (const InputError& error) {  // not told apart there by the last digits
            CHECK_THAT(error.what(), Contains("rounding hides the difference between vapour and liquid"));
            CHECK(expected.temperature > (1.0 - 1e-11) * critical_point(equation).temperature);
        }
    }
}

TEST_CASE("at any distance from the critical point there are values, or a message about the critical point") {
    for (const EquationOfState& equation : all_equations_of_state()) {
        const CriticalPoint critical = critical_point(equation);
        int coexisting = 0;
        for (int k = 0; k <= 24; ++k) {
            const double below = std::pow(10.0, -16.0 + 0.5 * k);
            const double temperature = critical.temperature * (1.0 - below);
            INFO(equation.name << ", 1 - T/T_c = " << below);
            const auto found = coexistence(equation, temperature);
            coexisting += found ? 1 : 0;
            if (below > 1e-12) {
                CHECK(found);
            }
            const double pressure = found ? found->pressure : critical.pressure * (1.0 - 6.0 * below);
            for (const double factor : {1.0, 1.0 + 3e-16, 1.0 - 3e-16, 1.0 + below, 1.0 - below}) {
                const auto phases = states_at_pressure(equation, temperature, factor * pressure);
                REQUIRE_FALSE(phases.empty());
                CHECK(phases.front().state.pressure == Approx(factor * pressure).epsilon(1e-9));
            }
            std::optional<Coexistence> saturated;
            try {
                saturated = coexistence_at_pressure(equation, pressure);
            } catch (const InputError& error) {
                CHECK_THAT(error.what(), Contains("critical"));
                CHECK(below < 1e-11);
            }
            if (saturated) {
                CHECK(saturated->pressure == Approx(pressure).epsilon(1e-12));
            }
        }
        CHECK(coexisting >= 16);
    }
}

TEST_CASE("a critical value is told with the digits that tell it from the given one") {
    CHECK(critical_in_words(2.0, 1.3200003469821535) == "1.32");
    CHECK(critical_in_words(1.3200003469, 1.3200003469821535) == "1.3200003469821535");
    CHECK_THAT(too_near_critical("pressure", 0.5, "equation", 0.5),
               Contains("pressure 0.5 is so near to the critical one of equation, 0.5, that rounding"));
}
