#include "run/run.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/few_body_system.hpp"
#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"
#include "run/run_directory.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

/// A few-body deck that was run in its folder, and what came of it.
struct Finished {
    explicit Finished(const std::string& text, const std::vector<std::string>& settings = {})
        : folder(text), deck(folder.load(settings)), system(make_few_body_system(deck.few_bodies())) {
        prepare_directory(deck.directory);
        result = run_plan(deck, system, listener);
    }

    [[nodiscard]] std::string file(const std::string& name) const { return content_of(deck.directory / name); }

    [[nodiscard]] const FewBodyHistory& history(const std::string& name) const {
        const auto found = std::find_if(result.histories.begin(), result.histories.end(),
                                        [&](const FewBodyHistory& history) { return history.name == name; });
        REQUIRE(found != result.histories.end());
        return *found;
    }

    /// NaN when the analysis has not found it.
    [[nodiscard]] double finding(const std::string& analysis, const std::string& name) const {
        for (const auto& [of, found] : result.findings) {
            for (const Finding& finding : found) {
                if (of == analysis && finding.name == name) {
                    return finding.value;
                }
            }
        }
        return std::nan("");
    }

    DeckFolder folder;
    Deck deck;
    FewBodySystem system;
    Recorder listener;
    FewBodyResult result{};
};

std::string stage(const std::string& name, const std::string& more) {
    return "\n[[stage]]\nname = \"" + name + "\"\ntime_step = 0.01\nsteps = 95\n" + more;
}

/// The deck with a stage more, which brings it back.
std::string there_and_back(const std::string& deck, const std::string& integrator) {
    const std::string choice = "integrator = \"" + integrator + "\"\n";
    return changed(deck, {{"steps = 95\n", "steps = 95\n" + choice}}) +
           stage("back", choice + "reverse = true\nsample = false\n");
}

/// Three stars at positions that are no whole multiples of anything, in three dimensions.
std::string three_stars() {
    return changed(stars_deck, {{"[-0.5, 0.0]", "[-0.7, 0.1, 0.3]"},
                                {"[0.0, -0.3]", "[0.1, -0.3, 0.0]"},
                                {"[0.5, 0.0]", "[0.5, 0.2, -0.1]"},
                                {"[0.0, 0.3]", "[0.0, 0.3, -0.2]"},
                                {"[[stage]]",
                                 "[[body]]\nmass = 0.1\nposition = [0.3, -0.9, 0.7]\n"
                                 "velocity = [0.2, 0.3, 0.1]\n\n[[stage]]"}});
}

/// The Pythagorean problem by the adaptive method, with frames so far apart.
std::string pythagorean(double frame, int frames) {
    return R"([force]
type = "newtonian-gravity"
gravitational_constant = 1.0

[[body]]
mass = 3.0
position = [1.0, 3.0]
velocity = [0.0, 0.0]

[[body]]
mass = 4.0
position = [-2.0, -1.0]
velocity = [0.0, 0.0]

[[body]]
mass = 5.0
position = [1.0, -1.0]
velocity = [0.0, 0.0]

[[stage]]
name = "fall"
integrator = "prince-dormand"
time_step = )" +
           std::to_string(frame) + "\nsteps = " + std::to_string(frames) + "\n\n[analysis]\nclosest_approach = {}\n";
}

}  // namespace

TEST_CASE("every tenth step of few bodies is in thermo.csv, and the end") {
    const Finished run(stars_deck);
    CHECK(column(run.file("thermo.csv"), "step") == std::vector<double>{0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 95});
    const auto times = column(run.file("thermo.csv"), "time");
    CHECK(times.front() == 0.0);
    CHECK(times.back() == 95 * 0.01);
    CHECK(run.listener.stages == std::vector<std::string>{"orbits"});
    REQUIRE(run.listener.steps.size() == 95);
    CHECK(run.listener.steps.front() == 1);
    CHECK(run.listener.steps.back() == 95);
    const Finished even(stars_deck, {"stage.orbits.steps=20"});
    CHECK(column(even.file("thermo.csv"), "step") == std::vector<double>{0, 10, 20});
    const Finished none(stars_deck, {"stage.orbits.steps=0"});
    CHECK(column(none.file("thermo.csv"), "step") == std::vector<double>{0});
}

