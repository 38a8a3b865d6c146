#pragma once

#include <optional>

#include "ljmd/core/archive.hpp"
#include "ljmd/forces/force_field.hpp"
#include "ljmd/model/state.hpp"
#include "ljmd/potentials/tail_correction.hpp"

namespace ljmd {

/// The thermodynamic state of one configuration, energies per atom, tail corrections included.
struct Thermodynamics {
    std::optional<double> temperature;    ///< of the motion about the centre of mass [epsilon/k_B]; empty for one atom
    double potential_energy = 0.0;        ///< U/N + u_tail [epsilon]
    double kinetic_energy = 0.0;          ///< K/N [epsilon]
    double total_energy = 0.0;            ///< the sum of the two [epsilon]
    double pressure = 0.0;                ///< (2 K + W)/(3 V) + p_tail [epsilon/sigma^3]
    Mat3 pressure_tensor = Mat3::Zero();  ///< (sum m v v + W_ab)/V + p_tail delta_ab [epsilon/sigma^3]
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

}  // namespace ljmd
