#include "deck/few_body_sense.hpp"

#include "deck/deck_fixtures.hpp"
#include "deck/errors_in.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

/// A deck that is wrong in one way, the line that is pointed at, and what is said of it.
void check_refused(const std::string& text, const std::string& line, const std::string& message) {
    INFO(text << "\n-> " << message);
    const auto found = complaints(text);
    REQUIRE(found.size() == 1);
    INFO(format(found[0]));
    CHECK(found[0].severity == Severity::error);
    CHECK(line_shown(found[0]) == line);
    CHECK_THAT(found[0].message, Contains(message));
}

void check_refused(const Replacements& replacements, const std::string& line, const std::string& message) {
    check_refused(changed(stars_deck, replacements), line, message);
}

std::string few_body_stage(const std::string& name, const std::string& more) {
    return "\n[[stage]]\nname = \"" + name + "\"\ntime_step = 0.01\nsteps = 5\n" + more;
}

const std::string about = "\n[analysis]\nclosest_approach = {}\n";
const std::string thermo_row = "thermo = { every = 10 }\n";

}  // namespace

TEST_CASE("sound few-body decks are not complained of") {
    CHECK(complaints(stars_deck).empty());
    CHECK(complaints(radial_deck).empty());
    CHECK(complaints(radial_deck + "\n[analysis]\norbit = { body = 1 }\n").empty());
    CHECK(complaints(stars_deck + "trajectory = { every = 1, accelerations = true }\n").empty());
}

TEST_CASE("all vectors of a deck have as many components as the first") {
    check_refused({{"[0.0, -0.3]", "[0.0, -0.3, 0.0]"}}, "velocity = [0.0, -0.3, 0.0]",
                  "'velocity' of body 1 has 3 components");
    check_refused({{"[0.5, 0.0]", "[0.5]"}}, "position = [0.5]", "'position' of body 2 has 1 component, but");
}

TEST_CASE("a force has as many dimensions as its coordinate") {
    check_refused(changed(radial_deck, {{"[1.0]", "[1.0, 0.0]"}, {"[0.0]", "[0.0, 0.0]"}}), "position = [1.0, 0.0]",
                  "'position' has 2 components, but force 'radial-kepler' moves a coordinate of 1 component");
}

TEST_CASE("a start at which forces have no value is refused at the body") {
    check_refused({{"[0.5, 0.0]", "[-5e-1, 0]"}}, "position = [-5e-1, 0]", "bodies 1 and 2 are both at (-0.5, 0, 0)");
    check_refused({{"gravitational_constant = 1.0", "gravitational_constant = 1.0\ncentral_mass = 1.0"},
                   {"[0.5, 0.0]", "[0, 0]"}},
                  "position = [0, 0]", "body 2 is at the origin");
    check_refused(changed(radial_deck, {{"[1.0]", "[-1.0]"}}), "position = [-1.0]", "must be > 0");
    CHECK(complaints(
              changed(stars_deck, {{"gravitational_constant = 1.0", "gravitational_constant = 1.0\nsoftening = 0.1"},
                                   {"[0.5, 0.0]", "[-0.5, 0]"}}))
              .empty());
}

TEST_CASE("analyses of bodies and components that are not there are refused at their key") {
    check_refused(stars_deck + "[analysis.orbit]\nbody = 3\n", "body = 3",
                  "'body' in orbit is 3, but the last body is 2");
    check_refused(stars_deck + "[analysis.orbit]\nbody = 1\nabout = 3\n", "about = 3", "'about' in orbit is 3");
    check_refused(stars_deck + "[analysis.orbit]\nbody = 1\nabout = 1\n", "about = 1", "is the body itself");
    check_refused(stars_deck + "[analysis.oscillation]\ncomponent = 3\n", "component = 3",
                  "but the last component is 2");
    check_refused(radial_deck + "[analysis.orbit]\nbody = 1\nabout = 2\n", "about = 2",
                  "has no meaning for force 'radial-kepler'");
}

TEST_CASE("outputs that do not go together are refused at their key") {
    check_refused({{thermo_row, "directory = \"\"\n"}}, "directory = \"\"", "empty");
    check_refused(stars_deck + "[output.trajectory]\nevery = 1\nformat = \"h5md\"\naccelerations = true\n",
                  "accelerations = true", "goes only with format = \"csv\", not \"h5md\"");
}

TEST_CASE("analyses are given one piece of the motion, forwards") {
    const std::string before = few_body_stage("before", "sample = false\n");
    const std::string after = few_body_stage("after", "sample = false\n");
    const std::string more = few_body_stage("more", "");
    const std::string back = few_body_stage("back", "reverse = true\nsample = false\n");
    const auto with = [&](const std::string& stages) {
        const std::string orbits = "\n[[stage]]\nname = \"orbits\"\n";
        return changed(stars_deck, {{orbits, stages + orbits}}) + about;
    };
    CHECK(complaints(with(before)).empty());
    CHECK(complaints(with(before) + more + after + back).empty());
    check_refused(stars_deck + few_body_stage("back", "reverse = true\n") + about, "reverse = true",
                  "stage 'back' runs backwards");
    check_refused(stars_deck + after + few_body_stage("gap", "sample = true\n") + about, "sample = true",
                  "stage 'gap' is sampled and so was 'orbits', but 'after' between them is not");
    const auto found =
        complaints(stars_deck + after + few_body_stage("again", "") + few_body_stage("back", "reverse = true\n"));
    CHECK(errors_in(found) == 0);  // nothing looks
}

TEST_CASE("a value that is wrong in itself is reported once in a few-body deck") {
    for (const Replacements& wrong :
         {Replacements{{"position = [0.5, 0.0]", "positon = [0.5, 0.0]"}},
          Replacements{{"position = [0.5, 0.0]", "position = 0.5"}}, Replacements{{"mass = 0.5", "mass = \"heavy\""}},
          Replacements{{"\"newtonian-gravity\"", "\"newtonian\""}, {"gravitational_constant = 1.0\n", ""}},
          Replacements{{"gravitational_constant = 1.0", "gravitational_constant = -1.0"}},
          Replacements{{"steps = 95", "steps = -1"}}, Replacements{{"name = \"orbits\"\n", ""}},
          Replacements{{thermo_row, "trajectory = 5\n"}}}) {
        const auto found = complaints(changed(stars_deck, wrong) + "[analysis]\norbit = { body = 2, about = 1 }\n");
        std::string all;
        for (const Diagnostic& entry : found) {
            all += format(entry) + "\n";
        }
        INFO(all);
        CHECK(found.size() == 1);
    }
    CHECK(complaints(stars_deck + "[analysis]\norbit = { about = 1 }\n").size() == 1);
}
