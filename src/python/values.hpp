#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <Eigen/Core>
#include <string_view>
#include <vector>

#include "core/document.hpp"
#include "ljmd/core/types.hpp"
#include "ljmd/detail/core/data.hpp"
#include "ljmd/detail/observables/analysis.hpp"
#include "python/lock.hpp"

namespace ljmd::python {

namespace py = pybind11;

/// Text as str. Bytes that are no UTF-8, as in names of files, become U+FFFD.
[[nodiscard]] py::str python_text(std::string_view text);

/// Values of results as dict, list, str, float, int, bool and None.
[[nodiscard]] py::object to_python(const Data& data);

/// Data and text as a tuple.
[[nodiscard]] py::tuple to_python(const Document& document);

/// A table as (columns, array of shape (rows, columns)).
[[nodiscard]] py::tuple to_python(const DataTable& table);

/// Tables by their names.
[[nodiscard]] py::dict to_python(const std::vector<DataTable>& tables);

/// Vectors of atoms, (3, N) in C++, as an array of shape (N, 3).
[[nodiscard]] py::array_t<double> to_python(const Eigen::Matrix3Xd& vectors);

/// An array of shape (3,).
[[nodiscard]] py::array_t<double> to_python(const Vec3& vector);

}  // namespace ljmd::python
