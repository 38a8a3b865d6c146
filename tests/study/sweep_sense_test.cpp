#include "study/sweep_sense.hpp"

#include "deck/deck_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
using Values = std::vector<std::string>;

namespace {

/// What the points of a grid are complained of, formatted.
Values mistakes_of(const std::vector<std::string>& grids, const std::string& deck = small_deck, bool force = false,
                   const std::vector<std::string>& settings = {}) {
    Diagnostics of_grid;
    const SweepPoints points = grid_points(grids, settings, of_grid);
    REQUIRE_FALSE(of_grid.has_errors());
    Diagnostics diagnostics;
    check_points({"deck.toml", deck}, settings, points, "--grid", force, diagnostics);
    Values found;
    for (const Diagnostic& entry : diagnostics.entries()) {
        found.push_back(format(entry));
    }
    return found;
}

}  // namespace

TEST_CASE("points of a good deck have no mistakes") {
    CHECK(mistakes_of({"system.temperature=1.2:2.0:5,system.density=0.1:0.8:8,stage.production.steps=20|40"}).empty());
    CHECK(mistakes_of({"body.1.mass=0.5:1:3"}, stars_deck).empty());
}

TEST_CASE("a mistake that all points have is told once") {
    const Values found = mistakes_of({"system.densty=0.1:0.8:8,system.temperature=1:2:5"});
    REQUIRE(found.size() == 1);
    CHECK(found[0] ==
          "error: --grid system.densty: unknown key 'densty' in [system] (all 40 points)\n  did you mean 'density'?");
    const Values of_deck = mistakes_of({"system.temperature=1:2:5"}, changed(small_deck, {{"seed", "sed"}}));
    REQUIRE(of_deck.size() == 1);
    CHECK_THAT(of_deck[0],
               Contains("error: deck.toml:7:1: unknown key 'sed' in [system] (all 5 points)\n  7 | sed = 7"));
}

TEST_CASE("a mistake of some points is told with these points, whatever the numbers in it are") {
    const Values found = mistakes_of({"system.density=-0.2:0.8:6"});
    REQUIRE(found.size() == 1);
    CHECK_THAT(found[0], Contains("--grid system.density: 'density' in [system] is -0.2") &&
                             Contains("(density=-0.2; density=0)"));
    // Half the box is less than the cutoff at these densities only.
    const Values box = mistakes_of(
        {"system.density=0.5:1.4:10"},
        changed(small_deck, {{"cutoff = 2.0", "cutoff = 2.3"}, {"temperature = 1.0", "temperature = 6.0"}}));
    REQUIRE(box.size() == 1);
    CHECK_THAT(box[0], Contains("deck.toml:") && Contains("(density=1.2; density=1.3; density=1.4)"));
    const Values more = mistakes_of({"system.density=-1:0.8:19"});
    REQUIRE(more.size() == 1);
    CHECK_THAT(more[0], Contains("(density=-1; density=-0.9; density=-0.8 and 8 other points)"));
}

TEST_CASE("mistakes that differ in more than numbers are each told") {
    const Values found = mistakes_of({"potential.truncation=cut|none|nil,system.temperature=1|warm"});
    REQUIRE(found.size() == 4);  // cut wants tail to be given, none and nil are unknown, warm is no number
    CHECK_THAT(found[0], Contains("(truncation=cut,temperature=1; truncation=cut,temperature=warm)"));
}

TEST_CASE("what is unlikely is an error, or with force a warning, and --set comes before the point") {
    const Values refused = mistakes_of({"system.temperature=1|60"});
    REQUIRE(refused.size() == 1);
    CHECK_THAT(refused[0], Contains("error: ") && Contains("(temperature=60)"));
    const Values warned = mistakes_of({"system.temperature=1|60"}, small_deck, true);
    REQUIRE(warned.size() == 1);
    CHECK_THAT(warned[0], Contains("warning: ") && Contains("(temperature=60)"));
    CHECK(mistakes_of({"system.lattice.cells=3|4"}, small_deck, false, {"system.lattice={ type = \"fcc\" }"}).empty());
}

TEST_CASE("the file that a point starts from is read, and its box known") {
    const TemporaryFolder folder;
    std::ofstream(folder / "start.xyz") << "2\nLattice=\"4 0 0 0 4 0 0 0 4\" Properties=species:S:1:pos:R:3\n"
                                           "X 0 0 0\nX 1.5 0 0\n";
    const std::string deck = changed(small_deck, {{"lattice = { type = \"fcc\", cells = 3 }\ndensity = 0.8",
                                                   "file = '" + (folder / "start.xyz").string() + "'"}});
    CHECK(mistakes_of({"potential.cutoff=1.5|2"}, deck).empty());
    const Values cutoff = mistakes_of({"potential.cutoff=1.5|2.5"}, deck);
    REQUIRE(cutoff.size() == 1);
    CHECK_THAT(cutoff[0], Contains("--grid potential.cutoff: ") && Contains("(cutoff=2.5)"));
    const Values none = mistakes_of({"system.temperature=1|2", "system.file=none.xyz"}, deck);
    REQUIRE(none.size() == 1);
    CHECK_THAT(none[0], Contains("error: none.xyz: ") && Contains("(all 2 points)"));
}
