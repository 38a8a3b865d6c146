#include "core/gsl_errors.hpp"

#include <gsl/gsl_errno.h>

#include <cmath>
#include "catch.hpp"

#include "core/quadrature.hpp"
#include "core/roots.hpp"
#include "ljmd/core/errors.hpp"

using namespace ljmd;

namespace {

int calls = 0;

void handler_of_program(const char* /*reason*/, const char* /*file*/, int /*line*/, int /*code*/) {
    ++calls;
}

/// The handler that GSL has now.
gsl_error_handler_t* handler_now() {
    gsl_error_handler_t* now = gsl_set_error_handler_off();
    gsl_set_error_handler(now);
    return now;
}

}  // namespace

TEST_CASE("a program keeps its handler of GSL's errors, which none of ours reaches") {
    gsl_error_handler_t* const before = gsl_set_error_handler(&handler_of_program);
    calls = 0;
    {
        const GslErrorCodes outer;
        CHECK(handler_now() != &handler_of_program);
        { const GslErrorCodes inner; }
        CHECK(handler_now() != &handler_of_program);
    }
    CHECK(handler_now() == &handler_of_program);
    CHECK(find_root([](double x) { return x - 0.5; }, 0.0, 1.0) == Approx(0.5));
    CHECK_THROWS_AS(find_root([](double x) { return x * x + 1.0; }, -1.0, 1.0), PhysicsError);
    CHECK_THROWS_AS(integrate([](double x) { return 1.0 / x; }, 0.0, 1.0), PhysicsError);
    CHECK(handler_now() == &handler_of_program);
    CHECK(calls == 0);
    gsl_set_error_handler(before);
}
