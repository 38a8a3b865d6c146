#include "observables/statistics/linear_trend.hpp"

namespace ljmd {

void LinearTrend::add(double t, double y) {
    samples_ += 1;
    const double n = static_cast<double>(samples_);
    const double step_t = t - mean_t_;
    const double step_y = y - mean_y_;
    mean_t_ += step_t / n;
    mean_y_ += step_y / n;
    deviation_tt_ += (n - 1.0) / n * step_t * step_t;
    deviation_ty_ += (n - 1.0) / n * step_t * step_y;
}

std::optional<double> LinearTrend::slope() const {
    if (deviation_tt_ == 0.0) {
        return std::nullopt;
    }
    return deviation_ty_ / deviation_tt_;
}

}  // namespace ljmd
