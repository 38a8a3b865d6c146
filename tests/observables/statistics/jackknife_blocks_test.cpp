#include "ljmd/detail/observables/statistics/jackknife_blocks.hpp"

#include <cmath>
#include <random>
#include "catch.hpp"

#include "core/through_archive.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/observables/statistics/blocking.hpp"

using namespace ljmd;

namespace {

Eigen::VectorXd as_it_is(const Eigen::VectorXd& means) {
    return means;
}

/// Fast noise above a slow process of a quarter of its width, which is all that the error of the mean knows.
class HiddenSlowProcess {
  public:
    explicit HiddenSlowProcess(std::uint64_t seed) : generator_(seed) {}
    Eigen::VectorXd next() {
        slow_ = memory_ * slow_ + 0.25 * std::sqrt(1.0 - memory_ * memory_) * normal_(generator_);
        return Eigen::VectorXd::Constant(1, slow_ + normal_(generator_));
    }

  private:
    static constexpr double memory_ = 0.99;  // 200 samples count as one
    std::mt19937_64 generator_;
    std::normal_distribution<double> normal_;
    double slow_ = 0.0;
};

}  // namespace

TEST_CASE("the jackknife error of a mean is the deviation of the blocks over the root of their number") {
    JackknifeBlocks blocks(1);
    double sum = 0.0;
    double squares = 0.0;
    for (int k = 0; k < 40; ++k) {
        const double x = std::sin(1.0 + k * k);
        blocks.add(Eigen::VectorXd::Constant(1, x));
        sum += x;
        squares += x * x;
    }
    const double variance = (squares - sum * sum / 40.0) / 39.0;
    CHECK(blocks.errors(as_it_is)[0] == Approx(std::sqrt(variance / 40.0)).epsilon(1e-12));
    // Of a square it is 2 x times that, but for curvature.
    const auto square = [](const Eigen::VectorXd& means) -> Eigen::VectorXd { return (means.array() + 50.0).square(); };
    CHECK(blocks.errors(square)[0] == Approx(2.0 * (50.0 + sum / 40.0) * std::sqrt(variance / 40.0)).epsilon(1e-3));
}

TEST_CASE("too few blocks know no error") {
    JackknifeBlocks blocks(2);
    for (int k = 0; k < 15; ++k) {
        blocks.add(Eigen::VectorXd::Constant(2, k));
    }
    CHECK(std::isnan(blocks.errors(as_it_is)[1]));
    blocks.add(Eigen::VectorXd::Constant(2, 15.0));
    CHECK(blocks.errors(as_it_is)[1] > 0.0);
}

TEST_CASE("a slow process that fast noise hides is seen") {
    // Over 100 series, the scatter of the means over the reported error: 1 is right.
    constexpr int series = 100;
    double scatter = 0.0;
    double reported = 0.0;
    for (int k = 0; k < series; ++k) {
        HiddenSlowProcess process(static_cast<std::uint64_t>(k));
        JackknifeBlocks blocks(1);
        BlockingAccumulator mean(1, Covariance::diagonal);
        for (int n = 0; n < 40000; ++n) {
            const Eigen::VectorXd sample = process.next();
            blocks.add(sample);
            mean.add(sample);
        }
        scatter += mean.mean()[0] * mean.mean()[0] / series;
        reported += std::pow(blocks.errors(as_it_is)[0], 2) / series;
    }
    CHECK(std::sqrt(scatter / reported) > 0.7);
    CHECK(std::sqrt(scatter / reported) < 1.32);
}

TEST_CASE("samples that share data have blocks that are long enough, or no error") {
    // Means of 20 random numbers, each with 19 of the one before.
    constexpr Index shared = 20;
    constexpr int series = 400;
    double scatter = 0.0;
    double reported = 0.0;
    double alone = 0.0;
    std::mt19937_64 generator(3);
    std::normal_distribution<double> normal;
    for (int k = 0; k < series; ++k) {
        JackknifeBlocks blocks(1);
        const Eigen::VectorXd numbers = Eigen::VectorXd::NullaryExpr(41 * shared, [&] { return normal(generator); });
        for (Index n = 0; n < 40 * shared; ++n) {
            blocks.add(Eigen::VectorXd::Constant(1, numbers.segment(n, shared).mean()));
        }
        scatter += blocks.mean()[0] * blocks.mean()[0] / series;
        reported += std::pow(blocks.errors(as_it_is, shared)[0], 2) / series;
        alone += std::pow(blocks.errors(as_it_is)[0], 2) / series;
        CHECK(std::isnan(blocks.errors(as_it_is, 2 * shared)[0]));
    }
    CHECK(std::sqrt(scatter / reported) > 0.9);
    CHECK(std::sqrt(scatter / reported) < 1.12);
    CHECK(std::sqrt(scatter / alone) > 1.15);  // as samples that share nothing
}

TEST_CASE("blocks go on from an archive to the same bits, and refuse those of another width") {
    JackknifeBlocks whole(1);
    JackknifeBlocks first(1);
    HiddenSlowProcess process(1);
    for (int n = 0; n < 1000; ++n) {
        if (n == 777) {
            JackknifeBlocks restored(1);
            test::through_archive(first, restored);
            first = restored;
            JackknifeBlocks wider(2);
            CHECK_THROWS_AS(test::through_archive(whole, wider), CheckpointError);
        }
        const Eigen::VectorXd sample = process.next();
        whole.add(sample);
        first.add(sample);
    }
    CHECK(first.errors(as_it_is)[0] == whole.errors(as_it_is)[0]);
}
