#include "analyze/trajectory_analyses.hpp"

#include "catch.hpp"

#include "deck/deck_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using Catch::Matchers::Contains;

namespace {

/// 50 frames of 108 atoms, 10 steps and 0.04 tau apart, in the box of the small deck.
TrajectorySummary fifty_frames() {
    TrajectorySummary summary{};
    summary.frames = 50;
    summary.atoms = 108;
    summary.edges = Vec3::Constant(5.13);
    summary.smallest_edges = summary.edges;
    summary.has_velocities = true;
    summary.positions = {Positions::unwrapped, "file", "", ""};
    for (int k = 0; k < 50; ++k) {
        summary.steps.push_back(10 * k);
        summary.times.push_back(0.04 * k);
    }
    return summary;
}

std::vector<FrameAnalysis> make(const std::vector<std::string>& names, const std::vector<std::string>& settings = {},
                                const Deck* deck = nullptr, const TrajectorySummary& summary = fifty_frames()) {
    return make_frame_analyses(names, settings, deck, summary,
                               select_frames(summary, std::nullopt, nullptr, std::nullopt));
}

/// Which of the first frames are measured.
std::vector<Index> due(const FrameAnalysis& analysis) {
    std::vector<Index> numbers;
    for (Index frame = 0; frame < 12; ++frame) {
        if (analysis.analysis->due(frame)) {
            numbers.push_back(frame);
        }
    }
    return numbers;
}

std::string complaint(const std::vector<std::string>& names, const TrajectorySummary& summary,
                      const std::vector<std::string>& settings = {}, const Deck* deck = nullptr) {
    try {
        static_cast<void>(make(names, settings, deck, summary));
    } catch (const InputError& error) {
        return error.what();
    }
    return "no InputError";
}

}  // namespace

TEST_CASE("every frame is measured unless something else is asked for") {
    const auto made = make({"rdf", "msd"}, {"analysis.msd.every=5"});
    REQUIRE(made.size() == 2);
    CHECK(made[0].method.name == "rdf");
    CHECK(due(made[0]).size() == 12);
    CHECK(due(made[1]) == std::vector<Index>{0, 5, 10});
}

TEST_CASE("what a deck asks for every so many steps becomes frames") {
    const test::DeckFolder folder;
    const Deck deck = folder.load({"analysis.rdf.every=40", "analysis.msd.every=7", "analysis.vacf.max_time=0.08",
                                   "analysis.structure_factor.k_max=5.0"});
    const auto made = make({"rdf", "msd", "vacf", "structure_factor", "chemical_potential"}, {}, &deck);
    CHECK(due(made[0]) == std::vector<Index>{0, 4, 8});
    CHECK(due(made[1]).size() == 12);              // every 7 steps there is no frame: each of them
    CHECK(due(made[2]).size() == 12);              // every 5 by default
    CHECK(due(made[3]) == std::vector<Index>{0});  // every 1000 by default
    CHECK(due(made[4]).size() == 12);              // the deck does not ask for it
    const auto set = make({"rdf"}, {"analysis.rdf.every=3"}, &deck);
    CHECK(due(set[0]) == std::vector<Index>{0, 3, 6, 9});
}

TEST_CASE("usual analyses are those that the trajectory is good for") {
    TrajectorySummary summary = fifty_frames();
    const auto usual = [&] {
        return default_analyses(summary, select_frames(summary, std::nullopt, nullptr, std::nullopt));
    };
    CHECK(usual() == std::vector<std::string>{"rdf", "structure_factor", "msd"});
    summary.is_part = true;
    CHECK(usual() == std::vector<std::string>{"rdf", "structure_factor"});
    summary.is_part = false;
    summary.times[7] = 0.29;
    CHECK(usual() == std::vector<std::string>{"rdf", "structure_factor"});
    summary.box_changes = 2;
    CHECK(usual() == std::vector<std::string>{"rdf"});
}

