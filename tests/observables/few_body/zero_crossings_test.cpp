#include "observables/few_body/zero_crossings.hpp"

#include <cmath>
#include <numbers>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"

using namespace ljmd;

namespace {

constexpr double full_turn = 2.0 * std::numbers::pi;

/// x = A sin(w t + phase), sampled from 0 to `end`.
ZeroCrossings of_sine(double amplitude, double w, double phase, double dt, double end) {
    ZeroCrossings crossings;
    for (Index i = 0; static_cast<double>(i) * dt < end; ++i) {
        const double t = static_cast<double>(i) * dt;
        crossings.add(t, amplitude * std::sin(w * t + phase), amplitude * w * std::cos(w * t + phase));
    }
    return crossings;
}

}  // namespace

TEST_CASE("A sine has its crossings, period and amplitude") {
    const double w = 2.5;
    const ZeroCrossings found = of_sine(0.3, w, 1.0, 0.05 / w, 40.0);
    REQUIRE(found.crossings().size() == 32);
    for (std::size_t k = 0; k < found.crossings().size(); ++k) {
        CAPTURE(k);
        const ZeroCrossing& crossing = found.crossings()[k];
        CHECK(crossing.direction == (k % 2 == 0 ? Direction::downward : Direction::upward));
        CHECK(crossing.time == Approx((0.5 * static_cast<double>(k + 1) * full_turn - 1.0) / w).margin(1e-9));
    }
    REQUIRE(found.period());
    CHECK(found.period()->mean == Approx(full_turn / w).margin(1e-9));
    CHECK(found.period()->standard_error < 1e-9);
    CHECK(found.period()->intervals == 15);
    CHECK(found.amplitude() == Approx(0.3).epsilon(2e-8));
}

TEST_CASE("A motion that begins at zero crosses there") {
    const ZeroCrossings found = of_sine(-1.0, 1.0, 0.0, 0.05, 10.0);
    REQUIRE(found.crossings().size() == 4);
    CHECK(found.crossings()[0].direction == Direction::downward);
    CHECK(found.crossings()[0].time == 0.0);
    CHECK(found.period()->mean == Approx(full_turn).margin(1e-9));
    CHECK(found.period()->intervals == 1);
    CHECK(std::isnan(found.period()->standard_error));
}

TEST_CASE("The error of the amplitude falls with the fourth power of the step") {
    // The phase puts the only maximum in the middle of a step, for both steps.
    const auto error = [](double dt) {
        return 1.0 - of_sine(1.0, 1.0, 0.25 * full_turn - 2.5 * dt, dt, 5.5 * dt).amplitude();
    };
    CHECK(std::log2(error(0.2) / error(0.1)) == Approx(4.0).margin(0.05));
    CHECK(std::log2(error(0.1) / error(0.05)) == Approx(4.0).margin(0.05));
}

TEST_CASE("The error of a crossing falls at least with the fourth power of the step") {
    // An offset, as the fourth derivative of a sine is zero where the sine is.
    const auto error = [](double dt) {
        ZeroCrossings found;
        for (Index i = 0; i < 2; ++i) {
            const double t = 0.25 * full_turn / 3.0 + (static_cast<double>(i) - 0.5) * dt;
            found.add(t, std::sin(t) - 0.5, std::cos(t));
        }
        return std::abs(found.crossings().at(0).time - 0.25 * full_turn / 3.0);
    };
    CHECK(std::log2(error(0.2) / error(0.1)) == Approx(4.0).margin(0.05));
    CHECK(std::log2(error(0.1) / error(0.05)) == Approx(4.0).margin(0.05));
}

TEST_CASE("The amplitude is at least the largest sample, and a motion without crossings has no period") {
    ZeroCrossings found;
    CHECK(found.amplitude() == 0.0);
    CHECK_FALSE(found.period());
    found.add(0.0, -3.0, 0.0);
    found.add(1.0, -2.0, 1.0);
    CHECK(found.amplitude() == 3.0);
    CHECK(found.crossings().empty());
    CHECK_FALSE(found.period());
}

TEST_CASE("Samples of a coordinate that do not follow in time are refused") {
    ZeroCrossings found;
    found.add(1.0, 0.0, 1.0);
    CHECK_THROWS_AS(found.add(1.0, 0.1, 1.0), ContractViolation);
}

TEST_CASE("an oscillation is continued from its last sample or later") {
    ZeroCrossings crossings;
    crossings.add(1.0, 0.5, 1.0);
    Archive a;
    crossings.archive(a, 1.0);
    ZeroCrossings other;
    Archive same(a.bytes());
    CHECK_NOTHROW(other.archive(same, 1.0));
    Archive earlier(a.bytes());
    CHECK_THROWS_AS(other.archive(earlier, 0.5), CheckpointError);
}
