#include "compare/compare_gsl.hpp"

#include <algorithm>
#include <cmath>

#include "io/tables/json_text.hpp"
#include "ljmd/core/errors.hpp"
#include "run/run_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

GslComparison compared_with_gsl(const std::string& text, const std::vector<std::string>& settings = {}) {
    const DeckFolder folder(text);
    const Deck deck = folder.load(settings);
    Recorder listener;
    GslComparison comparison = compare_with_gsl(deck, listener);
    CHECK(static_cast<Index>(listener.steps.size()) == total_steps(deck.stages()));
    CHECK(listener.stages.size() == deck.stages().size());
    return comparison;
}

/// The comparison of one and a half orbits of two stars with so many steps.
GslComparison compared_orbit(const std::string& integrator, int steps) {
    return compared_with_gsl(stars_deck,
                             {"stage.orbits.integrator=" + integrator, "stage.orbits.steps=" + std::to_string(steps),
                              "stage.orbits.time_step=" + std::to_string(4.5 / steps)});
}

const std::string second_stage = "\n[[stage]]\nname = \"more\"\ntime_step = 0.02\nsteps = 13\n";

}  // namespace

TEST_CASE("halving the step divides the error of a Kepler orbit by two to the order, against GSL") {
    for (const auto& [integrator, order, steps] :
         {std::tuple{"velocity-verlet", 2, 4500}, std::tuple{"leapfrog", 2, 4500}, std::tuple{"forest-ruth", 4, 3000},
          std::tuple{"euler-cromer", 1, 45000}}) {
        INFO(integrator);
        const GslComparison coarse = compared_orbit(integrator, steps);
        const GslComparison fine = compared_orbit(integrator, 2 * steps);
        CHECK(std::log2(coarse.largest_position_error / fine.largest_position_error) == Approx(order).margin(0.06));
        CHECK(std::log2(coarse.rows.back().velocity_error / fine.rows.back().velocity_error) ==
              Approx(order).margin(0.15));
        CHECK(coarse.passed());
        CHECK(coarse.reference_energy_error < 1e-11);
        CHECK(fine.rows.back().reference_error < 0.01 * fine.rows.back().position_error);
    }
}

TEST_CASE("a step of a comparison is off by what Taylor's formula says") {
    // One step of Euler's method: r is off by a dt^2/2 and v by da/dt dt^2/2, which is (v - 3 r (r.v)/r^2)/r^3 = v/r^3.
    const double dt = 1e-3;
    const GslComparison one = compared_with_gsl(stars_deck, {"stage.orbits.integrator=euler", "stage.orbits.steps=1",
                                                             "stage.orbits.time_step=" + std::to_string(dt)});
    REQUIRE(one.rows.size() == 2);
    CHECK(one.rows[0].position_error == 0.0);
    CHECK(one.rows[0].energy_error == 0.0);
    CHECK(one.rows[1].position_error == Approx(0.5 * 0.5 * dt * dt).epsilon(1e-3));  // a = 1/2
    CHECK(one.rows[1].velocity_error == Approx(0.3 * 0.5 * dt * dt).epsilon(1e-3));
    CHECK(one.largest_position_error == one.rows[1].position_error);
}

TEST_CASE("a comparison has up to a thousand rows behind its first, and ends with the run") {
    for (const int steps : {0, 1, 999, 1000, 1001, 2503}) {
        INFO(steps);
        const GslComparison comparison = compared_with_gsl(
            stars_deck, {"stage.orbits.steps=" + std::to_string(steps), "stage.orbits.time_step=0.001"});
        const auto& rows = comparison.rows;
        CHECK(rows.size() <= 1002);
        CHECK(rows.size() >= static_cast<std::size_t>(std::min(steps, 500)) + 1);
        CHECK(rows.front().step == 0);
        CHECK(rows.front().time == 0.0);
        CHECK(rows.back().step == steps);
        CHECK(rows.back().time == steps * 0.001);
        for (std::size_t k = 1; k < rows.size(); ++k) {
            CHECK(rows[k].step > rows[k - 1].step);
            CHECK(rows[k].energy_error <= comparison.largest_energy_error);
            CHECK(rows[k].position_error <= comparison.largest_position_error);
            CHECK(rows[k].angular_momentum_error <= comparison.largest_angular_momentum_error);
        }
    }
}

