#pragma once

#include <optional>

#include "ljmd/core/types.hpp"
#include "ljmd/detail/core/archive.hpp"
#include "ljmd/detail/core/archived_count.hpp"

namespace ljmd {

/// Streaming least-squares slope of y against t, such as the energy drift over a stage [epsilon/tau].
///
///     slope = sum (t - <t>)(y - <y>) / sum (t - <t>)^2
///
/// Sums are kept about the running means (Welford), so that large offsets of t and y cost no digits of the slope.
/// Source: B. P. Welford (1962), doi:10.1080/00401706.1962.10490022
class LinearTrend {
  public:
    /// Add one point. @pre both finite
    void add(double t, double y);

    [[nodiscard]] Index samples() const { return samples_; }

    /// Empty if no line is defined: fewer than 2 points, or all at the same t.
    [[nodiscard]] std::optional<double> slope() const;

    void archive(Archive& a) {
        a(samples_, mean_t_, mean_y_, deviation_tt_, deviation_ty_);
        require_count(samples_);
    }

  private:
    Index samples_ = 0;
    double mean_t_ = 0.0;
    double mean_y_ = 0.0;
    double deviation_tt_ = 0.0;
    double deviation_ty_ = 0.0;
};

}  // namespace ljmd
