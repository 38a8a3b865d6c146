#include "ljmd/observables/statistics/blocking.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>
#include "catch.hpp"

#include "ljmd/core/errors.hpp"

using ljmd::Archive;
using ljmd::BlockingAccumulator;
using ljmd::BlockLevel;
using ljmd::CheckpointError;
using ljmd::Covariance;
using ljmd::Estimate;
using ljmd::Index;

namespace {

/// `runs` independent stationary series x(t+1) = phi x(t) + sqrt(1 - phi^2) noise of unit variance, side by side.
/// The mean over n samples has the variance (1 + phi) / (1 - phi) / n when n is large.
class AutoregressiveRuns {
  public:
    AutoregressiveRuns(Index runs, double phi, std::uint64_t seed)
        : phi_(phi), generator_(seed), value_(Eigen::VectorXd::NullaryExpr(runs, [this] { return noise(); })) {}

    const Eigen::VectorXd& next() {
        const double strength = std::sqrt(1.0 - phi_ * phi_);
        for (double& x : value_) {
            x = phi_ * x + strength * noise();
        }
        return value_;
    }

  private:
    double noise() { return normal_(generator_); }

    double phi_;
    std::mt19937_64 generator_;
    std::normal_distribution<double> normal_;
    Eigen::VectorXd value_;
};

/// What the reported errors of many equal runs say together.
struct Calibration {
    double scatter;         ///< standard deviation of the means over the runs
    double reported_error;  ///< root mean square
    double independent;     ///< average of independent_samples
    double converged;       ///< share of runs
};

Calibration calibrate(Index runs, Index samples, double phi, double offset, std::uint64_t seed) {
    AutoregressiveRuns series(runs, phi, seed);
    BlockingAccumulator blocks(runs, Covariance::diagonal);
    for (Index i = 0; i < samples; ++i) {
        blocks.add(series.next().array() + offset);
    }
    Calibration result{0.0, 0.0, 0.0, 0.0};
    const double share = 1.0 / static_cast<double>(runs);
    for (Index run = 0; run < runs; ++run) {
        const Estimate estimate = blocks.estimate(run);
        const double deviation = estimate.mean - offset;  // the exact mean is known
        result.scatter += share * deviation * deviation;
        result.reported_error += share * estimate.standard_error * estimate.standard_error;
        result.independent += share * estimate.independent_samples;
        result.converged += estimate.converged ? share : 0.0;
    }
    result.scatter = std::sqrt(result.scatter);
    result.reported_error = std::sqrt(result.reported_error);
    return result;
}

Eigen::VectorXd one(double x) {
    return Eigen::VectorXd::Constant(1, x);
}

BlockingAccumulator of_series(const std::vector<double>& series) {
    BlockingAccumulator blocks(1, Covariance::diagonal);
    for (const double x : series) {
        blocks.add(one(x));
    }
    return blocks;
}

/// Error of the mean from the complete blocks of one length, straight from the definition.
double error_from_blocks(const std::vector<double>& series, Index length) {
    const Index blocks = static_cast<Index>(series.size()) / length;
    Eigen::VectorXd means(blocks);
    for (Index b = 0; b < blocks; ++b) {
        means(b) = Eigen::Map<const Eigen::VectorXd>(series.data() + b * length, length).mean();
    }
    const double variance = (means.array() - means.mean()).square().sum() / static_cast<double>(blocks - 1);
    return std::sqrt(variance * static_cast<double>(length) / static_cast<double>(series.size()));
}

}  // namespace

TEST_CASE("White noise has the error sigma / sqrt(n)") {
    const Index samples = 5000;
    const Calibration seen = calibrate(400, samples, 0.0, 0.0, 1);
    const double exact = 1.0 / std::sqrt(static_cast<double>(samples));
    CHECK(seen.reported_error == Approx(exact).epsilon(0.03));
    CHECK(seen.scatter / seen.reported_error == Approx(1.0).margin(0.12));  // 400 runs: known to 3.5 %
    CHECK(seen.independent > 0.85 * static_cast<double>(samples));
    CHECK(seen.converged == Approx(1.0));
}

