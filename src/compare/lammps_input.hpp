#pragma once

#include <string>
#include <vector>

#include "compare/fluid.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

// LAMMPS input for a fluid, in units lj. Numbers have as many digits as are needed to read back the same double.
// Source: LAMMPS documentation, the commands named below.

/// A data file (read_data): box, masses, atoms (style atomic, ids from 1) and velocities. Atoms of the same mass have
/// the same type; types are numbered in order of appearance.
[[nodiscard]] std::string lammps_data(const Fluid& fluid);

/// pair_style, pair_coeff and pair_modify for a potential, without tail corrections:
///
///     lennard-jones   cut, shifted: lj/cut   force-shifted: lj/smooth/linear   switched: lj/mdf
///     morse           cut, shifted: morse    force-shifted: morse/smooth/linear
///
/// lj/mdf tapers with (1 - x)^3 (1 + 3 x + 6 x^2), which equals our 1 - 10 x^3 + 15 x^4 - 6 x^5.
/// @throws InputError  LAMMPS does not have the potential; the message lists those it has
[[nodiscard]] std::string lammps_pair_style(const PairPotential& potential);

/// Whether LAMMPS has tail corrections for the potential: only `cut` Lennard-Jones.
[[nodiscard]] bool lammps_has_tail(const PairPotential& potential);

/// The files of the scripts below, in LAMMPS' working directory.
struct LammpsFiles {
    static constexpr const char* start = "start.data";
    static constexpr const char* forces = "forces.dump";  ///< columns id fx fy fz, sorted
    static constexpr const char* frames = "frames.dump";  ///< columns id xu yu zu, sorted; frame after frame
};

// Scripts whose log has tables of step, U, K and the pressure W/3V of the virial W, as totals over all atoms. Neighbour
// lists are checked at every step, so that no pair is missed.
// All functions throw InputError like lammps_pair_style().

/// A table with step 0, and the forces. If fluid.tail is set and LAMMPS has tail corrections, a second table with them.
[[nodiscard]] std::string lammps_point_input(const Fluid& fluid);

/// Velocity Verlet, with a table row and a frame at each of these steps.
/// @pre steps ascend from 0
[[nodiscard]] std::string lammps_follow_input(const Fluid& fluid, double time_step, const std::vector<Index>& steps);

/// Velocity Verlet, with a table row every `every` steps and a frame every `frame_every` steps, both also at step 0,
/// and a row at the end. 0: none in between.
[[nodiscard]] std::string lammps_sample_input(const Fluid& fluid, double time_step, Index steps, Index every,
                                              Index frame_every);

/// Input file for the user: energies per atom and pressure of the start, with tail corrections if LAMMPS has them, then
/// velocity Verlet. The pressure is printed by LAMMPS' convention, (2 K + W)/(3 V), and by ours, rho T + W/(3 V), as
/// `v_p`. The number of steps is the variable `steps`, set by `lmp -var steps N`.
/// @param title  for the comment in the first line
[[nodiscard]] std::string lammps_user_input(const Fluid& fluid, double time_step, Index steps,
                                            const std::string& title);

}  // namespace ljmd
