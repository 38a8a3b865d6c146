#include "python/values.hpp"

#include <algorithm>
#include <memory>
#include <type_traits>
#include <variant>

namespace ljmd::python {

py::str python_text(std::string_view text) {
    PyObject* decoded = PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace");
    if (decoded == nullptr) {
        throw py::error_already_set();
    }
    return py::reinterpret_steal<py::str>(decoded);
}

py::object to_python(const Data& data) {
    return std::visit(
        [](const auto& value) -> py::object {
            using T = std::remove_cvref_t<decltype(value)>;
            if constexpr (std::is_same_v<T, std::monostate>) {
                return py::none();
            } else if constexpr (std::is_same_v<T, Data::List>) {
                py::list list;
                for (const Data& item : value) {
                    list.append(to_python(item));
                }
                return list;
            } else if constexpr (std::is_same_v<T, Data::Object>) {
                py::dict dict;
                for (const Member& member : value) {
                    dict[python_text(member.key)] = to_python(member.value);
                }
                return dict;
            } else if constexpr (std::is_same_v<T, std::string>) {
                return python_text(value);
            } else {
                return py::cast(value);
            }
        },
        data.value());
}

py::tuple to_python(const Document& document) {
    return py::make_tuple(to_python(document.data), python_text(document.text));
}

py::tuple to_python(const DataTable& table) {
    const auto rows = static_cast<py::ssize_t>(table.rows.size());
    const auto columns = static_cast<py::ssize_t>(table.columns.size());
    py::array_t<double> numbers({rows, columns});
    double* next = numbers.mutable_data();
    for (const std::vector<double>& row : table.rows) {
        next = std::copy(row.begin(), row.end(), next);
    }
    py::list names;
    for (const std::string& column : table.columns) {
        names.append(python_text(column));
    }
    return py::make_tuple(names, numbers);
}

py::dict to_python(const std::vector<DataTable>& tables) {
    py::dict all;
    for (const DataTable& table : tables) {
        all[python_text(table.name)] = to_python(table);
    }
    return all;
}

py::array_t<double> to_python(const Eigen::Matrix3Xd& vectors) {
    py::array_t<double> array({static_cast<py::ssize_t>(vectors.cols()), py::ssize_t{3}});
    std::copy(vectors.data(), vectors.data() + vectors.size(), array.mutable_data());
    return array;
}

py::array_t<double> to_python(const Vec3& vector) {
    py::array_t<double> array(3);
    std::copy(vector.data(), vector.data() + 3, array.mutable_data());
    return array;
}

}  // namespace ljmd::python