TEST_CASE("The error of correlated series is right and independent of an offset") {
    struct Case {
        double phi;
        Index samples;
        double offset;
    };
    const auto c = GENERATE(Case{0.9, 10000, 0.0}, Case{0.9, 10000, 1e8}, Case{0.99, 100000, 0.0});
    CAPTURE(c.phi, c.samples, c.offset);
    const Calibration seen = calibrate(200, c.samples, c.phi, c.offset, 2);
    const double correlation = (1.0 + c.phi) / (1.0 - c.phi);
    const double n = static_cast<double>(c.samples);
    CHECK(seen.reported_error == Approx(std::sqrt(correlation / n)).epsilon(0.1));
    CHECK(seen.scatter / seen.reported_error > 0.8);
    CHECK(seen.scatter / seen.reported_error < 1.2);
    CHECK(seen.independent == Approx(n / correlation).epsilon(0.25));
    CHECK(seen.converged > 0.97);
}

TEST_CASE("Slow fluctuations below the noise of fast ones are in the error") {
    // White noise of variance 1 and a series of variance a^2 with a correlation time of 100 samples, which has six
    // tenths of the variance of the mean. Blocks that are long enough for what one sees at first are shorter than that.
    constexpr Index runs = 200;
    constexpr Index samples = 32'768;
    const double phi = std::exp(-1.0 / 100.0);
    const double slow_inefficiency = (1.0 + phi) / (1.0 - phi);
    const double a = std::sqrt(0.6 / (1.0 - 0.6) / slow_inefficiency);
    AutoregressiveRuns white(runs, 0.0, 21);
    AutoregressiveRuns slow(runs, phi, 22);
    BlockingAccumulator blocks(runs, Covariance::diagonal);
    for (Index i = 0; i < samples; ++i) {
        blocks.add(white.next() + a * slow.next());
    }
    double reported = 0.0;
    double converged = 0.0;
    for (Index run = 0; run < runs; ++run) {
        const Estimate estimate = blocks.estimate(run);
        reported += estimate.standard_error * estimate.standard_error / runs;
        converged += estimate.converged ? 1.0 / runs : 0.0;
    }
    const double exact = std::sqrt((1.0 + a * a * slow_inefficiency) / samples);
    CHECK(std::sqrt(reported) == Approx(exact).epsilon(0.08));  // 0.7 of it without a look at longer blocks
    CHECK(converged > 0.97);
}

TEST_CASE("An oscillation that cancels in blocks longer than its period is not in the error") {
    // White noise beside the changes of a damped oscillation of 64 samples and of more white noise, whose sum over a
    // run is its end minus its start: the mean has the error of the first. In blocks of half a period it looks 1.5
    // times larger, and grows up to them less than what is shorter hides.
    constexpr Index runs = 100;
    constexpr Index samples = 15'000;
    const double decay = std::exp(-1.0 / 100.0);
    const double turn = 2.0 * 3.14159265358979 / 64.0;
    AutoregressiveRuns white(runs, 0.0, 31);
    AutoregressiveRuns along(runs, 0.0, 32);
    AutoregressiveRuns across(runs, 0.0, 33);
    AutoregressiveRuns fast(runs, 0.0, 34);
    const double strength = std::sqrt(1.0 - decay * decay);
    Eigen::ArrayXd last = fast.next().array();
    Eigen::ArrayXd x = along.next().array();
    Eigen::ArrayXd y = across.next().array();
    BlockingAccumulator blocks(runs, Covariance::diagonal);
    for (Index i = 0; i < samples; ++i) {
        const Eigen::ArrayXd before = x;
        x = decay * (std::cos(turn) * before - std::sin(turn) * y) + strength * along.next().array();
        y = decay * (std::sin(turn) * before + std::cos(turn) * y) + strength * across.next().array();
        const Eigen::ArrayXd change = fast.next().array() - last;
        last += change;
        blocks.add(white.next() + Eigen::VectorXd(3.5 * (x - before) + change));
    }
    double reported = 0.0;
    double in_short_blocks = 0.0;
    for (Index run = 0; run < runs; ++run) {
        const Estimate estimate = blocks.estimate(run);
        reported += estimate.standard_error * estimate.standard_error / runs;
        in_short_blocks += std::pow(blocks.levels(run)[5].standard_error, 2) / runs;
        CHECK(estimate.converged);
    }
    const double exact = 1.0 / std::sqrt(static_cast<double>(samples));
    REQUIRE(std::sqrt(in_short_blocks) > 1.4 * exact);
    CHECK(std::sqrt(reported) == Approx(exact).epsilon(0.1));
}

