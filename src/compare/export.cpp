#include "compare/export.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

#include "compare/fluid.hpp"
#include "compare/lammps_input.hpp"
#include "compare/openmm.hpp"
#include "core/text.hpp"
#include "deck/fluid.hpp"
#include "engine/fluid_system.hpp"
#include "io/files/output_file.hpp"
#include "io/files/shell_word.hpp"
#include "io/formats/extended_xyz_writer.hpp"
#include "io/formats/trajectory_writer.hpp"
#include "ljmd/core/build_info.hpp"
#include "ljmd/core/errors.hpp"
#include "options/toml_writer.hpp"
#include "run/output_guard.hpp"
#include "run/run_directory.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

/// Input of an export.
struct Export {
    const Deck& deck;
    const State& state;
    fs::path directory;
    bool forces;  ///< whether the state's forces are current, and written
    Replacing allowed;

    [[nodiscard]] Fluid fluid() const {
        if (const std::string& external = deck.given.external; !external.empty()) {
            throw InputError(fmt::format(
                "the external force {} is a force of the program that made the run, which other programs do "
                "not have: only the configuration can be exported, to extxyz or h5md",
                in_quotes(external)));
        }
        const FluidSpec spec = fluid_spec(deck);
        if (spec.potential.is_custom()) {
            throw InputError(
                fmt::format("the pair potential {} is a formula of the program that made the run, which other programs "
                            "do not have: only the configuration can be exported, to extxyz or h5md",
                            in_quotes(spec.potential.formula())));
        }
        return fluid_of(state, spec.potential, spec.has_tail());
    }
};

/// Parts of the deck that are not exported: the files hold a configuration, a potential and the time step of one stage.
/// @param to_come  whether the configuration is from before the first stage, else from after the last one
std::vector<std::string> left_out(const Deck& deck, bool to_come) {
    const Stage& exported = exported_stage(deck);
    std::vector<std::string> words;
    std::vector<std::string> others;
    for (const Stage& stage : deck.stages()) {
        if (&stage != &exported && stage.steps > 0) {
            others.push_back(stage.name);
        }
    }
    if (to_come && !others.empty()) {
        words.push_back(fmt::format("left out: stage{} '{}'; the motion exported is that of '{}'",
                                    others.size() == 1 ? "" : "s", fmt::join(others, "', '"), exported.name));
    }
    if (exported.thermostat) {
        words.push_back(
            fmt::format("the thermostat '{}' of stage '{}' is left out: the exported motion is at constant energy",
                        exported.thermostat->name, exported.name));
    }
    if (exported.barostat) {
        words.push_back(
            fmt::format("the barostat '{}' of stage '{}' is left out: the exported motion is at constant volume",
                        exported.barostat->name, exported.name));
    }
    if (const std::string& name = exported.integrator.name; name != "velocity-verlet") {
        words.push_back(fmt::format("stage '{}' moves the atoms by '{}', the exported motion is velocity Verlet's",
                                    exported.name, name));
    }
    if (exported.total_energy && to_come) {
        words.push_back(fmt::format(
            "stage '{}' scales velocities to total_energy at its beginning, the exported ones are not", exported.name));
    }
    if (!exported.until.empty()) {
        words.push_back(fmt::format("stage '{}' ends when errors are reached; exported are its max_steps, {}",
                                    exported.name, exported.steps));
    }
    if (exported.reverse) {
        words.push_back(
            fmt::format("stage '{}' turns the motion round, the exported motion goes forward", exported.name));
    }
    return words;
}

/// Usage and warnings of an export.
struct Notes {
    std::string usage;
    std::vector<std::string> warnings{};
};

Notes export_lammps(const Export& what) {
    const Fluid fluid = what.fluid();
    const Stage& stage = exported_stage(what.deck);
    const std::string title = what.deck.title.empty() ? what.deck.path : what.deck.title;
    // Refuse unsupported potentials before anything is written.
    const std::string input = lammps_user_input(fluid, stage.time_step, stage.steps, title);
    make_directory(what.directory);
    write_output(what.directory / LammpsFiles::start, what.allowed, lammps_data(fluid));
    write_output(what.directory / "in.lammps", what.allowed, input);
    Notes notes{fmt::format("cd {} && lmp -in in.lammps", shell_word(what.directory)),
                left_out(what.deck, what.state.step == 0)};
    if (fluid.tail && !lammps_has_tail(fluid.potential)) {
        notes.warnings.push_back(
            fmt::format("LAMMPS has no tail corrections for '{}' with truncation '{}': its energy and "
                        "pressure are without them",
                        fluid.potential.formula(), fluid.potential.truncation()));
    }
    return notes;
}