TEST_CASE("the totals of two stars are those summed by hand") {
    const Finished run(stars_deck, {"stage.orbits.steps=0", "body.2.velocity=[0.1, 0.3]"});
    CHECK(run.history("potential_energy").at_start == Approx(-0.25).epsilon(1e-15));
    CHECK(run.history("kinetic_energy").at_start == Approx(0.25 * (0.09 + 0.1)).epsilon(1e-15));
    CHECK(run.history("total_energy").at_start == Approx(0.25 * 0.19 - 0.25).epsilon(1e-15));
    CHECK(run.history("momentum_x").at_start == Approx(0.05).epsilon(1e-15));
    CHECK(run.history("momentum_y").at_start == Approx(0.0).margin(1e-16));
    CHECK(run.history("angular_momentum_z").at_start == Approx(0.15).epsilon(1e-15));
    CHECK(run.result.histories.size() == 6);
}

TEST_CASE("the totals of a pendulum are those of a mass at the end of a rod") {
    const std::string deck = R"([force]
type = "pendulum"
gravity = 9.81
length = 2.0

[[body]]
mass = 1.0
position = [1.0]
velocity = [0.5]

[[stage]]
name = "swing"
time_step = 0.001
steps = 2000

[analysis]
oscillation = {}
)";
    const Finished run(deck);
    CHECK(run.history("potential_energy").at_start == Approx(9.81 * 2.0 * (1.0 - std::cos(1.0))).epsilon(1e-14));
    CHECK(run.history("potential_energy").at_start == Approx(9.0193).margin(5e-5));
    CHECK(run.history("kinetic_energy").at_start == 0.5);  // m l^2 omega^2 / 2
    CHECK(run.history("momentum_x").at_start == 2.0);      // m l^2 omega
    CHECK(run.history("total_energy").at_start == Approx(9.5193).margin(5e-5));
    CHECK(run.history("total_energy").largest_deviation < 2e-5);
    // m g l (1 - cos a) at the turning point.
    const double amplitude = run.finding("oscillation", "amplitude");
    CHECK(19.62 * (1.0 - std::cos(amplitude)) == Approx(run.history("total_energy").at_start).epsilon(1e-6));
    // With the mass doubled all are doubled, and the motion is the same.
    const Finished heavy(deck, {"body.1.mass=2.0"});
    CHECK(heavy.history("total_energy").at_end == Approx(2.0 * run.history("total_energy").at_end).epsilon(1e-12));
    CHECK(heavy.finding("oscillation", "amplitude") == Approx(amplitude).epsilon(1e-12));
}

TEST_CASE("totals have as many components as there are dimensions") {
    const auto names = [](const std::string& deck) {
        std::string all;
        for (const FewBodyHistory& history : Finished(deck).result.histories) {
            all += history.name + " ";
        }
        return all;
    };
    const std::string energies = "potential_energy kinetic_energy total_energy ";
    CHECK(names(radial_deck) == energies + "momentum_x ");
    CHECK(names(stars_deck) == energies + "momentum_x momentum_y angular_momentum_z ");
    CHECK(names(three_stars()) == energies +
                                      "momentum_x momentum_y momentum_z angular_momentum_x angular_momentum_y "
                                      "angular_momentum_z ");
}

TEST_CASE("what results say of a total is what thermo.csv says") {
    const Finished run(three_stars());
    for (const FewBodyHistory& history : run.result.histories) {
        INFO(history.name);
        const auto values = column(run.file("thermo.csv"), history.name);
        double sum = 0.0;
        double largest = 0.0;
        for (const double value : values) {
            sum += value;
            largest = std::max(largest, std::abs(value - values.front()));
        }
        CHECK(history.at_start == values.front());
        CHECK(history.at_end == values.back());
        CHECK(history.mean == Approx(sum / static_cast<double>(values.size())).epsilon(1e-12).margin(1e-15));
        CHECK(history.largest_deviation == largest);
    }
    CHECK(run.history("kinetic_energy").largest_deviation > 1e-3);
    CHECK(run.history("total_energy").largest_deviation < 1e-4);
    CHECK(run.history("angular_momentum_x").largest_deviation < 1e-14);
    CHECK(run.history("momentum_z").largest_deviation < 1e-14);
    REQUIRE(run.result.stages.size() == 1);
    CHECK(std::abs(run.result.stages[0].energy_drift.value()) < 1e-4);
}