TEST_CASE("A series too short for its correlations is reported as not converged, with its largest error") {
    const Index samples = 1000;  // ten correlation times of phi = 0.99
    const Calibration seen = calibrate(200, samples, 0.99, 0.0, 3);
    CHECK(seen.converged < 0.1);
    CHECK(seen.scatter / seen.reported_error < 2.0);  // the error of white noise would be 14 times too small

    AutoregressiveRuns series(1, 0.99, 4);
    BlockingAccumulator blocks(1, Covariance::diagonal);
    for (Index i = 0; i < samples; ++i) {
        blocks.add(series.next());
    }
    double largest = 0.0;
    for (const BlockLevel& level : blocks.levels(0)) {
        largest = level.blocks >= 4 ? std::max(largest, level.standard_error) : largest;
    }
    CHECK(blocks.estimate(0).standard_error == largest);
}

TEST_CASE("An error is said to be a guess where it is one, and nowhere else") {
    // Series with known errors: of a correlation phi there are n (1 - phi)/(1 + phi) independent samples.
    struct Case {
        double phi;
        Index samples;
        double min_converged;
        double max_converged;
    };
    const auto c = GENERATE(Case{0.0, 64, 0.9, 1.0}, Case{0.0, 124, 0.97, 1.0},     // all independent
                            Case{0.5, 100, 0.9, 1.0}, Case{0.9, 1000, 0.93, 1.0},   // 33, 53
                            Case{0.9, 100, 0.0, 0.15}, Case{0.99, 1000, 0.0, 0.1},  // 5
                            Case{0.0, 12, 0.0, 0.0});
    CAPTURE(c.phi, c.samples);
    const Calibration seen = calibrate(400, c.samples, c.phi, 0.0, 9);
    CHECK(seen.converged >= c.min_converged);
    CHECK(seen.converged <= c.max_converged);
    if (c.min_converged > 0.0) {
        CHECK(seen.scatter / seen.reported_error > 0.7);
        CHECK(seen.scatter / seen.reported_error < 1.32);
    }
}

TEST_CASE("Means and blocking curve agree with blocks formed from the stored series, whatever its length") {
    std::mt19937_64 generator(5);
    std::normal_distribution<double> normal(3.0, 1.0);
    std::vector<double> series;
    BlockingAccumulator blocks(1, Covariance::diagonal);
    for (Index n = 1; n <= 70; ++n) {
        series.push_back(normal(generator));
        blocks.add(one(series.back()));
        CAPTURE(n);
        const double direct = Eigen::Map<const Eigen::VectorXd>(series.data(), n).mean();
        REQUIRE(blocks.samples() == n);
        REQUIRE(blocks.mean()(0) == Approx(direct).epsilon(1e-14));

        const std::vector<BlockLevel> levels = blocks.levels(0);
        Index length = 1;
        for (const BlockLevel& level : levels) {
            REQUIRE(level.length == length);
            REQUIRE(level.blocks == n / length);
            REQUIRE(level.standard_error == Approx(error_from_blocks(series, length)).epsilon(1e-12));
            const double freedom = static_cast<double>(level.blocks - 1);
            REQUIRE(level.relative_uncertainty == Approx(1.0 / std::sqrt(2.0 * freedom)));
            length *= 2;
        }
        REQUIRE(n / length < 2);  // no level is missing
    }
}

