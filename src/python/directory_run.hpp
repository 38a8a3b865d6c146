#pragma once

#include "python/values.hpp"

namespace ljmd::python {

/// Runs with a directory, and what is in one.
void bind_directory_runs(py::module_& module);

}  // namespace ljmd::python