TEST_CASE("frames of few bodies are written at the start and when they are due") {
    const Finished run(stars_deck, {"output.trajectory.every=30"});
    const std::string csv = run.file("trajectory.csv");
    CHECK(header(csv) == "step,time,x1,y1,vx1,vy1,x2,y2,vx2,vy2");
    CHECK(column(csv, "step") == std::vector<double>{0, 30, 60, 90});
    CHECK(column(csv, "x1").front() == -0.5);
    CHECK(column(csv, "vy2").front() == 0.3);
    const Finished with(stars_deck, {"output.trajectory.every=95", "output.trajectory.accelerations=true"});
    CHECK(column(with.file("trajectory.csv"), "ax1").front() == Approx(0.5));
    CHECK(column(with.file("trajectory.csv"), "ax2").back() ==
          Approx(-0.5 * column(with.file("trajectory.csv"), "x2").back() /
                 std::pow(std::hypot(column(with.file("trajectory.csv"), "x2").back(),
                                     column(with.file("trajectory.csv"), "y2").back()),
                          3) /
                 4.0));
}

TEST_CASE("what is measured and written changes no bit of the motion of few bodies") {
    const std::string last = Finished(three_stars()).file("final.xyz");
    for (const std::vector<std::string>& settings :
         {std::vector<std::string>{"output.thermo.every=1"},
          {"output.thermo.every=1000"},
          {"output.trajectory.every=1", "output.trajectory.accelerations=true"},
          {"output.trajectory.every=3", "output.trajectory.format=xyz"},
          {"stage.orbits.sample=false"},
          {"analysis.orbit.body=2"}}) {
        INFO(settings.front());
        CHECK(Finished(three_stars(), settings).file("final.xyz") == last);
    }
    CHECK(Finished(three_stars(), {"body.3.mass=0.11"}).file("final.xyz") != last);
}

TEST_CASE("bit-reversible bodies are back where they began, to the last bit, and others are not") {
    const Finished exact(there_and_back(three_stars(), "bit-reversible"));
    REQUIRE(exact.result.stages.size() == 2);
    const StageResult& there = exact.result.stages[0];
    const StageResult& back = exact.result.stages[1];
    CHECK(back.reversed);
    CHECK_FALSE(there.reversed);
    CHECK(there.checksum_at_start != there.checksum_at_end);
    CHECK(back.checksum_at_start == there.checksum_at_end);
    CHECK(back.checksum_at_end == there.checksum_at_start);
    CHECK_THAT(exact.file("results.txt"), Contains(back.checksum_at_end + " at the start\n") &&
                                              Contains(back.checksum_at_end + " after stage 'back'\n"));
    CHECK(parse_json(exact.file("results.json")).at("stages")[1].at("checksum_at_end") == there.checksum_at_start);
    const Finished rounded(there_and_back(three_stars(), "velocity-verlet"));
    CHECK(rounded.result.stages[1].checksum_at_end != rounded.result.stages[0].checksum_at_start);
    CHECK(rounded.history("potential_energy").at_end ==
          Approx(rounded.history("potential_energy").at_start).epsilon(1e-11));
}

TEST_CASE("an ellipse has its elements and its closest approach") {
    const double a = 1.0 / 1.64;
    const Finished run(stars_deck + "[analysis]\norbit = { body = 1, about = 2 }\nclosest_approach = {}\n",
                       {"stage.orbits.steps=3000", "stage.orbits.time_step=0.002"});
    CHECK(run.finding("orbit", "semi_major_axis_at_start") == Approx(a).epsilon(1e-12));
    CHECK(run.finding("orbit", "eccentricity_at_start") == Approx(0.64).epsilon(1e-12));
    CHECK(run.finding("orbit", "semi_major_axis_at_end") == Approx(a).epsilon(1e-3));
    CHECK(run.finding("orbit", "period") == Approx(2.0 * std::numbers::pi * std::pow(a, 1.5)).epsilon(1e-3));
    CHECK(run.finding("orbit", "first_apocentre") == Approx(1.0).epsilon(1e-12));
    CHECK(run.finding("closest_approach", "distance") == Approx(a * 0.36).epsilon(1e-3));
    CHECK(header(run.file("orbit.csv")) == "apocentre,time,distance,angle");
    CHECK(rows(run.file("orbit.csv")).size() >= 4);
    CHECK(parse_json(run.file("results.json")).at("analysis").at("orbit").contains("period"));
}

TEST_CASE("analyses look at sampled stages from their beginning, and at no others") {
    const std::string nearest = "[analysis]\nclosest_approach = {}\n";
    // From apocentre to beyond pericentre, at half a period of 1.4959, and on to the apocentre.
    const std::vector<std::string> half{"stage.orbits.steps=200"};
    const double pericentre = 0.36 / 1.64;
    CHECK(Finished(stars_deck + nearest, half).finding("closest_approach", "distance") ==
          Approx(pericentre).epsilon(0.05));
    const Finished later(stars_deck + stage("later", "") + nearest,
                         {"stage.orbits.steps=200", "stage.orbits.sample=false"});
    CHECK(later.finding("closest_approach", "time") == Approx(2.0).epsilon(1e-14));
    CHECK(later.finding("closest_approach", "distance") > 2.0 * pericentre);
    CHECK(std::isnan(
        Finished(stars_deck + nearest, {"stage.orbits.sample=false"}).finding("closest_approach", "distance")));
}