TEST_CASE("a comparison goes through all stages, each with its own step and integrator") {
    const GslComparison comparison =
        compared_with_gsl(stars_deck + second_stage, {"stage.more.integrator=forest-ruth"});
    CHECK(comparison.rows.size() == 95 + 13 + 1);
    CHECK(comparison.rows.back().time == Approx(0.95 + 0.26).epsilon(1e-14));
    CHECK(comparison.largest_position_error < 1e-3);
}

TEST_CASE("the largest energy error is over all steps, also those without a row") {
    const std::vector<std::string> steps{"stage.orbits.steps=4000", "stage.orbits.time_step=0.00075"};
    const GslComparison comparison = compared_with_gsl(stars_deck, steps);
    double in_rows = 0.0;
    for (const auto& row : comparison.rows) {
        in_rows = std::max(in_rows, row.energy_error);
    }
    CHECK(comparison.largest_energy_error > in_rows);
    CHECK(comparison.largest_energy_error < 1.01 * in_rows);
}

TEST_CASE("fluids and motions that turn round are not compared with gsl") {
    Recorder listener;
    const DeckFolder fluid;
    CHECK_THROWS_AS(compare_with_gsl(fluid.load(), listener), InputError);
    CHECK_THROWS_WITH(compare_with_gsl(fluid.load(), listener), Contains("deck of a fluid"));
    const DeckFolder turned(stars_deck + second_stage + "reverse = true\n");
    CHECK_THROWS_AS(compare_with_gsl(turned.load(), listener), InputError);
    CHECK_THROWS_WITH(compare_with_gsl(turned.load(), listener), Contains("stage 'more' runs backwards"));
    CHECK(listener.steps.empty());
}

TEST_CASE("a comparison fails when its reference loses its energy") {
    GslComparison comparison;
    comparison.reference_energy_error = 0.9e-9;
    CHECK(comparison.passed());
    comparison.reference_energy_error = 1.1e-9;
    CHECK_FALSE(comparison.passed());
    comparison.reference_energy_error = std::nan("");
    CHECK_FALSE(comparison.passed());
}

TEST_CASE("the table of a comparison shows at most about twenty rows, the last among them") {
    const Deck deck = DeckFolder(stars_deck).load();
    Recorder listener;
    const GslComparison comparison = compare_with_gsl(deck, listener);
    const std::string table = comparison_table(comparison, deck);
    CHECK_THAT(table, Catch::StartsWith("Two stars\nagainst GSL's adaptive Runge-Kutta method of order 8") &&
                          Contains("\n           0     0.000e+00") && Contains("\n        0.95 ") &&
                          Contains("\n     largest") && Contains("tolerances 1e-13 and 1e-12"));
    CHECK(std::count(table.begin(), table.end(), '\n') < 30);
}

TEST_CASE("a comparison is written as CSV and JSON, into a folder that is made for it") {
    const DeckFolder folder(stars_deck);
    Deck deck = folder.load();
    deck.path = "d\xff.toml";  // no UTF-8, which JSON must be
    Recorder listener;
    const GslComparison comparison = compare_with_gsl(deck, listener);
    const auto directory = folder / "some" / "where";
    write_comparison(comparison, deck, directory);
    const std::string csv = content_of(directory / "compare-gsl.csv");
    CHECK(header(csv) == "step,time,position_error,velocity_error,energy_error,angular_momentum_error,reference_error");
    CHECK(rows(csv).size() == comparison.rows.size());
    CHECK(column(csv, "position_error").back() == comparison.rows.back().position_error);
    CHECK(column(csv, "reference_error").back() == comparison.rows.back().reference_error);
    const std::string text = content_of(directory / "compare-gsl.json");
    CHECK(text == comparison_json(comparison, deck) + "\n");
    const Data json = parse_json(text);
    CHECK(json.at("with") == "gsl");
    CHECK(json.at("passed") == true);
    CHECK(json.at("checks")[0].at("passed") == true);
    CHECK(json.at("checks")[0].at("tolerance") == 1e-9);
    CHECK(json.at("largest_position_error") == comparison.largest_position_error);
    CHECK(json.at("rows").size() == comparison.rows.size());
    CHECK(json.at("rows").items().back().at("energy_error") == comparison.rows.back().energy_error);
    CHECK(json.at("rows").items().back().at("step") == 95);
    std::ofstream(folder / "file") << "mine";
    CHECK_THROWS_AS(write_comparison(comparison, deck, folder / "file"), FileError);
}
