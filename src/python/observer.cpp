#include "python/observer.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "ljmd/core/errors.hpp"
#include "python/during_call.hpp"

namespace ljmd::python {

namespace {

using SeenSnapshot = Passing<Snapshot>;

const Thermodynamics& energies(const SeenSnapshot& seen) {
    const Snapshot& snapshot = seen.now();
    try {
        return snapshot.thermodynamics();
    } catch (const InputError&) {
        throw InputError("this snapshot has no energy and pressure: ask for them with @ljmd.observable(energy=True)");
    }
}

/// Of Python or NumPy, whose complex numbers become real with a warning that is easily missed.
bool is_complex(const py::object& value) {
    return PyComplex_Check(value.ptr()) != 0 ||
           py::str(py::getattr(py::getattr(value, "dtype", py::none()), "kind", py::none())).equal(py::str("c"));
}

/// A real number of Python or NumPy; nothing for anything else, also for text with a number.
std::optional<double> as_number(const py::object& value) {
    if (PyUnicode_Check(value.ptr()) != 0 || PyBytes_Check(value.ptr()) != 0 || value.is_none() || is_complex(value)) {
        return std::nullopt;
    }
    const double number = PyFloat_AsDouble(value.ptr());
    if (number == -1.0 && PyErr_Occurred() != nullptr) {
        PyErr_Clear();
        return std::nullopt;
    }
    return number;
}

}  // namespace

PythonObserver::PythonObserver(std::string name, std::string unit, py::object function, Index every, bool energy)
    : name_(std::move(name)), unit_(std::move(unit)), function_(std::move(function)), every_(every), energy_(energy) {}

double PythonObserver::call(const Snapshot& snapshot) const {
    const DuringCall call(snapshot);
    const py::object value = called(function_, call.seen());
    const std::optional<double> number = as_number(value);
    if (!number) {
        throw InputError(fmt::format("observable '{}' returned {} at step {}: it returns one number", name_,
                                     std::string(py::str(py::type::of(value).attr("__name__"))), snapshot.step()));
    }
    if (!std::isfinite(*number)) {
        throw InputError(fmt::format("observable '{}' is {} at step {}", name_, *number, snapshot.step()));
    }
    return *number;
}

void PythonObserver::sample(const Snapshot& snapshot) {
    const WithLock lock;
    const double value = called_undisturbed(attention_, [&] { return call(snapshot); });
    series_.add(Eigen::VectorXd::Constant(1, value));
}

std::optional<ObservableAverage> PythonObserver::average() const {
    ObservableAverage average{name_, name_, unit_, std::nullopt};
    if (series_.samples() > 0) {
        average.estimate = series_.estimate(0);
    } else {
        average.remark = "it was not measured: no step of a sampled stage was one of its";
    }
    return average;
}

PythonObservers::PythonObservers(const py::iterable& described) {
    for (const py::handle each : described) {
        const auto [name, unit, function, every, energy] =
            each.cast<std::tuple<std::string, std::string, py::object, Index, bool>>();
        observers_.push_back(std::make_unique<PythonObserver>(name, unit, function, every, energy));
    }
}

void PythonObservers::attend(Attention* attention) {
    for (const auto& observer : observers_) {
        observer->attend(attention);
    }
}

std::vector<Observer*> PythonObservers::all() const {
    std::vector<Observer*> all;
    for (const auto& observer : observers_) {
        all.push_back(observer.get());
    }
    return all;
}

void bind_snapshot(py::module_& module) {
    using Seen = const SeenSnapshot&;
    py::class_<SeenSnapshot, std::shared_ptr<SeenSnapshot>>(
        module, "Snapshot", "The atoms at one step, as a function of an observable sees them. Valid during its call.")
        .def_property_readonly(
            "step", [](Seen s) { return s.now().step(); }, "number of the step")
        .def_property_readonly(
            "time", [](Seen s) { return s.now().time(); }, "time [tau]")
        .def_property_readonly(
            "atoms", [](Seen s) { return s.now().atoms(); }, "number of atoms, N")
        .def_property_readonly(
            "edges", [](Seen s) { return to_python(Vec3(s.now().edges())); }, "edges of the box, shape (3,) [sigma]")
        .def_property_readonly(
            "positions", [](Seen s) { return to_python(s.now().positions()); },
            "in the box, by id: shape (N, 3) [sigma]. A copy.")
        .def_property_readonly(
            "unwrapped", [](Seen s) { return to_python(s.now().unwrapped()); },
            "continuous in time, by id: shape (N, 3) [sigma]. A copy.")
        .def_property_readonly(
            "velocities", [](Seen s) { return to_python(s.now().velocities()); },
            "by id: shape (N, 3) [sigma/tau]. A copy.")
        .def_property_readonly(
            "forces", [](Seen s) { return to_python(s.now().forces()); },
            "by id: shape (N, 3) [epsilon/sigma]. A copy.")
        .def_property_readonly(
            "temperature", [](Seen s) { return energies(s).temperature; },
            "of the motion about the centre of mass [epsilon/k_B]; takes energy=True")
        .def_property_readonly(
            "potential_energy", [](Seen s) { return energies(s).potential_energy; },
            "per atom [epsilon]; takes energy=True")
        .def_property_readonly(
            "kinetic_energy", [](Seen s) { return energies(s).kinetic_energy; },
            "per atom [epsilon]; takes energy=True")
        .def_property_readonly(
            "total_energy", [](Seen s) { return energies(s).total_energy; }, "per atom [epsilon]; takes energy=True")
        .def_property_readonly(
            "external_energy", [](Seen s) { return energies(s).external_energy; },
            "of an external force with an energy, else None: per atom [epsilon]; takes energy=True")
        .def_property_readonly(
            "pressure", [](Seen s) { return energies(s).pressure; }, "[epsilon/sigma^3]; takes energy=True");
}

}  // namespace ljmd::python
