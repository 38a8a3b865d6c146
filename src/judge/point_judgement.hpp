#pragma once

#include <string>
#include <vector>

#include "compare/agreement.hpp"
#include "compare/peer.hpp"
#include "judge/answer.hpp"
#include "judge/summed_pairs.hpp"

namespace ljmd {

/// The configuration as ljmd has it: what an engine's PointAnswer is held against.
struct ExpectedPoint {
    PairSums sums;               ///< of the pairs alone
    double kinetic_energy;       ///< [epsilon]
    double tail_energy = 0.0;    ///< of all atoms [epsilon]; 0 without tail corrections
    double tail_pressure = 0.0;  ///< [epsilon/sigma^3]
    double volume;               ///< [sigma^3]
    Index atoms;

    [[nodiscard]] double potential_energy() const { return sums.potential_energy + tail_energy; }
    [[nodiscard]] double temperature() const;  ///< 2 K/(3 N - 3); 0 of a single atom
    [[nodiscard]] double pressure() const;     ///< (2 K + W)/(3 V) + p_tail

    /// Sum of F^2/(2 K): in equilibrium the mean square of the frequencies of the atoms, because <F^2> = T <u''>
    /// [1/tau^2]. 0 at rest.
    [[nodiscard]] double squared_frequency() const;
};

/// @param ours  of the fluid, by point_of()
[[nodiscard]] ExpectedPoint expected_point(const Fluid& fluid, const PeerPoint& ours);

/// Tolerances for an unknown engine that computes in double precision: ten times those for LAMMPS. Its numbers may have
/// been written with 15 digits, and it may wrap the coordinates in its own way.
[[nodiscard]] Agreement engine_agreement(const Situation& situation);

/// Checks of the parts that the answer has. Differences are relative, as in compare_points().
[[nodiscard]] std::vector<Check> check_point(const ExpectedPoint& expected, const PointAnswer& answer,
                                             const Agreement& agreement);

/// By which known mistakes the numbers of an answer differ from ours, a sentence each; empty where none is known.
///
/// A mistake that changes energy, virial and forces alike (epsilon, sigma, cutoff, missing images) is named if the
/// numbers that ljmd finds with it are the answer's, in all parts that it has, to a thousandth of the
/// difference. If none is, each part is looked at alone: an energy that is shifted, without the tail or of one atom, a
/// virial of the wrong sign or by a factor off, forces with a net force, a temperature of 3 N degrees of freedom.
/// @param tolerance  of relative differences that are none
[[nodiscard]] std::vector<std::string> diagnose_point(const Fluid& fluid, const ExpectedPoint& expected,
                                                      const PointAnswer& answer, double tolerance);

}  // namespace ljmd
