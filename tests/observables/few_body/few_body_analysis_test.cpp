#include "observables/few_body/few_body_analysis.hpp"

#include "catch.hpp"

#include "ljmd/core/errors.hpp"

using namespace ljmd;

TEST_CASE("an analysis of few bodies by its name has its defaults, but for the options that are given") {
    const auto orbit = chosen_few_body_analysis({"orbit", {{"body", 2}}});
    CHECK(orbit.plugin.name == "orbit");
    CHECK(settings_in_words(orbit.values) == "body=2");
    CHECK_THROWS_AS(chosen_few_body_analysis({"ellipse"}), InputError);
    CHECK_THROWS_AS(chosen_few_body_analysis({"orbit", {{"body", 0}}}), InputError);
}
