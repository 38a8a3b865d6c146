#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ljmd/compare/ensemble_comparison.hpp"
#include "ljmd/compare/trajectory_comparison.hpp"
#include "ljmd/deck/simulation.hpp"
#include "ljmd/run/run.hpp"

namespace ljmd {

/// What is compared of a fluid.
struct CrosscheckOptions {
    std::string with;                                       ///< "openmm" or "lammps"
    std::string platform = "Reference";                     ///< of OpenMM
    Index steps = 1000;                                     ///< length of the trajectories
    std::vector<Index> frames{1, 10, 100, 200, 500, 1000};  ///< steps at which they are judged
    std::vector<std::string> parts{};                       ///< of crosscheck_parts(); empty: all

    [[nodiscard]] bool wants(const std::string& part) const;
};

/// "point", "trajectory", "averages", "speed".
[[nodiscard]] const std::vector<std::string>& crosscheck_parts();

/// The two that are compared: for single numbers the program in its most exact form, for long runs its fast one.
struct Peers {
    std::unique_ptr<Peer> exact;
    std::unique_ptr<Peer> fast;  ///< empty: the same
    Agreement agreement;         ///< of the exact one with ljmd

    [[nodiscard]] Peer& for_long_runs() const { return fast ? *fast : *exact; }
};

/// How fast both run [atom-steps/s], medians of interleaved rounds. Reported, never judged.
struct SpeedComparison {
    double ours;
    double theirs;
};

/// What was found.
struct Crosscheck {
    std::string peer;       ///< name and version of the program
    std::string fast_peer;  ///< the same of its fast form
    Index atoms;
    Index steps_before;       ///< of the deck, taken before the comparison
    std::string search;       ///< ljmd's, that was tested
    std::string simd;         ///< level; "scalar" where no kernel was used
    std::string precision;    ///< "double" or "mixed"
    std::string integrator;   ///< of the averages
    Index steps_of_averages;  ///< at constant energy
    std::vector<Check> checks;
    TrajectoryComparison trajectory;
    std::optional<EnsembleComparison> ensemble;
    std::optional<SpeedComparison> speed;

    [[nodiscard]] bool passed() const;
    [[nodiscard]] Index failures() const;
};

/// Steps of the deck before the comparison begins: of the stages before the first that is sampled, or before the last
/// one if none is.
[[nodiscard]] Index steps_before_crosscheck(const Deck& deck);

/// Take the deck's stages before the one that is sampled (the last one, if none is), then compare from there.
/// @param say  receives a line when something that takes time begins
/// @throws InputError  nothing to compare with: the program or its platform is not there
[[nodiscard]] Crosscheck crosscheck(const Deck& deck, Simulation& simulation, const CrosscheckOptions& options,
                                    RunListener& listener, const std::function<void(const std::string&)>& say);

}  // namespace ljmd
