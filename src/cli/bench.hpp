#pragma once

#include <string>

#include "deck/fluid.hpp"
#include "run/run.hpp"

namespace ljmd {

/// Speed of a run.
struct BenchResult {
    Index atoms;
    Index steps;
    Index rebuilds;         ///< of the neighbour list, also before the time loop
    std::string lists;      ///< when lists are rebuilt
    std::string precision;  ///< of pair terms
    std::string simd;       ///< SIMD level
    int threads;
    PhaseSeconds seconds;   ///< in the time loop
    double bytes_per_atom;  ///< peak memory until the last step, without what the program used before the atoms were
                            ///< created
    Thermodynamics first;   ///< at the start
    Thermodynamics last;    ///< at the last thermo step

    [[nodiscard]] double atom_steps_per_second() const {
        return static_cast<double>(atoms) * static_cast<double>(steps) / seconds.sum();
    }
};

/// Run a deck like `ljmd run`, with all its outputs, in a temporary directory.
/// @throws all exceptions of run_plan()
[[nodiscard]] BenchResult bench(Deck deck, Start start, const Execution& execution);

/// The Lennard-Jones melt of 32000 atoms: inputs/examples/melt-32k.toml at build time.
[[nodiscard]] std::string_view melt_deck();

[[nodiscard]] std::string bench_report(const BenchResult& result);
[[nodiscard]] std::string bench_json(const BenchResult& result);

}  // namespace ljmd
