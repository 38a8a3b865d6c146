#include "core/gsl_errors.hpp"

#include <gsl/gsl_errno.h>

#include <mutex>

namespace ljmd {

namespace {

std::mutex guard;
int living = 0;
gsl_error_handler_t* handler_of_program = nullptr;

}  // namespace

GslErrorCodes::GslErrorCodes() {
    const std::scoped_lock lock(guard);
    if (living++ == 0) {
        handler_of_program = gsl_set_error_handler_off();
    }
}

GslErrorCodes::~GslErrorCodes() {
    const std::scoped_lock lock(guard);
    if (--living == 0) {
        gsl_set_error_handler(handler_of_program);
    }
}

}  // namespace ljmd
