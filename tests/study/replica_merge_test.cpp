#include "study/replica_merge.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <vector>
#include "catch.hpp"

#include "ljmd/observables/statistics/blocking.hpp"

using namespace ljmd;

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Share of sets of replicas whose merged mean +- error covers the truth, 0: autoregressive series of correlation phi
/// and variance 1, of `samples` samples each.
/// @param offset  standard deviation of what each replica is off by, and does not know of
double covered(int sets, int replicas, Index samples, double phi, double offset, std::uint64_t seed) {
    std::mt19937_64 generator(seed);
    std::normal_distribution<double> normal;
    const double strength = std::sqrt(1.0 - phi * phi);
    int inside = 0;
    for (int set = 0; set < sets; ++set) {
        std::vector<ReplicaMean> runs;
        for (int k = 0; k < replicas; ++k) {
            BlockingAccumulator blocks(1, Covariance::diagonal);
            Eigen::VectorXd x = Eigen::VectorXd::Constant(1, normal(generator));
            for (Index n = 0; n < samples; ++n) {
                blocks.add(x);
                x[0] = phi * x[0] + strength * normal(generator);
            }
            const Estimate e = blocks.estimate(0);
            runs.push_back(
                {e.mean + offset * normal(generator), e.standard_error, static_cast<double>(samples), e.converged});
        }
        const MergedMean merged = merged_mean(runs);
        inside += std::abs(merged.mean) <= merged.standard_error ? 1 : 0;
    }
    return static_cast<double>(inside) / sets;
}

}  // namespace

TEST_CASE("one replica is merged with itself") {
    const MergedMean one = merged_mean({{1.5, 0.2, 100.0, true}});
    CHECK(one.mean == 1.5);
    CHECK(one.standard_error == 0.2);
    CHECK(std::isnan(one.between));
    CHECK(one.agree);
}

TEST_CASE("means are weighted by the lengths of the runs") {
    const MergedMean merged = merged_mean({{1.0, 0.1, 300.0, true}, {2.0, 0.2, 100.0, true}});
    CHECK(merged.mean == Approx(1.25));
    CHECK(merged.within == Approx(std::hypot(0.75 * 0.1, 0.25 * 0.2)));
    CHECK(merged.between == Approx(std::sqrt(0.75 * 0.25 * 0.25 + 0.25 * 0.75 * 0.75)));
}

TEST_CASE("runs that agree have the error of both estimates, by their degrees of freedom") {
    const MergedMean merged = merged_mean({{1.0, 0.1, 1.0, true}, {1.1, 0.1, 1.0, true}});
    const double within = 0.1 * 0.1 / 2.0;
    const double between = 0.05 * 0.05;
    CHECK(merged.agree);
    CHECK(merged.standard_error == Approx(std::sqrt((30.0 * within + between) / 31.0)));
}

TEST_CASE("runs that differ by more than their errors, or have none, have the error of their scatter") {
    const MergedMean differ = merged_mean({{1.0, 0.01, 1.0, true}, {1.2, 0.01, 1.0, true}});
    CHECK_FALSE(differ.agree);
    CHECK(differ.standard_error == Approx(1.8367 * 0.1).epsilon(1e-3));  // Student's t for one degree of freedom
    const MergedMean guessed = merged_mean({{1.0, 0.1, 1.0, false}, {1.2, 0.1, 1.0, true}});
    CHECK(guessed.standard_error == Approx(1.8367 * 0.1).epsilon(1e-3));
    CHECK(std::isnan(guessed.within));
    const MergedMean none = merged_mean({{1.0, unknown, 1.0, true}, {1.2, unknown, 1.0, true}});
    CHECK(none.standard_error == Approx(guessed.standard_error));
}

TEST_CASE("of 4000 sets of replicas 65.5 to 70.5 % have a merged mean +- error that covers the truth") {
    CHECK(covered(4000, 4, 1000, 0.6, 0.0, 1) == Approx(0.68).margin(0.025));
    CHECK(covered(4000, 2, 1000, 0.6, 0.0, 2) == Approx(0.68).margin(0.025));
    CHECK(covered(4000, 8, 30, 0.6, 0.0, 3) == Approx(0.68).margin(0.025));  // too short for errors of their own
}

TEST_CASE("so it is where replicas are off by more than they know") {
    CHECK(covered(4000, 4, 1000, 0.6, 0.5, 4) == Approx(0.68).margin(0.025));
}

TEST_CASE("tables are merged column by column where their rows are at the same places") {
    const std::vector<std::string> columns{"r", "g", "g_standard_error", "n"};
    const DataTable a{"rdf", columns, {{0.5, 1.0, 0.1, 4.0}, {1.5, 2.0, 0.1, 5.0}}};
    const DataTable b{"rdf", columns, {{0.5, 1.2, 0.1, 6.0}, {1.5, 2.0, 0.1, 7.0}}};
    const DataTable merged = merged_table({a, b}, {100.0, 100.0});
    REQUIRE(merged.rows.size() == 2);
    CHECK(merged.rows[0][0] == 0.5);
    CHECK(merged.rows[0][1] == Approx(1.1));
    CHECK(merged.rows[0][2] == merged_mean({{1.0, 0.1, 100.0, true}, {1.2, 0.1, 100.0, true}}).standard_error);
    CHECK(merged.rows[0][3] == Approx(5.0));
    DataTable other = b;
    other.rows[1][0] = 1.6;
    CHECK(merged_table({a, other}, {100.0, 100.0}).rows.empty());
}
