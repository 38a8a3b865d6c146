#pragma once

#include <optional>

#include "ljmd/core/archive.hpp"

namespace ljmd {

/// Where a quantity sampled once a step changes sign, a sample that is exactly zero included.
///
/// A zero counts as a change when the signs before and after it differ, or when the series begins with it; it is told
/// one sample later, when the sign after it is known. A series of zeros changes nothing.
class SignChanges {
  public:
    enum class Place {
        nowhere,
        at_last_sample,  ///< the sample before this one is the zero
        within_step      ///< between the sample before and this one
    };

    /// @param sign  of the next sample: -1, 0 or 1
    Place next(int sign) {
        Place place = Place::nowhere;
        if (last_ && sign != 0 && sign != side_) {
            place = *last_ == 0 ? Place::at_last_sample : Place::within_step;
        }
        last_ = sign;
        side_ = sign != 0 ? sign : side_;
        return place;
    }

    /// A sample was told.
    [[nodiscard]] bool begun() const { return last_.has_value(); }

    void archive(Archive& a) { a(side_, last_); }

  private:
    int side_ = 0;  // the latest sign that was not zero
    std::optional<int> last_;
};

}  // namespace ljmd
