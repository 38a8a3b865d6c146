#pragma once

#include <string>

#include "ljmd/detail/core/data.hpp"

namespace ljmd {

/// As to_json(), but zeros keep their sign: for files whose doubles are to come back with all their bits.
[[nodiscard]] std::string to_exact_json(const Data& data);

}  // namespace ljmd
