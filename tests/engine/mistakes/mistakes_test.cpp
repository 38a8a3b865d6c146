#include "engine/mistakes/mistakes.hpp"

#include "catch.hpp"

#include "engine/engine_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

Mistake only(const std::vector<Mistake>& found) {
    REQUIRE(found.size() == 1);
    return found.front();
}

/// Stages "0", "1", ... of which those marked 's' are sampled; 'r': sampled and reversed.
std::vector<Stage> stages_of(const std::string& marks) {
    std::vector<Stage> stages;
    for (const char mark : marks) {
        Stage stage{.name = std::to_string(stages.size()), .time_step = 0.1};
        stage.sample = mark == 's' || mark == 'r';
        stage.reverse = mark == 'r' || mark == 'R';
        stages.push_back(stage);
    }
    return stages;
}

}  // namespace

TEST_CASE("a mistake names the stage, and the value to change before those that it does not go with") {
    std::vector<Stage> stages = small_spec().stages;
    stages[1].thermostat = thermostat("langevin");
    stages[1].integrator = integrator("leapfrog");
    const Mistake found = only(fluid_stage_mistakes(stages));
    CHECK(found.table == "stage");
    CHECK(found.index == 1);
    CHECK(found.name == "production");
    CHECK(found.keys == std::vector<std::string>{"thermostat.type", "integrator"});
    CHECK(in_words(found).starts_with("stage 'production': the thermostat langevin is a part of the steps"));
}

TEST_CASE("a message that follows its key is told with the key, and with what to do") {
    const Mistake found = only(cutoff_mistakes(3.0, Box(Vec3(8.0, 5.0, 6.0))));
    CHECK(found.follows_key);
    CHECK(in_words(found) == "potential: cutoff is 3, more than half the box (L = 5); largest allowed: 2.5");
    CHECK(cutoff_mistakes(2.5, Box(Vec3(8.0, 5.0, 6.0))).empty());
}

TEST_CASE("where the force is switched off is told of a switched potential alone") {
    CHECK(potential_mistakes("switched", {.radius = 2.5, .switch_start = 2.0}, false).empty());
    CHECK(potential_mistakes("shifted", {.radius = 2.5}, false).empty());
    CHECK(in_words(only(potential_mistakes("shifted", {.radius = 2.5, .switch_start = 2.0}, false))) ==
          "potential: switch_start has no meaning for truncation = \"shifted\"; only \"switched\" begins before the "
          "cutoff");
}

TEST_CASE("only a list has mixed precision, and is kept for some steps") {
    CHECK(search_mistakes({.every = 5}, Precision::mixed).empty());
    CHECK(search_mistakes({.method = "cells"}, Precision::double_precision).empty());
    CHECK(in_words(only(search_mistakes({.method = "cells"}, Precision::mixed))) ==
          "performance: precision is 'mixed', which method = \"cells\" does not have; verlet-list has it");
    CHECK(only(search_mistakes({.method = "cells", .every = 5}, Precision::double_precision)).keys ==
          std::vector<std::string>{"every", "method"});
}

TEST_CASE("a crystal has no more atoms than can be indexed") {
    CHECK(lattice_mistakes({Lattice::fcc, 645}).empty());
    CHECK(in_words(only(lattice_mistakes({Lattice::fcc, 646}))) ==
          "start: lattice.cells makes 1078344544 atoms, more than 1073741824");
    CHECK(in_words(only(lattice_mistakes({.cells = 3, .layers = 0}))) == "start: 0 layers: allowed are 1 to 100000");
}

TEST_CASE("the names of stages can be printed") {
    std::vector<Stage> stages = stages_of("--");
    CHECK(stage_mistakes(stages).empty());
    for (const std::string& name : {std::string("a\tb"), std::string(65, 'x')}) {
        stages[1].name = name;
        CHECK_THAT(only(stage_mistakes(stages)).message, Contains("1 to 64 printable"));
    }
}

TEST_CASE("sampled stages of few bodies follow one another, and none runs backwards") {
    for (const char* good : {"", "-", "s", "-ss-", "ss"}) {
        CHECK(few_body_sampling_mistakes(stages_of(good)).empty());
    }
    const Mistake gap = only(few_body_sampling_mistakes(stages_of("s-s")));
    CHECK(gap.index == 2);
    CHECK_THAT(gap.message, Contains("stage '2' is sampled and so was '0', but '1' between them is not"));
    const Mistake backwards = only(few_body_sampling_mistakes(stages_of("sr")));
    CHECK(backwards.keys == std::vector<std::string>{"reverse"});
}

TEST_CASE("a fluid is not sampled on both sides of a reversal, wherever it is") {
    const auto mistakes_of = [](const std::string& marks, const std::string& empty = "") {
        std::vector<Stage> stages = stages_of(marks);
        for (Stage& stage : stages) {
            stage.steps = stage.name == empty ? 0 : 100;
        }
        return fluid_stage_mistakes(stages);
    };
    for (const char* good : {"", "ss", "-r", "-Rs", "sR", "sR-", "-r-s", "rs", "RRs", "sRR-"}) {
        CAPTURE(good);
        CHECK(mistakes_of(good).empty());
    }
    const Mistake back = only(mistakes_of("-sr"));
    CHECK(back.index == 2);
    CHECK(back.keys == std::vector<std::string>{"sample", "reverse"});
    CHECK_THAT(back.message, Contains("samples again what was sampled before"));
    const Mistake later = only(mistakes_of("sR-s"));
    CHECK(later.index == 3);
    CHECK(only(mistakes_of("sRRs")).index == 3);
    CHECK(only(mistakes_of("-rr")).index == 2);
    CHECK(mistakes_of("srs").size() == 2);
    // A stage without steps takes no sample, but turns the motion round.
    CHECK(mistakes_of("sr", "0").empty());
    CHECK(mistakes_of("sr", "1").empty());
    CHECK(only(mistakes_of("sRs", "1")).index == 2);
}

TEST_CASE("analyses want an unchanging box from the first sampled stage on, whatever was before") {
    std::vector<Stage> stages = stages_of("-s-");
    const std::vector<Choice> analyses{analysis("msd")};
    stages[0].barostat = barostat("stochastic-cell-rescaling", {{"pressure", 1.0}});
    CHECK(sampling_mistakes(analyses, stages).empty());
    stages[2].barostat = stages[0].barostat;
    CHECK(only(sampling_mistakes(analyses, stages)).index == 2);
    CHECK(sampling_mistakes({analysis("rdf")}, stages).empty());
    CHECK(sampling_mistakes({}, stages).empty());
    stages[1].sample = false;
    CHECK(sampling_mistakes(analyses, stages).empty());  // nothing is measured
}
