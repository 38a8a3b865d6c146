#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <functional>
#include <vector>

#include "ljmd/core/types.hpp"
#include "ljmd/detail/core/archive.hpp"

namespace ljmd {

/// The means of at most 64 consecutive blocks of a vector-valued series, for a jackknife over them. Blocks are as long
/// as they have to be: when there are 64, each two become one.
///
/// With B blocks, and f_b the function of the means of all blocks but the b-th, the standard error is
///
///     e^2 = (B - 1)/B * sum over b of (f_b - mean of f_b)^2
///
/// It is valid for smooth functions and for correlations shorter than the blocks, of which there are 32 or more in a
/// long series. These blocks are long enough to include a slow process hidden below fast noise, for which
/// BlockingAccumulator can choose blocks that are too short. It is known to 1/(2 (B - 1))^(1/2), 9 to 13 %. Source:
/// Efron (1982), The Jackknife, the Bootstrap and Other Resampling Plans, chapter 3
class JackknifeBlocks {
  public:
    explicit JackknifeBlocks(Index width) : width_(width), pending_(Eigen::VectorXd::Zero(width)) {}

    /// @pre the sample has `width` components
    void add(const Eigen::VectorXd& sample);

    /// Samples in complete blocks.
    [[nodiscard]] Index samples() const { return length_ * static_cast<Index>(means_.size()); }

    [[nodiscard]] Index blocks() const { return static_cast<Index>(means_.size()); }

    /// Means over complete blocks, which errors() has the errors of. @pre samples() > 0
    [[nodiscard]] Eigen::VectorXd mean() const { return sum() / static_cast<double>(means_.size()); }

    /// Standard errors of the components of a function of the means; NaN with fewer than 16 blocks.
    /// @param function  of the means, `width` components; returns the same number of components whenever it is called
    /// @param shared  s: samples that are n < s apart share data and have the correlation 1 - n/s. The length L of the
    ///        blocks is then at least 2 s. Neighbouring blocks share data, too, which hides the part s/(3 L) of the
    ///        variance of the mean; this part is added
    [[nodiscard]] Eigen::VectorXd errors(const std::function<Eigen::VectorXd(const Eigen::VectorXd& means)>& function,
                                         Index shared = 0) const;

    /// Memory of the blocks of so many samples, or of any number, also in a checkpoint [bytes].
    [[nodiscard]] static double bytes(Index width, Index samples = 64) {
        return 8.0 * static_cast<double>(std::min(samples, Index{64}) + 1) * static_cast<double>(width);
    }

    /// @throws CheckpointError for blocks of another width
    void archive(Archive& a);

  private:
    [[nodiscard]] Eigen::VectorXd sum() const;                                   ///< of the means of blocks
    [[nodiscard]] std::vector<Eigen::VectorXd> joined(std::size_t count) const;  ///< means of so many blocks each

    Index width_;
    Index length_ = 1;     ///< samples of a block
    Index collected_ = 0;  ///< samples in the block that is not complete
    Eigen::VectorXd pending_;
    std::vector<Eigen::VectorXd> means_;
};

}  // namespace ljmd
