#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "neighbors/row_shape.hpp"

namespace ljmd {

/// Points among which neighbours are searched, cluster after cluster, in units of FixedPoint. Rounding them to single
/// precision moves each coordinate by at most 16 units.
template <class Real, class Integer>
struct PointArrays {
    Real* x;
    Real* y;
    Real* z;
    Integer* entry;  ///< list entry of the cluster part that the point belongs to
};
using Candidates = PointArrays<float, std::int32_t>;
using ConstCandidates = PointArrays<const float, const std::int32_t>;

/// x of a point without an atom, farther away than any cutoff.
inline constexpr float nowhere = 0x1p60F;

/// Atoms that share a list, in units of FixedPoint. Rows with fewer atoms are filled up with points out of range.
struct RowOfAtoms {
    RowShape shape;
    float x[4] = {-nowhere, -nowhere, -nowhere, -nowhere};
    float y[4] = {};
    float z[4] = {};
};

/// Kernels read and write whole vectors, so arrays have this many elements after the requested ones.
inline constexpr int list_kernel_slack = 16;

/// Storage for candidates, with the slack behind them.
class CandidateArrays {
  public:
    void resize(std::size_t size) {
        size_ = size;
        for (auto& coordinate : coordinates_) {
            coordinate.resize(size + list_kernel_slack);
        }
        entry_.resize(size + list_kernel_slack);
    }
    [[nodiscard]] std::size_t size() const { return size_; }

    [[nodiscard]] Candidates write() {
        return {coordinates_[0].data(), coordinates_[1].data(), coordinates_[2].data(), entry_.data()};
    }
    [[nodiscard]] ConstCandidates read() const {
        return {coordinates_[0].data(), coordinates_[1].data(), coordinates_[2].data(), entry_.data()};
    }

  private:
    std::size_t size_ = 0;
    std::array<std::vector<float>, 3> coordinates_;
    std::vector<std::int32_t> entry_;
};

}  // namespace ljmd
