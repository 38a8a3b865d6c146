#include "python/pair.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <utility>

#include "ljmd/core/errors.hpp"
#include "ljmd/potentials/second_virial.hpp"
#include "potentials/pair_table.hpp"
#include "run/recorded_run.hpp"

namespace ljmd::python {

std::pair<py::array_t<double>, py::array_t<double>> PairOfPython::values(const py::array_t<double>& distances,
                                                                         bool truncated) const {
    const auto r = distances.unchecked<1>();
    py::array_t<double> energies(r.shape(0));
    py::array_t<double> forces(r.shape(0));
    for (py::ssize_t k = 0; k < r.shape(0); ++k) {
        if (!(r(k) > 0.0)) {
            throw InputError(fmt::format("a distance is above 0, found {}", r(k)));
        }
        const PairTerm<double> term = truncated ? potential()(r(k)) : potential().untruncated(r(k));
        energies.mutable_at(k) = term.u;
        forces.mutable_at(k) = term.w * r(k);
    }
    return {energies, forces};
}

namespace {

/// The arguments of ljmd.Pair for the potential that a run in a directory was given; None if it was given none.
py::object pair_of_run(const std::filesystem::path& directory) {
    const auto potential = recorded_run(directory).deck.given.potential;
    if (!potential) {
        return py::none();
    }
    static_cast<void>(potential->known());
    if (!potential->table) {
        throw DataError(fmt::format("the pair potential '{}' of this run has no table", potential->name));
    }
    const TabulatedPair& t = *potential->table;
    return py::make_tuple(python_text(t.name), t.first, t.cutoff.radius,
                          py::array_t<double>(static_cast<py::ssize_t>(t.energies.size()), t.energies.data()),
                          python_text(t.truncation), t.cutoff.switch_start, t.error, t.force_error);
}

}  // namespace

void bind_pairs(py::module_& module) {
    py::class_<PairOfPython>(module, "Pair", "A pair potential as a table.")
        .def(py::init([](std::string name, double first, double last, std::vector<double> energies,
                         std::string truncation, double switch_start, double error, double force_error) {
                 return PairOfPython({.name = std::move(name),
                                      .truncation = std::move(truncation),
                                      .cutoff = {.radius = last, .switch_start = switch_start},
                                      .first = first,
                                      .energies = std::move(energies),
                                      .error = error,
                                      .force_error = force_error});
             }),
             py::arg("name"), py::arg("first"), py::arg("last"), py::arg("energies"), py::arg("truncation"),
             py::arg("switch_start"), py::arg("error"), py::arg("force_error"))
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
    module.def("pair_of_run", &pair_of_run, py::arg("directory"));
    module.def("pair_distances", &PairTable::distances, py::arg("first"), py::arg("last"), py::arg("pieces"));
}

}  // namespace ljmd::python
