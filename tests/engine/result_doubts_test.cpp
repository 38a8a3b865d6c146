#include "engine/result_doubts.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include "catch.hpp"

#include "engine/engine_fixtures.hpp"

using namespace ljmd;
using namespace ljmd::test;
using Catch::Matchers::Contains;

namespace {

const StageResult there{"there", "bit-reversible", 0, 40, 0.004, true, false, false, -1.5e-7, "xxh3:a", "xxh3:b"};

}  // namespace

TEST_CASE("a drift is too large when it adds up to more than 0.3 % of the kinetic energy") {
    const auto remark = [](std::optional<double> drift) {
        StageResult stage = there;  // 40 steps
        stage.time_step = 0.2;
        stage.energy_drift = drift;
        return drift_remark(stage, 1.5);
    };
    const double limit = 0.003 * 1.5 / 8.0;
    CHECK(remark(std::nullopt).empty());
    CHECK(remark(0.99 * limit).empty());
    CHECK(remark(-0.99 * limit).empty());
    CHECK_THAT(remark(2.0 * limit), Contains("in all 0.009 epsilon per atom, 0.6 % of the kinetic energy: too much"));
    CHECK_THAT(remark(-2.0 * limit), Contains("in all -0.009") && Contains("0.6 %"));
    // In a short stage, here of 0.16 tau, more is left to chance.
    StageResult brief = there;
    brief.energy_drift = 0.99 * 0.02 * 1.5 / 0.16;
    CHECK(drift_remark(brief, 1.5).empty());
    brief.energy_drift = 1.01 * 0.02 * 1.5 / 0.16;
    CHECK_THAT(drift_remark(brief, 1.5), Contains("2 % of the kinetic energy"));
}

TEST_CASE(
    "a time step is too long when it sets temperatures of velocities and of configurations apart by more than 1 %") {
    StageResult stage = there;
    CHECK(time_step_remark(stage).empty());
    stage.time_step = 0.016;
    stage.time_step_error = 0.0099;
    CHECK(time_step_remark(stage).empty());
    stage.time_step_error = 0.016;
    const std::string remark = time_step_remark(stage);
    CHECK_THAT(remark, Contains("1.6 % apart") && Contains("a time step of 0.004 makes it 0.1 %"));
    stage.integrator = "forest-ruth";  // of fourth order: what its step does is another matter
    CHECK(time_step_remark(stage).empty());
}

TEST_CASE("the order that is left by chance in few molten atoms is no crystal") {
    CHECK(largest_molten_order(864) == 0.1);
    CHECK(largest_molten_order(108) == Approx(5.0 / std::sqrt(648.0)));
    std::mt19937_64 generator(7);
    std::uniform_real_distribution<double> anywhere(0.0, 2.0 * std::numbers::pi);
    int above = 0;
    for (int run = 0; run < 1000; ++run) {
        double sum = 0.0;
        for (int k = 0; k < 3 * 108; ++k) {
            sum += std::cos(anywhere(generator));
        }
        above += sum / (3 * 108) > largest_molten_order(108) ? 1 : 0;
    }
    CHECK(above == 0);
}

TEST_CASE("what makes results doubtful is said once, for the run as a whole") {
    RunResult result{};
    result.stages = {there};
    add_remarks(result, small_spec());
    REQUIRE(result.warnings.size() == 1);
    CHECK_THAT(result.warnings[0], Contains("no sample was taken"));

    const Estimate good{1.0, 0.01, 100.0, 1000, true};
    result.averages = {{"temperature", "T", "epsilon/k_B", good}, {"kinetic_energy", "K/N", "epsilon", good}};
    add_remarks(result, small_spec());
    CHECK(result.warnings.empty());
    CHECK(result.averages[0].remark.empty());

    result.atoms = 108;
    result.order_at_sampling = 0.5;
    result.search.rebuilds = 10;
    result.search.late_rebuilds = 3;
    result.stages[0].energy_drift = 1.0;
    result.averages[1].estimate->converged = false;
    result.averages[0].estimate->mean = 1.2;
    add_remarks(result, small_spec());
    REQUIRE(result.warnings.size() == 4);
    CHECK(result.doubts == std::vector<std::string>(result.warnings.begin(), result.warnings.begin() + 3));
    CHECK_THAT(result.warnings[0], Contains("50 % of the crystal left"));
    CHECK_THAT(result.warnings[1], Contains("3 of 10 neighbor lists were kept too long"));
    CHECK_THAT(result.warnings[2], Contains("the energy drifts in stage 'there'"));
    CHECK_THAT(result.warnings[3], Contains("error bars of kinetic_energy"));
    CHECK_THAT(result.averages[0].remark, Contains("asked 1, found 1.2"));

    result.averages.push_back({"bragg_peak", "S(k_1)/N", "1", Estimate{0.8, 0.01, 100.0, 100, true}});
    result.warnings.clear();
    add_remarks(result, small_spec());
    CHECK_THAT(result.warnings.at(0), Contains("3 of 10 neighbor lists"));  // a crystal that is measured is wanted
}
