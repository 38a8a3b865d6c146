#pragma once

#include <Eigen/Core>
#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/detail/core/archive.hpp"

namespace ljmd {

/// Mean of a correlated series with its standard error.
struct Estimate {
    double mean;                 ///< NaN without samples
    double standard_error;       ///< one standard deviation of the mean; NaN with fewer than 4 samples
    double independent_samples;  ///< variance of the series / standard_error^2, at most `samples`; NaN if the error is
    Index samples;
    bool converged;    ///< false: the series is too short for its correlations, and the error is a guess (see below)
    Index blocks = 0;  ///< the error was found from; 0 if unknown
};

/// A point of the blocking curve: the error of the mean if blocks of this length are taken as independent.
struct BlockLevel {
    Index length;                 ///< samples per block, a power of two
    Index blocks;                 ///< number of complete blocks, at least 2
    double standard_error;        ///< of the mean over all samples
    double relative_uncertainty;  ///< of standard_error itself: 1 / sqrt(2 (blocks - 1))
};

/// What each level keeps: variances of the components, or all their covariances.
enum class Covariance { diagonal, full };

/// Streaming block averages of a vector-valued, time-correlated series. Gives mean and standard error of each component
/// and of functions of the means, without storing the series.
///
/// Level k averages the series over consecutive blocks of B = 2^k samples. From the variance s_k^2 of its complete
/// blocks, the standard error of the mean of all n samples is
///
///     e_k = s_k sqrt(B / n)
///
/// It grows with k until blocks are longer than the correlation time. The reported error is e_k of the shortest blocks
/// with B^3 > 2 n max(1, e_k/e_0)^4 among the levels with at least 16 blocks, whose error is known to 18 %. This
/// condition balances the bias of short blocks against the scatter of few blocks; it takes about a hundred independent
/// samples.
///
/// A quantity that oscillates, as the pressure normal to a film does with its breathing, has e_k that falls again where
/// blocks get longer than a period. So a later level l takes the place of k where there are 32 blocks and e_l is
/// smaller by more than its scatter explains, and again from there:
///
///     e_l < e_k (1 - 2.5 (u_l^2 - u_k^2)^(1/2)),   u = 1/(2 (blocks - 1))^(1/2)
///
/// In white noise that happens to one series in a hundred, and makes errors smaller by less than 1 % on average.
///
/// Fluctuations that are slow but small are hidden below the noise of fast ones at that level: in a gas, the
/// fluctuations of bound pairs below the noise of collisions. So longer blocks are looked at, too, as long as there are
/// 32. If their error e_l is larger by more than its scatter explains, the largest such one is reported:
///
///     e_l > e_k (1 + 1.5 (u_l^2 - u_k^2)^(1/2))
///
/// In white noise that happens to one or two series in ten, and makes errors larger by 2 to 3 % on average.
/// Fluctuations that are slower than a thirtieth of the series stay hidden. If no level satisfies the condition, the
/// error is the largest e_k of the levels with at least 4 blocks. Then `converged` says whether it is reliable. It is
/// if there are at least 16 independent samples, and if e_k grows by at most a factor of 1.3 at the longest blocks of
/// which there are 16 (where blocks are shorter than correlations it grows by sqrt(2)). A constant series has the error
/// 0.
///
/// Test with many autoregressive series, white or with correlation times up to 100 samples: the scatter of the means is
/// 0.85 to 1.2 times the converged errors where there are at least 25 independent samples, 1.25 times with 16. With a
/// slow part of 30 % to 85 % of the variance of the mean it is 0.98 to 1.03 times the errors where the series has at
/// least 300 of its correlation times, 1.05 to 1.16 times where it has 100, up to 1.4 times where it has 40. With 50
/// independent samples 97 to 99 % of the series count as converged, with 16 half, with 10 at most three in ten, with 5
/// one in twenty.
///
/// Memory: 24 width bytes for each doubling of n, or 4 width (width + 5) with Covariance::full. Means are pairwise
/// sums, whose round-off grows like log n. A sample that is not finite makes mean and error of its component NaN.
/// Sources: Flyvbjerg and Petersen (1989), doi:10.1063/1.457480; choice of the level: Lee et al. (2011),
/// doi:10.1103/PhysRevE.83.066706.
class BlockingAccumulator {
  public:
    /// @param width  number of components of a sample
    /// @throws InputError if width < 1
    BlockingAccumulator(Index width, Covariance covariance);