TEST_CASE("The mean of a long series agrees with the direct sum to 1e-13, beside a large offset too") {
    std::mt19937_64 generator(6);
    std::normal_distribution<double> normal;
    for (const double offset : {1.0, 1e8}) {
        BlockingAccumulator blocks(1, Covariance::diagonal);
        long double sum = 0.0L;
        const Index samples = 300001;
        for (Index i = 0; i < samples; ++i) {
            const double x = offset + normal(generator);
            sum += static_cast<long double>(x);
            blocks.add(one(x));
        }
        const Estimate estimate = blocks.estimate(0);
        const double n = static_cast<double>(samples);
        CHECK(estimate.mean == Approx(static_cast<double>(sum / static_cast<long double>(samples))).epsilon(1e-15));
        CHECK(estimate.standard_error == Approx(1.0 / std::sqrt(n)).epsilon(0.1));
        CHECK(blocks.levels(0).front().standard_error == Approx(1.0 / std::sqrt(n)).epsilon(0.005));
    }
}

TEST_CASE("The error of a function of the means follows from the delta method") {
    // Two correlated series, p = 2 + x + y and T = 1 + x / 2, with x and y autoregressive: Z = p / T has the gradient
    // (1, -2) at the means, so its error is that of (x + y) - 2 (x / 2) = y.
    const Index runs = 200;
    const Index samples = 8000;
    double scatter = 0.0;
    double reported = 0.0;
    for (Index run = 0; run < runs; ++run) {
        AutoregressiveRuns series(2, 0.8, static_cast<std::uint64_t>(100 + run));
        BlockingAccumulator blocks(2, Covariance::full);
        BlockingAccumulator direct(1, Covariance::diagonal);
        for (Index i = 0; i < samples; ++i) {
            const Eigen::VectorXd& xy = series.next();
            const Eigen::Vector2d sample(2.0 + xy(0) + xy(1), 1.0 + 0.5 * xy(0));
            blocks.add(sample);
            direct.add(one(xy(1)));
        }
        const Eigen::VectorXd exact_gradient = Eigen::Vector2d(1.0, -2.0);
        const Estimate y = direct.estimate(0);
        // Blocks as long as p and T need may have a larger error than those that y needs.
        REQUIRE(blocks.estimate(2.0, exact_gradient).standard_error > y.standard_error * (1.0 - 1e-9));

        const Eigen::VectorXd m = blocks.mean();
        const double ratio = m(0) / m(1);
        const Eigen::VectorXd gradient = Eigen::Vector2d(1.0 / m(1), -m(0) / (m(1) * m(1)));
        const Estimate z = blocks.estimate(ratio, gradient);
        REQUIRE(z.mean == ratio);
        scatter += (ratio - 2.0) * (ratio - 2.0) / static_cast<double>(runs);
        reported += z.standard_error * z.standard_error / static_cast<double>(runs);
    }
    const double exact = std::sqrt(1.8 / 0.2 / static_cast<double>(samples));
    CHECK(std::sqrt(reported) == Approx(exact).epsilon(0.1));
    CHECK(std::sqrt(scatter / reported) > 0.8);
    CHECK(std::sqrt(scatter / reported) < 1.2);
}

