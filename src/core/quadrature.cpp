#include "core/quadrature.hpp"

#include <fmt/format.h>
#include <gsl/gsl_integration.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/gsl_function.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

constexpr std::size_t max_intervals = 1000;
constexpr double absolute_error = 1e-15;
constexpr double relative_error = 1e-12;
constexpr double round_off_allowance = 1000.0;

}  // namespace

double integrate(const std::function<double(double)>& f, double a, double b) {
    GslFunction function(f);
    const std::unique_ptr<gsl_integration_workspace, decltype(&gsl_integration_workspace_free)> workspace(
        gsl_integration_workspace_alloc(max_intervals), gsl_integration_workspace_free);
    double result = 0.0;
    double error = 0.0;
    const int status = std::isinf(b)
                           ? gsl_integration_qagiu(function.get(), a, absolute_error, relative_error, max_intervals,
                                                   workspace.get(), &result, &error)
                           : gsl_integration_qag(function.get(), a, b, absolute_error, relative_error, max_intervals,
                                                 GSL_INTEG_GAUSS31, workspace.get(), &result, &error);
    // GSL reports round-off when bisection no longer helps. If the error is nearly the requested one, that is machine
    // precision and good enough; if it is large, the integral oscillates or diverges.
    const double tolerable = round_off_allowance * std::max(absolute_error, relative_error * std::abs(result));
    const bool converged = status == GSL_SUCCESS || (status == GSL_EROUND && error <= tolerable);
    if (!converged || !std::isfinite(result)) {
        throw PhysicsError(fmt::format("an integral from {} to {} does not converge: {}", a, b, gsl_strerror(status)));
    }
    return result;
}

}  // namespace ljmd
