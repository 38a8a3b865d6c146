#pragma once

#include "python/values.hpp"

namespace ljmd::python {

/// The class Simulation, a run in memory step by step, and the views of its arrays.
void bind_simulation(py::module_& module);

}  // namespace ljmd::python
