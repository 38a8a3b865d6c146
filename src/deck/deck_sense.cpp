#include "deck/deck_sense.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "deck/analysis_sense.hpp"
#include "deck/fluid.hpp"
#include "deck/mistake_report.hpp"
#include "deck/stage_sense.hpp"
#include "engine/mistakes/film_mistakes.hpp"
#include "ljmd/model/lattice.hpp"
#include "ljmd/potentials/pair_potential.hpp"
#include "model/box_for_cutoff.hpp"

namespace ljmd {

namespace {

constexpr double unlikely_time_step = 0.02;  // [tau]; slightly above, Lennard-Jones is unstable
constexpr double unlikely_density = 1.5;     // [sigma^-3]; 1.5 times the density of the crystal at its melting point
constexpr double unlikely_temperature = 50;  // [epsilon/k_B]; 6000 K for argon
constexpr double unlikely_cutoff = 6;        // [sigma]; 2.5 to 5 are usual
constexpr double core = 1.0;                 // [sigma]; where Lennard-Jones' potential is 0
constexpr double unlikely_flight = 3.0;      // in units of the skin, of a free atom while a list is kept

// Values that validation found wrong are skipped: their stand-ins say nothing about the deck, and each mistake is
// reported once.

/// Report an error that --force turns into a warning.
void unlikely(bool force, const Location& where, const std::string& message, const std::string& hint,
              Diagnostics& diagnostics) {
    if (force) {
        diagnostics.warning(where, message);
    } else {
        diagnostics.error(where, message, hint + "; --force runs it as it is");
    }
}

void check_lattice(const Placed<FluidTables>& tables, Diagnostics& diagnostics) {
    const Placed<LatticeTable>& lattice = *tables.system.lattice;
    if (!lattice.sound(&LatticeTable::type)) {
        return;
    }
    const bool no_cells = lattice.absent(&LatticeTable::cells);
    const bool no_atoms = lattice.absent(&LatticeTable::atoms);
    if (lattice.atoms && lattice.layers) {
        diagnostics.error(lattice.location(&LatticeTable::layers), "'layers' in lattice goes with 'cells'",
                          "give 'cells' instead of 'atoms'");
    } else if (lattice.is_random()) {
        if (lattice.height) {
            diagnostics.error(lattice.location(&LatticeTable::height),
                              "'height' in lattice has no meaning for a random start", "a film starts from a crystal");
        }
        if (lattice.cells) {
            diagnostics.error(lattice.location(&LatticeTable::cells),
                              "'cells' in lattice has no meaning for a random start", "give 'atoms'");
        } else if (no_atoms) {
            diagnostics.error(lattice.location(), "missing key 'atoms' in lattice", "a random start needs it");
        }
    } else if (lattice.cells && lattice.atoms) {
        diagnostics.error(lattice.location(&LatticeTable::atoms), "'cells' and 'atoms' in lattice say the same",
                          "give one of them");
    } else if (no_cells && no_atoms) {
        diagnostics.error(lattice.location(), "missing key 'cells' in lattice", "or give 'atoms'");
    } else if (lattice.given(&LatticeTable::atoms)) {
        const Index wanted = *lattice.atoms;
        const auto near = nearest_cells(lattice.crystal(), wanted);
        if (near.below != near.above) {
            diagnostics.error(lattice.location(&LatticeTable::atoms),
                              fmt::format("'atoms' in lattice is {}, which fills no {} crystal", wanted, lattice.type),
                              fmt::format("nearest: {} or {}", lattice_atoms(lattice.crystal(), near.below),
                                          lattice_atoms(lattice.crystal(), near.above)));
        }
    } else if (lattice.given(&LatticeTable::cells)) {
        report(lattice_mistakes(lattice.start()), tables, diagnostics);
    }
}

void check_system(const Placed<FluidTables>& tables, bool force, Diagnostics& diagnostics) {
    const Placed<SystemTable>& system = tables.system;
    if (system.lattice.has_value() == system.file.has_value() && system.sound(&SystemTable::lattice) &&
        system.sound(&SystemTable::file)) {
        diagnostics.error(system.location(&SystemTable::file), "[system] needs one of 'lattice' and 'file'",
                          system.file ? "remove one of them" : "e.g. lattice = { type = \"fcc\", cells = 6 }");
    }
    if (system.given(&SystemTable::lattice)) {
        check_lattice(tables, diagnostics);
        for (const auto member : {&SystemTable::density, &SystemTable::temperature}) {
            if (system.absent(member)) {
                diagnostics.error(system.location(),
                                  fmt::format("missing key '{}' in [system]", Placed<SystemTable>::key(member)),
                                  "a start from a lattice needs it");
            }
        }
        if (system.xyz_comment) {
            diagnostics.error(system.location(&SystemTable::xyz_comment),
                              "'xyz_comment' in [system] belongs to a 'file', but there is none", "remove it");
        }
        if (system.wants_velocities_of_file()) {
            diagnostics.error(system.location(&SystemTable::velocities),
                              "'velocities' in [system] is 'file', but there is no file", "use 'maxwell'");
        }
    }
    if (!system.lattice && system.draws_velocities() && !system.temperature) {
        diagnostics.error(system.location(&SystemTable::velocities), "missing key 'temperature' in [system]",
                          "Maxwell's distribution needs it");
    }
    if (system.given(&SystemTable::density) && *system.density > unlikely_density) {
        unlikely(force, system.location(&SystemTable::density),
                 fmt::format("'density' in [system] is {:.6g}, above {}", *system.density, unlikely_density),
                 "liquid argon has 0.84, its crystal 1.0", diagnostics);
    }
}

/// Of [system] or a stage.
template <class Table>
void check_temperature(const Placed<Table>& table, bool force, Diagnostics& diagnostics) {
    if (table.given(&Table::temperature) && *table.temperature > unlikely_temperature) {
        unlikely(force, table.location(&Table::temperature),
                 fmt::format("'temperature' in {} is {:.6g} epsilon/k_B, above {}", table.heading(), *table.temperature,
                             unlikely_temperature),
                 "for kelvin, give [argon] and write \"86.5 K\"", diagnostics);
    }
}

constexpr const char* angstrom_hint = "for angstrom, give [argon] and write \"8.5 angstrom\"";

void check_potential(const Placed<FluidTables>& tables, bool force, Diagnostics& diagnostics) {
    const Placed<PotentialTable>& potential = tables.potential;
    if (potential.given(&PotentialTable::radius) && potential.radius < core && potential.sound(&PotentialTable::type) &&
        potential.type == "lennard-jones") {
        unlikely(force, potential.location(&PotentialTable::radius),
                 fmt::format("'cutoff' in [potential] is {:.6g} sigma: below {:.6g} the core of the potential is cut, "
                             "and atoms fly through each other until two of them blow up the run",
                             potential.radius, core),
                 "2.5 is usual", diagnostics);
    }
    if (potential.given(&PotentialTable::radius) && potential.radius > unlikely_cutoff) {
        diagnostics.warning(
            potential.location(&PotentialTable::radius),
            fmt::format("'cutoff' in [potential] is {:.6g} sigma, more than {}", potential.radius, unlikely_cutoff),
            angstrom_hint);
    }
    if (!potential.sound(&PotentialTable::truncation)) {
        return;
    }
    if (PairPotential::takes_tail(potential.truncation) && potential.absent(&PotentialTable::tail)) {
        diagnostics.error(potential.location(), "missing key 'tail' in [potential]",
                          fmt::format("true or false: truncation = \"{}\" leaves the choice", potential.truncation));
    }
    const bool tail = potential.given(&PotentialTable::tail) && potential.has_tail();
    report(potential_mistakes(potential.truncation, potential, tail), tables, diagnostics);
}

/// A list that is kept for a fixed number of steps becomes old, which some want to see: how far atoms fly meanwhile,
/// were they free.
void check_age_of_list(const Placed<FluidTables>& tables, Diagnostics& diagnostics) {
    const Placed<NeighborSpec>& neighbors = tables.neighbors;
    if (!neighbors.given(&NeighborSpec::every) || !(neighbors.skin > 0.0)) {
        return;
    }
    double farthest = 0.0;
    for (const Placed<Stage>& stage : tables.stages) {
        const double temperature = stage.temperature.value_or(tables.system.temperature.value_or(0.0));
        farthest = std::max(farthest, std::sqrt(3.0 * temperature) * stage.time_step);
    }
    const double flight = farthest * static_cast<double>(*neighbors.every);
    if (flight > unlikely_flight * neighbors.skin) {
        diagnostics.warning(
            neighbors.location(&NeighborSpec::every),
            fmt::format(
                "'every' in [neighbors] is {}: atoms fly {:.2g} sigma in so many steps, and the skin is {:.6g}, so "
                "that atoms meet unseen, and the run may blow up",
                *neighbors.every, flight, neighbors.skin),
            "leave it out: lists are rebuilt when they have to be");
    }
}

/// Refuse settings that only a Verlet list supports.
void check_search(const Placed<FluidTables>& tables, Diagnostics& diagnostics) {
    check_age_of_list(tables, diagnostics);
    const Placed<PerformanceTable>& performance = tables.performance;
    const Precision precision = performance.sound(&PerformanceTable::precision) ? precision_of(performance.precision)
                                                                                : Precision::double_precision;
    if (tables.neighbors.sound(&NeighborSpec::method)) {
        report(search_mistakes(tables.neighbors, precision), tables, diagnostics);
    }
}

void check_stages(const Placed<FluidTables>& tables, bool force, Diagnostics& diagnostics) {
    for (const Placed<Stage>& stage : tables.stages) {
        if (stage.given(&Stage::time_step) && stage.time_step >= unlikely_time_step) {
            unlikely(force, stage.location(&Stage::time_step),
                     fmt::format("'time_step' in [[stage]] is {:.6g} tau; from {} on the energy is not conserved",
                                 stage.time_step, unlikely_time_step),
                     "0.004 is usual", diagnostics);
        }
        check_temperature(stage, force, diagnostics);
    }
    check_fluid_stages(tables, diagnostics);
}

void check_output(const Placed<FluidOutputTable>& output, bool has_units, Diagnostics& diagnostics) {
    check_directory(output.directory, output.location(&FluidOutputTable::directory), diagnostics);
    if (output.trajectory && output.trajectory->si() && !has_units) {
        diagnostics.error(output.trajectory->location(&TrajectoryOutput::units),
                          "'units' in trajectory is 'si', which needs an [argon] table");
    }
}

struct LatticeAtoms {
    Index atoms;
    Box box;
};

/// Atoms and box of a lattice start; nothing if the deck has too many errors to determine them.
std::optional<LatticeAtoms> lattice_start(const Placed<FluidTables>& tables, Diagnostics& diagnostics) {
    const Placed<SystemTable>& system = tables.system;
    if (!system.given(&SystemTable::lattice) || !system.given(&SystemTable::density)) {
        return std::nullopt;
    }
    const Placed<LatticeTable>& lattice = *system.lattice;
    const bool by_cells = lattice.given(&LatticeTable::cells);
    if (!lattice.given(&LatticeTable::type) || lattice.given(&LatticeTable::atoms) == by_cells ||
        !lattice.sound(&LatticeTable::layers) || !lattice.sound(&LatticeTable::height) ||
        (!by_cells && lattice.layers) || (lattice.is_random() && lattice.height)) {
        return std::nullopt;
    }
    if (lattice.is_random()) {
        return by_cells ? std::nullopt
                        : std::optional(LatticeAtoms{*lattice.atoms, cubic_box(*lattice.atoms, *system.density)});
    }
    const LatticeStart start = lattice.start();
    const Index atoms = lattice_atoms(start.lattice, start.cells, start.layers_along_z());
    if ((!by_cells && atoms != *lattice.atoms) || !lattice_mistakes(start).empty()) {
        return std::nullopt;
    }
    const bool has_tail = tables.potential.given(&PotentialTable::tail) && tables.potential.has_tail();
    const std::vector<Mistake> of_film = film_mistakes(start, *system.density, has_tail);
    report(of_film, tables, diagnostics);
    return of_film.empty() ? std::optional(LatticeAtoms{atoms, lattice_box(start, *system.density)}) : std::nullopt;
}

}  // namespace

void check_sense(const Placed<FluidTables>& tables, bool has_units, bool force, Diagnostics& diagnostics) {
    const Placed<SystemTable>& system = tables.system;
    const Placed<PotentialTable>& potential = tables.potential;
    const bool has_system = tables.sound(&FluidTables::system);
    if (has_system) {
        check_system(tables, force, diagnostics);
        check_temperature(system, force, diagnostics);
    }
    if (tables.sound(&FluidTables::potential)) {
        check_potential(tables, force, diagnostics);
    }
    if (tables.sound(&FluidTables::neighbors) && tables.sound(&FluidTables::performance)) {
        check_search(tables, diagnostics);
    }
    check_stages(tables, force, diagnostics);
    check_output(tables.output, has_units, diagnostics);
    if (const auto start = has_system ? lattice_start(tables, diagnostics) : std::nullopt) {
        const Box box =
            potential.given(&PotentialTable::radius) ? box_for_cutoff(start->box, potential.radius) : start->box;
        check_box(tables, start->atoms, box, diagnostics);
    }
}

void check_directory(const std::optional<std::string>& directory, const Location& where, Diagnostics& diagnostics) {
    if (directory && directory->empty()) {
        diagnostics.error(where, "'directory' in [output] is empty");
    }
}

void check_box(const Placed<FluidTables>& tables, Index atoms, const Box& box, Diagnostics& diagnostics) {
    const double cutoff = tables.potential.radius;
    std::vector<Mistake> mistakes = cutoff_mistakes(cutoff, box);
    for (Mistake& mistake : mistakes) {
        mistake.hint += cutoff > unlikely_cutoff ? fmt::format("; {}", angstrom_hint) : "";
    }
    report(mistakes, tables, diagnostics);
    if (!tables.stages.empty()) {
        check_analyses(tables, atoms, box, diagnostics);
    }
}

}  // namespace ljmd
