#include "compare/crosscheck_report.hpp"

#include <limits>

#include "io/output_fixtures.hpp"
#include "io/tables/json_text.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

const CrosscheckOptions options{.with = "openmm"};

/// One check that passes and one that does not, a trajectory of two rows, averages, g(r) of two bins, speeds.
Crosscheck made() {
    Crosscheck found{.peer = "OpenMM 7.7 (Reference)",
                     .fast_peer = "OpenMM 7.7 (CPU, 1 thread)",
                     .atoms = 108,
                     .steps_before = 20,
                     .search = "verlet-list",
                     .simd = "x86-64-v3",
                     .precision = "double",
                     .threads = 2,
                     .integrator = "leapfrog",
                     .steps_of_averages = 400,
                     .checks = {{"potential energy", 1e-15, 1e-13}, {"pressure", 2e-12, 1e-12}},
                     .trajectory = {},
                     .ensemble = EnsembleComparison{},
                     .speed = SpeedComparison{5e6, 1e6}};
    found.trajectory.time_step = 0.004;
    found.trajectory.pairings = {{"leapfrog", "VerletIntegrator", false}, {"velocity-verlet", "kick-drift-kick", true}};
    found.trajectory.rows = {{0, 0.0, {0.0, 0.0}, 0.0, 0.0}, {10, 0.04, {1e-14, 2e-15}, 3e-16, 4e-16}};
    found.ensemble->rows = {{"temperature", "T", {0.7, 0.03, 10.0, 100, true}, {0.8, 0.04, 10.0, 100, true}}};
    found.ensemble->rdf = {{0.5, 0.0, 0.0, 0.0, 0.0}, {1.0, 2.5, 0.1, 2.4, 0.2}};
    found.ensemble->frames = 40;
    return found;
}

Deck any_deck() {
    return DeckFolder(small_deck).load();
}

}  // namespace

TEST_CASE("the table of a comparison tells who was compared, what was found, and the verdict") {
    const std::string table = crosscheck_table(made(), any_deck(), options);
    for (const char* part :
         {"A small liquid\nagainst OpenMM 7.7 (Reference), long runs OpenMM 7.7 (CPU, 1 thread)\n",
          "108 atoms, after 20 steps of the deck\n", "ljmd: verlet-list, x86-64-v3, double precision, 2 threads\n",
          "potential energy      1.00e-15     1.0e-13\n", "pressure              2.00e-12     1.0e-12  FAILED\n",
          "400 steps of leapfrog, 40 configurations for g(r)\n",
          "temperature                0.700       0.030       0.800       0.040     2.00\n",
          "pressures are (2 K + W)/(3 V), as LAMMPS prints them: a convention",
          "speed: ljmd 5, OpenMM 7.7 (CPU, 1 thread) 1 million atom-steps/s, ratio 5.00\n", "1 of 2 checks FAILED\n"}) {
        CHECK_THAT(table, Contains(part));
    }
    Crosscheck good = made();
    good.checks.pop_back();
    good.checks.push_back(good.checks.front());
    CHECK_THAT(crosscheck_table(good, any_deck(), options), Contains("all 2 checks passed\n"));
    good.checks.clear();
    CHECK_THAT(crosscheck_table(good, any_deck(), options), Contains("nothing was judged\n"));
}

TEST_CASE("the JSON of a comparison holds every number") {
    const Data json = parse_json(crosscheck_json(made(), any_deck(), options));
    CHECK(json["passed"] == false);
    CHECK(json["checks"][0] ==
          Data::object({{"name", "potential energy"}, {"value", 1e-15}, {"tolerance", 1e-13}, {"passed", true}}));
    CHECK(json["checks"][1]["passed"] == false);
    CHECK(json["with"] == "openmm");
    CHECK(json["pressure_convention"] == "(2 K + W)/(3 V)");
    CHECK(json["path"]["simd"] == "x86-64-v3");
    CHECK(json["path"]["threads"] == 2);
    CHECK(json["trajectory"]["pairings"][1] ==
          Data::object({{"ours", "velocity-verlet"}, {"theirs", "kick-drift-kick"}}));
    CHECK(json["trajectory"]["rows"][1]["distances"] == Data::list({1e-14, 2e-15}));
    CHECK(json["trajectory"]["rows"][1]["kinetic_energy_difference"] == 4e-16);
    CHECK(json["trajectory"]["divergence_rate"].is_null());
    CHECK(json["averages"]["observables"]["temperature"]["peer"]["mean"] == 0.8);
    CHECK(json["averages"]["observables"]["temperature"]["sigmas"].number() == Approx(2.0));
    CHECK(json["atom_steps_per_second"]["ljmd"] == 5e6);
}

TEST_CASE("a number that is none is null in JSON, and no pass") {
    Crosscheck found = made();
    found.checks = {{"pressure", std::numeric_limits<double>::quiet_NaN(), 1e-12}};
    const Data json = parse_json(crosscheck_json(found, any_deck(), options));
    CHECK(json["checks"][0]["value"].is_null());
    CHECK(json["passed"] == false);
}

TEST_CASE("files of a comparison are written for what was compared") {
    const TemporaryFolder folder;
    const Deck deck = any_deck();
    write_crosscheck(made(), deck, options, folder / "new");
    CHECK(content_of(folder / "new/compare-openmm.json") == crosscheck_json(made(), deck, options) + "\n");
    CHECK(content_of(folder / "new/compare-openmm-trajectory.csv") ==
          "step,time,leapfrog - VerletIntegrator,velocity-verlet - kick-drift-kick,potential_energy_difference,"
          "kinetic_energy_difference\n0,0,0,0,0,0\n10,0.04,1e-14,2e-15,3e-16,4e-16\n");
    CHECK(content_of(folder / "new/compare-openmm-rdf.csv") ==
          "r,g_ljmd,g_ljmd_standard_error,g_peer,g_peer_standard_error\n0.5,0,0,0,0\n1,2.5,0.1,2.4,0.2\n");

    Crosscheck point_alone = made();
    point_alone.trajectory = {};
    point_alone.ensemble.reset();
    point_alone.speed.reset();
    write_crosscheck(point_alone, any_deck(), options, folder / "point");
    CHECK(std::filesystem::exists(folder / "point/compare-openmm.json"));
    CHECK_FALSE(std::filesystem::exists(folder / "point/compare-openmm-trajectory.csv"));
    CHECK_FALSE(std::filesystem::exists(folder / "point/compare-openmm-rdf.csv"));
    const Data json = parse_json(crosscheck_json(point_alone, any_deck(), options));
    CHECK_FALSE(json.contains("trajectory"));
    CHECK_FALSE(json.contains("averages"));
    CHECK_FALSE(json.contains("atom_steps_per_second"));
}