TEST_CASE("the polar angle of a distance grows with the motion and goes back with it") {
    const Finished run(there_and_back(changed(radial_deck, {{"steps = 50", "steps = 95"}}), "velocity-verlet"),
                       {"output.trajectory.every=1"});
    const auto angle = column(run.file("trajectory.csv"), "angle");
    REQUIRE(angle.size() == 191);
    CHECK(angle[0] == 0.0);
    CHECK(angle[1] == Approx(0.012).epsilon(1e-3));  // h / rho^2 dt
    for (std::size_t n = 0; n < 95; ++n) {
        CHECK(angle[n + 1] > angle[n]);
        CHECK(angle[95 + n] > angle[95 + n + 1]);
    }
    CHECK(std::abs(angle[190]) < 1e-12);
}

TEST_CASE("bodies that collide end the run with step, stage and the configuration") {
    const DeckFolder folder(changed(stars_deck, {{"gravitational_constant = 1.0", "gravitational_constant = 1e-300"},
                                                 {"[0.0, -0.3]", "[0.25, 0.0]"},
                                                 {"[0.0, 0.3]", "[-0.25, 0.0]"},
                                                 {"time_step = 0.01", "time_step = 0.25"},
                                                 {"every = 10", "every = 1"}}));
    const Deck deck = folder.load();
    FewBodySystem system = make_few_body_system(deck.few_bodies());
    prepare_directory(deck.directory);
    Recorder listener;
    const auto run = [&] { static_cast<void>(run_plan(deck, system, listener)); };
    const std::string failed = (deck.directory / "failed.xyz").string();
    CHECK_THROWS_MATCHES(run(), PhysicsError, Catch::Matchers::Predicate<PhysicsError>([&](const PhysicsError& error) {
                             const std::string text = error.what();
                             UNSCOPED_INFO(text);
                             return text.starts_with("step 8 (stage 'orbits'): bodies 1 and 2 are both at (0, 0, 0)") &&
                                    text.ends_with("\n  the configuration is in " + failed);
                         }));
    CHECK(std::filesystem::exists(failed));
    CHECK_FALSE(std::filesystem::exists(deck.directory / "results.json"));
    CHECK_FALSE(std::filesystem::exists(deck.directory / "final.xyz"));
    CHECK(parse_json(content_of(deck.directory / "run.json")).at("finished") == false);
    CHECK(rows(content_of(deck.directory / "thermo.csv")).size() == 8);  // what was measured until then is there
}

TEST_CASE("bodies that leave the range of numbers end the run, and the last checkpoint is from before") {
    const DeckFolder folder(changed(stars_deck, {{"time_step = 0.01", "time_step = 10.0"},
                                                 {"type = \"newtonian-gravity\"", "type = \"harmonic\""},
                                                 {"gravitational_constant = 1.0", "stiffness = 1.0"},
                                                 {"steps = 95\n", "steps = 5000\nintegrator = \"euler\"\n"}}));
    const Deck deck =
        folder.load({GENERATE("output.thermo.every=7", "output.thermo.every=4000"), "output.checkpoint.every=100"});
    FewBodySystem system = make_few_body_system(deck.few_bodies());
    prepare_directory(deck.directory);
    Recorder listener;
    CHECK_THROWS_WITH(run_plan(deck, system, listener), Contains("the run has blown up. Is the time step too large"));
    CHECK_THAT(content_of(deck.directory / "thermo.csv"), !Contains("inf") && !Contains("nan"));
    REQUIRE(find_continuation(deck).has_value());
    CHECK(find_continuation(deck)->head.step == 100);  // velocities can be squared until step 134
}

TEST_CASE("run.json of few bodies tells that the run has ended") {
    const Finished run(stars_deck);
    const Data record = parse_json(run.file("run.json"));
    CHECK(record.at("finished") == true);
    CHECK(record.at("seconds_in_time_loop") == run.result.seconds);
    CHECK(run.result.bodies == 2);
    CHECK(run.result.dimensions == 2);
    CHECK(run.result.force == "newtonian-gravity");
}

