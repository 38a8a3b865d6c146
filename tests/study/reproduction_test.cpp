#include "study/reproduction.hpp"

#include <fmt/format.h>

#include <numbers>

#include "deck/deck_fixtures.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

const VerletRow argon{0.85, 0.786, Printed{0.99, Soundness::sound, Provenance::one_reprint},
                      Printed{-6.05, Soundness::sound, Provenance::one_reprint}, ""};

/// What the run of a row leaves, made up: production begins behind step 100, and has 8 rows.
class MadeUpRun {
  public:
    MadeUpRun(double temperature, double pressure) {
        write("results.json",
              R"({"observables": {},
                  "stages": [{"sampled": false, "first_step": 0, "steps": 100},
                             {"sampled": true, "first_step": 100, "steps": 80}]})");
        std::string thermo = "step,time,temperature,potential_energy,pressure\n0,0,9,9,9\n100,1,9,9,9\n";
        for (int k = 1; k <= 8; ++k) {
            const double swing = k % 2 == 0 ? 0.01 : -0.01;
            thermo +=
                fmt::format("{},2,{},{},{}\n", 100 + 10 * k, temperature + swing, -6.0 - swing, pressure + 5.0 * swing);
        }
        write("thermo.csv", thermo);
        write("rdf.csv", "r,g\n2.45,0.5\n2.55,1.1\n2.65,0.9\n");
    }

    void write(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
    [[nodiscard]] fs::path path() const { return folder_ / ""; }

  private:
    TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("every row has a deck that is right, with 864 atoms and a name of its own") {
    std::vector<std::string> names;
    for (const VerletRow& row : verlet1967_table()) {
        for (const auto& length : {ReproductionLength::full(), ReproductionLength::quick()}) {
            const DeckFolder folder(row_deck(row, length));
            const Deck deck = folder.load();
            INFO(row_name(row));
            CHECK(find_start(deck).atoms == 864);
            CHECK(deck.system().density == row.density);
            CHECK(deck.stages().back().temperature == row.temperature);
            CHECK(deck.stages().back().steps == length.production);
            CHECK(deck.stages().back().sample);
        }
        CHECK(std::find(names.begin(), names.end(), row_name(row)) == names.end());
        names.push_back(row_name(row));
    }
}

TEST_CASE("a row is read from its run: means of the production stage, at Verlet's temperature") {
    const EquationOfState thol = equation_of_state("thol2016");
    const double measured = 0.8;
    const MadeUpRun run(measured, 0.7);
    const ReproducedRow row = evaluate_row(argon, run.path());
    CHECK(row.steps == 80);
    CHECK(row.temperature.mean == Approx(measured));
    CHECK(row.temperature.samples == 8);
    const FluidProperties there = properties(thol, measured, argon.density);
    const FluidProperties nominal = properties(thol, argon.temperature, argon.density);
    CHECK(row.thol.z == nominal.compressibility_factor);
    CHECK(row.thol.u == nominal.potential_energy);
    CHECK(row.z.mean ==
          Approx(0.7 / (argon.density * measured) + nominal.compressibility_factor - there.compressibility_factor));
    CHECK(row.u.mean == Approx(-6.0 + nominal.potential_energy - there.potential_energy));
    CHECK(row.z_scores().z == Approx((row.z.mean + row.beyond_cutoff.z - row.thol.z) / row.z.standard_error));
}

TEST_CASE("at Verlet's own temperature nothing is corrected") {
    const MadeUpRun run(argon.temperature, 0.6);
    const ReproducedRow row = evaluate_row(argon, run.path());
    CHECK(row.z.mean == Approx(0.6 / (argon.density * argon.temperature)).epsilon(1e-9));
    CHECK(row.u.mean == Approx(-6.0).epsilon(1e-9));
}

TEST_CASE("the error takes into account that temperature, energy and pressure swing together") {
    // p swings with T: what a change of temperature explains is no error of Z at a given temperature.
    const MadeUpRun run(argon.temperature, 0.6);
    const ReproducedRow row = evaluate_row(argon, run.path());
    const double rho = argon.density;
    const double t = argon.temperature;
    const EquationOfState thol = equation_of_state("thol2016");
    const double h = 1e-5;
    const double slope =
        (properties(thol, t + h, rho).compressibility_factor - properties(thol, t - h, rho).compressibility_factor) /
        (2.0 * h);
    const double per_swing = 5.0 / (rho * t) - 0.6 / (rho * t * t) - slope;
    CHECK(row.z.standard_error == Approx(std::abs(per_swing) * row.temperature.standard_error).epsilon(1e-6));
}

TEST_CASE("a run that is not there, or whose results are damaged, is refused") {
    const TemporaryFolder nothing;
    CHECK_THROWS_AS(evaluate_row(argon, nothing / ""), DataError);
    const MadeUpRun run(0.8, 0.7);
    run.write("results.json", "{}");
    CHECK_THROWS_WITH(evaluate_row(argon, run.path()), Contains("is not the result of a run"));
    run.write("results.json", R"({"observables": {}, "stages": []})");
    CHECK_THROWS_WITH(evaluate_row(argon, run.path()), Contains("tells of no stage that was sampled"));
}

TEST_CASE("what a cutoff misses is the integral of g - 1") {
    const double rho = 0.8;
    const double t = 1.2;
    const double cutoff = 2.5;
    std::vector<double> r;
    std::vector<double> g;
    const double width = 0.001;
    for (double x = 0.5 * width; x < 4.0; x += width) {
        r.push_back(x);
        g.push_back(x < 3.0 ? 1.5 : 1.0);
    }
    const auto [z, u] = cutoff_bias(r, g, rho, t, cutoff);
    // Half of the integrals from 2.5 to 3 in closed form.
    const auto energy = [](double x) { return 4.0 * (std::pow(x, -3) / 3.0 - std::pow(x, -9) / 9.0); };
    const auto virial = [](double x) { return 24.0 * (std::pow(x, -3) / 3.0 - 2.0 * std::pow(x, -9) / 9.0); };
    CHECK(u == Approx(2.0 * std::numbers::pi * rho * 0.5 * (energy(3.0) - energy(2.5))).epsilon(1e-5));
    CHECK(z == Approx(2.0 * std::numbers::pi * rho / (3.0 * t) * 0.5 * (virial(3.0) - virial(2.5))).epsilon(1e-5));
    CHECK(cutoff_bias(r, std::vector<double>(r.size(), 1.0), rho, t, cutoff).u == 0.0);
}

TEST_CASE("rows are made longer until their errors are small, but not for ever") {
    ReproducedRow row{argon, 10'000, {}, {}, {}, {}, {}, {}};
    const ReproductionLength length = ReproductionLength::full();
    row.z = {0.9, 0.01, 100, 1000, true};
    row.u = {-6.0, 0.003, 100, 1000, true};
    CHECK(row.precise(length));
    row.z.standard_error = 0.03;
    CHECK_FALSE(row.precise(length));
    row.z = {0.9, 0.01, 100, 1000, false};
    CHECK_FALSE(row.precise(length));
    row.z.converged = true;
    row.u.standard_error = 0.005;
    CHECK_FALSE(row.precise(length));
    row.u.standard_error = std::nan("");
    CHECK_FALSE(row.precise(length));
    row.steps = length.production * length.max_parts;
    CHECK(row.precise(length));
    row.steps = ReproductionLength::quick().production;
    CHECK(row.precise(ReproductionLength::quick()));
}

TEST_CASE("chi-square is over numbers that are sound") {
    ReproducedRow row{argon, 100, {}, {1.0, 0.1, 10, 10, true}, {-6.0, 0.1, 10, 10, true}, {0.0, 0.0}, {0.8, -6.3}, {}};
    ReproducedRow doubtful = row;
    doubtful.verlet.compressibility_factor->soundness = Soundness::suspect;
    doubtful.verlet.potential_energy.reset();
    const ChiSquare sum = chi_square({row, doubtful, row});
    CHECK(sum.z == Approx(8.0));
    CHECK(sum.z_count == 2);
    CHECK(sum.u == Approx(18.0));
    CHECK(sum.u_count == 2);
}

TEST_CASE("a row whose files hold something else than its run has written is refused") {
    const auto refused = [](const std::string& name, const std::string& text, const std::string& why) {
        const MadeUpRun run(0.8, 0.7);
        run.write(name, text);
        CHECK_THROWS_WITH(evaluate_row(argon, run.path()), Contains(name) && Contains(why));
    };
    const std::string header = "step,temperature,potential_energy,pressure\n";
    refused("rdf.csv", "r,g\n2.5,1\n", "has 1 rows");
    refused("thermo.csv", header + "100,1,1,1\n", "has no row behind step 100");
    refused("thermo.csv", header + "110,1,,1\n", "'potential_energy' is empty");
    refused("thermo.csv", header + ",1,1,1\n", "'step' is empty");
    refused("results.json", R"({"observables": {}, "stages": [{"sampled": true, "first_step": [[]], "steps": 1}]})",
            "'first_step' is [[]]");
}
