#pragma once

#include <string>

namespace ljmd {

/// "0.2709(46)": a value with its standard error in units of the last digits, of which the error has two. Shorter than
/// with_error(). If the error is 0 or not known, the value alone with four decimals.
[[nodiscard]] std::string with_error_in_brackets(double mean, double standard_error);

}  // namespace ljmd
