#include "python/external_force.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "ljmd/core/errors.hpp"
#include "python/during_call.hpp"

namespace ljmd::python {

namespace {

using SeenPositions = Passing<AtomPositions>;

std::string type_of(const py::handle& value) {
    return py::str(py::type::of(value).attr("__name__"));
}

std::string shape_in_words(const py::array& array) {
    std::string text = "(";
    for (py::ssize_t k = 0; k < array.ndim(); ++k) {
        text += fmt::format("{}{}", k > 0 ? ", " : "", array.shape(k));
    }
    return text + (array.ndim() == 1 ? ",)" : ")");
}

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Numbers of NumPy or Python as doubles one after the other: of any real type, also read-only or with gaps.
/// @param what  it is, for the message  @throws InputError for anything else
Doubles doubles_of(const py::handle& value, const std::string& what) {
    const py::array array = py::array::ensure(value);
    if (!array) {
        PyErr_Clear();
    }
    if (!array || std::string("fiu").find(array.dtype().kind()) == std::string::npos) {
        const bool of_numpy = py::isinstance<py::array>(value);
        throw InputError(fmt::format("{} is {}{}, not an array of real numbers", what, type_of(value),
                                     of_numpy ? fmt::format(" of {}", std::string(py::str(array.dtype()))) : ""));
    }
    return Doubles(array);
}

}  // namespace

PythonExternalForce::PythonExternalForce(std::string name, py::object function, bool energy, bool virial)
    : name_(std::move(name)), function_(std::move(function)), energy_(energy), virial_(virial) {}

PythonExternalForce::~PythonExternalForce() {
    const WithLock lock;  // the last to hold it may be the engine
    function_ = py::object();
}

ExternalEnergy PythonExternalForce::call(const AtomPositions& atoms, bool energy, Eigen::Matrix3Xd& forces) const {
    const DuringCall call(atoms);
    const py::object value = called(function_, call.seen());
    const std::string what = fmt::format("external force '{}'", name_);
    const std::size_t parts = 1 + (energy_ ? 1U : 0U) + (virial_ ? 1U : 0U);
    const bool several = py::isinstance<py::tuple>(value);
    const std::size_t returned = several ? py::len(value) : 1;
    if (returned != parts) {
        throw InputError(fmt::format(
            "{} returned {}, expected {}: with energy=True and virial=True a function returns them after the forces",
            what, several ? fmt::format("{} things", returned) : fmt::format("{} alone", type_of(value)),
            !energy_ && !virial_ ? "forces alone"
                                 : fmt::format("(forces{}{})", energy_ ? ", energy" : "", virial_ ? ", virial" : "")));
    }
    const auto part = [&](std::size_t k) -> py::object { return several ? py::object(value[py::int_(k)]) : value; };
    const Doubles f = doubles_of(part(0), fmt::format("what {} returned as forces", what));
    if (f.ndim() != 2 || f.shape(0) != atoms.atoms() || f.shape(1) != 3) {
        throw InputError(fmt::format("{} returned forces of the shape {}: it is ({}, 3), a row for each atom", what,
                                     shape_in_words(f), atoms.atoms()));
    }
    std::copy(f.data(), f.data() + f.size(), forces.data());
    ExternalEnergy found;
    if (energy && energy_) {
        const Doubles u = doubles_of(part(1), fmt::format("the energy of {}", what));
        if (u.ndim() != 0 && !(u.ndim() == 1 && u.shape(0) == atoms.atoms())) {
            throw InputError(
                fmt::format("{} returned an energy of the shape {}: it is one number, or one for each of {} "
                            "atoms",
                            what, shape_in_words(u), atoms.atoms()));
        }
        found.energy = Eigen::Map<const Eigen::VectorXd>(u.data(), u.size()).sum();
    }
    if (energy && virial_) {
        const Doubles w = doubles_of(part(parts - 1), fmt::format("the virial of {}", what));
        if (w.ndim() != 2 || w.shape(0) != 3 || w.shape(1) != 3) {
            throw InputError(
                fmt::format("{} returned a virial of the shape {}: it is (3, 3)", what, shape_in_words(w)));
        }
        found.virial = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(w.data());
    }
    return found;
}

ExternalEnergy PythonExternalForce::compute(const AtomPositions& atoms, bool energy, Eigen::Matrix3Xd& forces) {
    const WithLock lock;
    return called_undisturbed(attention_, [&] { return call(atoms, energy, forces); });
}

std::shared_ptr<PythonExternalForce> external_force_of(const py::object& described) {
    if (described.is_none()) {
        return nullptr;
    }
    const auto [name, function, energy, virial] = described.cast<std::tuple<std::string, py::object, bool, bool>>();
    return std::make_shared<PythonExternalForce>(name, function, energy, virial);
}

void bind_external_forces(py::module_& module) {
    using Seen = const SeenPositions&;
    py::class_<SeenPositions, std::shared_ptr<SeenPositions>>(
        module, "Positions",
        "Where the atoms are, as the function of an external force sees them. Valid during its call.")
        .def_property_readonly(
            "time", [](Seen s) { return s.now().time(); }, "time that the positions belong to [tau]")
        .def_property_readonly(
            "atoms", [](Seen s) { return s.now().atoms(); }, "number of atoms, N")
        .def_property_readonly(
            "edges", [](Seen s) { return to_python(Vec3(s.now().edges())); }, "edges of the box, shape (3,) [sigma]")
        .def_property_readonly(
            "positions", [](Seen s) { return to_python(s.now().positions()); },
            "in the box, by id: shape (N, 3) [sigma]. A copy.")
        .def_property_readonly(
            "unwrapped", [](Seen s) { return to_python(s.now().unwrapped()); },
            "continuous in time, by id: shape (N, 3) [sigma]. A copy.");
}

}  // namespace ljmd::python
