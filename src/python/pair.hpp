#pragma once

#include <string>
#include <utility>
#include <vector>

#include "python/values.hpp"
#include "run/given/given_record.hpp"

namespace ljmd::python {

/// A pair potential whose energies were computed in Python, as a table.
class PairOfPython {
  public:
    /// @throws InputError as PairTable and PairPotential::custom(); for a `switched` one unless 0 < switch_start < last
    explicit PairOfPython(TabulatedPair table) : given_(given_potential(std::move(table))) {}

    [[nodiscard]] const GivenPotential& given() const { return given_; }
    [[nodiscard]] const PairPotential& potential() const { return given_.known(); }

    /// u and -u' at distances, of the formula without truncation or of the truncated one.
    [[nodiscard]] std::pair<py::array_t<double>, py::array_t<double>> values(const py::array_t<double>& distances,
                                                                             bool truncated) const;

  private:
    GivenPotential given_;
};

void bind_pairs(py::module_& module);

}  // namespace ljmd::python
