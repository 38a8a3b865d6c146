#pragma once

#include <array>
#include <string>
#include <vector>

#include "compare/agreement.hpp"
#include "compare/peer.hpp"
#include "ljmd/detail/forces/force_field.hpp"
#include "ljmd/detail/observables/analysis.hpp"
#include "ljmd/observables/statistics/blocking.hpp"

namespace ljmd {

/// Sampling options, equal for both programs.
struct EnsembleOptions {
    std::string integrator;  ///< ljmd's
    double time_step;        ///< [tau]
    Index steps;             ///< at constant energy
    Index every;             ///< steps between samples of the thermodynamics
    Index frame_every;       ///< steps between configurations for g(r), a multiple of `every`; 0: no g(r)
    Index bins;              ///< of g(r)
    double radius;           ///< of g(r) [sigma]
    Execution execution{};   ///< for the states of ljmd, and for g(r)
};

/// Averages of one program.
struct EnsembleAverages {
    std::array<Estimate, 3> estimates;  ///< temperature, potential energy per atom, pressure; without tail corrections
    DataTable rdf;                      ///< columns as in RadialDistribution; empty without configurations
    Index frames = 0;
    bool has_temperature = true;  ///< false for a single atom
};

/// @pre options.steps >= options.every > 0
[[nodiscard]] EnsembleAverages our_averages(const Fluid& fluid, ForceField& force_field,
                                            const EnsembleOptions& options);
[[nodiscard]] EnsembleAverages their_averages(const Fluid& fluid, Peer& peer, const EnsembleOptions& options);

/// Averages of two runs at constant energy from one start. The trajectories diverge soon and are then independent.
/// Without tail corrections.
struct EnsembleComparison {
    struct Row {
        std::string name;    ///< as in results.json
        std::string symbol;  ///< for tables
        Estimate ours;
        Estimate theirs;
        /// |difference| over the standard error of the difference.
        [[nodiscard]] double sigmas() const;
    };
    struct Bin {
        double r;  ///< middle of the bin [sigma]
        double ours;
        double our_error;
        double theirs;
        double their_error;
    };
    std::vector<Row> rows;  ///< temperature if there is one, potential energy per atom, pressure
    std::vector<Bin> rdf;
    Index frames = 0;  ///< number of configurations for g(r)
    [[nodiscard]] double largest_rdf_difference() const;
};

[[nodiscard]] EnsembleComparison compare_ensembles(const EnsembleAverages& ours, const EnsembleAverages& theirs);

/// Checks of means, against max_sigmas, and of g(r), against rdf_difference. The latter is scaled up by the noise of a
/// histogram for fewer than 300 configurations of 864 atoms.
[[nodiscard]] std::vector<Check> checks_of(const EnsembleComparison& comparison, const Fluid& fluid);

}  // namespace ljmd