TEST_CASE("an analysis of what a trajectory lacks is refused") {
    TrajectorySummary summary = fifty_frames();
    const test::DeckFolder folder;
    const Deck deck = folder.load({});
    CHECK_THAT(complaint({"viscosity"}, summary), Contains("viscosity needs the interaction"));
    CHECK(complaint({"viscosity"}, summary, {}, &deck) == "no InputError");
    Deck pushed = deck;
    pushed.given.external = "wave";
    CHECK_THAT(complaint({"viscosity"}, summary, {}, &pushed),
               Contains("viscosity is for a homogeneous fluid, and the external force 'wave' acted"));
    CHECK(complaint({"rdf"}, summary, {}, &pushed) == "no InputError");
    summary.smallest_edges[1] = 3.9;
    CHECK_THAT(complaint({"chemical_potential"}, summary, {}, &deck), Contains("the cutoff of the deck, 2, is more"));
    summary = fifty_frames();
    summary.has_velocities = false;
    for (const char* name : {"vacf", "viscosity", "chemical_potential"}) {
        CHECK_THAT(complaint({name}, summary, {}, &deck), Contains("needs velocities"));
    }
    CHECK(complaint({"rdf", "structure_factor", "msd"}, summary) == "no InputError");
    summary = fifty_frames();
    summary.times.clear();
    for (const char* name : {"msd", "vacf", "viscosity"}) {
        CHECK_THAT(complaint({name}, summary, {}, &deck), Contains("needs equally spaced frames"));
    }
    summary = fifty_frames();
    summary.box_changes = 2;
    for (const char* name : {"msd", "vacf", "viscosity", "structure_factor", "chemical_potential"}) {
        CHECK_THAT(complaint({name}, summary, {}, &deck), Contains("needs a box that stays the same"));
    }
    CHECK(complaint({"rdf"}, summary, {}, &deck) == "no InputError");
    summary = fifty_frames();
    summary.positions = {std::nullopt, "", "nobody knows", ""};
    CHECK_THAT(complaint({"msd"}, summary), Contains("msd needs displacements: nobody knows"));
    CHECK(complaint({"rdf", "vacf", "structure_factor"}, summary) == "no InputError");
    summary = fifty_frames();
    summary.is_part = true;
    for (const char* name : {"msd", "vacf", "viscosity", "bulk_viscosity", "thermal_conductivity"}) {
        CHECK_THAT(complaint({name}, summary, {}, &deck),
                   Contains("needs all atoms: motion is measured about the centre of mass of all of them"));
    }
    CHECK(complaint({"rdf", "structure_factor"}, summary) == "no InputError");
}

TEST_CASE("what deck and potential make impossible is refused for frames, too") {
    const TrajectorySummary summary = fifty_frames();
    const test::DeckFolder folder;
    const Deck deck = folder.load({});
    CHECK(complaint({"thermal_conductivity"}, summary, {}, &deck) == "no InputError");
    CHECK(complaint({"bulk_viscosity"}, summary, {}, &deck) == "no InputError");
    CHECK_THAT(complaint({"thermal_conductivity"}, summary), Contains("needs the interaction: give a deck"));
    const Deck cut = folder.load({"potential.truncation=cut", "potential.tail=true"});
    CHECK_THAT(complaint({"thermal_conductivity"}, summary, {}, &cut),
               Contains("thermal_conductivity needs a continuous potential: truncation = \"cut\" has a step"));
    const Deck held = folder.load({"stage.production.thermostat.type=stochastic-rescaling"});
    CHECK(complaint({"thermal_conductivity"}, summary, {}, &held) == "no InputError");
    CHECK_THAT(complaint({"bulk_viscosity"}, summary, {}, &held), Contains("needs frames at constant energy"));
    const Deck film = folder.load({"system.lattice.height=20"});
    for (const char* name : {"viscosity", "cutoff_correction", "response_functions"}) {
        CHECK_THAT(complaint({name}, summary, {}, &film), Contains("is for a homogeneous fluid, and the box of this"));
    }
    CHECK(complaint({"chemical_potential"}, summary, {}, &film) == "no InputError");
}

TEST_CASE("settings are checked as those of a deck are") {
    const TrajectorySummary summary = fifty_frames();
    CHECK_THAT(complaint({"rdf"}, summary, {"analysis.rdf.radius=3"}), Contains("half the box is 2.56"));
    CHECK_THAT(complaint({"rdf"}, summary, {"analysis.rdf.bin=3"}), Contains("did you mean 'bins'?"));
    CHECK_THAT(complaint({"rdf"}, summary, {"system.seed=3"}), Contains("only settings of what is measured"));
    CHECK_THAT(complaint({"rdf"}, summary, {"analysis.rdf=3"}), Contains("only settings of what is measured"));
    CHECK_THAT(complaint({"msd"}, summary, {"analysis.msd.max_time=3"}), Contains("2 tau are sampled at a stretch"));
}

TEST_CASE("names are those of analyses, or thermo") {
    CHECK_NOTHROW(check_analysis_names({"rdf", "thermo", "msd"}));
    CHECK_THROWS_WITH(check_analysis_names({"rdff"}), Contains("did you mean 'rdf'?"));
    CHECK_THROWS_WITH(check_analysis_names({"energies"}),
                      Contains("chemical_potential, ") && Contains(", viscosity, thermo"));
}
