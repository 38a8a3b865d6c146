#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/compare/agreement.hpp"
#include "ljmd/compare/peer.hpp"
#include "ljmd/forces/force_field.hpp"

namespace ljmd {

using MakeForceField = std::function<std::unique_ptr<ForceField>()>;

/// Trajectories of ljmd and of another program from one start, at equal steps.
struct TrajectoryComparison {
    /// A method of ours, one of theirs that has the same positions to rounding.
    struct Pairing {
        std::string ours;
        std::string theirs;
        bool same_order;  ///< the two do the same in the same order: theirs names ours alone
    };
    struct Row {
        Index step;
        double time;                    ///< since the start [tau]
        std::vector<double> distances;  ///< of each pairing: of the atom that is furthest off [sigma]
        double potential_difference;    ///< |U - U'| / |U'| of the first pairing
        double kinetic_difference;      ///< |K - K'| over the larger of K' and K' at the start, of the first pairing
    };
    double time_step = 0.0;
    std::vector<Pairing> pairings;
    std::vector<Row> rows;

    /// lambda of the growth exp(lambda t) [1/tau]: least-squares slope of ln(distance) of the first pairing, where it
    /// is far above rounding and far below the distance between neighbours. Empty with fewer than 8 such rows.
    [[nodiscard]] std::optional<double> divergence_rate() const;
};

/// What ljmd's integrator makes of the fluid: frames at the given steps.
/// @param steps  ascending, from 0
[[nodiscard]] std::vector<PeerFrame> follow(const Fluid& fluid, ForceField& force_field, const std::string& integrator,
                                            double time_step, const std::vector<Index>& steps);

/// Follow all pairs of methods that belong together.
/// @param steps  ascending, from 0
[[nodiscard]] TrajectoryComparison compare_trajectories(const Fluid& fluid, const MakeForceField& make_force_field,
                                                        Peer& peer, double time_step, const std::vector<Index>& steps);

/// The checks at some of the rows: distances, and kinetic energies up to step 100.
/// @param judged  steps at which to judge; those beyond the limits are left out
[[nodiscard]] std::vector<Check> checks_of(const TrajectoryComparison& comparison, const std::vector<Index>& judged,
                                           const Agreement& agreement);

}  // namespace ljmd
