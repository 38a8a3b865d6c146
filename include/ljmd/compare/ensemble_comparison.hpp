#pragma once

#include <array>
#include <string>
#include <vector>

#include "ljmd/compare/agreement.hpp"
#include "ljmd/compare/peer.hpp"
#include "ljmd/forces/force_field.hpp"
#include "ljmd/observables/analysis.hpp"
#include "ljmd/observables/statistics/blocking.hpp"

namespace ljmd {

/// What is sampled, by both programs alike.
struct EnsembleOptions {
    std::string integrator;  ///< ljmd's
    double time_step;        ///< [tau]
    Index steps;             ///< at constant energy
    Index every;             ///< steps between samples of the thermodynamics
    Index frame_every;       ///< steps between configurations for g(r), a multiple of `every`; 0: no g(r)
    Index bins;              ///< of g(r)
    double radius;           ///< of g(r) [sigma]
};

/// One side's averages.
struct EnsembleAverages {
    std::array<Estimate, 3> estimates;  ///< temperature, potential energy an atom, pressure; without tails
    DataTable rdf;                      ///< columns as RadialDistribution has them; empty without configurations
    Index frames = 0;
    bool has_temperature = true;  ///< a single atom has none
};

/// @pre options.steps >= options.every > 0
[[nodiscard]] EnsembleAverages our_averages(const Fluid& fluid, ForceField& force_field,
                                            const EnsembleOptions& options);
[[nodiscard]] EnsembleAverages their_averages(const Fluid& fluid, Peer& peer, const EnsembleOptions& options);

/// Averages of two runs at constant energy from one start, which part soon and then are independent. Without tails.
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
    std::vector<Row> rows;  ///< temperature where there is one, potential energy an atom, pressure
    std::vector<Bin> rdf;
    Index frames = 0;  ///< configurations behind g(r)
    [[nodiscard]] double largest_rdf_difference() const;
};

[[nodiscard]] EnsembleComparison compare_ensembles(const EnsembleAverages& ours, const EnsembleAverages& theirs);

/// Means within most_sigmas; g(r) within rdf_difference, and more where fewer than 300 configurations of 864 atoms are
/// behind it, as the noise of a histogram goes.
[[nodiscard]] std::vector<Check> checks_of(const EnsembleComparison& comparison, const Fluid& fluid);

}  // namespace ljmd
