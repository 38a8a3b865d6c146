#pragma once

#include <cxxabi.h>
#include <pybind11/pybind11.h>
#include <unistd.h>

#include <optional>

namespace ljmd::python {

namespace py = pybind11;

/// Do what takes the interpreter's lock, or gives it back in between. A thread that wants the lock when the interpreter
/// ends, as a daemon thread does, is ended by Python in the middle of our functions, which would end the process with
/// SIGABRT; later the interpreter is gone. Here the thread stops for ever instead, until the process ends: so do
/// threads of Python from version 3.14 on.
template <class Work>
auto unless_python_ends(const Work& work) {
    const auto stop_here = [] {
        while (true) {
            ::pause();
        }
    };
    if (Py_IsInitialized() == 0) {
        stop_here();
    }
    try {
        return work();
    } catch (abi::__forced_unwind&) {
        stop_here();  // within the handler, which must not end
        throw;
    }
}

/// While it lives, its thread holds the interpreter's lock.
class WithLock {
  public:
    WithLock() {
        unless_python_ends([this] { lock_.emplace(); });
    }

  private:
    std::optional<py::gil_scoped_acquire> lock_;
};

/// While it lives, its thread, which holds the interpreter's lock, does without.
class WithoutLock {
  public:
    WithoutLock() : thread_(PyEval_SaveThread()) {}
    ~WithoutLock() {
        unless_python_ends([this] { PyEval_RestoreThread(thread_); });
    }
    WithoutLock(const WithoutLock&) = delete;
    WithoutLock& operator=(const WithoutLock&) = delete;

  private:
    PyThreadState* thread_;
};

/// Call a function of the user's from within the engine. With the lock.
template <class... Arguments>
py::object called(const py::object& function, const Arguments&... arguments) {
    const py::tuple all = py::make_tuple(arguments...);
    PyObject* result = unless_python_ends([&] { return PyObject_CallObject(function.ptr(), all.ptr()); });
    if (result == nullptr) {
        throw py::error_already_set();
    }
    return py::reinterpret_steal<py::object>(result);
}

}  // namespace ljmd::python
