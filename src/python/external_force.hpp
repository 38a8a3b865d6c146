#pragma once

#include <memory>
#include <string>

#include "ljmd/forces/external_force.hpp"
#include "python/attention.hpp"
#include "python/values.hpp"

namespace ljmd::python {

/// An external force that a Python function computes.
class PythonExternalForce : public ExternalForce {
  public:
    /// @param function  called with the positions; returns forces of shape (N, 3), and then energy and virial if it has
    /// them
    PythonExternalForce(std::string name, py::object function, bool energy, bool virial);
    ~PythonExternalForce() override;
    PythonExternalForce(const PythonExternalForce&) = delete;
    PythonExternalForce& operator=(const PythonExternalForce&) = delete;

    /// Whom to tell of Ctrl-C; null: nobody. It outlives the steps that follow.
    void attend(Attention* attention) { attention_ = attention; }

    [[nodiscard]] std::string name() const override { return name_; }
    [[nodiscard]] bool has_energy() const override { return energy_; }
    [[nodiscard]] bool has_virial() const override { return virial_; }

    /// Without the interpreter's lock. @throws py::error_already_set  what the function raises; InputError for anything
    /// that is no array of the forces, no energy or no virial
    ExternalEnergy compute(const AtomPositions& atoms, bool energy, Eigen::Matrix3Xd& forces) override;

  private:
    [[nodiscard]] ExternalEnergy call(const AtomPositions& atoms, bool energy, Eigen::Matrix3Xd& forces) const;

    std::string name_;
    py::object function_;
    bool energy_;
    bool virial_;
    Attention* attention_ = nullptr;
};

/// @param described  a tuple (name, function, energy, virial), or None
/// @return null for None
[[nodiscard]] std::shared_ptr<PythonExternalForce> external_force_of(const py::object& described);

/// The class of what functions of external forces are called with.
void bind_external_forces(py::module_& module);

}  // namespace ljmd::python
