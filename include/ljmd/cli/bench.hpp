#pragma once

#include <string>

#include "ljmd/run/run.hpp"

namespace ljmd {

/// How fast a run was.
struct BenchResult {
    Index atoms;
    Index steps;
    Index rebuilds;         ///< of the neighbour list, in the time loop and before
    std::string lists;      ///< when they are rebuilt
    std::string precision;  ///< of pair terms
    PhaseSeconds seconds;   ///< of the time loop
    double bytes_per_atom;  ///< memory at its peak until the last step, without what the program had before the atoms
                            ///< were there
    Thermodynamics first;   ///< at the start
    Thermodynamics last;    ///< at the last thermo step

    [[nodiscard]] double atom_steps_per_second() const {
        return static_cast<double>(atoms) * static_cast<double>(steps) / seconds.sum();
    }
};

/// Run a deck as `ljmd run` does, with all its outputs, in a directory that is removed afterwards.
/// @throws what a run throws
[[nodiscard]] BenchResult bench(Deck deck, Start start);

/// The Lennard-Jones melt of 32000 atoms, inputs/examples/melt-32k.toml, as it was when the program was built.
[[nodiscard]] std::string_view melt_deck();

[[nodiscard]] std::string bench_report(const BenchResult& result);
[[nodiscard]] std::string bench_json(const BenchResult& result);

}  // namespace ljmd
