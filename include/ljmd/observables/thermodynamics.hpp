#pragma once

#include <optional>

#include "ljmd/core/archive.hpp"
#include "ljmd/forces/force_field.hpp"
#include "ljmd/model/state.hpp"
#include "ljmd/potentials/tail_correction.hpp"

namespace ljmd {

/// The thermodynamic state of one configuration, energies per atom, tail corrections included.
///
/// The pressure has the kinetic part rho T of all N atoms, whatever part of it 3 N - 3 degrees of freedom carry: its
/// mean is the thermodynamic one where momentum is conserved and where it is not. The kinetic part of the tensor is
/// scaled likewise. One atom has no motion about the centre of mass, and so neither temperature nor pressure.
struct Thermodynamics {
    std::optional<double> temperature;    ///< of the motion about the centre of mass [epsilon/k_B]; empty for one atom
    double potential_energy = 0.0;        ///< U/N + u_tail [epsilon]
    double kinetic_energy = 0.0;          ///< K/N [epsilon]
    double total_energy = 0.0;            ///< the sum of the two [epsilon]
    std::optional<double> pressure;       ///< rho T + W/(3 V) + p_tail [epsilon/sigma^3]; empty for one atom
    std::optional<Mat3> pressure_tensor;  ///< N/(N - 1) (sum m v v - P P/M)/V + W_ab/V + p_tail delta_ab; trace/3 = p
    double density = 0.0;                 ///< N/V [sigma^-3]
    double virial = 0.0;                  ///< W = sum over pairs of r . f [epsilon], of the whole system, without tail

    void archive(Archive& a) {
        a(temperature, potential_energy, kinetic_energy, total_energy, pressure, pressure_tensor, density, virial);
    }
};

/// Evaluate the thermodynamics of a state from what its force field returned for it.
/// @pre the evaluation belongs to the state's positions and was asked for energy; the state has a box and atoms
[[nodiscard]] Thermodynamics thermodynamics(const State& state, const Evaluation& evaluation,
                                            const TailCorrection& tail);

/// Whether a temperature can be divided by: it is more than what rounding leaves of the motion of atoms at rest, 2^-52
/// of the unit of energy.
[[nodiscard]] bool is_above_zero(double temperature);

/// The remark on what is divided by a temperature that is not above zero.
inline constexpr const char* no_temperature =
    "it is divided by the temperature, which is zero for atoms at rest and not defined for a single one";

/// W/(3 V) + p_tail [epsilon/sigma^3]: the pressure without its kinetic part.
/// @pre as for thermodynamics()
[[nodiscard]] double virial_pressure(const State& state, const Evaluation& evaluation, const TailCorrection& tail);

/// (sum m v v + W_ab)/V [epsilon/sigma^3]: the momentum that flows through a plane, whose fluctuations make the
/// viscosity. Unlike the pressure tensor it is that of the motion as it is, of 3 N - 3 degrees of freedom where
/// momentum is conserved.
/// @pre as for thermodynamics()
[[nodiscard]] Mat3 mechanical_stress(const State& state, const Evaluation& evaluation);

}  // namespace ljmd
