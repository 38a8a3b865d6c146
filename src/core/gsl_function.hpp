#pragma once

#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>

#include <functional>

namespace ljmd {

/// A function of one variable in GSL's form. Its constructor turns off GSL's error handler, which would abort the
/// program, so that errors are returned as codes.
class GslFunction {
  public:
    explicit GslFunction(const std::function<double(double)>& f) : f_(f), function_{&call, &f_} {
        gsl_set_error_handler_off();
    }
    GslFunction(const GslFunction&) = delete;
    GslFunction& operator=(const GslFunction&) = delete;

    [[nodiscard]] gsl_function* get() { return &function_; }

  private:
    static double call(double x, void* f) { return (*static_cast<const std::function<double(double)>*>(f))(x); }

    std::function<double(double)> f_;
    gsl_function function_;
};

}  // namespace ljmd
