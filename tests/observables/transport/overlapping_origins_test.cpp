#include "observables/transport/overlapping_origins.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>
#include "catch.hpp"

#include "neighbors/sample_states.hpp"
#include "observables/transport/mean_square_displacement.hpp"

using namespace ljmd;

namespace {

/// As the definition says, with the double sum.
double by_double_sum(const Eigen::VectorXd& weights, Index between, Index origins) {
    const auto covariance = [&](Index apart) {
        double sum = 0.0;
        for (Index j = 0; j < weights.size(); ++j) {
            for (Index k = 0; k < weights.size(); ++k) {
                const auto shared = static_cast<double>(std::max<Index>(std::min(j, k + apart) - apart, 0));
                sum += weights[j] * weights[k] * shared * shared;
            }
        }
        return sum;
    };
    double inefficiency = 1.0;
    for (Index m = 1; m < origins; ++m) {
        inefficiency += 2.0 * (1.0 - static_cast<double>(m) / static_cast<double>(origins)) * covariance(m * between) /
                        covariance(0);
    }
    return static_cast<double>(origins) / inefficiency;
}

Eigen::VectorXd line(Index times, Index first) {
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(times);
    const double middle = 0.5 * static_cast<double>(first + times - 1);
    for (Index k = first; k < times; ++k) {
        weights[k] = static_cast<double>(k) - middle;
    }
    return weights / weights.squaredNorm();
}

constexpr int walks = 300;

struct Walks {
    double ratio = 0.0;  ///< of the scatter of D to its error, over all walks
    int marked = 0;
    double independent = 0.0;  ///< mean
};

/// D of many random walks of so many times the largest time, eight atoms each.
Walks random_walks(Index multiple) {
    constexpr LagTimes lags{.every = 1, .count = 20, .spacing = 0.1};

    std::mt19937_64 generator(17);
    std::normal_distribution<double> normal;
    std::vector<Estimate> found;
    for (int walk = 0; walk < walks; ++walk) {
        State state = test::random_state(8, Box(Vec3::Constant(6.0)), 1);
        MeanSquareDisplacement msd(8, lags, 20, 0.4);
        for (Index t = 0; t <= multiple * lags.count; ++t) {
            auto r = state.write_positions();
            for (Index i = 0; i < state.count(); ++i) {
                r.col(i) += 0.3 * Vec3(normal(generator), normal(generator), normal(generator));
                r.col(i) = state.snapped(r.col(i));
            }
            state.wrap();
            msd.sample(state, {});
        }
        found.push_back(msd.observables().at(0).estimate.value());
    }
    Walks all;
    double mean = 0.0;
    for (const Estimate& one : found) {
        mean += one.mean / walks;
    }
    for (const Estimate& one : found) {
        all.ratio += std::pow((one.mean - mean) / one.standard_error, 2) / walks;
        all.marked += one.converged ? 0 : 1;
        all.independent += one.independent_samples / walks;
    }
    all.ratio = std::sqrt(all.ratio);
    return all;
}

}  // namespace

TEST_CASE("origins are worth what the overlap of their displacements leaves") {
    for (const Index between : {1, 3, 12, 40}) {
        for (const Index origins : {1, 2, 7, 100}) {
            CAPTURE(between, origins);
            CHECK(independent_origins(line(13, 3), between, origins) ==
                  Approx(by_double_sum(line(13, 3), between, origins)).epsilon(1e-12));
        }
    }
    CHECK(independent_origins(line(13, 3), 12, 30) == 30.0);  // no frame in common
}

TEST_CASE(
    "the diffusion of random walks scatters as its error says, and is marked by the number of independent samples") {
    const Walks longer = random_walks(12);
    CHECK(longer.independent > 16.0);
    CHECK(longer.ratio > 0.85);
    CHECK(longer.ratio < 1.2);
    CHECK(longer.marked < walks / 10);
    const Walks shorter = random_walks(6);
    CHECK(shorter.independent < 16.0);
    CHECK(shorter.ratio > 0.85);
    CHECK(shorter.ratio < 1.35);
    CHECK(shorter.marked == walks);
}

TEST_CASE("what correlates for longer than origins overlap shows in blocks, whose error counts then") {
    BlockingAccumulator means(1, Covariance::diagonal);
    std::mt19937_64 generator(5);
    std::normal_distribution<double> normal;
    double slow = 0.0;
    for (int k = 0; k < 4000; ++k) {
        slow = 0.98 * slow + std::sqrt(1.0 - 0.98 * 0.98) * normal(generator);
        means.add(Eigen::VectorXd::Constant(1, slow));
    }
    const Estimate by_blocks = means.estimate(0);
    const Estimate slower = overlapping_estimate(means, 0, 1000.0);
    CHECK(slower.standard_error == by_blocks.standard_error);
    CHECK(slower.independent_samples == by_blocks.independent_samples);
    const Estimate known = overlapping_estimate(means, 0, 40.0);
    CHECK(known.standard_error == Approx(1.0 / std::sqrt(39.0)).epsilon(0.2));
    CHECK(known.independent_samples == 40.0);
    CHECK(known.converged);
    CHECK_FALSE(overlapping_estimate(means, 0, 15.9).converged);
}
