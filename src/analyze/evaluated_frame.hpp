#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/document.hpp"
#include "io/formats/extended_xyz_writer.hpp"
#include "io/formats/trajectory_reader.hpp"
#include "ljmd/detail/model/state.hpp"
#include "ljmd/detail/observables/thermodynamics.hpp"
#include "ljmd/engine/fluid_spec.hpp"
#include "ljmd/execution/execution.hpp"

namespace ljmd {

/// A frame whose energy, pressure and forces were computed, in reduced units.
struct EvaluatedFrame {
    Index number = 1;   ///< of the frame in its file, from 1
    FrameFacts source;  ///< what the file tells

    State state;                   ///< with forces of the positions; the velocities mean nothing without has_velocities
    bool has_velocities = false;   ///< whether the file has them
    Thermodynamics found;          ///< with the kinetic parts, if there are velocities
    Mat3 virial;                   ///< W_ab = sum over pairs of r_a f_b [epsilon], without tail
    double tail_energy = 0.0;      ///< per atom [epsilon], in found.potential_energy
    double tail_pressure = 0.0;    ///< [epsilon/sigma^3], in both pressures
    double virial_pressure = 0.0;  ///< tr W/(3 V) + p_tail [epsilon/sigma^3]: the pressure of atoms at rest
    std::string too_near = {};  ///< of pairs nearer than the potential's table, see PairsTooNear; empty: there are none
    std::vector<double> energies;  ///< of each atom, half of its pairs', by id [epsilon], see atom_energies()
};

/// Open a file in any format that is read: as open_trajectory(), and NIST sample configurations and LAMMPS data, which
/// have one frame.
/// @throws DataError as open_trajectory() and read_configuration(); InputError a group or a comment for a format that
/// has none
[[nodiscard]] std::unique_ptr<TrajectoryReader> open_frames(const std::filesystem::path& path,
                                                            const std::optional<SubstanceUnits>& units,
                                                            const std::string& group, const std::string& xyz_comment);

/// Evaluate a frame as the start of a run: energy, virial and forces have the bits of a run of 0 steps from there.
/// @param spec    its potential, tail and neighbours are used
/// @param source  of the frame, for messages
/// @throws InputError  the cutoff is more than half the box
/// @throws DataError   atoms overlap so that forces are not finite, or as place_configuration()
[[nodiscard]] EvaluatedFrame evaluate_frame(Frame frame, Index number, const FluidSpec& spec,
                                            const Execution& execution, const std::string& source);

/// "lennard-jones, cut at 2.5 sigma, with tail corrections"
[[nodiscard]] std::string interaction_in_words(const FluidSpec& spec);

/// The frame as a document. Text: energy, pressure, virial, and the atoms with the largest forces. Data:
/// docs/evaluate.md lists the keys; vectors and energies of the atoms are in the order of `ids`.
[[nodiscard]] Document frame_document(const EvaluatedFrame& frame, const FluidSpec& spec, const std::string& source);

/// The headings of a table of frames, and the row of one. All entries fit 80 columns.
[[nodiscard]] std::string frame_headings();
[[nodiscard]] std::string frame_row(const EvaluatedFrame& frame);

}  // namespace ljmd
