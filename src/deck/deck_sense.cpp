#include "ljmd/deck/deck_sense.hpp"

#include <fmt/format.h>

#include "ljmd/deck/analysis_sense.hpp"
#include "ljmd/deck/fluid.hpp"
#include "ljmd/deck/mistake_report.hpp"
#include "ljmd/deck/stage_sense.hpp"
#include "ljmd/model/box_for_cutoff.hpp"
#include "ljmd/model/lattice.hpp"
#include "ljmd/potentials/pair_potential.hpp"

namespace ljmd {

namespace {

constexpr double unlikely_time_step = 0.02;  // [tau]; slightly above, Lennard-Jones is unstable
constexpr double unlikely_density = 1.5;     // [sigma^-3]; 1.5 times the density of the crystal at its melting point
constexpr double unlikely_temperature = 50;  // [epsilon/k_B]; 6000 K for argon
constexpr double unlikely_cutoff = 6;        // [sigma]; 2.5 to 5 are usual

// Values that validation found wrong are skipped: their stand-ins say nothing about the deck, and each mistake is
// reported once.

/// Whether the key has a valid value.
bool given(const Section& section, const char* key) {
    return section.has(key) && section.sound(key);
}

/// Whether the key was left out, not merely misspelt.
bool absent(const Section& section, const char* key) {
    return !section.has(key) && section.sound(key);
}

/// Report an error that --force turns into a warning.
void unlikely(bool force, const Location& where, const std::string& message, const std::string& hint,
              Diagnostics& diagnostics) {
    if (force) {
        diagnostics.warning(where, message);
    } else {
        diagnostics.error(where, message, hint + "; --force runs it as it is");
    }
}

void check_lattice(const Section& root, Diagnostics& diagnostics) {
    const Section& lattice = root.section("system").section("lattice");
    if (!lattice.sound("type")) {
        return;
    }
    const std::string& type = lattice.text("type");
    const bool cells = lattice.has("cells");
    const bool atoms = lattice.has("atoms");
    if (type == random_lattice) {
        if (cells) {
            diagnostics.error(lattice.location("cells"), "'cells' in lattice has no meaning for a random start",
                              "give 'atoms'");
        } else if (absent(lattice, "atoms")) {
            diagnostics.error(lattice.location(), "missing key 'atoms' in lattice", "a random start needs it");
        }
    } else if (cells && atoms) {
        diagnostics.error(lattice.location("atoms"), "'cells' and 'atoms' in lattice say the same", "give one of them");
    } else if (absent(lattice, "cells") && absent(lattice, "atoms")) {
        diagnostics.error(lattice.location(), "missing key 'cells' in lattice", "or give 'atoms'");
    } else if (given(lattice, "atoms")) {
        const Index wanted = lattice.integer("atoms");
        const Lattice crystal = find_lattice(type);
        const auto near = nearest_cells(crystal, wanted);
        if (near.below != near.above) {
            diagnostics.error(lattice.location("atoms"),
                              fmt::format("'atoms' in lattice is {}, which fills no {} crystal", wanted, type),
                              fmt::format("nearest: {} or {}", lattice_atoms(crystal, near.below),
                                          lattice_atoms(crystal, near.above)));
        }
    } else if (given(lattice, "cells")) {
        report(lattice_mistakes({find_lattice(type), lattice.integer("cells")}), root, diagnostics);
    }
}

void check_system(const Section& root, bool force, Diagnostics& diagnostics) {
    const Section& system = root.section("system");
    if (system.has("lattice") == system.has("file") && system.sound("lattice") && system.sound("file")) {
        diagnostics.error(system.location("file"), "[system] needs one of 'lattice' and 'file'",
                          system.has("file") ? "remove one of them" : "e.g. lattice = { type = \"fcc\", cells = 6 }");
    }
    if (given(system, "lattice")) {
        check_lattice(root, diagnostics);
        for (const char* key : {"density", "temperature"}) {
            if (absent(system, key)) {
                diagnostics.error(system.location(), fmt::format("missing key '{}' in [system]", key),
                                  "a start from a lattice needs it");
            }
        }
        if (system.has("xyz_comment")) {
            diagnostics.error(system.location("xyz_comment"),
                              "'xyz_comment' in [system] belongs to a 'file', but there is none", "remove it");
        }
        if (system.has("velocities") && system.text("velocities") == "file") {
            diagnostics.error(system.location("velocities"), "'velocities' in [system] is 'file', but there is no file",
                              "use 'maxwell'");
        }
    }
    if (!system.has("lattice") && system.has("velocities") && system.text("velocities") == "maxwell" &&
        !system.has("temperature")) {
        diagnostics.error(system.location("velocities"), "missing key 'temperature' in [system]",
                          "Maxwell's distribution needs it");
    }
    if (given(system, "density") && system.number("density") > unlikely_density) {
        unlikely(force, system.location("density"),
                 fmt::format("'density' in [system] is {:.6g}, above {}", system.number("density"), unlikely_density),
                 "liquid argon has 0.84, its crystal 1.0", diagnostics);
    }
}

void check_temperature(const Section& section, bool force, Diagnostics& diagnostics) {
    if (given(section, "temperature") && section.number("temperature") > unlikely_temperature) {
        unlikely(force, section.location("temperature"),
                 fmt::format("'temperature' in {} is {:.6g} epsilon/k_B, above {}", section.title(),
                             section.number("temperature"), unlikely_temperature),
                 "for kelvin, give [argon] and write \"86.5 K\"", diagnostics);
    }
}

constexpr const char* angstrom_hint = "for angstrom, give [argon] and write \"8.5 angstrom\"";

void check_potential(const Section& root, Diagnostics& diagnostics) {
    const Section& potential = root.section("potential");
    if (given(potential, "cutoff") && potential.number("cutoff") > unlikely_cutoff) {
        diagnostics.warning(potential.location("cutoff"),
                            fmt::format("'cutoff' in [potential] is {:.6g} sigma, more than {}",
                                        potential.number("cutoff"), unlikely_cutoff),
                            angstrom_hint);
    }
    if (!potential.sound("truncation")) {
        return;
    }
    const std::string& truncation = potential.text("truncation");
    if (PairPotential::takes_tail(truncation) && absent(potential, "tail")) {
        diagnostics.error(potential.location(), "missing key 'tail' in [potential]",
                          fmt::format("true or false: truncation = \"{}\" leaves the choice", truncation));
    }
    const auto number = [&](const char* key) { return potential.has(key) ? potential.number(key) : 0.0; };
    const bool tail = given(potential, "tail") && potential.flag("tail");
    report(potential_mistakes(truncation, {number("cutoff"), number("switch_start")}, tail), root, diagnostics);
}

/// Refuse settings that only a Verlet list supports.
void check_search(const Section& root, Diagnostics& diagnostics) {
    const Section& performance = root.section("performance");
    const Precision precision =
        performance.sound("precision") ? precision_of(performance.text("precision")) : Precision::double_precision;
    if (root.section("neighbors").sound("method")) {
        report(search_mistakes(neighbor_spec(root.section("neighbors")), precision), root, diagnostics);
    }
}

void check_stages(const Section& root, bool force, Diagnostics& diagnostics) {
    for (const Section& stage : root.sections("stage")) {
        if (given(stage, "time_step") && stage.number("time_step") >= unlikely_time_step) {
            unlikely(force, stage.location("time_step"),
                     fmt::format("'time_step' in [[stage]] is {:.6g} tau; from {} on the energy is not conserved",
                                 stage.number("time_step"), unlikely_time_step),
                     "0.004 is usual", diagnostics);
        }
        check_temperature(stage, force, diagnostics);
    }
    check_fluid_stages(root, diagnostics);
}

void check_output(const Section& output, bool has_units, Diagnostics& diagnostics) {
    if (output.has("directory") && output.text("directory").empty()) {
        diagnostics.error(output.location("directory"), "'directory' in [output] is empty");
    }
    if (output.has("trajectory")) {
        const Section& trajectory = output.section("trajectory");
        if (trajectory.text("units") == "si" && !has_units) {
            diagnostics.error(trajectory.location("units"),
                              "'units' in trajectory is 'si', which needs an [argon] table");
        }
    }
}

/// Number of atoms of a lattice start; nothing if the deck has too many errors to determine it or the box.
std::optional<Index> lattice_start(const Section& system) {
    if (!given(system, "lattice") || !given(system, "density")) {
        return std::nullopt;
    }
    const Section& lattice = system.section("lattice");
    if (!given(lattice, "type") || given(lattice, "atoms") == given(lattice, "cells")) {
        return std::nullopt;
    }
    const std::string& type = lattice.text("type");
    const bool by_cells = given(lattice, "cells");
    if (type == random_lattice) {
        return by_cells ? std::nullopt : std::optional<Index>(lattice.integer("atoms"));
    }
    const Lattice crystal = find_lattice(type);
    const auto near = by_cells ? NearestCells{lattice.integer("cells"), lattice.integer("cells")}
                               : nearest_cells(crystal, lattice.integer("atoms"));
    return near.below == near.above ? std::optional(lattice_atoms(crystal, near.below)) : std::nullopt;
}

}  // namespace

void check_sense(const Section& root, bool has_units, bool force, Diagnostics& diagnostics) {
    const Section& system = root.section("system");
    if (root.sound("system")) {
        check_system(root, force, diagnostics);
        check_temperature(system, force, diagnostics);
    }
    if (root.sound("potential")) {
        check_potential(root, diagnostics);
    }
    if (root.sound("neighbors") && root.sound("performance")) {
        check_search(root, diagnostics);
    }
    check_stages(root, force, diagnostics);
    check_output(root.section("output"), has_units, diagnostics);
    if (const auto atoms = root.sound("system") ? lattice_start(system) : std::nullopt) {
        const Section& potential = root.section("potential");
        const Box box = cubic_box(*atoms, system.number("density"));
        check_box(root, *atoms, given(potential, "cutoff") ? box_for_cutoff(box, potential.number("cutoff")) : box,
                  diagnostics);
    }
}

void check_box(const Section& root, Index atoms, const Box& box, Diagnostics& diagnostics) {
    const double cutoff = root.section("potential").number("cutoff");
    std::vector<Mistake> mistakes = cutoff_mistakes(cutoff, box);
    for (Mistake& mistake : mistakes) {
        mistake.hint += cutoff > unlikely_cutoff ? fmt::format("; {}", angstrom_hint) : "";
    }
    report(mistakes, root, diagnostics);
    if (!root.sections("stage").empty()) {
        check_analyses(root, atoms, box, diagnostics);
    }
}

}  // namespace ljmd
