// A formula of the calling program in a whole run: its own numbers are those of the same formula in the library.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>
#include "catch.hpp"

#include "engine/engine_fixtures.hpp"
#include "forces/pair_force_field.hpp"
#include "ljmd/core/errors.hpp"
#include "neighbors/pair_search.hpp"
#include "potentials/pair_table.hpp"
#include "potentials/twelve_six.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

FluidSpec custom_spec(const std::string& search) {
    FluidSpec spec = with_analyses();
    spec.potential = PairPotential::custom("twelve-six", TwelveSix{}, "force-shifted", {2.0, 0.0});
    spec.neighbors.method = search;
    return spec;
}

/// Lennard-Jones as a table from some distance on.
FluidSpec spec_of_table(double first) {
    const PairPotential bare = PairPotential::lennard_jones("cut", {2.0, 0.0});
    std::vector<double> energies;
    for (const double r : PairTable::distances(first, 2.0, 256)) {
        energies.push_back(bare.untruncated(r).u);
    }
    FluidSpec spec = small_spec();
    spec.potential = PairPotential::custom("own", PairTable(first, 2.0, energies), "force-shifted", {2.0, 0.0});
    return spec;
}

std::vector<std::string> doubts_of_whole_run(double first) {
    Simulation run(spec_of_table(first));
    run.run();
    return run.result().doubts;
}

}  // namespace

TEST_CASE("a formula of the program runs as the same one of the library: bits, tables, energy, checkpoints") {
    for (const std::string& search : pair_search_names()) {
        INFO(search);
        FluidSpec built_in = with_analyses();
        built_in.neighbors.method = search;
        Simulation ours(built_in);
        Simulation theirs(custom_spec(search));
        ours.run();
        theirs.run();
        if (search == "verlet-list") {  // kernels sum the library's in another order
            const RunResult expected = ours.result();
            for (const char* name : {"temperature", "potential_energy", "pressure"}) {
                CHECK(theirs.result().observable(name).estimate->mean ==
                      Approx(expected.observable(name).estimate->mean).epsilon(1e-9));
            }
            CHECK(theirs.result().table("rdf").rows.size() == expected.table("rdf").rows.size());
        } else {
            check_same(theirs, ours);
        }
        CHECK(std::abs(theirs.result().stages.back().energy_drift.value()) < 0.02);
        Simulation pieces(custom_spec(search));
        pieces.advance(33);
        Simulation resumed(custom_spec(search));
        resumed.restore(pieces.checkpoint());
        resumed.run();
        check_same(resumed, theirs);
    }
}

TEST_CASE("a checkpoint is not continued with another formula of the same name, and none runs in mixed precision") {
    Simulation first(custom_spec("cells"));
    first.advance(30);
    FluidSpec other = custom_spec("cells");
    other.potential = PairPotential::custom("twelve-six",
                                            [](const PairDistance<double>& d) {
                                                const PairTerm<double> term = TwelveSix{}(d);
                                                return PairTerm<double>{1.01 * term.u, 1.01 * term.w};
                                            },
                                            "force-shifted", {2.0, 0.0});
    CHECK_THROWS_WITH(Simulation(other).restore(first.checkpoint()), Contains("another specification"));
    CHECK_THROWS_WITH(Simulation(custom_spec("verlet-list"), Execution({.precision = Precision::mixed})),
                      Contains("computed in double precision"));
}

TEST_CASE("the virial of a formula of the program is the response of its energy to a change of the box") {
    const FluidSpec spec = custom_spec("cells");
    Simulation simulation(spec);
    simulation.run();
    const auto evaluated = [&](double stretch) {
        State state = simulation.state();
        state.rescale_to(Box(stretch * state.box().edges()));
        PairForceField force_field(spec.potential, make_pair_search("cells", 0.3));
        return force_field.evaluate(state, Request::forces_and_energy);
    };
    constexpr double h = 2e-6;  // dU/d(ln L) = -trace(W)
    const double response = -(evaluated(1.0 + h).potential_energy - evaluated(1.0 - h).potential_energy) / (2.0 * h);
    const double virial = evaluated(1.0).virial.trace();
    CHECK(std::abs(response - virial) < 1e-6 * (std::abs(virial) + 100.0));
}

TEST_CASE("a run whose pairs come nearer than the table of its potential says so, also resumed") {
    const auto tells = [](const std::vector<std::string>& doubts) {
        return std::ranges::count_if(
            doubts, [](const std::string& each) { return each.find("where the table") < each.size(); });
    };
    CHECK(tells(doubts_of_whole_run(0.5)) == 0);
    const std::vector<std::string> expected = doubts_of_whole_run(1.0);
    REQUIRE(tells(expected) == 1);
    CHECK_THAT(expected.front(),
               Contains("in 4 of 4 samples pairs of atoms were nearer than 1, where the table") && Contains("'own'"));
    Simulation pieces(spec_of_table(1.0));
    pieces.advance(43);
    Simulation resumed(spec_of_table(1.0));
    resumed.restore(pieces.checkpoint());
    resumed.run();
    CHECK(resumed.result().doubts == expected);
}
