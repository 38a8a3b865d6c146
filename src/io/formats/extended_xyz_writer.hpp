#pragma once

#include <optional>
#include <span>
#include <vector>

#include "io/files/open_directory.hpp"
#include "io/files/output_file.hpp"
#include "ljmd/detail/model/state.hpp"
#include "ljmd/detail/options/units.hpp"

namespace ljmd {

/// What is known of a frame beside its atoms. What is not known is not written.
struct FrameFacts {
    std::optional<Index> step = {};
    std::optional<double> time = {};  ///< [tau]
    bool is_unwrapped = false;        ///< positions are known to continue across the walls
    std::vector<Index> ids = {};      ///< of the atoms, ascending; empty: they are known by their order alone
};

/// What a frame holds beside the positions.
struct FrameContents {
    bool velocities = false;
    bool forces = false;                    ///< @pre the state's forces are current
    std::span<const double> energies = {};  ///< of the atoms, by id [epsilon], see atom_energies(); empty: none
    /// Of a copy, what its source tells. None for a state of a run, whose step, time and displacements are known and
    /// whose ids count from 1.
    std::optional<FrameFacts> source = {};
};

/// Append one frame in extended XYZ: the number of atoms, a comment line, one line per atom in the order of ids.
///
///     Lattice="L 0 0 0 L 0 0 0 L" Properties=species:S:1:pos:R:3:velo:R:3:momenta:R:3:id:I:1 pbc="T T T" Time=..
///     step=.. units=..                                                          (in one line)
///
/// `momenta` are for ASE, which takes velocities from nothing else: the velocity times the mass that ASE gives to the
/// species [u]. That velocity is in ASE's unit sqrt(eV/u), in a reduced file in sigma/tau.
/// `forces:R:3` and `energies:R:1` stand before the id where they are asked for: names and units are ASE's, which takes
/// them as results of a calculator. Numbers have as many digits as are needed to read back the same double. Positions
/// are unwrapped and `positions=unwrapped` says so, or they are as in the source of a copy; ids count from 1, or are
/// the source's. Without a box there is no Lattice, and pbc="F F F".
///
/// @param si  empty: units=reduced, species X. Set: units=si, species Ar; positions [angstrom], velocities
///            [angstrom/ps], Time [ps]; forces [eV/angstrom], energies [eV]
/// @throws FileError
void write_extended_xyz_frame(OutputFile& file, const State& state, const FrameContents& contents,
                              const std::optional<SubstanceUnits>& si);

/// Write one configuration in reduced units, from which a later run can start. The file is replaced atomically.
/// Positions are unwrapped, so that displacements continue.
/// @throws FileError; no new file is then left behind
void write_configuration(const OutputPlace& place, const State& state, bool velocities);

}  // namespace ljmd
