#include <pybind11/stl.h>

#include <array>

#include "execution/launched_ranks.hpp"
#include "execution/threads.hpp"
#include "integrators/barostat.hpp"
#include "integrators/integrator.hpp"
#include "integrators/thermostat.hpp"
#include "ljmd/core/build_info.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/detail/execution/simd.hpp"
#include "ljmd/detail/observables/analysis.hpp"
#include "ljmd/detail/options/registry.hpp"
#include "observables/few_body/few_body_analysis.hpp"
#include "python/directory_run.hpp"
#include "python/errors.hpp"
#include "python/evaluator.hpp"
#include "python/external_force.hpp"
#include "python/frames.hpp"
#include "python/loaded_deck.hpp"
#include "python/observer.hpp"
#include "python/pair.hpp"
#include "python/simulation.hpp"
#include "reference/equation_report.hpp"

namespace ljmd::python {

namespace {

/// Version, build, and what decks can select.
py::dict build() {
    const BuildInfo& info = build_info();
    std::vector<std::string> levels;
    for (const SimdLevel level : usable_simd_levels()) {
        levels.emplace_back(name(level));
    }
    py::dict all;
    all["version"] = info.version;
    all["commit"] = info.commit;
    all["compiler"] = info.compiler + " " + info.compiler_version;
    all["build_type"] = info.build_type;
    all["flags"] = info.flags;
    all["simd"] = std::string(name(default_simd_level()));
    all["simd_levels"] = levels;
    all["threads"] = default_thread_count();
    all["potentials"] = PairPotential::formula_names();
    all["truncations"] = PairPotential::truncation_names();
    all["integrators"] = plugin_names(all_integrators());
    all["thermostats"] = plugin_names(all_thermostats());
    all["barostats"] = plugin_names(all_barostats());
    all["analyses"] = plugin_names(all_analyses());
    all["few_body_analyses"] = plugin_names(all_few_body_analyses());
    all["defaults"] = default_tables();
    all["equations_of_state"] = plugin_names(all_equations_of_state());
    return all;
}

void bind_equations(py::module_& module) {
    module.def("equations", [] { return to_python(equations_document()); });
    module.def(
        "state",
        [](const std::string& model, double temperature, double density) {
            return to_python(state_document(equation_of_state(model), temperature, density));
        },
        py::arg("model"), py::arg("temperature"), py::arg("density"));
    module.def(
        "coexistence",
        [](const std::string& model, double temperature) {
            return to_python(coexistence_document(equation_of_state(model), temperature));
        },
        py::arg("model"), py::arg("temperature"));
    module.def(
        "state_at_pressure",
        [](const std::string& model, double temperature, double pressure) {
            return to_python(pressure_document(equation_of_state(model), temperature, pressure));
        },
        py::arg("model"), py::arg("temperature"), py::arg("pressure"));
    module.def(
        "saturation",
        [](const std::string& model, double pressure) {
            return to_python(saturation_document(equation_of_state(model), pressure));
        },
        py::arg("model"), py::arg("pressure"));
}

/// Refuse other interpreters than the main one: pybind11's locks, its exceptions' too, know that one alone,
/// and wait for ever. So this is a function of Python's own interface. @return null with ImportError set
PyObject* require_main_interpreter(PyObject* /*module*/ = nullptr, PyObject* /*arguments*/ = nullptr) {
    if (PyInterpreterState_Get() == PyInterpreterState_Main()) {
        Py_RETURN_NONE;
    }
    PyErr_SetString(PyExc_ImportError,
                    "ljmd works in the main interpreter of a process alone, and this is another one");
    return nullptr;
}

std::array<PyMethodDef, 2> own_functions{
    {{"require_main_interpreter", &require_main_interpreter, METH_NOARGS, nullptr}, {}}};

/// Refuse `Class.__new__(Class)`, which would make an object without the one of the engine that it stands for. Classes
/// are called as before: that takes the slot of the type, not the attribute.
void refuse_bare_objects(const py::module_& module) {
    const py::cpp_function refuse([](const py::args&, const py::kwargs&) -> py::object {
        throw py::type_error("objects of ljmd._core are made by calling their class");
    });
    const py::staticmethod attribute(refuse);
    const auto close = [&](const py::handle& type) {
        auto* object = reinterpret_cast<PyTypeObject*>(type.ptr());
        if (PyDict_SetItemString(object->tp_dict, "__new__", attribute.ptr()) != 0) {
            throw py::error_already_set();
        }
        PyType_Modified(object);
    };
    for (const auto& [name, value] : py::dict(module.attr("__dict__"))) {
        if (py::isinstance<py::type>(value)) {
            close(value);
            close(value.attr("__base__"));
        }
    }
}

}  // namespace

// What pybind11 defines is called by ours, below.
#define PyInit__core ljmd_init_core
// NOLINTNEXTLINE: what the macro makes is pybind11's
PYBIND11_MODULE(_core, module) {
    module.doc() = "The engine of ljmd. The package `ljmd` is what programs use.";
    translate_errors();
    module.def("build", &build);
    module.def("launched_processes", &launched_processes);
    bind_decks(module);
    bind_snapshot(module);
    bind_external_forces(module);
    bind_pairs(module);
    bind_evaluator(module);
    bind_simulation(module);
    bind_directory_runs(module);
    bind_frames(module);
    bind_equations(module);
    if (PyModule_AddFunctions(module.ptr(), own_functions.data()) != 0) {
        throw py::error_already_set();
    }
    refuse_bare_objects(module);
}
#undef PyInit__core

}  // namespace ljmd::python

/// What Python calls to import the module.
extern "C" PYBIND11_EXPORT PyObject* PyInit__core() {  // NOLINT(readability-identifier-naming): Python wants this name
    PyObject* is_main = ljmd::python::require_main_interpreter();
    if (is_main == nullptr) {
        return nullptr;
    }
    Py_DECREF(is_main);
    return ljmd::python::ljmd_init_core();
}
