#pragma once

#include "python/values.hpp"

namespace ljmd::python {

/// The class Evaluator: energy, forces and virial of configurations that Python moves.
void bind_evaluator(py::module_& module);

}  // namespace ljmd::python
