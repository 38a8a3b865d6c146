#include "ljmd/observables/statistics/equilibration.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "ljmd/core/errors.hpp"

using namespace ljmd;

namespace {

/// x_(t+1) = memory x_t + noise, of variance 1: C(t) = memory^t, g = (1 + memory)/(1 - memory).
std::vector<double> autoregressive(Index count, double memory, unsigned seed) {
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> normal;
    std::vector<double> series;
    double x = normal(generator);
    for (Index k = 0; k < count; ++k) {
        series.push_back(x);
        x = memory * x + std::sqrt(1.0 - memory * memory) * normal(generator);
    }
    return series;
}

/// The sum that defines it.
double by_definition(const std::vector<double>& x) {
    const auto n = static_cast<double>(x.size());
    double mean = 0.0;
    for (const double value : x) {
        mean += value / n;
    }
    double variance = 0.0;
    for (const double value : x) {
        variance += (value - mean) * (value - mean) / n;
    }
    double g = 1.0;
    for (std::size_t t = 1; t + 1 < x.size(); ++t) {
        double sum = 0.0;
        for (std::size_t s = 0; s + t < x.size(); ++s) {
            sum += (x[s] - mean) * (x[s + t] - mean);
        }
        const double c = sum / (n - static_cast<double>(t)) / variance;
        if (c <= 0.0 && t > 3) {
            break;
        }
        g += 2.0 * c * (1.0 - static_cast<double>(t) / n);
    }
    return std::max(g, 1.0);
}

}  // namespace

TEST_CASE("the statistical inefficiency is the sum over correlations that defines it") {
    for (const Index count : {2, 3, 5, 17, 1000}) {
        for (const double memory : {-0.5, 0.0, 0.9}) {
            const auto series = autoregressive(count, memory, 3);
            CAPTURE(count, memory);
            CHECK(statistical_inefficiency(series) == Approx(by_definition(series)).epsilon(1e-10));
        }
    }
}

TEST_CASE("correlations that are negative within three samples do not end the sum") {
    // On top of what decays slowly an oscillation of four samples: C(2) < 0 < C(3).
    auto series = autoregressive(2000, 0.98, 6);
    for (std::size_t k = 0; k < series.size(); ++k) {
        series[k] += k % 4 == 0 ? 2.0 : k % 4 == 2 ? -2.0 : 0.0;
    }
    CHECK(statistical_inefficiency(series) == Approx(by_definition(series)).epsilon(1e-10));
    CHECK(by_definition(series) > 2.5);  // 1.7 from C(1) alone
}

TEST_CASE("the statistical inefficiency of an autoregressive series is (1 + a)/(1 - a)") {
    for (const double memory : {0.0, 0.5, 0.9, 0.98}) {
        const auto series = autoregressive(200000, memory, 4);
        CAPTURE(memory);
        CHECK(statistical_inefficiency(series) == Approx((1.0 + memory) / (1.0 - memory)).epsilon(0.1));
    }
}

TEST_CASE("series that do not vary are independent, and those that cannot be known are not numbers") {
    CHECK(statistical_inefficiency(std::vector<double>(50, 0.1)) == 1.0);
    CHECK(statistical_inefficiency(std::vector<double>{1.0, -1.0, 1.0, -1.0}) == 1.0);
    CHECK(std::isnan(statistical_inefficiency(std::vector<double>{})));
    CHECK(std::isnan(statistical_inefficiency(std::vector<double>{1.0})));
    CHECK(std::isnan(statistical_inefficiency(std::vector<double>{1.0, 2.0, std::numeric_limits<double>::infinity()})));
}

TEST_CASE("a decay at the beginning is found and left out") {
    auto series = autoregressive(4000, 0.5, 5);
    for (std::size_t k = 0; k < series.size(); ++k) {
        series[k] += 20.0 * std::exp(-static_cast<double>(k) / 50.0);  // below the noise after 150
    }
    const Equilibration found = detect_equilibration(series, 10);
    CHECK(found.start >= 100);
    CHECK(found.start <= 400);
    CHECK(found.start % 10 == 0);
    CHECK(found.inefficiency == Approx(3.0).epsilon(0.3));
    CHECK(found.independent_samples == Approx(static_cast<double>(4000 - found.start) / found.inefficiency));
    CHECK(std::abs(found.mean) < 3.0 * found.standard_error);
}

TEST_CASE("a series in equilibrium is used nearly whole, and its error is that of independent samples") {
    Index max_left_out = 0;
    double sum = 0.0;
    double reported = 0.0;
    constexpr int runs = 100;
    for (unsigned seed = 0; seed < runs; ++seed) {
        const Equilibration found = detect_equilibration(autoregressive(2000, 0.8, seed), 40);
        max_left_out = std::max(max_left_out, found.start);
        sum += found.mean * found.mean;
        reported += found.standard_error * found.standard_error;
    }
    CHECK(max_left_out < 1200);
    CHECK(std::sqrt(sum / reported) == Approx(1.0).margin(0.25));
}

TEST_CASE("series of one kind only") {
    const Equilibration constant = detect_equilibration(std::vector<double>(50, 0.25), 1);
    CHECK(constant.start == 0);
    CHECK(constant.independent_samples == 50.0);
    CHECK(constant.mean == 0.25);
    CHECK(constant.standard_error == 0.0);
    const Equilibration single = detect_equilibration(std::vector<double>{3.0}, 1);
    CHECK(single.mean == 3.0);
    CHECK(std::isnan(single.standard_error));
    CHECK(std::isnan(detect_equilibration(std::vector<double>(9, std::nan("")), 1).mean));
    CHECK_THROWS_AS(detect_equilibration(std::vector<double>{}, 1), ContractViolation);
    CHECK_THROWS_AS(detect_equilibration(std::vector<double>{1.0, 2.0}, 0), ContractViolation);
}
