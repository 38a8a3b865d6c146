#include "judge/judge.hpp"

#include "catch.hpp"

#include "judge/own_run.hpp"
#include "judge/point_judgement.hpp"
#include "judge/small_problem.hpp"
#include "ljmd/detail/potentials/tail_correction.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

const auto quiet = [](const std::string&) {};

/// The answer of an engine that is ljmd itself.
Answer right_answer(const Problem& problem) {
    const ExpectedPoint expected =
        expected_point(problem.fluid, point_of(problem.fluid, *MadePeer::force_field_of(problem.fluid)));
    Answer answer;
    answer.point = {.potential_energy = expected.potential_energy(),
                    .kinetic_energy = expected.kinetic_energy,
                    .temperature = expected.temperature(),
                    .virial = expected.sums.virial,
                    .pressure = expected.pressure(),
                    .forces = expected.sums.forces};
    JudgedTrajectory trajectory{problem.fluid.edges, problem.stage.time_step, {}};
    for (const Index step : problem.frames) {
        trajectory.frames.push_back({.step = step, .positions = problem.fluid.positions});
    }
    follow(problem.fluid, *MadePeer::force_field_of(problem.fluid), {}, trajectory);
    for (const JudgedFrame& made : trajectory.frames) {
        Frame frame;
        frame.configuration.step = made.step;
        frame.configuration.positions = made.our_positions;
        frame.configuration.velocities = made.our_velocities;
        frame.forces = made.our_forces;
        answer.frames.push_back(frame);
    }
    const auto rows = own_rows(problem.fluid, TailCorrection(), *MadePeer::force_field_of(problem.fluid), {},
                               problem.stage.time_step, 10);
    answer.thermo = ThermoAnswer{};
    for (const Index step : {0, 5, 10}) {
        const OwnRow& row = rows[static_cast<std::size_t>(step)];
        answer.thermo->steps.push_back(step);
        answer.thermo->potential_energy.push_back(row.potential_energy);
        answer.thermo->kinetic_energy.push_back(row.kinetic_energy);
        answer.thermo->pressure.push_back(row.pressure);
    }
    return answer;
}

Judgement judged(const Problem& problem, const Answer& answer) {
    return judge(problem, answer, own_side(problem), quiet);
}

}  // namespace

TEST_CASE("an answer is judged in all its parts, and a right one passes") {
    const Problem problem = small_problem();
    const Judgement found = judged(problem, right_answer(problem));
    CHECK(found.passed());
    CHECK(found.checks.size() == 7 + 3 * 4 + 2 * 3);
    CHECK(found.diagnoses.empty());
    REQUIRE(found.trajectory.size() == 3);
    CHECK(found.time_step == problem.stage.time_step);
    CHECK(found.trajectory[2].step == 10);
    CHECK(found.trajectory[2].distance <= found.trajectory[2].allowed.value());
    CHECK(found.trajectory[2].force_difference.value() < 1e-11);
    CHECK(found.atoms == 108);
    CHECK(found.steps_before == 20);
    CHECK_THAT(found.path, StartsWith("all-pairs, scalar, double precision"));
    CHECK_THAT(found.not_judged.at(0), Contains("too short"));
    CHECK_THAT(found.warnings.at(0), Contains("thermo.csv ends with step 10, the run has 40 steps"));
}

TEST_CASE("only the parts that are asked for are judged, and missing ones are named") {
    Problem problem = small_problem();
    const Judgement nothing = judged(problem, {});
    CHECK(nothing.checks.empty());
    CHECK(nothing.not_judged.size() == 3);
    problem.parts = {"point"};
    CHECK(judged(problem, right_answer(problem)).checks.size() == 7);
    CHECK(judged(problem, {}).not_judged.size() == 1);
    problem.parts = {"trajectory"};
    Answer answer = right_answer(problem);
    answer.frames.pop_back();
    answer.frames[0].configuration.velocities.clear();
    const Judgement found = judged(problem, answer);
    CHECK(found.checks.size() == 6);
    CHECK_THAT(found.not_judged.at(0), StartsWith("trajectory at step 10: no frame"));
    CHECK_THAT(found.not_judged.at(1), StartsWith("kinetic energies of the trajectory"));
}

