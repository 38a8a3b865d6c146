#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace ljmd {

/// Mistakes that may explain a difference: each is offered with the distance that is left when it is assumed. The one
/// that leaves least is the explanation, if it leaves little enough; what is left below the noise counts as nothing, so
/// of several that explain all the first wins.
class Explanations {
  public:
    /// @param off    distance of what was found from what is right
    /// @param noise  distances up to it are none
    /// @param unexplained  part of `off` that an explanation may leave
    Explanations(double off, double noise, double unexplained)
        : off_(off), noise_(noise), most_(std::max(noise, unexplained * off)) {}

    [[nodiscard]] bool is_wrong() const { return !(off_ <= noise_); }

    void offer(double left, std::string words) {
        const double counted = std::max(left, noise_);
        if (left <= most_ && (!best_ || counted < least_)) {
            least_ = counted;
            best_ = std::move(words);
        }
    }

    /// The words of the explanation; nothing if there is no difference, or none that explains it.
    [[nodiscard]] std::optional<std::string> best() const { return is_wrong() ? best_ : std::nullopt; }
    [[nodiscard]] double least() const { return least_; }  ///< what it leaves

  private:
    double off_;
    double noise_;
    double most_;
    double least_ = 0.0;
    std::optional<std::string> best_;
};

}  // namespace ljmd
