#include "python/deck_values.hpp"

#include <fmt/format.h>

#include <type_traits>
#include <utility>
#include <variant>

#include "ljmd/core/errors.hpp"
#include "options/toml_writer.hpp"

namespace ljmd::python {

namespace {

constexpr int deepest = 32;               // tables and lists within one another, as the reader of decks allows
constexpr int with_none = 2;              // [system], [[stage]] and lattice = {...} may have keys without a value
constexpr py::ssize_t largest = 1 << 20;  // members of an array: a deck has as many bytes

py::object check(const char* function) {
    return py::module_::import("ljmd._check").attr(function);
}

std::string shown(const py::handle& value) {
    return py::cast<std::string>(check("shown")(value));
}

std::string text_of(const py::handle& value, const std::string& name) {
    return py::cast<std::string>(check("text")(value, name));
}

std::string key_of(const py::handle& key, const std::string& where) {
    if (!py::isinstance<py::str>(key)) {
        throw InputError(fmt::format("{}: keys of a deck are text, found {}", where, shown(key)));
    }
    return text_of(key, "a key of " + where);
}

std::int64_t integer_of(const py::handle& value, const std::string& name) {
    int overflow = 0;
    const long long number = PyLong_AsLongLongAndOverflow(value.ptr(), &overflow);
    if (overflow != 0) {
        throw InputError(fmt::format("{}: {} does not fit in 64 bits", name, shown(value)));
    }
    return number;
}

/// What an array or a number of NumPy, or a path, holds.
py::object plain(const py::handle& value, const std::string& name) {
    if (const py::object as_list = py::getattr(value, "tolist", py::none()); PyCallable_Check(as_list.ptr()) != 0) {
        check("not_masked")(value, name);
        const py::object size = py::getattr(value, "size", py::int_(0));
        if (py::isinstance<py::int_>(size) && py::cast<py::ssize_t>(size) > largest) {
            throw InputError(fmt::format("{}: a deck cannot hold an array of {} members", name, py::cast<int>(size)));
        }
        try {
            return as_list();
        } catch (py::error_already_set& error) {  // a view of memory whose members Python does not know
            if (!error.matches(PyExc_NotImplementedError)) {
                throw;
            }
        }
    } else if (py::hasattr(value, "__fspath__")) {
        return py::module_::import("os").attr("fspath")(value);
    }
    return py::reinterpret_borrow<py::object>(value);
}

Value value_of(const py::handle& given, const std::string& name, int depth);

Table table_of(const py::handle& dict, const std::string& name, int depth) {
    Table table;
    for (const py::handle& item : py::list(dict.attr("items")())) {  // a list: what shows a value may change the dict
        const auto [key, value] = py::cast<std::pair<py::object, py::object>>(item);
        if (!value.is_none() || depth > with_none) {
            const std::string word = key_of(key, name.empty() ? "a deck" : name);
            table.push_back({word, {}, value_of(value, name.empty() ? word : fmt::format("{}.{}", name, word), depth)});
        }
    }
    return table;
}

Value value_of(const py::handle& value, const std::string& name, int depth) {
    if (depth > deepest) {
        throw InputError(
            fmt::format("{}: a deck cannot hold lists and tables more than {} within one another", name, deepest));
    }
    if (PyBool_Check(value.ptr())) {
        return {value.is(py::bool_(true)), {}};
    }
    if (PyLong_Check(value.ptr())) {
        return {integer_of(value, name), {}};
    }
    if (PyFloat_Check(value.ptr())) {
        return {PyFloat_AS_DOUBLE(value.ptr()), {}};
    }
    if (py::isinstance<py::str>(value)) {
        return {text_of(value, name), {}};
    }
    if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) {
        Array items;
        for (const py::handle& item : value) {
            items.push_back(value_of(item, name, depth + 1));
        }
        return {std::move(items), {}};
    }
    if (py::isinstance<py::dict>(value)) {
        return {table_of(value, name, depth + 1), {}};
    }
    if (const py::object inner = plain(value, name); !inner.is(value)) {
        return value_of(inner, name, depth + 1);
    }
    throw InputError(
        fmt::format("{}: a deck cannot hold {} of type {}: allowed are numbers, text, true or false, lists and tables",
                    name, shown(value), py::cast<std::string>(py::type::of(value).attr("__name__"))));
}

py::object object_of(const Value& value) {
    return std::visit(
        [](const auto& data) -> py::object {
            using T = std::remove_cvref_t<decltype(data)>;
            if constexpr (std::is_same_v<T, Array>) {
                py::list list;
                for (const Value& item : data) {
                    list.append(object_of(item));
                }
                return list;
            } else if constexpr (std::is_same_v<T, Table>) {
                return to_python(data);
            } else if constexpr (std::is_same_v<T, Date>) {
                return python_text(data.text);
            } else if constexpr (std::is_same_v<T, std::string>) {
                return python_text(data);
            } else {
                return py::cast(data);
            }
        },
        value.data);
}

}  // namespace

py::dict to_python(const Table& table) {
    py::dict dict;
    for (const Entry& entry : table) {
        dict[python_text(entry.key)] = object_of(entry.value);
    }
    return dict;
}

std::string deck_text(const py::dict& tables) {
    return toml_document(table_of(tables, "", 0));
}

std::string value_text(const py::handle& value, const std::string& name) {
    return toml_value(value_of(value, name, 0));
}

}  // namespace ljmd::python
