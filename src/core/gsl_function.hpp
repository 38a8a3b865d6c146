#pragma once

#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>

#include <functional>

namespace ljmd {

/// A function of one variable as GSL takes it. From the first one on errors of GSL come back as codes: its own handler
/// would abort the program.
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
