#include "ljmd/detail/observables/statistics/wanted_errors.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>
#include "catch.hpp"

using ljmd::BlockingAccumulator;
using ljmd::Covariance;
using ljmd::Estimate;
using ljmd::Index;
using ljmd::is_look;
using ljmd::is_reached;
using ljmd::stopped_estimate;

namespace {

constexpr double no_error = std::numeric_limits<double>::quiet_NaN();

/// Whether a series ends with this many samples, and the estimate that is then reported.
using Ends = std::function<bool(const BlockingAccumulator&, Estimate&)>;

/// The rule of `until`.
Ends by_looks(double wanted) {
    return [wanted](const BlockingAccumulator& blocks, Estimate& estimate) {
        if (!is_look(blocks.samples())) {
            return false;
        }
        estimate = stopped_estimate(blocks.estimate(0));
        return is_reached(estimate, wanted);
    };
}

/// What one must not do: look after every sample, and take the first error that is small enough.
Ends greedily(double wanted) {
    return [wanted](const BlockingAccumulator& blocks, Estimate& estimate) {
        estimate = blocks.estimate(0);
        return estimate.standard_error <= wanted;
    };
}

/// Share of series x(t+1) = phi x(t) + sqrt(1 - phi^2) noise, of mean 0 and variance 1, whose mean +- error covers 0
/// when they end.
double covered(int series, double phi, std::uint64_t seed, const Ends& ends) {
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> normal;
    const double strength = std::sqrt(1.0 - phi * phi);
    int inside = 0;
    for (int k = 0; k < series; ++k) {
        BlockingAccumulator blocks(1, Covariance::diagonal);
        Estimate estimate{};
        Eigen::VectorXd x = Eigen::VectorXd::Constant(1, normal(generator));
        do {
            blocks.add(x);
            x[0] = phi * x[0] + strength * normal(generator);
        } while (!ends(blocks, estimate));
        inside += std::abs(estimate.mean) <= estimate.standard_error ? 1 : 0;
    }
    return static_cast<double>(inside) / series;
}

/// The error that so many independent samples of variance 1 have.
double error_of(double independent) {
    return 1.0 / std::sqrt(independent);
}

}  // namespace

TEST_CASE("looks are sqrt(2) apart, from the 128th sample on") {
    std::vector<Index> looks;
    for (Index samples = 0; samples <= 2100; ++samples) {
        if (is_look(samples)) {
            looks.push_back(samples);
        }
    }
    CHECK(looks == std::vector<Index>{128, 182, 256, 363, 512, 725, 1024, 1449, 2048});
    CHECK(is_look(Index{1} << 40));
    CHECK_FALSE(is_look((Index{1} << 40) + 1));
}

TEST_CASE("the error of a stopped series is enlarged by 2/nu, and counts fewer independent samples") {
    const Estimate raw{1.5, 0.1, 400.0, 1000, true, 17};
    const Estimate stopped = stopped_estimate(raw);
    CHECK(stopped.mean == raw.mean);
    CHECK(stopped.standard_error == Approx(0.1 * (1.0 + 2.0 / 16.0)));
    CHECK(stopped.independent_samples == Approx(400.0 / (1.125 * 1.125)));
    CHECK(stopped_estimate({0.0, 0.1, 400.0, 1000, true, 2001}).standard_error == Approx(0.1001));
    SECTION("a constant series keeps its error 0") {
        const Estimate constant = stopped_estimate({2.0, 0.0, 500.0, 500, true, 500});
        CHECK(constant.standard_error == 0.0);
        CHECK(constant.independent_samples == 500.0);
        CHECK(is_reached(constant, 1e-300));
    }
}

TEST_CASE("an error is reached when it is small enough, no guess, and from 150 independent samples") {
    CHECK(is_reached({0.0, 0.01, 150.0, 1000, true, 30}, 0.01));
    CHECK_FALSE(is_reached({0.0, 0.0101, 150.0, 1000, true, 30}, 0.01));
    CHECK_FALSE(is_reached({0.0, 0.01, 149.0, 1000, true, 30}, 0.01));
    CHECK_FALSE(is_reached({0.0, 0.01, 150.0, 1000, false, 30}, 0.01));
    CHECK_FALSE(is_reached({0.0, no_error, no_error, 3, false}, 0.01));
}

TEST_CASE("of 10^4 correlated series that are ended when an error is reached 66 to 70 % cover the truth") {
    // The mean of n samples has the error of n/4 independent ones.
    CHECK(covered(10'000, 0.6, 1, by_looks(error_of(200.0))) == Approx(0.68).margin(0.02));
}

TEST_CASE("so it is for white and more correlated series, and for all errors wanted") {
    // Of white series 70.6 % are covered, a little more than of others; 2000 of them scatter by 1 %.
    for (const double phi : {0.0, 0.6, 0.8}) {
        for (const double independent : {50.0, 150.0, 300.0}) {
            INFO("phi " << phi << ", " << independent << " independent samples");
            CHECK(covered(2000, phi, 2, by_looks(error_of(independent))) == Approx(0.69).margin(0.05));
        }
    }
}

TEST_CASE("who looks after every sample, and ends at the first error that is small enough, covers less") {
    CHECK(covered(10'000, 0.6, 1, greedily(error_of(200.0))) < 0.66);
}