TEST_CASE("The error of a function is the largest of blocks up to the longest that a part needs") {
    // The second component is white, but for a share of the first one, which is slow.
    const Index samples = 2048;
    int longer = 0;
    for (std::uint64_t run = 0; run < 40; ++run) {
        AutoregressiveRuns slow(1, 0.96, 1000 + run);
        AutoregressiveRuns white(1, 0.0, 2000 + run);
        BlockingAccumulator blocks(2, Covariance::full);
        for (Index i = 0; i < samples; ++i) {
            const double x = slow.next()(0);
            blocks.add(Eigen::Vector2d(x, white.next()(0) + 0.2 * x));
        }
        const Estimate part = blocks.estimate(0);
        const Estimate alone = blocks.estimate(1);
        const Estimate whole = blocks.estimate(alone.mean, Eigen::Vector2d(0.0, 1.0), {0});
        double largest = alone.standard_error;
        for (const BlockLevel& level : blocks.levels(1)) {
            if (level.blocks <= alone.blocks && level.blocks >= part.blocks) {
                largest = std::max(largest, level.standard_error);
            }
        }
        CHECK(whole.standard_error == Approx(largest).epsilon(1e-12));
        CHECK(whole.mean == alone.mean);
        longer += whole.standard_error > 1.05 * alone.standard_error ? 1 : 0;
        // A part that contributes next to nothing changes nothing.
        const Estimate with_traces = blocks.estimate(alone.mean, Eigen::Vector2d(1e-6, 1.0));
        CHECK(with_traces.standard_error == Approx(alone.standard_error).epsilon(1e-3));
    }
    CHECK(longer >= 10);
}

TEST_CASE("The error of a function is a guess where that of a part is one") {
    AutoregressiveRuns slow(1, 0.999, 3);
    AutoregressiveRuns white(1, 0.0, 4);
    BlockingAccumulator blocks(2, Covariance::full);
    for (Index i = 0; i < 2048; ++i) {
        blocks.add(Eigen::Vector2d(slow.next()(0), white.next()(0)));
    }
    REQUIRE_FALSE(blocks.estimate(0).converged);
    CHECK(blocks.estimate(1).converged);
    CHECK(blocks.estimate(0.0, Eigen::Vector2d(0.0, 1.0)).converged);
    CHECK_FALSE(blocks.estimate(0.0, Eigen::Vector2d(0.0, 1.0), {0}).converged);
    CHECK_FALSE(blocks.estimate(0.0, Eigen::Vector2d(0.01, 1.0)).converged);
    CHECK_THROWS_AS(blocks.estimate(0.0, Eigen::Vector2d(0.0, 1.0), {2}), ljmd::InputError);
}

TEST_CASE("Full and diagonal covariance give the same error of a component") {
    AutoregressiveRuns series(3, 0.5, 7);
    BlockingAccumulator full(3, Covariance::full);
    BlockingAccumulator diagonal(3, Covariance::diagonal);
    for (Index i = 0; i < 1000; ++i) {
        const Eigen::VectorXd& sample = series.next();
        full.add(sample);
        diagonal.add(sample);
    }
    for (Index component = 0; component < 3; ++component) {
        const Estimate estimate = full.estimate(component);
        CHECK(estimate.standard_error == Approx(diagonal.estimate(component).standard_error).epsilon(1e-13));
        const Eigen::VectorXd unit = Eigen::VectorXd::Unit(3, component);
        CHECK(full.estimate(estimate.mean, unit).standard_error == Approx(estimate.standard_error).epsilon(1e-13));
    }
}

TEST_CASE("Too few samples have no error, and no samples have no mean") {
    CHECK(std::isnan(of_series({}).estimate(0).mean));
    for (const auto& series : {std::vector<double>{}, {1.0}, {1.0, 2.0}, {1.0, 2.0, 3.0}}) {
        const Estimate estimate = of_series(series).estimate(0);
        CAPTURE(series.size());
        CHECK(std::isnan(estimate.standard_error));
        CHECK(std::isnan(estimate.independent_samples));
        CHECK_FALSE(estimate.converged);
        CHECK(estimate.samples == static_cast<Index>(series.size()));
    }
    CHECK(of_series({1.0, 2.0}).estimate(0).mean == 1.5);
    const Estimate four = of_series({1.0, 2.0, 3.0, 4.0}).estimate(0);
    CHECK(four.standard_error == Approx(std::sqrt(5.0 / 3.0 / 4.0)));
    CHECK_FALSE(four.converged);
}

