#pragma once

#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include "ljmd/forces/external_force.hpp"

namespace ljmd::test {

/// An external force that a test makes of a function.
class MadeForce : public ExternalForce {
  public:
    using Function = std::function<ExternalEnergy(const AtomPositions&, Eigen::Matrix3Xd& forces)>;

    explicit MadeForce(Function function, bool energy = true, bool virial = false, std::string name = "made")
        : function_(std::move(function)), energy_(energy), virial_(virial), name_(std::move(name)) {}

    [[nodiscard]] std::string name() const override { return name_; }
    [[nodiscard]] bool has_energy() const override { return energy_; }
    [[nodiscard]] bool has_virial() const override { return virial_; }
    ExternalEnergy compute(const AtomPositions& atoms, bool energy, Eigen::Matrix3Xd& forces) override {
        ++calls;
        times.push_back(atoms.time());
        energies += energy ? 1 : 0;
        return function_(atoms, forces);
    }

    int calls = 0;
    int energies = 0;  ///< calls that wanted an energy
    std::vector<double> times;

  private:
    Function function_;
    bool energy_;
    bool virial_;
    std::string name_;
};

/// U = sum over atoms of k/2 |r - L/2|^2 in the box: with kinks at its walls.
inline std::shared_ptr<MadeForce> trap(double k) {
    return std::make_shared<MadeForce>(
        [k](const AtomPositions& atoms, Eigen::Matrix3Xd& forces) -> ExternalEnergy {
            const Eigen::Matrix3Xd d = atoms.positions().colwise() - Eigen::Vector3d(0.5 * atoms.edges());
            forces = -k * d;
            return {0.5 * k * d.squaredNorm(), -k * d * d.transpose()};
        },
        true, true, "trap");
}

/// U = sum over atoms of U_0 cos(2 pi x/L): scales with the box.
inline std::shared_ptr<MadeForce> wave(double u0, std::string name = "wave") {
    return std::make_shared<MadeForce>(
        [u0](const AtomPositions& atoms, Eigen::Matrix3Xd& forces) -> ExternalEnergy {
            const double k = 2.0 * std::numbers::pi / atoms.edges()[0];
            const Eigen::ArrayXd phase = k * atoms.positions().row(0).transpose().array();
            forces.row(0) = (u0 * k * phase.sin()).matrix().transpose();
            return {u0 * phase.cos().sum()};
        },
        true, true, std::move(name));
}

/// The same force on all atoms.
inline std::shared_ptr<MadeForce> uniform(const Vec3& force) {
    return std::make_shared<MadeForce>(
        [force](const AtomPositions&, Eigen::Matrix3Xd& forces) -> ExternalEnergy {
            forces.colwise() = force;
            return {};
        },
        false, false, "uniform");
}

}  // namespace ljmd::test
