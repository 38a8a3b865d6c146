#pragma once

#include <string>
#include <vector>

#include "ljmd/compare/fluid.hpp"
#include "ljmd/core/types.hpp"

namespace ljmd {

// A fluid in the words of LAMMPS, units lj. Numbers have as many digits as it takes to read the same double back.
// Source: LAMMPS documentation, the commands named below.

/// A data file (read_data): box, masses, atoms (style atomic, ids from 1) and velocities. Atoms of one mass are of one
/// type; types are numbered in the order in which they appear.
[[nodiscard]] std::string lammps_data(const Fluid& fluid);

/// pair_style, pair_coeff and pair_modify of a potential, without tail:
///
///     lennard-jones   cut, shifted: lj/cut   force-shifted: lj/smooth/linear   switched: lj/mdf
///     morse           cut, shifted: morse    force-shifted: morse/smooth/linear
///
/// lj/mdf tapers with (1 - x)^3 (1 + 3 x + 6 x^2), which is our 1 - 10 x^3 + 15 x^4 - 6 x^5.
/// @throws InputError  LAMMPS has no such potential; the message lists those that it has
[[nodiscard]] std::string lammps_pair_style(const PairPotential& potential);

/// Whether LAMMPS has tail corrections for it: `cut` Lennard-Jones alone.
[[nodiscard]] bool lammps_has_tail(const PairPotential& potential);

/// What the scripts below read and write, all in the directory where LAMMPS runs.
struct LammpsFiles {
    static constexpr const char* start = "start.data";
    static constexpr const char* forces = "forces.dump";  ///< columns id fx fy fz, sorted
    static constexpr const char* frames = "frames.dump";  ///< columns id xu yu zu, sorted; frame after frame
};

// Scripts whose log holds tables of step, U, K and the pressure W/3V of the virial W, totals of all atoms. Neighbour
// lists are looked after at every step, so that no pair is missed.
// All throw InputError as lammps_pair_style.

/// A table with step 0; the forces; and, where fluid.tail is set and LAMMPS has it, a table of the same with tail.
[[nodiscard]] std::string lammps_point_input(const Fluid& fluid);

/// Velocity Verlet with a table row and a frame at each of these steps.
/// @pre steps ascend from 0
[[nodiscard]] std::string lammps_follow_input(const Fluid& fluid, double time_step, const std::vector<Index>& steps);

/// Velocity Verlet with a table row every `every` steps and a frame every `frame_every`, both also at step 0, and a row
/// at the end; 0: none in between.
[[nodiscard]] std::string lammps_sample_input(const Fluid& fluid, double time_step, Index steps, Index every,
                                              Index frame_every);

/// What a user goes on from: energies (per atom) and pressure of the start, tail included where LAMMPS has it, then
/// velocity Verlet. The pressure by LAMMPS' convention, (2 K + W)/(3 V), and by ours, rho T + W/(3 V), as `v_p`. The
/// number of steps is the variable `steps`, which `lmp -var steps N` sets.
/// @param title  of the comment that it begins with, one line
[[nodiscard]] std::string lammps_user_input(const Fluid& fluid, double time_step, Index steps,
                                            const std::string& title);

}  // namespace ljmd
