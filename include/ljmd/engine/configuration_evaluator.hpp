#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "ljmd/detail/neighbors/near_pairs.hpp"
#include "ljmd/detail/potentials/interaction.hpp"
#include "ljmd/engine/fluid_spec.hpp"
#include "ljmd/execution/execution.hpp"

namespace ljmd {

/// Energy, virial and forces of one configuration.
struct EvaluatedConfiguration {
    double potential_energy = 0.0;  ///< U/N + u_tail [epsilon]
    Mat3 virial = Mat3::Zero();     ///< W_ab = sum over pairs of r_a f_b [epsilon], without tail
    double virial_pressure = 0.0;   ///< tr W/(3 V) + p_tail [epsilon/sigma^3]: the pressure of atoms at rest
    Eigen::Matrix3Xd forces = {};   ///< in the order of the positions, shape (3, N) [epsilon/sigma]
    NearPairs too_near = {};        ///< pairs where the potential's table has not begun yet, see pairs_too_near()
};

/// Evaluates configurations of a fluid that other programs move: no stages, no velocities.
///
/// The neighbour list is kept from one configuration to the next, and rebuilt before a pair can be missed. The first
/// configuration, and one with another box or number of atoms, has the bits that it has as the start of a run; later
/// ones sum in the order of the list, and differ from that by rounding.
class ConfigurationEvaluator {
  public:
    /// @throws InputError for values that no run of a fluid takes, see potential_mistakes() and search_mistakes()
    ConfigurationEvaluator(const PairPotential& potential, bool tail, const NeighborSpec& neighbors,
                           const Execution& execution);
    ~ConfigurationEvaluator();
    ConfigurationEvaluator(ConfigurationEvaluator&&) noexcept;
    ConfigurationEvaluator& operator=(ConfigurationEvaluator&&) noexcept;
    ConfigurationEvaluator(const ConfigurationEvaluator&) = delete;
    ConfigurationEvaluator& operator=(const ConfigurationEvaluator&) = delete;

    /// @param positions  shape (3, N) [sigma], N >= 1; may lie outside the box
    /// @param edges      of the box [sigma], each at least twice the cutoff
    /// @throws InputError for wrong edges, and unless all numbers are finite and N is one that a run can have; for
    /// atoms that overlap, so that the forces between them are not finite
    [[nodiscard]] EvaluatedConfiguration evaluate(const Eigen::Ref<const Eigen::Matrix3Xd>& positions,
                                                  const Vec3& edges);

    /// Energy of each atom of the configuration evaluated last, in the order of the positions [epsilon], see
    /// ljmd::atom_energies(): half of its pairs' energies, without tail.
    /// @throws InputError  nothing was evaluated yet
    [[nodiscard]] std::vector<double> atom_energies() const;

  private:
    struct Parts;

    void begin(const Eigen::Ref<const Eigen::Matrix3Xd>& positions, const Vec3& edges);
    [[nodiscard]] bool move_to(const Eigen::Ref<const Eigen::Matrix3Xd>& positions);

    Interaction interaction_;
    NeighborSpec neighbors_;
    Execution execution_;
    std::unique_ptr<Parts> parts_;
};

}  // namespace ljmd
