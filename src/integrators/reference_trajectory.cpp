#include "integrators/reference_trajectory.hpp"

#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <cmath>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "core/gsl_errors.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

/// Parts of a step of the method between which the solution is shown, because a step of order 8 may turn by as much as
/// a third of a radian. Steps that the next one may exceed by `much_longer`, as those at the start, are short enough.
constexpr int parts = 8;
constexpr double much_longer = 4.0;

}  // namespace

/// y holds the positions by id, then the velocities by id, because force fields may reorder bodies in memory.
class ReferenceTrajectory::Integration {
  public:
    Integration(const State& start, ForceField& force, double tolerance)
        : state_(start),
          force_(force),
          size_(3 * static_cast<std::size_t>(start.count())),
          y_(2 * size_),
          origin_(start.time),
          system_{&Integration::call, nullptr, y_.size(), this} {
        const GslErrorCodes codes;
        const double any_step = 1.0;  // replaced by set_step() before it is used
        driver_.reset(gsl_odeiv2_driver_alloc_y_new(&system_, gsl_odeiv2_step_rk8pd, any_step, tolerance, tolerance));
        inner_method_.reset(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, y_.size()));
        if (!driver_ || !inner_method_) {
            throw std::bad_alloc();
        }
        for (std::size_t i = 0; i < state_.ids().size(); ++i) {
            Map(y_.data() + place(i)) = start.positions().col(static_cast<Index>(i));
            Map(y_.data() + size_ + place(i)) = start.velocities().col(static_cast<Index>(i));
        }
    }

    const State& advance_to(double time) {
        if (time != state_.time) {
            advance(time - origin_, {});
            state_.time = time;
        }
        return state_;
    }

    const State& advance_by(double span, const StateWatch& within) {
        if (span != 0.0) {
            advance(elapsed_ + span, within);
        }
        return state_;
    }

    [[nodiscard]] Index steps() const { return steps_; }

  private:
    using Map = Eigen::Map<Vec3>;
    using ConstMap = Eigen::Map<const Vec3>;

    struct FreeDriver {
        void operator()(gsl_odeiv2_driver* driver) const { gsl_odeiv2_driver_free(driver); }
    };
    struct FreeStep {
        void operator()(gsl_odeiv2_step* step) const { gsl_odeiv2_step_free(step); }
    };

    /// @param end  time since the origin
    void advance(double end, const StateWatch& within) {
        const GslErrorCodes codes;
        set_step(end - elapsed_);
        const int status = step_to(end, within);
        show(y_, elapsed_);
        if (status != GSL_SUCCESS) {
            report(status, end);
        }
    }

    /// As gsl_odeiv2_driver_apply(), but shows every step. @return GSL's code
    int step_to(double end, const StateWatch& within) {
        gsl_odeiv2_driver& driver = *driver_;
        const double sign = std::copysign(1.0, driver.h);
        while (sign * (end - elapsed_) > 0.0) {
            const double begin = elapsed_;
            if (within) {
                before_ = y_;
            }
            const int status =
                gsl_odeiv2_evolve_apply(driver.e, driver.c, driver.s, driver.sys, &elapsed_, end, &driver.h, y_.data());
            if (status != GSL_SUCCESS) {
                return status;
            }
            ++steps_;
            if (within && std::abs(driver.h) < much_longer * std::abs(elapsed_ - begin)) {
                look_inside(begin, within);
            }
            if (within && elapsed_ != end) {
                show(y_, elapsed_);
                within(state_);
            }
        }
        return GSL_SUCCESS;
    }

    /// Show points inside the step from before_ to y_. They are reached by shorter steps from its beginning; points at
    /// which the forces have no value are left out.
    void look_inside(double begin, const StateWatch& within) {
        for (int part = 1; part < parts; ++part) {
            const double length = (elapsed_ - begin) * part / parts;
            inner_ = before_;
            if (gsl_odeiv2_step_apply(inner_method_.get(), begin, length, inner_.data(), error_.data(), nullptr,
                                      nullptr, &system_) == GSL_SUCCESS) {
                show(inner_, begin + length);
                within(state_);
            }
        }
    }

    /// Index in y of the position of the body at index i; its velocity follows size_ later.
    [[nodiscard]] std::size_t place(std::size_t i) const { return 3 * static_cast<std::size_t>(state_.ids()[i]); }

    /// The first step is chosen far too short rather than too long: steps grow fast, and a long one may leap over
    /// events.
    void set_step(double span) {
        if (steps_ == 0) {
            gsl_odeiv2_driver_reset_hstart(driver_.get(), 1e-6 * span);
        } else if (std::signbit(driver_->h) != std::signbit(span)) {
            gsl_odeiv2_driver_reset_hstart(driver_.get(), -driver_->h);
        }
    }

    /// GSL is C code, through which no exception may pass. After a failure GSL halves the step as long as that changes
    /// the time, so only the last exception counts.
    static int call(double, const double* y, double* derivative, void* self) {
        auto& integration = *static_cast<Integration*>(self);
        integration.trouble_ = nullptr;
        try {
            integration.differentiate(y, derivative);
            return GSL_SUCCESS;
        } catch (...) {
            integration.trouble_ = std::current_exception();
            return GSL_FAILURE;
        }
    }

    void differentiate(const double* y, double* derivative) {
        for (std::size_t i = 0; i < state_.ids().size(); ++i) {
            state_.write_positions().col(static_cast<Index>(i)) = ConstMap(y + place(i));
        }
        force_.evaluate(state_, Request::forces);
        for (std::size_t i = 0; i < state_.ids().size(); ++i) {
            Map velocity(derivative + place(i));
            Map acceleration(derivative + size_ + place(i));
            velocity = ConstMap(y + size_ + place(i));
            acceleration = static_cast<const State&>(state_).forces().col(static_cast<Index>(i)) / state_.masses()[i];
            // For GSL's choice of the step, NaN would count as a small error.
            if (!velocity.allFinite() || !acceleration.allFinite()) {
                throw PhysicsError(
                    fmt::format("velocity or acceleration of body {} is not finite", state_.ids()[i] + 1));
            }
        }
    }

    /// Copy y into state_. @param elapsed  time since the origin
    void show(const std::vector<double>& y, double elapsed) {
        for (std::size_t i = 0; i < state_.ids().size(); ++i) {
            state_.write_positions().col(static_cast<Index>(i)) = ConstMap(y.data() + place(i));
            state_.write_velocities().col(static_cast<Index>(i)) = ConstMap(y.data() + size_ + place(i));
        }
        state_.time = origin_ + elapsed;
    }

    [[noreturn]] void report(int status, double end) const {
        std::string reason = status == GSL_FAILURE ? "bodies collide, or the tolerance asks for more than doubles hold"
                                                   : gsl_strerror(status);
        try {
            if (trouble_) {
                std::rethrow_exception(trouble_);
            }
        } catch (const PhysicsError& error) {
            reason = error.what();
        }
        throw PhysicsError(
            fmt::format("the solution ends at time {}, before {}: {}", state_.time, origin_ + end, reason));
    }

    State state_;
    ForceField& force_;
    std::size_t size_;  // number of position coordinates in y
    std::vector<double> y_;
    std::vector<double> before_ = y_;  // y at the beginning of a step whose inside is shown
    std::vector<double> inner_ = y_;
    std::vector<double> error_ = y_;
    double origin_;         // time of the start
    double elapsed_ = 0.0;  // time since the origin
    gsl_odeiv2_system system_;
    std::unique_ptr<gsl_odeiv2_driver, FreeDriver> driver_;
    std::unique_ptr<gsl_odeiv2_step, FreeStep> inner_method_;
    std::exception_ptr trouble_;  // exception of the last evaluation
    Index steps_ = 0;
};

ReferenceTrajectory::ReferenceTrajectory(const State& start, ForceField& force, double tolerance) {
    if (start.has_box() || start.count() == 0) {
        throw ContractViolation("a reference solution needs bodies in unbounded space");
    }
    if (!(tolerance > 0.0 && tolerance < 1.0)) {
        throw ContractViolation(fmt::format("a tolerance of {}; allowed: > 0, < 1", tolerance));
    }
    integration_ = std::make_unique<Integration>(start, force, tolerance);
}

ReferenceTrajectory::~ReferenceTrajectory() = default;

const State& ReferenceTrajectory::advance_to(double time) {
    if (!std::isfinite(time)) {
        throw ContractViolation(fmt::format("a reference solution at time {}", time));
    }
    return integration_->advance_to(time);
}

const State& ReferenceTrajectory::advance_by(double span, const StateWatch& within) {
    if (!std::isfinite(span)) {
        throw ContractViolation(fmt::format("a reference solution over a time of {}", span));
    }
    return integration_->advance_by(span, within);
}

Index ReferenceTrajectory::steps_taken() const {
    return integration_->steps();
}

}  // namespace ljmd