TEST_CASE("an encounter within a step of the adaptive method is found, however long the step") {
    // To t = 16. Frames 1e-7 apart around the encounter have 4.1382e-4 at t = 15.829920.
    for (const auto& [frame, frames] : {std::pair{0.01, 1600}, {0.25, 64}, {16.0, 1}}) {
        INFO(frame);
        const Finished run(pythagorean(frame, frames));
        CHECK(run.finding("closest_approach", "distance") == Approx(4.138e-4).epsilon(2e-4));
        CHECK(run.finding("closest_approach", "time") == Approx(15.82992).margin(5e-6));
        CHECK(run.finding("closest_approach", "first_body") == 2.0);
        CHECK(run.finding("closest_approach", "second_body") == 3.0);
        CHECK(std::ssize(run.listener.steps) == frames);
    }
}

TEST_CASE("an encounter that fixed steps do not resolve has no closest approach, and the results say why") {
    // The first of them: 0.0097 at t = 1.8793, where the two move by half of that in 1.1e-4.
    const auto run = [](double time_step) {
        return Finished(changed(pythagorean(time_step, static_cast<int>(std::lround(2.0 / time_step))),
                                {{"prince-dormand", "velocity-verlet"}}));
    };
    const Finished fine = run(5e-5);
    CHECK(fine.finding("closest_approach", "distance") == Approx(0.0097).epsilon(0.01));
    CHECK_THAT(fine.file("results.json"), !Contains("remark"));
    const Finished coarse = run(1e-3);
    const Data found = parse_json(coarse.file("results.json")).at("analysis").at("closest_approach");
    for (const char* name : {"distance", "time", "first_body", "second_body"}) {
        INFO(name);
        CHECK(found.at(name).at("value").is_null());
        CHECK_THAT(found.at(name).at("remark").text(),
                   Contains("meet at time 1.8") && Contains("within a step") && Contains("take smaller steps"));
    }
    CHECK_THAT(coarse.file("results.txt"), Contains("no value  [1]\n") && Contains("\n  [1] bodies "));
}

TEST_CASE("what is measured within steps changes no bit of the motion") {
    const Finished with(pythagorean(0.25, 20));
    const Finished without(changed(pythagorean(0.25, 20), {{"closest_approach = {}", ""}}));
    CHECK(with.file("final.xyz") == without.file("final.xyz"));
    CHECK(with.file("thermo.csv") == without.file("thermo.csv"));
}

TEST_CASE("apsides, swings and angles of the adaptive method do not depend on its frames") {
    // Three orbits of the comet by its distance alone in 5 frames: longer than half an orbit each.
    const Finished comet(radial_deck + "\n[analysis]\norbit = { body = 1 }\n",
                         {"force.gravitational_parameter=1.001", "stage.out.integrator=prince-dormand",
                          "stage.out.time_step=9.0", "stage.out.steps=5"});
    CHECK(comet.finding("orbit", "period") == Approx(14.928269695716399).epsilon(1e-9));
    CHECK(comet.finding("orbit", "first_apocentre") == Approx(2.562277580071175).epsilon(1e-9));
    CHECK(comet.finding("orbit", "precession") == Approx(0.0).margin(1e-8));
    // A pendulum let go at 170 degrees, in frames of more than one swing.
    const Finished pendulum(R"([force]
type = "pendulum"
gravity = 1.0
length = 1.0

[[body]]
mass = 1.0
position = [2.9670597283903604]
velocity = [0.0]

[[stage]]
name = "swing"
integrator = "prince-dormand"
time_step = 20.0
steps = 4

[analysis]
oscillation = {}
)");
    CHECK(pendulum.finding("oscillation", "period") == Approx(15.326967999137).epsilon(1e-9));
    CHECK(pendulum.finding("oscillation", "amplitude") == Approx(2.9670597283903604).epsilon(1e-9));
}

TEST_CASE("what ends a run within a step is told with the time of the run") {
    // Two bodies at rest fall on each other at t = pi/8^(1/2) = 1.11072.
    const std::string deck = R"([force]
type = "newtonian-gravity"
gravitational_constant = 1.0

[[body]]
mass = 0.5
position = [-0.5]
velocity = [0.0]

[[body]]
mass = 0.5
position = [0.5]
velocity = [0.0]

[[stage]]
name = "fall"
integrator = "prince-dormand"
time_step = 0.5
steps = 4
)";
    CHECK_THROWS_WITH(Finished(deck),
                      Contains("step 3 (stage 'fall'): the solution ends at time 1.1107") && Contains("before 1.5"));
}