TEST_CASE("Series without variance between blocks are certain") {
    const Estimate constant = of_series(std::vector<double>(37, 0.1)).estimate(0);
    CHECK(constant.mean == Approx(0.1).epsilon(1e-15));
    CHECK(constant.standard_error == 0.0);
    CHECK(constant.converged);
    CHECK(constant.independent_samples == 37.0);

    std::vector<double> alternating;
    for (int i = 0; i < 512; ++i) {
        alternating.push_back(i % 2 == 0 ? 1.0 : -1.0);
    }
    const Estimate estimate = of_series(alternating).estimate(0);
    CHECK(estimate.standard_error == 0.0);
    CHECK(estimate.converged);
    CHECK(estimate.independent_samples == 512.0);
}

TEST_CASE("A sample that is not finite is not hidden") {
    std::vector<double> series(100, 1.0);
    series[50] = std::numeric_limits<double>::quiet_NaN();
    const Estimate estimate = of_series(series).estimate(0);
    CHECK(std::isnan(estimate.mean));
    CHECK(std::isnan(estimate.standard_error));
    CHECK_FALSE(estimate.converged);
}

TEST_CASE("Misuse of block averages is refused") {
    CHECK_THROWS_AS(BlockingAccumulator(0, Covariance::diagonal), ljmd::InputError);
    BlockingAccumulator blocks(2, Covariance::diagonal);
    CHECK_THROWS_AS(blocks.add(one(1.0)), ljmd::InputError);
    CHECK_THROWS_AS(blocks.estimate(2), ljmd::InputError);
    CHECK_THROWS_AS(blocks.levels(-1), ljmd::InputError);
    CHECK_THROWS_AS(blocks.estimate(0.0, Eigen::VectorXd::Zero(2)), ljmd::InputError);
    BlockingAccumulator full(2, Covariance::full);
    CHECK_THROWS_AS(full.estimate(0.0, Eigen::VectorXd::Zero(3)), ljmd::InputError);
}

TEST_CASE("block averages whose levels do not go together are not taken from an archive") {
    BlockingAccumulator written(1, Covariance::diagonal);
    for (int n = 0; n < 5; ++n) {
        written.add(Eigen::VectorXd::Constant(1, n));
    }
    Archive a;
    written.archive(a);
    // The number of levels stands first, then that of the blocks of the shortest.
    const auto changed = [&](std::size_t at, Index value) {
        std::vector<std::byte> bytes(a.bytes().begin(), a.bytes().end());
        std::memcpy(bytes.data() + at * sizeof(Index), &value, sizeof(Index));
        return bytes;
    };
    const auto restore = [](const std::vector<std::byte>& bytes) {
        Archive back(bytes);
        BlockingAccumulator read(1, Covariance::diagonal);
        read.archive(back);
        return read.samples();
    };
    CHECK(restore(changed(0, 3)) == 5);
    CHECK_THROWS_AS(restore(changed(0, 2)), CheckpointError);
    for (const Index blocks : {Index{-5}, Index{0}, Index{3}, Index{9}, std::numeric_limits<Index>::max()}) {
        CHECK_THROWS_AS(restore(changed(1, blocks)), CheckpointError);
    }
}

TEST_CASE("the estimates of a million components do not look at all for each one") {
    constexpr Index width = 1'000'000;
    BlockingAccumulator blocks(width, Covariance::diagonal);
    const Eigen::VectorXd series = Eigen::VectorXd::LinSpaced(width, 0.0, 1.0);
    for (int sample = 0; sample < 4; ++sample) {
        blocks.add(series.array() + sample);
    }
    const Eigen::VectorXd means = blocks.mean();
    Index alike = 0;
    for (Index component = 0; component < width; ++component) {
        alike += blocks.estimate(component).mean == means[component] ? 1 : 0;
    }
    CHECK(alike == width);
}
