#include "judge/exchange.hpp"

#include "catch.hpp"

#include "integrators/thermostat.hpp"
#include "io/output_fixtures.hpp"
#include "io/tables/json_file.hpp"
#include "judge/small_problem.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;

TEST_CASE("the start that an engine gets is read back to the last bit") {
    const TemporaryFolder folder;
    const Problem problem = small_problem();
    write_problem(problem, folder / "");
    const Fluid found = read_start(folder / "", problem.fluid.potential, false);
    CHECK(found.edges == problem.fluid.edges);
    CHECK(found.positions == problem.fluid.positions);
    CHECK(found.velocities == problem.fluid.velocities);
    CHECK(std::filesystem::exists(folder / "start.data"));
    Problem again = problem;
    again.fluid = found;
    CHECK(json_text(folder / "problem.json") == problem_json(again));
}

TEST_CASE("a problem tells its parameters, in numbers and in words") {
    Problem problem = small_problem();
    const Data json = parse_json(problem_json(problem));
    CHECK(json["atoms"].integer() == 108);
    CHECK(json["potential"]["truncation"].text() == "force-shifted");
    CHECK_THAT(json["potential"]["in_words"].text(), Catch::Contains("(r - 2.5) u'(2.5)"));
    CHECK(json["potential"]["tail_pressure"].number() == 0.0);
    CHECK(json["trajectory"]["frames"].size() == 3);
    CHECK(json["run"]["ensemble"].text() == "NVE");
    CHECK(json["run"]["degrees_of_freedom"].integer() == 321);
    CHECK(json["wanted"].size() == 3);
    problem.parts = {"point"};
    CHECK(parse_json(problem_json(problem))["wanted"].size() == 1);
    problem.fluid.potential = PairPotential::lennard_jones("cut", {2.5, 0.0});
    problem.fluid.tail = true;
    CHECK(parse_json(problem_json(problem))["potential"]["tail_energy_per_atom"].number() < -0.3);
}

TEST_CASE("a thermostat that acts on the centre of mass gives all atoms their degrees of freedom") {
    Stage stage;
    CHECK(ensemble_of(stage) == "NVE");
    CHECK(freedom_of(stage, 10) == 27);
    stage.thermostat = Choice{"langevin"};
    CHECK(ensemble_of(stage) == "NVT");
    CHECK(freedom_of(stage, 10) == 30);
    stage.thermostat = Choice{"stochastic-rescaling"};
    CHECK(freedom_of(stage, 10) == 27);
}

TEST_CASE("a start without velocities is not the one that was written") {
    const TemporaryFolder folder;
    std::ofstream(folder / "start.xyz") << "1\nLattice=\"6 0 0 0 6 0 0 0 6\"\nX 1 1 1\n";
    CHECK_THROWS_AS(read_start(folder / "", PairPotential::lennard_jones("cut", {2.5, 0.0}), false), DataError);
}
