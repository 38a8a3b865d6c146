#include "pair.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include "ljmd/core/errors.hpp"
#include "ljmd/engine/mistakes.hpp"
#include "ljmd/potentials/pair_table.hpp"
#include "ljmd/potentials/second_virial.hpp"

namespace ljmd::python {

namespace {

/// @throws InputError with the first mistake
Cutoff checked(const std::string& truncation, const Cutoff& cutoff) {
    for (const Mistake& mistake : potential_mistakes(truncation, cutoff, false)) {
        throw InputError(in_words(mistake));
    }
    return cutoff;
}

}  // namespace

PairOfPython::PairOfPython(const std::string& name, double first, double last, const std::vector<double>& energies,
                           const std::string& truncation, double switch_start)
    : potential_(PairPotential::custom(name, PairTable(first, last, energies), truncation,
                                       checked(truncation, {.radius = last, .switch_start = switch_start}))) {}

std::pair<py::array_t<double>, py::array_t<double>> PairOfPython::values(const py::array_t<double>& distances,
                                                                         bool truncated) const {
    const auto r = distances.unchecked<1>();
    py::array_t<double> energies(r.shape(0));
    py::array_t<double> forces(r.shape(0));
    for (py::ssize_t k = 0; k < r.shape(0); ++k) {
        if (!(r(k) > 0.0)) {
            throw InputError(fmt::format("a distance is above 0, found {}", r(k)));
        }
        const PairTerm<double> term = truncated ? potential_(r(k)) : potential_.untruncated(r(k));
        energies.mutable_at(k) = term.u;
        forces.mutable_at(k) = term.w * r(k);
    }
    return {energies, forces};
}

void bind_pairs(py::module_& module) {
    py::class_<PairOfPython>(module, "Pair", "A pair potential as a table.")
        .def(py::init<const std::string&, double, double, const std::vector<double>&, const std::string&, double>(),
             py::arg("name"), py::arg("first"), py::arg("last"), py::arg("energies"), py::arg("truncation"),
             py::arg("switch_start"))
        .def("values", &PairOfPython::values, py::arg("distances"), py::arg("truncated"))
        .def(
            "second_virial",
            [](const PairOfPython& pair, double temperature) {
                if (!(temperature > 0.0)) {
                    throw InputError(fmt::format("a temperature is above 0, found {}", temperature));
                }
                return second_virial_coefficient(pair.potential(), temperature);
            },
            py::arg("temperature"));
    module.def("pair_distances", &PairTable::distances, py::arg("first"), py::arg("last"), py::arg("pieces"));
}

}  // namespace ljmd::python
