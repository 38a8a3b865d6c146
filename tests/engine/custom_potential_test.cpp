// A formula of the calling program in a whole run: its own numbers are those of the same formula in the library.
#include <catch2/catch.hpp>
#include <cmath>

#include "engine/engine_fixtures.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/forces/pair_force_field.hpp"
#include "ljmd/neighbors/pair_search.hpp"
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
