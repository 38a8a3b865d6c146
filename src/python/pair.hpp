#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ljmd/potentials/pair_potential.hpp"
#include "values.hpp"

namespace ljmd::python {

/// A pair potential whose energies were computed in Python, as a table.
class PairOfPython {
  public:
    /// @param energies  see PairTable
    /// @throws InputError as PairTable and PairPotential::custom(); for a `switched` one unless 0 < switch_start < last
    PairOfPython(const std::string& name, double first, double last, const std::vector<double>& energies,
                 const std::string& truncation, double switch_start);

    [[nodiscard]] const PairPotential& potential() const { return potential_; }

    /// u and -u' at distances, of the formula without truncation or of the truncated one.
    [[nodiscard]] std::pair<py::array_t<double>, py::array_t<double>> values(const py::array_t<double>& distances,
                                                                             bool truncated) const;

  private:
    PairPotential potential_;
};

void bind_pairs(py::module_& module);

}  // namespace ljmd::python
