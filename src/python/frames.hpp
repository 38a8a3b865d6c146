#pragma once

#include "python/values.hpp"

namespace ljmd::python {

/// The class Trajectory: analyses of the frames of a file.
void bind_frames(py::module_& module);

}  // namespace ljmd::python
