#pragma once

#include <string>

#include "ljmd/detail/options/value.hpp"
#include "python/values.hpp"

namespace ljmd::python {

// Values of Python as a deck's values: NumPy's numbers and arrays, paths and tuples count as what they hold, and a key
// of a table whose value is None is not there. They throw InputError for a type that no deck holds, numbers that are
// masked or too large, and lists and tables that are deeper within one another than a deck may be.

/// The tables as the text of a deck.
[[nodiscard]] std::string deck_text(const py::dict& tables);

/// A value as it stands in a deck. @param name  of the value, for messages
[[nodiscard]] std::string value_text(const py::handle& value, const std::string& name);

/// Values of a deck as dict, list and so on.
[[nodiscard]] py::dict to_python(const Table& table);

}  // namespace ljmd::python