Notes export_openmm(const Export& what) {
    const OpenmmXml xml = openmm_xml(what.fluid(), exported_stage(what.deck).time_step);
    make_directory(what.directory);
    write_output(what.directory / "system.xml", what.allowed, xml.system);
    write_output(what.directory / "state.xml", what.allowed, xml.state);
    write_output(what.directory / "integrator.xml", what.allowed, xml.integrator);
    return {
        "in Python: system, state, integrator = "
        "[openmm.XmlSerializer.deserialize(open(name).read()) for name in\n"
        "               (\"system.xml\", \"state.xml\", \"integrator.xml\")]\n"
        "           context = openmm.Context(system, integrator); context.setState(state)",
        left_out(what.deck, what.state.step == 0)};
}

Notes export_extxyz(const Export& what) {
    make_directory(what.directory);
    const fs::path path = what.directory / "start.xyz";
    write_output(path, what.allowed, [&](OutputFile& file) {
        write_extended_xyz_frame(file, what.state, {.velocities = true, .forces = what.forces}, std::nullopt);
    });
    return {fmt::format("in a deck: [system] file = {}; in Python: ase.io.read(\"start.xyz\")",
                        toml_string(path.string()))};
}

/// A trajectory writer does not replace its file atomically, so this one gets a temporary place until it is complete.
Notes export_h5md(const Export& what) {
    make_directory(what.directory);
    const fs::path path = what.directory / "start.h5md";
    NamedOutput file(path, what.allowed);
    const auto writer = make_trajectory_writer("h5md", what.state,
                                               {.path = file.growing().growing(),
                                                .velocities = true,
                                                .forces = what.forces,
                                                .creator_version = build_info().version,
                                                .title = what.deck.title});
    writer->write(what.state);
    writer->close();
    file.take_place();
    return {fmt::format("in a deck: [system] file = {}; it opens with MDAnalysis, VMD and h5py",
                        toml_string(path.string()))};
}

struct Target {
    const char* name;
    std::vector<std::string> files;
    bool has_forces;  ///< as a column
    Notes (*write)(const Export&);
};

const std::array<Target, 4>& all_targets() {
    static const std::array<Target, 4> all{
        Target{"lammps", {LammpsFiles::start, "in.lammps"}, false, export_lammps},
        Target{"openmm", {"system.xml", "state.xml", "integrator.xml"}, false, export_openmm},
        Target{"extxyz", {"start.xyz"}, true, export_extxyz}, Target{"h5md", {"start.h5md"}, true, export_h5md}};
    return all;
}

const Target& find_target(const std::string& name) {
    for (const Target& target : all_targets()) {
        if (target.name == name) {
            return target;
        }
    }
    throw InputError(
        fmt::format("unknown target '{}' to export to, allowed: '{}'", name, fmt::join(export_targets(), "', '")));
}

/// The configuration with the forces of the deck's potential.
State with_forces(const Deck& deck, const Target& target, const State& state) {
    if (!target.has_forces) {
        throw InputError(fmt::format(
            "--forces: {} computes them itself, its files hold none; allowed with extxyz and h5md", target.name));
    }
    const FluidSpec spec = fluid_spec(deck);
    if (!deck.given.external.empty() || spec.potential.is_custom()) {
        throw InputError(
            "--forces: they were those of the program that made the run, whose potential or force is not known here; "
            "without --forces the configuration can be exported");
    }
    State copy = state;
    make_force_field(spec, copy.execution()).evaluate(copy, Request::forces);
    return copy;
}

}  // namespace

std::vector<std::string> export_targets() {
    std::vector<std::string> names;
    for (const Target& target : all_targets()) {
        names.emplace_back(target.name);
    }
    return names;
}

const Stage& exported_stage(const Deck& deck) {
    return deck.stages()[first_sampled(deck.stages())];
}

void check_export(const std::string& target, const fs::path& directory, bool force) {
    require_no_outputs(directory, find_target(target).files, force, "Nothing was written");
}

std::vector<fs::path> export_files(const std::string& target, const fs::path& directory) {
    std::vector<fs::path> files;
    for (const std::string& name : find_target(target).files) {
        files.push_back(directory / name);
    }
    return files;
}

Exported export_configuration(const Deck& deck, const State& state, const std::string& target,
                              const fs::path& directory, bool forces, bool force) {
    const Target& chosen = find_target(target);
    const Replacing allowed{.force = force, .instead = another_directory};
    const Notes notes = forces ? chosen.write({deck, with_forces(deck, chosen, state), directory, true, allowed})
                               : chosen.write({deck, state, directory, false, allowed});
    return {export_files(target, directory), notes.usage, notes.warnings};
}

}  // namespace ljmd
