#pragma once

#include <optional>

#include "ljmd/detail/core/archive.hpp"

namespace ljmd {

/// Finds sign changes of a quantity that is sampled once per step, including samples that are exactly zero.
///
/// A zero counts as a sign change if the signs before and after it differ, or if the series begins with it. It is
/// reported one sample later, when the sign after it is known. A series of zeros has no sign changes.
class SignChanges {
  public:
    enum class Place {
        nowhere,
        at_last_sample,  ///< the previous sample is the zero
        within_step      ///< between the previous sample and this one
    };

    /// Add the next sample. @param sign  -1, 0 or 1
    Place next(int sign) {
        Place place = Place::nowhere;
        if (last_ && sign != 0 && sign != side_) {
            place = *last_ == 0 ? Place::at_last_sample : Place::within_step;
        }
        last_ = sign;
        side_ = sign != 0 ? sign : side_;
        return place;
    }

    /// Whether there have been samples.
    [[nodiscard]] bool begun() const { return last_.has_value(); }

    void archive(Archive& a) { a(side_, last_); }

  private:
    int side_ = 0;  // last sign other than zero
    std::optional<int> last_;
};

}  // namespace ljmd