TEST_CASE("mistakes are named wherever they show") {
    const Problem problem = small_problem();
    SECTION("in the first frame, if there is no other force of the start") {
        Answer answer = right_answer(problem);
        answer.point = {};
        for (Frame& frame : answer.frames) {
            for (Vec3& f : frame.forces) {
                f *= -1.0;
            }
        }
        CHECK_THAT(judged(problem, answer).diagnoses.at(0),
                   StartsWith("frame of step 0: epsilon off") || StartsWith("frame of step 0: forces"));
    }
    SECTION("in the first row of the table") {
        Answer answer = right_answer(problem);
        const PeerPoint point = point_of(problem.fluid, *MadePeer::force_field_of(problem.fluid));
        answer.thermo->kinetic_energy[0] = half_step_kinetic_energy(problem.fluid, point.forces, -0.002);
        const Judgement found = judged(problem, answer);
        CHECK(found.failures() == 1);
        CHECK_THAT(found.diagnoses.at(0), StartsWith("half-step velocities: the kinetic energy of thermo.csv"));
    }
    SECTION("in its later rows") {
        Answer answer = right_answer(problem);
        const auto rows = own_rows(problem.fluid, TailCorrection(), *MadePeer::force_field_of(problem.fluid), {},
                                   problem.stage.time_step, 10);
        answer.thermo->potential_energy[1] = rows[4].potential_energy;
        answer.thermo->potential_energy[2] = rows[9].potential_energy;
        const Judgement found = judged(problem, answer);
        CHECK(found.failures() == 1);
        CHECK_THAT(found.diagnoses.at(0), StartsWith("one step late: the potential energy of thermo.csv"));
    }
    SECTION("in velocities") {
        Answer answer = right_answer(problem);
        for (Frame& frame : answer.frames) {
            for (Vec3& v : frame.configuration.velocities) {
                v = -v;
            }
        }
        const Judgement found = judged(problem, answer);
        CHECK(found.failures() == 3);
        CHECK_THAT(found.diagnoses.at(0), StartsWith("velocities: in the frame of step 0 they have the wrong sign"));
    }
    SECTION("in the temperatures of the table") {
        Answer answer = right_answer(problem);
        for (const double k : answer.thermo->kinetic_energy) {
            answer.thermo->temperature.push_back(2.0 * k / (3.0 * 108.0));
        }
        CHECK_THAT(judged(problem, answer).diagnoses.at(0),
                   StartsWith("3N against 3N-3: the temperature of thermo.csv"));
    }
    SECTION("few digits") {
        Answer answer = right_answer(problem);
        double off = 1e-7;
        for (Vec3& f : answer.point.forces) {
            f[0] += off;
            off = -off;
        }
        CHECK_THAT(judged(problem, answer).diagnoses.at(0), StartsWith("single precision"));
        for (Vec3& f : answer.point.forces) {
            f = f.unaryExpr([](double x) { return std::round(x * 1e6) * 1e-6; });
        }
        CHECK_THAT(judged(problem, answer).diagnoses.at(0),
                   StartsWith("few digits: numbers of point.json have 6 decimals"));
    }
}

TEST_CASE("rows under a thermostat are not compared one by one, and those beyond the last common step neither") {
    Problem problem = small_problem();
    Answer answer = right_answer(problem);
    answer.thermo->potential_energy.back() += 1.0;
    CHECK(judged(problem, answer).failures() == 1);
    problem.stage.thermostat = Choice{"langevin"};
    problem.stage.temperature = 1.0;
    CHECK(judged(problem, answer).failures() == 0);
    problem = small_problem();
    answer.thermo->steps.back() = 100'000;
    const Judgement late = judged(problem, answer);
    CHECK(late.failures() == 0);
    answer.thermo = ThermoAnswer{};
    answer.thermo->steps = {100'000};
    answer.thermo->potential_energy = {1.0};
    CHECK_THAT(judged(problem, answer).not_judged.at(0), Contains("rows of thermo.csv: there is none from step 1 to"));
}

TEST_CASE("the problem of a deck is its first sampled stage, forward and at its own energy") {
    const DeckFolder folder(small_deck);
    const Deck deck = folder.load();
    const Problem problem =
        problem_of(deck, warm_crystal(), {.with = "files:x", .steps = 150, .frames = {100, 1, 500}});
    CHECK(problem.frames == std::vector<Index>{0, 1, 100});
    CHECK(problem.trajectory_steps == 100);
    CHECK(problem.steps_before == 20);
    CHECK(problem.stage.name == "production");
    CHECK_FALSE(problem.stage.total_energy);
}
