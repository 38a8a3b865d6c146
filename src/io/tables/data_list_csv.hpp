#pragma once

#include <string>

#include "ljmd/detail/core/data.hpp"

namespace ljmd {

/// A list of objects as CSV: a column for each key, in the order in which keys appear first. A member that is an object
/// has a column OBJECT_KEY for each of its keys; a list of texts is one field, separated by "; "; other lists are left
/// out. A key that an object lacks, or whose value is null, is an empty field.
/// @throws WrongData  if it is no list of objects
[[nodiscard]] std::string data_list_csv(const Data& objects);

}  // namespace ljmd
