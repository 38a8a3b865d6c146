#pragma once

#include <algorithm>
#include <vector>

#include "ljmd/detail/options/diagnostics.hpp"

namespace ljmd::test {

/// How many of what is complained of are errors, not warnings.
inline std::ptrdiff_t errors_in(const std::vector<Diagnostic>& complaints) {
    return std::ranges::count(complaints, Severity::error, &Diagnostic::severity);
}

}  // namespace ljmd::test
