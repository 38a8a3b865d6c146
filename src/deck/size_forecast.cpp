#include "deck/size_forecast.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/formats/trajectory_writer.hpp"
#include "neighbors/linked_cells.hpp"

namespace ljmd {

namespace {

// Bytes, measured in runs of 4,000 to 1,000,000 atoms at densities of 0.05 to 0.85.
constexpr double program_itself = 21.3e6;  // with its libraries and the buffers of its files
constexpr double checkpoint_of_few = 4e3;
constexpr double checkpoint_of_atom = 110.0;  // positions, velocities, forces, masses, ids, images
constexpr double checkpoint_of_list = 32.0;   // positions at which it was built
constexpr double atom_itself = 150.0;         // the same in memory, plus space for sorting
constexpr double atom_in_cells = 10.0;
constexpr double point_in_cells = 8.0;  // atoms and ghosts
constexpr double image = 32.0;
constexpr double atom_on_list = 98.0;      // clusters, ghosts of tiles and their forces
constexpr double neighbor_on_list = 0.85;  // per neighbour within its range; each pair is listed once, in clusters
constexpr double atom_on_mixed_list = 73.0;
constexpr double neighbor_on_mixed_list = 0.56;

// Bytes per row of thermo.csv, without and with SI columns.
constexpr double thermo_row = 240.0;
constexpr double thermo_row_si = 350.0;
constexpr double records = 8e3;  // run.json, results.json, results.txt

double points_around(const Deck& deck, const Start& start) {
    const double range = deck.potential().radius + deck.neighbors().skin;
    const double density = static_cast<double>(start.atoms) / start.box.volume();
    return density * 4.0 / 3.0 * std::numbers::pi * range * range * range;
}

/// Bytes per atom in the pair search.
double search(const Deck& deck, const Start& start) {
    if (deck.neighbors().keeps_list()) {
        const bool mixed = deck.fluid().performance.precision == "mixed";
        return mixed ? atom_on_mixed_list + neighbor_on_mixed_list * points_around(deck, start)
                     : atom_on_list + neighbor_on_list * points_around(deck, start);
    }
    if (deck.neighbors().method == LinkedCells::name) {
        const double halo = 2.0 * deck.potential().radius;
        const double points = (start.box.edges().array() + halo).prod() / start.box.volume();
        return atom_in_cells + point_in_cells * points + image * (points - 1.0);
    }
    return 0.0;
}

AnalysisSize analyses(const Deck& deck, const Start& start) {
    const SampledRun run = sampled_run(deck, start.atoms, start.box);
    AnalysisSize sum{0.0};
    for (const Choice& analysis : deck.fluid().analysis.asked) {
        const AnalysisSize size = chosen_analysis(analysis).options->size(run);
        sum.kept += size.kept;
        sum.fixed += size.fixed;
        sum.passing = std::max(sum.passing, size.passing);
    }
    return sum;
}

double checkpoint(const Deck& deck, const Start& start, const AnalysisSize& analyses) {
    const double list = deck.neighbors().keeps_list() ? checkpoint_of_list : 0.0;
    return checkpoint_of_few + analyses.kept + (checkpoint_of_atom + list) * static_cast<double>(start.atoms);
}

double trajectory(const Deck& deck, const Start& start) {
    if (!deck.trajectory) {
        return 0.0;
    }
    const Index frames = 1 + total_steps(deck.stages()) / deck.trajectory->every;
    return trajectory_bytes(deck.trajectory->format, start.atoms, frames,
                            {.velocities = deck.trajectory->velocities,
                             .forces = deck.trajectory->forces,
                             .energies = deck.trajectory->energies});
}

}  // namespace

SizeForecast forecast_size(const Deck& deck, const Start& start) {
    const AnalysisSize analyzed = analyses(deck, start);
    const auto atoms = static_cast<double>(start.atoms);
    const double one_checkpoint = checkpoint(deck, start, analyzed);
    const double memory = program_itself + (atom_itself + search(deck, start)) * atoms + analyzed.kept +
                          analyzed.fixed + analyzed.passing;
    const Index rows_after_start = total_steps(deck.stages()) / deck.sample_every();
    const double rows = 1.0 + static_cast<double>(rows_after_start);
    const double disk = records + rows * (deck.units() ? thermo_row_si : thermo_row) + trajectory(deck, start) +
                        trajectory_bytes("xyz", start.atoms, 1, {.velocities = true}) +  // final.xyz
                        static_cast<double>(deck.checkpoint.keep) * one_checkpoint;
    return {memory, disk};
}

}  // namespace ljmd
