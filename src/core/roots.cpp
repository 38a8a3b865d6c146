#include "core/roots.hpp"

#include <fmt/format.h>
#include <gsl/gsl_roots.h>

#include <algorithm>
#include <limits>
#include <memory>

#include "core/gsl_function.hpp"
#include "ljmd/core/errors.hpp"

namespace ljmd {

namespace {

constexpr int max_iterations = 200;
constexpr double smallest_width = std::numeric_limits<double>::min();  // so that a root at zero is found exactly, too
constexpr double relative_width = 4.0 * std::numeric_limits<double>::epsilon();

}  // namespace

double find_root(const std::function<double(double)>& f, double a, double b) {
    GslFunction function(f);
    const std::unique_ptr<gsl_root_fsolver, decltype(&gsl_root_fsolver_free)> solver(
        gsl_root_fsolver_alloc(gsl_root_fsolver_brent), gsl_root_fsolver_free);
    int status = gsl_root_fsolver_set(solver.get(), function.get(), std::min(a, b), std::max(a, b));
    for (int iteration = 0; status == GSL_SUCCESS && iteration < max_iterations; ++iteration) {
        status = gsl_root_fsolver_iterate(solver.get());
        const double lower = gsl_root_fsolver_x_lower(solver.get());
        const double upper = gsl_root_fsolver_x_upper(solver.get());
        if (status == GSL_SUCCESS &&
            gsl_root_test_interval(lower, upper, smallest_width, relative_width) == GSL_SUCCESS) {
            return gsl_root_fsolver_root(solver.get());
        }
    }
    throw PhysicsError(fmt::format("no root is found between {} and {}: {}", a, b,
                                   status == GSL_SUCCESS ? "too many iterations" : gsl_strerror(status)));
}

}  // namespace ljmd
