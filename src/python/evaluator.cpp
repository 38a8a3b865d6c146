#include "python/evaluator.hpp"

#include <pybind11/stl.h>

#include <array>
#include <mutex>

#include "engine/mistakes/mistakes.hpp"
#include "execution/threads.hpp"
#include "ljmd/core/errors.hpp"
#include "ljmd/engine/configuration_evaluator.hpp"
#include "observables/pairs_too_near.hpp"
#include "python/pair.hpp"

namespace ljmd::python {

namespace {

/// Vectors of atoms as Python holds them: shape (N, 3), contiguous.
using Vectors = py::array_t<double, py::array::c_style | py::array::forcecast>;

ExecutionOptions options_of(int threads, const std::string& simd, const std::string& precision) {
    return {.threads = threads > 0 ? threads : default_thread_count(),
            .simd = default_simd_level(simd),
            .precision = precision_of(precision)};
}

/// Before the formula is made, which expects a sound cutoff.
PairPotential potential_of(const std::string& formula, const std::string& truncation, double cutoff,
                           double switch_start, const PairPotential::Parameters& parameters, bool tail) {
    const Cutoff radii{.radius = cutoff, .switch_start = switch_start};
    for (const Mistake& mistake : potential_mistakes(truncation, radii, tail)) {
        throw InputError(in_words(mistake));
    }
    return PairPotential::make(formula, truncation, radii, parameters);
}

/// An evaluator as Python holds it: threads of Python take turns.
class PythonEvaluator {
  public:
    PythonEvaluator(const PairPotential& potential, bool tail, double skin, const ExecutionOptions& options)
        : potential_(potential), evaluator_(potential, tail, {.skin = skin}, Execution(options)) {}

    /// @param energies  whether the atoms' energies are wanted; else they are None
    [[nodiscard]] py::tuple evaluate(const Vectors& positions, const std::array<double, 3>& edges, bool energies) {
        if (positions.ndim() != 2 || positions.shape(1) != 3) {
            throw InputError("positions: an array of shape (N, 3)");
        }
        const Eigen::Map<const Eigen::Matrix3Xd> r(positions.data(), 3, positions.shape(0));
        EvaluatedConfiguration found;
        std::vector<double> of_atoms;
        {
            const WithoutLock free;
            const std::scoped_lock turn(busy_);
            found = evaluator_.evaluate(r, Vec3(edges[0], edges[1], edges[2]));
            if (energies) {
                of_atoms = evaluator_.atom_energies();
            }
        }
        py::array_t<double> virial({3, 3});
        for (int a = 0; a < 3; ++a) {
            for (int b = 0; b < 3; ++b) {
                virial.mutable_at(a, b) = found.virial(a, b);
            }
        }
        py::object array = py::none();
        if (energies) {
            array = py::array_t<double>(static_cast<py::ssize_t>(of_atoms.size()), of_atoms.data());
        }
        return py::make_tuple(found.potential_energy, virial, found.virial_pressure, to_python(found.forces), array,
                              found.too_near.count, too_near_in_words(found.too_near, potential_));
    }

  private:
    PairPotential potential_;
    std::mutex busy_;
    ConfigurationEvaluator evaluator_;
};

}  // namespace

void bind_evaluator(py::module_& module) {
    py::class_<PythonEvaluator>(module, "Evaluator", "Energy, virial and forces of configurations, one after another.")
        .def(py::init([](const PairOfPython& pair, double skin, int threads, const std::string& simd) {
                 return std::make_unique<PythonEvaluator>(pair.potential(), false, skin,
                                                          options_of(threads, simd, "double"));
             }),
             py::arg("pair"), py::arg("skin"), py::arg("threads"), py::arg("simd"))
        .def(py::init([](const std::string& formula, const std::string& truncation, double cutoff, double switch_start,
                         const PairPotential::Parameters& parameters, bool tail, double skin, int threads,
                         const std::string& simd, const std::string& precision) {
                 return std::make_unique<PythonEvaluator>(
                     potential_of(formula, truncation, cutoff, switch_start, parameters, tail), tail, skin,
                     options_of(threads, simd, precision));
             }),
             py::arg("formula"), py::arg("truncation"), py::arg("cutoff"), py::arg("switch_start"),
             py::arg("parameters"), py::arg("tail"), py::arg("skin"), py::arg("threads"), py::arg("simd"),
             py::arg("precision"))
        .def("evaluate", &PythonEvaluator::evaluate, py::arg("positions"), py::arg("edges"), py::arg("energies"));
}

}  // namespace ljmd::python
