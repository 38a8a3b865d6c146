#include "engine/mistakes/few_body_mistakes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "deck/deck_fixtures.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/engine/choices.hpp"
#include "ljmd/engine/few_body_simulation.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

TEST_CASE("a specification of few bodies that makes no sense is refused with all mistakes") {
    const FewBodySpec sound = DeckFolder(stars_deck).load().few_bodies();
    CHECK(mistakes(sound).empty());
    const auto words_of = [&](const auto& change) {
        FewBodySpec spec = sound;
        change(spec);
        const std::string words = fmt::format("{}", fmt::join(mistakes(spec), "\n"));
        if (!words.empty()) {
            CHECK_THROWS_WITH(FewBodySimulation(spec), words);
        }
        return words;
    };
    CHECK_THAT(words_of([](FewBodySpec& s) { s.bodies.clear(); }), Contains("bodies: at least one"));
    CHECK_THAT(words_of([](FewBodySpec& s) { s.stages.clear(); }), Contains("stages: at least one"));
    CHECK_THAT(words_of([](FewBodySpec& s) { s.force.name = "gravitas"; }), Contains("force: unknown"));
    CHECK_THAT(words_of([](FewBodySpec& s) { s.sample_every = 0; }), Contains("at least 1"));
    CHECK_THAT(words_of([](FewBodySpec& s) { s.bodies[1].mass = -1.0; }), Contains("body 2: 'mass'"));
    CHECK_THAT(words_of([](FewBodySpec& s) { s.bodies[0].velocity = {std::nan("")}; }), Contains("body 1: "));
    CHECK_THAT(words_of([](FewBodySpec& s) { s.bodies[1].position.push_back(0.0); }),
               Contains("body 2: 'position' of body 2 has 3 components, but the first vector has 2"));
    CHECK_THAT(words_of([](FewBodySpec& s) { s.bodies[1].position = s.bodies[0].position; }), Contains("body 2: "));
    CHECK_THAT(words_of([](FewBodySpec& s) { s.stages[0].thermostat = thermostat("langevin"); }),
               Contains("': few bodies have no temperature"));
    CHECK_THAT(words_of([](FewBodySpec& s) { s.stages.push_back(s.stages[0]); }), Contains("two stages are called"));
    CHECK_THAT(words_of([](FewBodySpec& s) { s.stages[0].time_step = 0.0; }), Contains("must be above 0"));
    CHECK_THAT(words_of([](FewBodySpec& s) { s.analyses = {Choice{"orbits", {}}}; }), Contains("analysis orbits: "));
    CHECK_THAT(words_of([](FewBodySpec& s) {
                   s.bodies[0].mass = 0.0;
                   s.sample_every = 0;
                   s.stages.clear();
               }),
               Contains("body 1") && Contains("sample_every") && Contains("stages"));
}
