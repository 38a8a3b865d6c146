#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/fluid.hpp"
#include "deck/deck.hpp"

namespace ljmd {

/// What an engine is asked: to evaluate one configuration, to follow it at constant energy, and to run it as the deck
/// does.
struct Problem {
    Fluid fluid;
    Stage stage;                       ///< of the deck, that is judged
    Index steps_before;                ///< steps of the deck before the configuration
    Index trajectory_steps;            ///< at constant energy
    std::vector<Index> frames;         ///< steps of it that are compared, from 0
    Index thermo_every;                ///< steps between rows of the table of the run
    std::string deck_hash{};           ///< of the deck as used, see deck_hash()
    std::vector<std::string> parts{};  ///< "point", "trajectory", "averages": what is judged

    [[nodiscard]] bool wants(const std::string& part) const;
};

/// The files of a problem.
struct ExchangeFiles {
    static constexpr const char* problem = "problem.json";
    static constexpr const char* start = "start.xyz";
    static constexpr const char* start_for_lammps = "start.data";
};

/// "NVE", "NVT" or "NPT".
[[nodiscard]] std::string ensemble_of(const Stage& stage);

/// Degrees of freedom of the kinetic energy of a stage's run: 3 N where its thermostat also acts on the centre of mass,
/// else 3 N - 3.
[[nodiscard]] Index freedom_of(const Stage& stage, Index atoms);

/// All parameters of a problem as JSON, with words for whoever reads them: docs/judge.md lists the keys.
[[nodiscard]] std::string problem_json(const Problem& problem);

/// Write problem.json, start.xyz (positions in the box, velocities, ids from 1) and start.data (LAMMPS data).
/// @param force  whether existing files of these names are replaced
/// @throws OutputRefused as require_writable(); FileError
void write_problem(const Problem& problem, const std::filesystem::path& directory, bool force = false);

/// The configuration that was written, to the last bit; the potential is the problem's.
/// @throws DataError  start.xyz cannot be read, or has no velocities
[[nodiscard]] Fluid read_start(const std::filesystem::path& directory, const PairPotential& potential, bool tail);

}  // namespace ljmd
