#include "observables/transport/correlation_windows.hpp"

#include <random>
#include <vector>
#include "catch.hpp"

#include "core/through_archive.hpp"
#include "execution/test_execution.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;

namespace {

std::vector<Eigen::VectorXd> random_frames(Index count, Index series, unsigned seed) {
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> normal(0.3, 1.0);
    std::vector<Eigen::VectorXd> frames;
    for (Index t = 0; t < count; ++t) {
        frames.push_back(Eigen::VectorXd::NullaryExpr(series, [&] { return normal(generator); }));
    }
    return frames;
}

/// The sum that defines it, over frames first ... first + window - 1.
Eigen::VectorXd by_definition(const std::vector<Eigen::VectorXd>& frames, Index first, Index window, Index lags) {
    Eigen::VectorXd correlation = Eigen::VectorXd::Zero(lags + 1);
    for (Index k = 0; k <= lags; ++k) {
        for (Index t = 0; t < window - k; ++t) {
            const auto at = static_cast<std::size_t>(first + t);
            correlation[k] += frames[at].dot(frames[at + static_cast<std::size_t>(k)]);
        }
        correlation[k] /= static_cast<double>(window - k);
    }
    return correlation;
}

Eigen::VectorXd first_window(CorrelationWindows& windows, const std::vector<Eigen::VectorXd>& frames,
                             const Execution& execution = test::test_execution()) {
    for (const Eigen::VectorXd& frame : frames) {
        if (const auto found = windows.add(frame, execution)) {
            return *found;
        }
    }
    return {};
}

}  // namespace

TEST_CASE("correlations of a window are the sums that define them, at all lags, for any number of series") {
    const Index series = GENERATE(1, 16, 17, 300);
    const auto [window, lags] = GENERATE(table<Index, Index>({{2, 1}, {7, 3}, {12, 11}, {33, 16}}));
    CAPTURE(series, window, lags);
    const auto frames = random_frames(2 * window, series, 7);
    CorrelationWindows windows(series, lags, window);
    const Execution execution = test::test_execution();
    Index found = 0;
    for (Index t = 0; t < 2 * window; ++t) {
        const auto correlation = windows.add(frames[static_cast<std::size_t>(t)], execution);
        REQUIRE(correlation.has_value() == ((t + 1) % window == 0));
        if (correlation) {
            const Eigen::VectorXd expected = by_definition(frames, t + 1 - window, window, lags);
            REQUIRE(correlation->size() == lags + 1);
            CHECK((*correlation - expected).cwiseAbs().maxCoeff() < 1e-14 * expected[0] * static_cast<double>(window));
            ++found;
        }
    }
    CHECK(found == 2);
}

TEST_CASE("a window that was interrupted does not count") {
    const auto frames = random_frames(20, 4, 8);
    CorrelationWindows interrupted(4, 3, 8);
    for (std::size_t t = 0; t < 5; ++t) {
        CHECK_FALSE(interrupted.add(frames[t], {}).has_value());
    }
    interrupted.interrupt();
    const std::vector<Eigen::VectorXd> rest(frames.begin() + 5, frames.end());
    CHECK(first_window(interrupted, rest) == [&] {
        CorrelationWindows fresh(4, 3, 8);
        return first_window(fresh, rest);
    }());
}

TEST_CASE("threads change no bit of a correlation") {
    const auto frames = random_frames(24, 1000, 9);
    std::vector<Eigen::VectorXd> found;
    for (const int threads : {1, 2, 3}) {
        CorrelationWindows windows(1000, 12, 24);
        found.push_back(first_window(windows, frames, test::with_threads(threads)));
    }
    CHECK(found[1] == found[0]);
    CHECK(found[2] == found[0]);
}

TEST_CASE("a window goes on from an archive, and refuses that of another") {
    const auto frames = random_frames(8, 4, 10);
    CorrelationWindows windows(4, 3, 8);
    for (std::size_t t = 0; t < 5; ++t) {
        static_cast<void>(windows.add(frames[t], {}));
    }
    CorrelationWindows restored(4, 3, 8);
    test::through_archive(windows, restored);
    for (const Index series : {3, 6}) {
        CorrelationWindows other(series, 3, 8);
        CHECK_THROWS_AS(test::through_archive(windows, other), CheckpointError);
    }
    CorrelationWindows shorter(4, 3, 5);
    CHECK_THROWS_AS(test::through_archive(windows, shorter), CheckpointError);
    const std::vector<Eigen::VectorXd> rest(frames.begin() + 5, frames.end());
    CHECK(first_window(restored, rest) == first_window(windows, rest));
}

TEST_CASE("windows that make no sense are refused") {
    CHECK_THROWS_AS(CorrelationWindows(0, 3, 8), ContractViolation);
    CHECK_THROWS_AS(CorrelationWindows(4, 0, 8), ContractViolation);
    CHECK_THROWS_AS(CorrelationWindows(4, 8, 8), ContractViolation);
    CorrelationWindows windows(4, 3, 8);
    CHECK_THROWS_AS(windows.add(Eigen::VectorXd::Zero(5), {}), ContractViolation);
}

TEST_CASE("the running integral is exact for straight lines") {
    const Eigen::VectorXd line = Eigen::VectorXd::LinSpaced(6, 1.0, 2.0);  // 1 + 0.4 t at t = 0, 0.5, ... 2.5
    const Eigen::VectorXd integral = running_integral(line, 0.5);
    for (Index k = 0; k < 6; ++k) {
        const double t = 0.5 * static_cast<double>(k);
        CHECK(integral[k] == Approx(t + 0.2 * t * t));
    }
    CHECK(running_integral(Eigen::VectorXd::Ones(1), 0.5)[0] == 0.0);
}
