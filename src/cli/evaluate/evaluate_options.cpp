#include "ljmd/cli/evaluate/evaluate_options.hpp"

#include "ljmd/execution/threads.hpp"
#include "ljmd/input/reduced_number.hpp"
#include "ljmd/potentials/pair_potential.hpp"

namespace ljmd {

namespace {

CLI::Validator reduced_length() {
    return {[](const std::string& text) { return not_reduced(text, "sigma", Dimension::length); }, ""};
}

void add_potential_options(CLI::App& command, EvaluateOptions& options) {
    command.add_option("--cutoff", options.cutoff, "without a deck: pairs closer than this interact, in sigma")
        ->type_name("RC")
        ->check(reduced_length());
    command.add_option("--truncation", options.truncation, "without a deck: what happens at the cutoff")
        ->type_name("HOW")
        ->check(CLI::IsMember(PairPotential::truncation_names()));
    command
        .add_option("--tail", options.tail,
                    "without a deck: true or false, correct for what cut and switched leave out")
        ->type_name("BOOL")
        ->check(CLI::IsMember({"true", "false"}));
    command.add_option("--switch-start", options.switch_start, "without a deck: where switched begins, in sigma")
        ->type_name("R")
        ->check(reduced_length());
    command.add_option("--potential", options.potential, "without a deck: lennard-jones by default")
        ->type_name("TYPE")
        ->check(CLI::IsMember(PairPotential::formula_names()));
    command.add_option("--parameter", options.parameters, "without a deck: one of the potential's, in reduced units")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
}

}  // namespace

EvaluateCommand::EvaluateCommand(CLI::App& app)
    : command_(
          *app.add_subcommand("evaluate", "energy, virial, pressure and forces of a configuration; nothing is run")) {
    command_
        .add_option("configuration", options_.path,
                    "configuration or trajectory in any format that is read, or directory of a run, whose final.xyz is "
                    "taken")
        ->required()
        ->type_name("CONFIGURATION");
    command_.add_option("--deck", options_.deck, "deck with the potential, and [argon] for files in SI units")
        ->type_name("DECK");
    command_.add_option("--set", options_.settings, "replace a value of the deck, e.g. --set potential.cutoff=3.0")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    add_potential_options(command_, options_);
    command_.add_option("--frame", options_.frame, "one frame of a trajectory, counted from 1; all by default")
        ->type_name("K")
        ->check(CLI::PositiveNumber);
    command_.add_option("--group", options_.group, "of an H5MD file with several groups of particles, the one to take")
        ->type_name("NAME");
    command_
        .add_option("--xyz-comment", options_.xyz_comment,
                    "what the comment lines of an XYZ file lack, e.g. 'Lattice=\"20 0 0 0 20 0 0 0 20\"'")
        ->type_name("KEY=VALUE...");
    command_
        .add_option("--out", options_.out,
                    "file to write, with forces and energies of the atoms: *.xyz, or *.lammpsdump")
        ->type_name("FILE");
    command_
        .add_option("--threads", options_.threads,
                    "threads to share the work, 1 or OMP_NUM_THREADS by default; no result depends on it")
        ->type_name("N")
        ->check(CLI::Range(1, max_threads));
    command_.add_flag("--force", options_.force, "replace the file if it exists");
    command_.add_flag("--json", options_.json, "print the result as JSON, with forces and energies of all atoms");
}

}  // namespace ljmd
