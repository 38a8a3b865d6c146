#include "observables/few_body/zero_crossings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ljmd/core/errors.hpp"
#include "observables/statistics/hermite.hpp"

namespace ljmd {

void ZeroCrossings::add(double time, double x, double rate) {
    if (last_ && !(time > last_->time)) {
        throw ContractViolation(
            fmt::format("samples of a coordinate must follow in time: {} came after {}", time, last_->time));
    }
    const SignChanges::Place place = changes_.next(x > 0.0 ? 1 : x < 0.0 ? -1 : 0);
    const Direction direction = x > 0.0 ? Direction::upward : Direction::downward;
    amplitude_ = std::max(amplitude_, std::abs(x));
    if (last_) {
        const HermiteStep<double> path{last_->time, time - last_->time, last_->x, last_->rate, x, rate};
        if (place == SignChanges::Place::at_last_sample) {
            crossings_.push_back({direction, last_->time});
        } else if (place == SignChanges::Place::within_step) {
            crossings_.push_back({direction, path.time(root_in_step([&](double s) { return path.value(s); }))});
        }
        if (last_->rate * rate < 0.0) {
            const double extreme = path.value(root_in_step([&](double s) { return path.rate(s); }));
            amplitude_ = std::max(amplitude_, std::abs(extreme));
        }
    }
    last_ = {time, x, rate};
}

void ZeroCrossings::archive(Archive& a, double now) {
    a(last_, changes_, crossings_, amplitude_);
    if (last_.has_value() != changes_.begun() || (last_ && !(last_->time <= now))) {
        throw CheckpointError("its oscillation was sampled at other times");
    }
}

std::optional<IntervalMean> ZeroCrossings::period() const {
    std::vector<double> upward;
    std::vector<double> downward;
    for (const ZeroCrossing& crossing : crossings_) {
        (crossing.direction == Direction::upward ? upward : downward).push_back(crossing.time);
    }
    return better_known(mean_interval(upward), mean_interval(downward));
}

}  // namespace ljmd
