#include "observables/transport/green_kubo_averages.hpp"

#include <cmath>
#include <random>
#include "catch.hpp"

#include "core/through_archive.hpp"

using namespace ljmd;

namespace {

constexpr LagTimes noisy_lags{.every = 1, .count = 40, .spacing = 0.05};  // up to 2

/// Correlations exp(-rate t) plus `tail`, each with noise that its integral adds up.
GreenKuboAverages averages_of(double rate, double tail, double noise) {
    GreenKuboAverages averages(noisy_lags);
    std::mt19937_64 generator(3);
    std::normal_distribution<double> normal;
    for (int window = 0; window < 400; ++window) {
        Eigen::VectorXd c(noisy_lags.count + 1);
        for (Index k = 0; k <= noisy_lags.count; ++k) {
            c[k] = std::exp(-rate * noisy_lags.time(k)) + tail + noise * normal(generator);
        }
        averages.add(c, window % 2 == 0 ? 1.0 : 2.0);
    }
    return averages;
}

}  // namespace

TEST_CASE("averages are those of the correlations, their integrals and the temperature") {
    GreenKuboAverages averages({.every = 1, .count = 2, .spacing = 0.5});
    CHECK(averages.windows() == 0);
    averages.add(Eigen::Vector3d(4.0, 2.0, 0.0), 1.0);
    averages.add(Eigen::Vector3d(2.0, 0.0, 0.0), 2.0);
    CHECK(averages.windows() == 2);
    CHECK(averages.temperature() == 1.5);
    const DataTable table = averages.table("flux", "conductivity", 10.0);
    CHECK(table.name == "flux");
    CHECK(table.columns == std::vector<std::string>{"time", "flux", "flux_standard_error", "conductivity",
                                                    "conductivity_standard_error"});
    REQUIRE(table.rows.size() == 3);
    CHECK(table.rows[1][1] == Approx(1.0));
    CHECK(table.rows[1][3] == Approx(10.0 * 0.5 * 0.5 * (3.0 + 1.0)));
    CHECK(table.rows[2][3] == Approx(10.0 * (1.0 + 0.25)));
}

TEST_CASE("without a temperature to divide by there is no coefficient, and it says why") {
    const ObservableAverage none = averages_of(3.0, 0.0, 0.1).coefficient({"c", "c", "", std::nullopt}, std::nan(""));
    CHECK_FALSE(none.estimate.has_value());
    CHECK_THAT(none.remark, Catch::Contains("divided by the temperature"));
}

TEST_CASE("an integral has levelled out if what is still to come is below its error") {
    CHECK(averages_of(8.0, 0.0, 0.1).has_levelled_out());          // e^-8 is left after half of the time
    CHECK(averages_of(2.0, 0.0, 10.0).has_levelled_out());         // the change is lost in the noise
    CHECK_FALSE(averages_of(1.0, 0.0, 0.05).has_levelled_out());   // e^-2 = 0.14 is left after all of the time
    CHECK_FALSE(averages_of(8.0, 0.05, 0.05).has_levelled_out());  // a tail that stays
    // The change of 0.02 is significant, but after it 0.001 is left at most: less than the error of 0.004.
    CHECK(averages_of(3.8, 0.0, 0.25).has_levelled_out());
    GreenKuboAverages few(noisy_lags);
    few.add(Eigen::VectorXd::Ones(noisy_lags.count + 1), 1.0);
    CHECK(few.has_levelled_out());  // no errors to judge by
}

TEST_CASE("a series of fluxes is cut into windows, goes on from an archive, and drops what was interrupted") {
    const auto sampled = [](int interrupted_at, int archived_at) {
        const LagTimes few{.every = 1, .count = 3, .spacing = 0.1};
        auto series = std::make_unique<GreenKuboSeries>(2, few, 6, 2.0);
        std::mt19937_64 generator(5);
        std::normal_distribution<double> normal;
        for (int t = 0; t < 30; ++t) {
            if (t == interrupted_at) {
                series->interrupt();
            }
            if (t == archived_at) {
                auto restored = std::make_unique<GreenKuboSeries>(2, few, 6, 2.0);
                test::through_archive(*series, *restored);
                series = std::move(restored);
            }
            series->add(Eigen::Vector2d(normal(generator), normal(generator)), 1.0 + t, Execution());
        }
        std::vector<double> numbers{series->averages().temperature()};
        for (const auto& row : series->averages().table("f", "c", 1.0).rows) {
            numbers.insert(numbers.end(), row.begin(), row.begin() + 3);  // noise has no integral
        }
        return numbers;
    };
    const auto whole = sampled(-1, -1);
    CHECK(whole.front() == 15.5);
    CHECK(sampled(-1, 17) == whole);
    CHECK(sampled(12, -1) == whole);
    CHECK(sampled(13, -1) != whole);
}