    /// Add the next sample of the series. @throws InputError unless it has `width` components
    void add(const Eigen::VectorXd& sample);

    /// Memory of the averages of `samples` samples, also in a checkpoint: the largest on the way to them [bytes].
    [[nodiscard]] static double bytes(Index width, Covariance covariance, Index samples);

    [[nodiscard]] Index width() const { return width_; }
    [[nodiscard]] Index samples() const;

    /// Means of all components; NaN without samples.
    [[nodiscard]] Eigen::VectorXd mean() const;

    /// Mean and error of one component. @throws InputError unless 0 <= component < width
    [[nodiscard]] Estimate estimate(Index component) const;

    /// Estimate of a function f of the means by the delta method: the error is taken from the series g . x with g =
    /// df/dmean at the means. For ratios such as Z = p / (rho T). f must be smooth over a few standard errors.
    ///
    /// Its parts are the components with g != 0 that contribute more than a tenth of the error. There are none where
    /// more than 8 have g != 0: such sums, of shells or layers, are series of their own. What is slow in one of them
    /// may be hidden in g . x. So errors of all blocks up to the longest that a part needs are looked at, and the
    /// largest is reported. It is a guess if the error of a part is one.
    ///
    /// @param value     f(mean)
    /// @param gradient  df/dmean, `width` components
    /// @param more      components that count as parts as well, because what is slow in f shows in them
    /// @throws InputError with Covariance::diagonal, or for a wrong number of components
    [[nodiscard]] Estimate estimate(double value, const Eigen::VectorXd& gradient,
                                    const std::vector<Index>& more = {}) const;

    /// Blocking curve of one component: its levels with at least 2 blocks, shortest blocks first.
    /// @throws InputError unless 0 <= component < width
    [[nodiscard]] std::vector<BlockLevel> levels(Index component) const;

    /// Covariances of all components with this one, over all samples; not a number with fewer than 2.
    /// @throws InputError with Covariance::diagonal, or unless 0 <= component < width
    [[nodiscard]] Eigen::VectorXd covariances(Index component) const;

    /// @throws CheckpointError for averages of another width
    void archive(Archive& a);

  private:
    struct Level {
        Index blocks = 0;
        Eigen::VectorXd mean;       // running mean over the blocks
        Eigen::VectorXd deviation;  // running sum of squared deviations (products with Covariance::full)
        Eigen::VectorXd pending;    // the block that waits for its partner, if `blocks` is odd

        void archive(Archive& a) { a(blocks, mean, deviation, pending); }
    };

    /// Number of products of deviations that are kept: one per component, or with Covariance::full the lower triangle
    /// of their matrix, column by column from the diagonal down.
    [[nodiscard]] static Index products(Index width, Covariance covariance);
    [[nodiscard]] Index kept_products() const { return products(width_, covariance_); }
    [[nodiscard]] Index diagonal(Index component) const;  ///< index of its variance among the products

    /// Means of `count` components from `first` on.
    [[nodiscard]] Eigen::VectorXd mean_of(Index first, Index count) const;
    void accumulate(Level& level, const Eigen::VectorXd& block) const;
    void check(Index component) const;
    template <class Deviation>
    [[nodiscard]] std::vector<BlockLevel> curve(Deviation deviation) const;

    Index width_;
    Covariance covariance_;
    std::vector<Level> levels_;
};

}  // namespace ljmd
