#include "observables/structure/coordination_number.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include "catch.hpp"

#include "core/through_archive.hpp"

using namespace ljmd;

namespace {

using Density = std::function<double(double)>;

constexpr double radius = 2.8;
constexpr Index cells = 560;  // of 0.005 sigma, of which all divisions below are made
constexpr Index atoms = 108;

/// A liquid's: a peak at 1.08, the first minimum near 1.55, a second peak near 2.1.
double liquid(double r) {
    return r < 0.95 ? 0.0
                    : 0.8 * (1.0 + 1.6 * std::exp(-1.1 * (r - 1.0)) * std::cos(2.0 * std::numbers::pi * (r - 1.08)));
}

/// A thin gas': exp(-u/T) at T = 1.5.
double gas(double r) {
    const double s6 = std::pow(r, -6);
    return 0.05 * std::exp(-4.0 * (s6 * s6 - s6) / 1.5);
}

double ideal_gas(double /*r*/) {
    return 0.8;
}

double place_of_minimum() {
    double low = 1.3;
    double high = 1.8;
    while (high - low > 1e-9) {
        const double a = low + (high - low) / 3.0;
        const double b = high - (high - low) / 3.0;
        (liquid(a) < liquid(b) ? high : low) = liquid(a) < liquid(b) ? b : a;
    }
    return low;
}

double atoms_within(double r) {
    const int steps = 20000;
    double sum = 0.0;
    for (int k = 0; k < steps; ++k) {
        const double middle = r * (k + 0.5) / steps;
        sum += 4.0 * std::numbers::pi * middle * middle * liquid(middle) * r / steps;
    }
    return sum;
}

/// Of pairs in cell k of a configuration.
double mean_count(const Density& density, Index k) {
    const double width = radius / static_cast<double>(cells);
    const double r = width * (static_cast<double>(k) + 0.5);
    return 0.5 * atoms * 4.0 * std::numbers::pi * r * r * width * density(r);
}

/// Counts of pairs in independent configurations, in cells.
std::vector<std::vector<Index>> configurations(const Density& density, int count, unsigned seed) {
    std::mt19937_64 generator(seed);
    std::vector<std::poisson_distribution<Index>> draws;
    for (Index k = 0; k < cells; ++k) {
        draws.emplace_back(std::max(mean_count(density, k), 1e-12));
    }
    std::vector<std::vector<Index>> all(static_cast<std::size_t>(count));
    for (auto& counts : all) {
        for (auto& draw : draws) {
            counts.push_back(draw(generator));
        }
    }
    return all;
}

/// Configurations in which atoms move to and fro on both sides of the minimum: that moves the minimum, whereas the
/// number within its mean place stays the same to one pair, as in a liquid, which cannot be compressed.
std::vector<std::vector<Index>> stiff_configurations(const Density& density, int count, unsigned seed) {
    constexpr double reach = 0.4;
    constexpr double pairs = 20.0;  // that move
    std::mt19937_64 generator(seed);
    std::uniform_real_distribution<double> uniform;
    const double minimum = place_of_minimum();
    std::vector<std::vector<Index>> all(static_cast<std::size_t>(count));
    for (auto& counts : all) {
        const double moved = pairs * (2.0 * uniform(generator) - 1.0);
        double mean = uniform(generator);
        Index before = 0;
        for (Index k = 0; k < cells; ++k) {
            mean += mean_count(density, k);
            const double x = radius / static_cast<double>(cells) * static_cast<double>(k + 1) - minimum;
            const double shift = std::abs(x) < reach ? 1.0 - std::cos(2.0 * std::numbers::pi * x / reach) : 0.0;
            const auto within = std::max(static_cast<Index>(mean + moved * shift), before);
            counts.push_back(within - before);
            before = within;
        }
    }
    return all;
}

ObservableAverage found(const std::vector<std::vector<Index>>& all, Index bins) {
    const CoordinationNumber::Division division = CoordinationNumber::division(bins, radius);
    const Index merged = cells / (bins * division.parts);
    REQUIRE(merged * bins * division.parts == cells);
    CoordinationNumber number(division);
    for (const auto& counts : all) {
        std::vector<Index> parts(static_cast<std::size_t>(bins * division.parts));
        for (Index k = 0; k < cells; ++k) {
            parts[static_cast<std::size_t>(k / merged)] += counts[static_cast<std::size_t>(k)];
        }
        number.add(parts, atoms);
    }
    return number.observable();
}

}  // namespace

