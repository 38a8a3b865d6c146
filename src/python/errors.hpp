#pragma once

#include <string>

#include "python/values.hpp"

namespace ljmd::python {

/// Raise an exception of ljmd.errors in Python. @throws py::error_already_set
[[noreturn]] void raise(const char* type, const std::string& text);

/// From now on each error of the library becomes the exception of ljmd.errors that has its name.
void translate_errors();

}  // namespace ljmd::python
