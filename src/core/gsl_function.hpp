#pragma once

#include <gsl/gsl_errno.h>
#include <gsl/gsl_math.h>

#include <functional>

#include "core/gsl_errors.hpp"

namespace ljmd {

/// A function of one variable in GSL's form. While it lives, GSL returns errors as codes.
class GslFunction {
  public:
    explicit GslFunction(const std::function<double(double)>& f) : f_(f), function_{&call, &f_} {}
    GslFunction(const GslFunction&) = delete;
    GslFunction& operator=(const GslFunction&) = delete;

    [[nodiscard]] gsl_function* get() { return &function_; }

  private:
    static double call(double x, void* f) { return (*static_cast<const std::function<double(double)>*>(f))(x); }

    GslErrorCodes codes_;
    std::function<double(double)> f_;
    gsl_function function_;
};

}  // namespace ljmd
