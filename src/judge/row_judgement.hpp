#pragma once

#include <string>
#include <vector>

#include "compare/agreement.hpp"
#include "judge/answer.hpp"

namespace ljmd {

/// What ljmd has at one step of a trajectory at constant energy, of the whole system, tail corrections included.
struct OwnRow {
    double potential_energy;       ///< [epsilon]
    double kinetic_energy;         ///< at the time of the positions [epsilon]
    double kinetic_energy_before;  ///< of the velocities of half a step earlier [epsilon]
    double kinetic_energy_after;   ///< of half a step later [epsilon]
    double pressure;               ///< (2 K + W)/(3 V), with the tail [epsilon/sigma^3]
};

/// What rows are judged by.
struct RowConditions {
    Index atoms;
    double volume;               ///< [sigma^3]
    Index thermo_every;          ///< steps between rows
    const Agreement& agreement;  ///< of trajectories
    double digits;               ///< relative differences that are none because numbers have been through text
    double tail_energy = 0.0;    ///< of all atoms [epsilon]
    double tail_pressure = 0.0;  ///< [epsilon/sigma^3]
};

/// The judgement of the rows of a table while two trajectories are together.
struct RowJudgement {
    std::vector<Check> checks;
    std::vector<std::string> mistakes;  ///< rows of another step, of velocities half a step off, of few digits
    bool has_constant_motion = false;   ///< the pressure is that of one temperature in all rows
    std::vector<std::string> others;  ///< a constant that is added, or a factor: as a mistake of the start leaves them
};

/// Compare a table at constant energy with ljmd's own trajectory, row by row, after step 0 and up to the step where the
/// limits of distances end. A distance d of atoms changes energies and pressures by at most
///
///     |dU|, |dK| <= 40/tau N v d,    |dp| <= 20 (40/tau N v d)/(3 V)    v = (2 K/N)^(1/2), mass 1
///
/// because a pair's virial changes with its distance by at most some twenty times its force. Differences are relative
/// as for a point.
///
/// @param ours  at each step from 0 on, one more than the last that is compared
/// @pre the table's columns have an entry for each of its steps, or none
[[nodiscard]] RowJudgement judge_rows(const ThermoAnswer& table, const std::vector<OwnRow>& ours,
                                      const RowConditions& conditions);

/// The last step of a table for which judge_rows() takes rows of ours: up to `together`, also by the number of rows,
/// which may stand in the place of steps.
/// @pre there is a row up to `together`
[[nodiscard]] Index last_compared_step(const ThermoAnswer& table, Index every, Index together);

/// Temperature and kinetic energy of a table are one quantity; nothing is judged without both.
[[nodiscard]] RowJudgement judge_temperatures(const ThermoAnswer& table, Index atoms, Index freedom, double tolerance);

}  // namespace ljmd
