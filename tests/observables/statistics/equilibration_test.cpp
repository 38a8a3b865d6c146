#include "observables/statistics/equilibration.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <vector>
#include "catch.hpp"

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

TEST_CASE("no start is found in series in equilibrium, however slow they are") {
    const auto [count, memory, largest] = GENERATE(table<Index, double, int>(
        {{500, 0.0, 0}, {500, 0.8, 0}, {500, 0.95, 0}, {2000, 0.99, 1}, {2000, 0.995, 1}, {2000, 0.998, 3}}));
    int starts = 0;
    for (unsigned seed = 0; seed < 300; ++seed) {
        const Equilibration found = detect_equilibration({{autoregressive(count, memory, seed)}})[0];
        starts += found.changes || found.start.value_or(0) > 0 ? 1 : 0;
    }
    CAPTURE(count, memory);
    CHECK(starts <= largest);
}

TEST_CASE("a relaxation, a jump and a drift are found, where they end") {
    struct Change {
        const char* name;
        double (*at)(double);     ///< of the part of the series that has passed, in standard deviations
        double earliest, latest;  ///< of the start, as a part of the series
    };
    const Change change =
        GENERATE(Change{"relaxation", [](double t) { return 20.0 * std::exp(-t / 0.03); }, 0.02, 0.15},
                 Change{"jump", [](double t) { return t < 0.3 ? 4.0 : 0.0; }, 0.28, 0.4},
                 Change{"drift", [](double t) { return t < 0.4 ? 10.0 * (0.4 - t) / 0.4 : 0.0; }, 0.25, 0.45});
    int found_in = 0;
    int ends_there = 0;
    for (unsigned seed = 0; seed < 100; ++seed) {
        auto series = autoregressive(1000, 0.8, seed);
        for (std::size_t k = 0; k < series.size(); ++k) {
            series[k] += change.at(static_cast<double>(k) / 1000.0);
        }
        const Equilibration found = detect_equilibration({{series}})[0];
        const double start = found.changes ? 1.0 : static_cast<double>(found.start.value_or(0)) / 1000.0;
        found_in += start > 0.0 ? 1 : 0;
        ends_there += start >= change.earliest && start <= change.latest ? 1 : 0;
    }
    CAPTURE(change.name);
    CHECK(found_in >= 95);
    CHECK(ends_there >= 95);
}

TEST_CASE("a drift that goes on beyond the middle has no start") {
    int changing = 0;
    for (unsigned seed = 0; seed < 100; ++seed) {
        auto series = autoregressive(1000, 0.8, seed);
        for (std::size_t k = 0; k < series.size(); ++k) {
            series[k] += 12.0 * static_cast<double>(k) / 1000.0;
        }
        const Equilibration found = detect_equilibration({{series}})[0];
        changing += found.changes && !found.start ? 1 : 0;
    }
    CHECK(changing >= 95);
}

TEST_CASE("all columns are as slow as the slowest") {
    // Slow fluctuations that are small beside fast ones, as of an energy in a pressure.
    int alone = 0;
    int together = 0;
    for (unsigned seed = 0; seed < 300; ++seed) {
        const auto slow = autoregressive(1000, 0.996, seed);
        auto fast = autoregressive(1000, 0.0, seed + 1000);
        for (std::size_t k = 0; k < slow.size(); ++k) {
            fast[k] += 0.7 * slow[k];
        }
        const auto has_start = [](const Equilibration& one) { return one.changes || one.start.value_or(0) > 0; };
        alone += has_start(detect_equilibration({{fast}})[0]) ? 1 : 0;
        const auto found = detect_equilibration({{fast}, {slow}});
        together += has_start(found[0]) ? 1 : 0;
        CHECK(found[0].inefficiency == found[1].inefficiency);
    }
    CHECK(alone > 5);
    CHECK(together <= 1);
}

TEST_CASE("no column is in equilibrium before all are") {
    auto late = autoregressive(1000, 0.5, 3);
    for (std::size_t k = 0; k < 300; ++k) {
        late[k] += 8.0;
    }
    const auto found = detect_equilibration({{autoregressive(1000, 0.5, 4)}, {late}});
    CHECK(found[1].start >= 300);
    CHECK(found[0].start == found[1].start);
    const auto not_judged = detect_equilibration({{autoregressive(1000, 0.5, 4)}, {.series = late, .judged = false}});
    CHECK(not_judged[0].start == 0);
}

TEST_CASE("a change by more than a sample deviates in equilibrium is found, however slow the series") {
    std::vector<double> cooling;
    const auto noise = autoregressive(500, 0.9, 3);
    for (std::size_t k = 0; k < noise.size(); ++k) {
        cooling.push_back(1.0 + 2.0 * std::exp(-static_cast<double>(k) / 250.0) + 0.2 * noise[k]);
    }
    const Equilibration alone = detect_equilibration({{cooling}})[0];
    const Equilibration known = detect_equilibration({{cooling, 0.06}})[0];
    CHECK((known.changes || known.start.value_or(0) > 50));
    CHECK_FALSE((alone.changes || alone.start.value_or(0) > 0));
}

TEST_CASE("a series is too short to tell with fewer than 8 independent samples in its second half") {
    const Equilibration slow = detect_equilibration({{autoregressive(400, 0.99, 2)}})[0];
    CHECK_FALSE(slow.start);
    CHECK_FALSE(slow.changes);
    CHECK(200.0 / slow.inefficiency < 8.0);
    const Equilibration fast = detect_equilibration({{autoregressive(400, 0.5, 2)}})[0];
    CHECK(fast.start == 0);
    CHECK(200.0 / fast.inefficiency > 8.0);
}

TEST_CASE("series of one kind only") {
    const std::vector<double> constant(50, 0.25);
    std::vector<double> late(50, 0.25);
    late[3] = 1.0;
    const auto found = detect_equilibration({{constant}, {late}});
    CHECK(found[0].start == 0);
    CHECK(found[0].inefficiency == 1.0);
    CHECK_FALSE(found[1].start);
    CHECK_FALSE(found[1].changes);
    for (const std::vector<double>& unknown :
         {std::vector<double>{}, std::vector<double>(7, 0.25), std::vector<double>(50, std::nan(""))}) {
        const Equilibration none = detect_equilibration({{unknown}})[0];
        CHECK_FALSE(none.start);
        CHECK_FALSE(none.changes);
        CHECK(std::isnan(none.inefficiency));
    }
    CHECK(detect_equilibration({}).empty());
}
