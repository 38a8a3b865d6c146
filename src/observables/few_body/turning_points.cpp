#include "observables/few_body/turning_points.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <numbers>

#include "ljmd/core/errors.hpp"
#include "observables/statistics/hermite.hpp"

namespace ljmd {

namespace {

constexpr double rounding = 1e-12;  // angles smaller than this count as zero
constexpr double turn = 2.0 * std::numbers::pi;

/// Sign of dr^2/dt, 0 at an apsis.
int radial_sign(const Vec3& r, const Vec3& v) {
    const double product = r.dot(v);
    const double smallest = rounding * r.norm() * v.norm();
    return product > smallest ? 1 : product < -smallest ? -1 : 0;
}

}  // namespace

void TurningPoints::add(double time, const Vec3& r, const Vec3& v) {
    if (!last_) {
        set_plane(r, v);
    }
    add(Sample{time, r, v, angle_of(r, last_ ? last_->angle : 0.0), std::nullopt});
}

void TurningPoints::add_radial(double time, double rho, double rho_rate, double angle, double angle_rate) {
    add(Sample{time, Vec3(rho, 0.0, 0.0), Vec3(rho_rate, 0.0, 0.0), angle, angle_rate});
}

void TurningPoints::add(const Sample& now) {
    if (last_ && !(now.time > last_->time)) {
        throw ContractViolation(
            fmt::format("samples of an orbit must follow in time: {} came after {}", now.time, last_->time));
    }
    const int sign = radial_sign(now.r, now.v);
    const SignChanges::Place place = changes_.next(sign);
    const Apsis kind = sign > 0 ? Apsis::pericentre : Apsis::apocentre;
    if (place == SignChanges::Place::at_last_sample) {
        const double distance = last_->r.norm();
        const double speed = std::hypot(last_->v.norm(), distance * last_->angle_rate.value_or(0.0));
        passages_.push_back({kind, last_->time, distance, last_->angle, (now.time - last_->time) * speed});
    } else if (place == SignChanges::Place::within_step) {
        passages_.push_back(passage_within_step(kind, now));
    }
    last_ = now;
}

void TurningPoints::archive(Archive& a, double now) {
    a(last_, changes_, axis_, forward_, passages_);
    if (last_.has_value() != changes_.begun() || (last_ && !(last_->time <= now))) {
        throw CheckpointError("its orbit was sampled at other times");
    }
}

void TurningPoints::set_plane(const Vec3& r, const Vec3& v) {
    const Vec3 normal = r.cross(v);
    axis_ = r.normalized();
    if (normal.norm() > rounding * r.norm() * v.norm()) {
        forward_ = normal.cross(r).normalized();
    } else {
        forward_.setConstant(std::numeric_limits<double>::quiet_NaN());  // on a line there is no direction to turn to
    }
}

/// Angle of r, as a continuation of a nearby one: they differ by less than half a turn.
double TurningPoints::angle_of(const Vec3& r, double nearby) const {
    const double principal = std::atan2(r.dot(forward_), r.dot(axis_));
    return principal + turn * std::round((nearby - principal) / turn);
}

Passage TurningPoints::passage_within_step(Apsis kind, const Sample& now) const {
    const double length = now.time - last_->time;
    const HermiteStep<Vec3> orbit{last_->time, length, last_->r, last_->v, now.r, now.v};
    const double s = root_in_step([&](double x) { return orbit.value(x).dot(orbit.rate(x)); });
    const Vec3 r = orbit.value(s);
    double angle = 0.0;
    double speed = orbit.rate(s).norm();
    if (now.angle_rate && last_->angle_rate) {
        const HermiteStep<double> turning{last_->time,        length,    last_->angle,
                                          *last_->angle_rate, now.angle, *now.angle_rate};
        angle = turning.value(s);
        speed = std::hypot(speed, r.norm() * turning.rate(s));
    } else {
        angle = angle_of(r, last_->angle);
    }
    return {kind, orbit.time(s), r.norm(), angle, length * speed};
}

std::optional<IntervalMean> TurningPoints::mean_over_kinds(double Passage::*mark) const {
    std::vector<double> pericentres;
    std::vector<double> apocentres;
    for (const Passage& passage : passages_) {
        (passage.kind == Apsis::pericentre ? pericentres : apocentres).push_back(passage.*mark);
    }
    return better_known(mean_interval(pericentres), mean_interval(apocentres));
}

std::optional<IntervalMean> TurningPoints::period() const {
    return mean_over_kinds(&Passage::time);
}

std::optional<IntervalMean> TurningPoints::precession() const {
    auto swept = mean_over_kinds(&Passage::angle);
    if (!swept || !(std::abs(swept->mean) > 0.0)) {
        return std::nullopt;
    }
    swept->mean = std::abs(swept->mean) - turn;  // a caller's angle may decrease
    return swept;
}

}  // namespace ljmd
