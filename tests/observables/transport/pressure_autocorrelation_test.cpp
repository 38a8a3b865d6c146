#include "observables/transport/pressure_autocorrelation.hpp"

#include <cmath>
#include <random>
#include "catch.hpp"

#include "core/through_archive.hpp"
#include "neighbors/sample_states.hpp"

using namespace ljmd;

namespace {

const Box pressure_box(Vec3(4.0, 5.0, 6.0));

/// Two atoms with opposite velocities, of temperature 2/3.
State atoms_of_pressure() {
    State state = test::random_state(2, pressure_box, 1);
    auto v = state.write_velocities();
    v.col(0) = Vec3(0.6, 0.0, 0.8);
    v.col(1) = -v.col(0);
    return state;
}

/// The virial that makes tr mechanical_stress/3 this pressure: kinetic part 2, and shares of the diagonal that differ.
Evaluation evaluation_of(double pressure) {
    Evaluation evaluation;
    evaluation.virial.diagonal() = (3.0 * pressure * pressure_box.volume() - 2.0) * Vec3(0.5, 0.3, 0.2);
    evaluation.virial(0, 1) = 7.0;
    return evaluation;
}

/// Pressures about a mean that decay exponentially, with variance 1.
class Pressures {
  public:
    Pressures(double rate, double interval, std::uint64_t seed) : kept_(std::exp(-rate * interval)), generator_(seed) {
        last_ = normal_(generator_);
    }
    double next() {
        last_ = kept_ * last_ + std::sqrt(1.0 - kept_ * kept_) * normal_(generator_);
        return last_;
    }

  private:
    double kept_;
    std::mt19937_64 generator_;
    std::normal_distribution<double> normal_;
    double last_;
};

constexpr double pressure_rate = 2.5;
const LagTimes pressure_lags{.every = 1, .count = 20, .spacing = 0.1};

/// Stages of different energy, whose mean pressures differ by far more than they fluctuate.
PressureAutocorrelation analysis_of(int stages, int frames, std::uint64_t seed) {
    PressureAutocorrelation analysis(pressure_box, pressure_lags, 2 * pressure_lags.count);
    const State state = atoms_of_pressure();
    for (int stage = 0; stage < stages; ++stage) {
        analysis.interrupt();
        Pressures pressures(pressure_rate, pressure_lags.spacing, seed + 1000003U * static_cast<std::uint64_t>(stage));
        for (int t = 0; t < frames; ++t) {
            analysis.sample(state, evaluation_of(20.0 * stage - 5.0 + pressures.next()));
        }
    }
    return analysis;
}

}  // namespace

TEST_CASE(
    "the bulk viscosity is right, and so is its error, in stages so short that their mean pressure is uncertain") {
    constexpr int trials = 1500;
    double expected = 0.0;  // by the trapezoidal rule, as the analysis has it
    for (Index k = 0; k < pressure_lags.count; ++k) {
        expected += 0.05 * (std::exp(-pressure_rate * pressure_lags.time(k)) +
                            std::exp(-pressure_rate * pressure_lags.time(k + 1)));
    }
    expected *= pressure_box.volume() / (2.0 / 3.0);
    double sum = 0.0;
    double squares = 0.0;
    double stated = 0.0;
    int values = 0;
    for (int trial = 0; trial < trials; ++trial) {
        // Two stages of 20 times the largest time: uncorrected, the integral would be a tenth too low.
        const ObservableAverage found =
            analysis_of(2, 20 * static_cast<int>(pressure_lags.count), static_cast<std::uint64_t>(trial))
                .observables()
                .at(0);
        CHECK(found.name == "bulk_viscosity");
        if (found.estimate) {
            ++values;
            sum += found.estimate->mean;
            squares += found.estimate->mean * found.estimate->mean;
            stated += found.estimate->standard_error * found.estimate->standard_error;
        }
    }
    CHECK(values > 0.95 * trials);
    const double mean = sum / values;
    const double scatter = std::sqrt(squares / values - mean * mean);
    CHECK(std::abs(mean - expected) < 5.0 * scatter / std::sqrt(values));
    CHECK(scatter / std::sqrt(values) < 0.015 * expected);
    const double ratio = scatter / std::sqrt(stated / values);
    CHECK(ratio > 0.7);
    CHECK(ratio < 1.32);
}

TEST_CASE("a pressure that stays has no correlation, and stages that are too short do not count") {
    PressureAutocorrelation analysis(pressure_box, pressure_lags, 2 * pressure_lags.count);
    CHECK(analysis.needs_energy());
    const State state = atoms_of_pressure();
    for (int t = 0; t < 10 * pressure_lags.count - 1; ++t) {
        analysis.sample(state, evaluation_of(3.0));
    }
    CHECK(analysis.tables().empty());
    CHECK(analysis.observables().empty());
    analysis.sample(state, evaluation_of(3.0));
    const DataTable table = analysis.tables().at(0);
    CHECK(table.name == "pressure_autocorrelation");
    REQUIRE(table.rows.size() == 21);
    for (const auto& row : table.rows) {
        CHECK(std::abs(row[1]) < 1e-20);
        CHECK(std::abs(row[3]) < 1e-20);
    }
}

TEST_CASE("atoms at rest have no bulk viscosity, and it says why") {
    PressureAutocorrelation analysis(pressure_box, pressure_lags, 2 * pressure_lags.count);
    const State state = test::random_state(2, pressure_box, 1);
    for (int t = 0; t < 10 * pressure_lags.count; ++t) {
        analysis.sample(state, evaluation_of(3.0 + 0.1 * (t % 3)));
    }
    CHECK_FALSE(analysis.observables().at(0).estimate.has_value());
    CHECK_THAT(analysis.observables().at(0).remark, Catch::Contains("divided by the temperature"));
}

TEST_CASE("a pressure autocorrelation goes on from an archive bit for bit") {
    PressureAutocorrelation whole = analysis_of(2, 400, 4);
    PressureAutocorrelation restored(pressure_box, pressure_lags, 2 * pressure_lags.count);
    test::through_archive(whole, restored);
    const State state = atoms_of_pressure();
    for (int t = 0; t < 60; ++t) {
        whole.sample(state, evaluation_of(15.0 + 0.1 * (t % 7)));
        restored.sample(state, evaluation_of(15.0 + 0.1 * (t % 7)));
    }
    CHECK(restored.samples() == 860);
    CHECK(restored.tables().at(0).rows == whole.tables().at(0).rows);
}
