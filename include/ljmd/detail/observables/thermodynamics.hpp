#pragma once

#include <optional>

#include "ljmd/detail/core/archive.hpp"
#include "ljmd/detail/forces/force_field.hpp"
#include "ljmd/detail/model/state.hpp"
#include "ljmd/detail/potentials/tail_correction.hpp"

namespace ljmd {

/// Thermodynamic state of one configuration. Energies are per atom and include tail corrections.
///
/// The kinetic part of the pressure is rho T of all N atoms, although 3 N - 3 degrees of freedom may carry it. So the
/// mean is the thermodynamic pressure whether or not momentum is conserved. The kinetic part of the tensor is scaled
/// likewise. A single atom has no motion about the centre of mass, so it has neither temperature nor pressure.
///
/// With an external force nothing of this changes: the temperature is measured with 3 N - 3 degrees of freedom, the
/// motion about the centre of mass. Whether the force lets the centre of mass rest, move thermally or fall, in any
/// direction, 2 K - P^2/M is 3 N - 3 times T. The pressure is from the pairs, and from the force if it tells its
/// virial.
struct Thermodynamics {
    std::optional<double> temperature;    ///< of the motion about the centre of mass [epsilon/k_B]; empty for one atom
    double potential_energy = 0.0;        ///< U/N + u_tail, of the pairs [epsilon]
    double kinetic_energy = 0.0;          ///< K/N [epsilon]
    double total_energy = 0.0;            ///< sum of the two, and of the external energy [epsilon]
    std::optional<double> pressure;       ///< rho T + W/(3 V) + p_tail [epsilon/sigma^3]; empty for one atom
    std::optional<Mat3> pressure_tensor;  ///< N/(N - 1) (sum m v v - P P/M)/V + W_ab/V + p_tail delta_ab; trace/3 = p
    double density = 0.0;                 ///< N/V [sigma^-3]
    Vec3 edges = Vec3::Zero();            ///< of the box [sigma]
    double virial = 0.0;                  ///< W = sum over pairs of r . f [epsilon], of the whole system, without tail
    std::optional<double> external_energy = {};  ///< U_ext/N of an external force that has one [epsilon]

    void archive(Archive& a) {
        a(temperature, potential_energy, kinetic_energy, total_energy, pressure, pressure_tensor, density, edges,
          virial, external_energy);
    }
};

/// Compute the thermodynamics of a state from the evaluation of its force field.
/// @pre the evaluation belongs to the positions of the state and contains the energy; the state has a box and atoms
[[nodiscard]] Thermodynamics thermodynamics(const State& state, const Evaluation& evaluation,
                                            const TailCorrection& tail);

/// Whether a temperature can be divided by: it exceeds what rounding leaves of the motion of atoms at rest, 2^-52 of
/// the unit of energy.
[[nodiscard]] bool is_above_zero(double temperature);

/// Remark for results that would be divided by a temperature that is not above zero.
inline constexpr const char* no_temperature =
    "it is divided by the temperature, which is zero for atoms at rest and not defined for a single one";

/// W/(3 V) + p_tail [epsilon/sigma^3]: the pressure without its kinetic part.
/// @pre as for thermodynamics()
[[nodiscard]] double virial_pressure(const State& state, const Evaluation& evaluation, const TailCorrection& tail);

/// W_aa/V + p_tail along each edge [epsilon/sigma^3].
/// @pre as for thermodynamics()
[[nodiscard]] Vec3 virial_pressures(const State& state, const Evaluation& evaluation, const TailCorrection& tail);

/// (sum m v v - P P/M + W_ab)/V [epsilon/sigma^3]: the momentum flux through a plane that moves with the centre of
/// mass, whose fluctuations determine the viscosity. Unlike the pressure tensor it is not scaled: it has the 3 N - 3
/// degrees of freedom of the motion about the centre of mass.
/// @pre as for thermodynamics()
[[nodiscard]] Mat3 mechanical_stress(const State& state, const Evaluation& evaluation);

}  // namespace ljmd
