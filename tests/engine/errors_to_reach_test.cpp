#include "engine/errors_to_reach.hpp"

#include <random>
#include "catch.hpp"

#include "core/through_archive.hpp"

using namespace ljmd;

namespace {

/// Counts how often errors are shown.
struct Shown : RunOutputs {
    void errors(const std::vector<ErrorSoFar>& found) override {
        ++times;
        last = found;
    }
    int times = 0;
    std::vector<ErrorSoFar> last;
};

/// Samples whose temperature is white noise of width 0.1.
class Noise {
  public:
    void add_to(RunAverages& averages, int samples) {
        for (int k = 0; k < samples; ++k) {
            Thermodynamics row;
            row.temperature = 1.0 + 0.1 * normal_(generator_);
            row.kinetic_energy = 1.5 * *row.temperature;
            row.potential_energy = 0.1 * normal_(generator_);
            row.total_energy = row.kinetic_energy + row.potential_energy;
            row.pressure = 0.8 * *row.temperature;
            row.pressure_tensor = Mat3::NullaryExpr([&] { return 0.1 * normal_(generator_); });
            row.density = 0.8;
            row.virial = 1.0;
            averages.add(row);
        }
    }

  private:
    std::mt19937_64 generator_{11};
    std::normal_distribution<double> normal_;
};

RunAverages canonical_averages() {
    return RunAverages(108, Ensemble::canonical);
}

}  // namespace

TEST_CASE("a stage ends when its errors are reached at a look, and not before") {
    const Stage stage{.name = "production", .steps = 100000, .sample = true, .until = {{"temperature", 0.006}}};
    RunAverages averages = canonical_averages();
    ErrorsToReach errors;
    Shown outputs;
    Noise noise;
    Index ended = 0;
    for (Index samples = 1; samples <= 1000 && ended == 0; ++samples) {
        noise.add_to(averages, 1);
        CHECK_FALSE(errors.reached(stage, averages, false, false, outputs));  // between two samples
        if (errors.reached(stage, averages, true, false, outputs)) {
            ended = samples;
        }
    }
    CHECK(is_look(ended));  // 0.1/sqrt(n) is 0.006 at 278
    CHECK(ended > 181);
    CHECK(ended < 513);
    REQUIRE(outputs.last.size() == 1);
    CHECK(outputs.last[0].reached);
    CHECK(outputs.last[0].error <= 0.006);
    CHECK(outputs.times > 64);
    CHECK_FALSE(errors.reached(stage, averages, true, true, outputs));  // it has ended
}

TEST_CASE("the last step of a stage is looked at, and what was not reached is said in the results") {
    const Stage stage{
        .name = "production", .steps = 1000, .sample = true, .until = {{"temperature", 1e-6}, {"pressure", 1.0}}};
    RunAverages averages = canonical_averages();
    Noise().add_to(averages, 300);
    ErrorsToReach errors;
    Shown outputs;
    CHECK_FALSE(errors.reached(stage, averages, true, true, outputs));
    REQUIRE(outputs.last.size() == 2);
    CHECK_FALSE(outputs.last[0].reached);
    RunResult result;
    result.stages.emplace_back();
    result.averages = averages.averages();
    const double error = result.observable("temperature").estimate->standard_error;
    errors.add_to(result, stage, averages);
    CHECK(result.observable("temperature").estimate->standard_error > error);
    REQUIRE(result.stages.back().until);
    CHECK_FALSE(result.stages.back().until->reached);
    CHECK(result.stages.back().until->errors.size() == 2);
}

TEST_CASE("whether errors were reached goes through a checkpoint") {
    const Stage stage{.name = "production", .steps = 1000, .sample = true, .until = {{"temperature", 1.0}}};
    RunAverages averages = canonical_averages();
    Noise().add_to(averages, 300);
    ErrorsToReach errors;
    Shown outputs;
    CHECK(errors.reached(stage, averages, true, true, outputs));
    ErrorsToReach restored;
    test::through_archive(errors, restored);
    CHECK_FALSE(restored.reached(stage, averages, true, true, outputs));
}
