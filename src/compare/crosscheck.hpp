#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compare/ensemble_comparison.hpp"
#include "compare/trajectory_comparison.hpp"
#include "deck/fluid.hpp"
#include "run/run.hpp"

namespace ljmd {

/// Options of a cross-check.
struct CrosscheckOptions {
    std::string with;                                       ///< "openmm", "lammps", or an engine: "command:..."
    std::string platform = "Reference";                     ///< of OpenMM
    Index steps = 1000;                                     ///< length of the trajectories
    std::vector<Index> frames{1, 10, 100, 200, 500, 1000};  ///< steps at which trajectories are compared
    std::vector<std::string> parts{};                       ///< a subset of crosscheck_parts(); empty: all
    std::string timeout = "1h";                             ///< wall time of an engine's command

    [[nodiscard]] bool wants(const std::string& part) const;
};

/// "point", "trajectory", "averages", "speed".
[[nodiscard]] const std::vector<std::string>& crosscheck_parts();

/// The other program: in its most exact form for single numbers, in its fast form for long runs.
struct Peers {
    std::unique_ptr<Peer> exact;
    std::unique_ptr<Peer> fast;  ///< null: the exact one
    Agreement agreement;         ///< tolerances between the exact one and ljmd

    [[nodiscard]] Peer& for_long_runs() const { return fast ? *fast : *exact; }
};

/// Speeds of both programs [atom-steps/s]: medians of interleaved rounds. Reported, never judged.
struct SpeedComparison {
    double ours;
    double theirs;
};

/// Results of a cross-check.
struct Crosscheck {
    std::string peer;       ///< name and version of the program
    std::string fast_peer;  ///< the same for its fast form
    Index atoms;
    Index steps_before;       ///< steps of the deck before the comparison
    std::string search;       ///< pair search of ljmd
    std::string simd;         ///< SIMD level; "scalar" if no kernel was used
    std::string precision;    ///< "double" or "mixed"
    int threads;              ///< of ljmd
    std::string integrator;   ///< of the averages
    Index steps_of_averages;  ///< at constant energy
    std::vector<Check> checks;
    TrajectoryComparison trajectory;
    std::optional<EnsembleComparison> ensemble;
    std::optional<SpeedComparison> speed;

    [[nodiscard]] bool passed() const;
    [[nodiscard]] Index failures() const;
};

/// Number of steps of the deck before the comparison: the steps of the stages before the first sampled one, or before
/// the last one if none is sampled.
[[nodiscard]] Index steps_before_crosscheck(const Deck& deck);

/// Run the deck's stages before the comparison. @return the moment that is compared
[[nodiscard]] Fluid run_before_crosscheck(const Deck& deck, FluidSystem& simulation, RunListener& listener);

/// Run the deck's stages before the first sampled one (the last one, if none is sampled), then compare from there.
/// @param say  receives a line before each slow operation
/// @throws InputError  the program to compare with, or its platform, is missing
[[nodiscard]] Crosscheck crosscheck(const Deck& deck, FluidSystem& simulation, const CrosscheckOptions& options,
                                    RunListener& listener, const std::function<void(const std::string&)>& say);

}  // namespace ljmd
