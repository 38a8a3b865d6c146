#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compare/agreement.hpp"
#include "compare/peer.hpp"
#include "ljmd/detail/forces/force_field.hpp"

namespace ljmd {

using MakeForceField = std::function<std::unique_ptr<ForceField>()>;

/// Trajectories of ljmd and another program from the same start, at equal steps.
struct TrajectoryComparison {
    /// A method of ljmd and one of the other program with the same positions, up to rounding.
    struct Pairing {
        std::string ours;
        std::string theirs;
        bool same_order;  ///< the same operations in the same order: the other method is paired with this one only
    };
    struct Row {
        Index step;
        double time;                    ///< since the start [tau]
        std::vector<double> distances;  ///< for each pairing: largest distance of an atom [sigma]
        double potential_difference;    ///< |U - U'| / |U'| of the first pairing
        double kinetic_difference;      ///< |K - K'| / max(K', K' at the start), of the first pairing
    };
    double time_step = 0.0;
    std::vector<Pairing> pairings;
    std::vector<Row> rows;

    /// lambda of the growth exp(lambda t) [1/tau]: least-squares slope of ln(distance) of the first pairing, over
    /// distances far above rounding and far below the distance between neighbours. Nothing for fewer than 8 such rows.
    [[nodiscard]] std::optional<double> divergence_rate() const;
};

/// Integrate the fluid with ljmd; frames at the given steps.
/// @param steps      ascending, from 0
/// @param execution  for its state
[[nodiscard]] std::vector<PeerFrame> follow(const Fluid& fluid, ForceField& force_field, const std::string& integrator,
                                            double time_step, const std::vector<Index>& steps,
                                            const Execution& execution = {});

/// Compare all pairings of methods.
/// @param steps      ascending, from 0
/// @param execution  for the states of ljmd
[[nodiscard]] TrajectoryComparison compare_trajectories(const Fluid& fluid, const MakeForceField& make_force_field,
                                                        Peer& peer, double time_step, const std::vector<Index>& steps,
                                                        const Execution& execution = {});

/// Checks of rows: distances, and kinetic energies up to step 100.
/// @param judged  steps to check; steps beyond the limits are skipped
[[nodiscard]] std::vector<Check> checks_of(const TrajectoryComparison& comparison, const std::vector<Index>& judged,
                                           const Agreement& agreement);

}  // namespace ljmd
