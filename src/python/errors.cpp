#include "python/errors.hpp"

#include <exception>

#include "execution/thread_team.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/run/interruption.hpp"
#include "run/output_guard.hpp"

namespace ljmd::python {

namespace {

/// Set Python's current exception.
void set(const char* type, const std::string& text) {
    const py::object exception = py::module_::import("ljmd.errors").attr(type);
    PyErr_SetObject(exception.ptr(), python_text(text).ptr());
}

void translate(std::exception_ptr thrown) {  // NOLINT(performance-unnecessary-value-param): pybind11 wants it by value
    try {
        if (thrown) {
            std::rethrow_exception(thrown);
        }
    } catch (const InputError& e) {
        set("InputError", e.what());
    } catch (const DataError& e) {
        set("DataError", e.what());
    } catch (const FileError& e) {
        set("FileError", e.what());
    } catch (const CheckpointError& e) {
        set("CheckpointError", e.what());
    } catch (const InUseError& e) {
        set("InUseError", e.what());
    } catch (const PhysicsError& e) {
        set("PhysicsError", e.what());
    } catch (const ThreadsError& e) {
        set("ThreadsError", e.what());
    } catch (const Interrupted& e) {
        set("Interrupted", e.what());
    } catch (const Error& e) {
        set("Error", e.what());
    } catch (const ContractViolation& e) {
        set("InternalError", e.what());
    }
}

}  // namespace

void raise(const char* type, const std::string& text) {
    set(type, text);
    throw py::error_already_set();
}

void translate_errors() {
    py::register_exception_translator(translate);
}

}  // namespace ljmd::python