TEST_CASE("the error of the coordination number holds that of the minimum: the scatter of 60 runs is what it says") {
    const auto draw = GENERATE(configurations, stiff_configurations);
    const double expected = atoms_within(place_of_minimum());
    double sum = 0.0;
    double squares = 0.0;
    double reported = 0.0;
    int found_in = 0;
    for (unsigned seed = 0; seed < 60; ++seed) {
        const ObservableAverage average = found(draw(liquid, 64, seed), 280);
        if (average.estimate) {  // error bars of one in a hundred such short runs are not called converged
            ++found_in;
            sum += average.estimate->mean;
            squares += std::pow(average.estimate->mean - expected, 2);
            reported += std::pow(average.estimate->standard_error, 2);
        }
    }
    REQUIRE(found_in >= 57);
    CAPTURE(expected, sum / found_in, std::sqrt(reported / found_in));
    const double scatter_over_error = std::sqrt(squares / reported);
    CHECK(scatter_over_error > 0.7);
    CHECK(scatter_over_error < 1.32);
    CHECK(std::abs(sum / found_in - expected) < 4.0 * std::sqrt(reported) / found_in);
}

TEST_CASE("the coordination number does not depend on the bins of g(r)") {
    const auto all = configurations(liquid, 64, 7);
    const Estimate fine = found(all, 560).estimate.value();
    for (const Index bins : {20, 40, 80, 140, 280}) {
        const Estimate other = found(all, bins).estimate.value();
        CAPTURE(bins, other.mean, fine.mean, fine.standard_error);
        CHECK(std::abs(other.mean - fine.mean) < 0.3 * fine.standard_error);
        CHECK(other.standard_error == Approx(fine.standard_error).epsilon(0.15));
    }
}

TEST_CASE("where g(r) has no minimum there is no coordination number, but a remark") {
    const Density density = GENERATE(Density(ideal_gas), Density(gas));
    for (unsigned seed = 0; seed < 40; ++seed) {
        const ObservableAverage average = found(configurations(density, 64, seed), 280);
        CHECK(average.name == "coordination_number");
        CHECK_FALSE(average.estimate.has_value());
        CHECK_FALSE(average.remark.empty());
    }
}

TEST_CASE("a few configurations tell no minimum from noise") {
    CHECK_FALSE(found(configurations(liquid, 3, 1), 280).estimate.has_value());
    CHECK_FALSE(found(configurations([](double r) { return 1e-3 * liquid(r); }, 8, 1), 280).estimate.has_value());
}

TEST_CASE("a division has shells that suit the fit, made of whole parts of bins") {
    for (const Index bins : {1, 30, 100, 250, 2000, 100000}) {
        const CoordinationNumber::Division division = CoordinationNumber::division(bins, 5.0);
        CAPTURE(bins);
        CHECK(division.width <= 0.04 * (1.0 + 1e-8));
        CHECK(division.width > 0.02);
        CHECK(division.width * static_cast<double>(bins * division.parts) ==
              Approx(5.0 * static_cast<double>(division.in_a_shell)));
        CHECK(division.shells * division.in_a_shell <= bins * division.parts);
        CHECK(static_cast<double>(division.shells) * division.width > 3.1);
        CHECK(static_cast<double>(division.shells) * division.width < 3.2 + 1e-9);
    }
}

TEST_CASE("what a checkpoint holds of a coordination number is small beside a few thousand atoms") {
    const CoordinationNumber::Division division = CoordinationNumber::division(250, 5.0);
    CoordinationNumber number(division);
    const std::vector<Index> counts(static_cast<std::size_t>(250 * division.parts));
    for (int k = 0; k < 1024; ++k) {
        number.add(counts, atoms);
    }
    Archive a;
    number.archive(a);
    CHECK(a.bytes().size() < 320'000);
}

TEST_CASE("a coordination number goes on from an archive bit for bit") {
    const auto all = configurations(liquid, 32, 3);
    const CoordinationNumber::Division division = CoordinationNumber::division(cells, radius);
    CoordinationNumber whole(division);
    CoordinationNumber part(division);
    for (std::size_t k = 0; k < all.size(); ++k) {
        whole.add(all[k], atoms);
        if (k < 20) {
            part.add(all[k], atoms);
        }
    }
    CoordinationNumber restored(division);
    test::through_archive(part, restored);
    for (std::size_t k = 20; k < all.size(); ++k) {
        restored.add(all[k], atoms);
    }
    CHECK(restored.observable().estimate->mean == whole.observable().estimate->mean);
    CHECK(restored.observable().estimate->standard_error == whole.observable().estimate->standard_error);
}
