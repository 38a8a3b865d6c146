#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

#include "cli/command.hpp"
#include "cli/deck_options.hpp"
#include "cli/streams.hpp"
#include "compare/export.hpp"
#include "deck/deck_sense.hpp"
#include "deck/deck_system.hpp"
#include "io/files/file_system.hpp"
#include "io/files/input_file.hpp"
#include "io/tables/json_text.hpp"
#include "run/output_guard.hpp"
#include "run/recorded_run.hpp"
#include "run/run_directory.hpp"

namespace ljmd {

namespace {

/// Input of `ljmd export`: a deck and its start configuration, or a run's deck and its last configuration.
struct Exportable {
    Deck deck;
    State state;
};

void refuse_bodies(const Deck& deck) {
    require_fluid(deck, "a few-body deck has no box and no pair potential: `ljmd export` wants a fluid");
}

Exportable end_of_run(const DeckOptions& options, Diagnostics& diagnostics) {
    const Deck deck = recorded_deck(options.deck, options.settings, diagnostics);
    refuse_bodies(deck);
    State state = last_configuration(options.deck, deck);
    check_box(deck.fluid(), state.count(), state.box(), diagnostics);
    diagnostics.throw_if_errors();
    return {deck, std::move(state)};
}

Exportable start_of_deck(const DeckOptions& options, Diagnostics& diagnostics) {
    const Deck deck = options.load(diagnostics);
    refuse_bodies(deck);
    CheckedRun fluid = options.checked(deck, diagnostics);
    FluidSystem simulation =
        make_fluid(fluid_spec(deck, std::move(fluid.start.value())), fluid.execution, [&](const std::string& text) {
            if (!options.quiet) {
                warn(text);
            }
        });
    return {deck, std::move(simulation.state)};
}

/// "argon-lammps" for `argon.toml` or `runs/argon` and target `lammps`; in the working directory.
std::filesystem::path export_directory(const std::filesystem::path& source, bool is_run, const std::string& to) {
    const std::filesystem::path whole = files::absolute(source).lexically_normal();
    const std::filesystem::path name = !is_run                ? whole.stem()
                                       : whole.has_filename() ? whole.filename()
                                                              : whole.parent_path().filename();
    return output_name(name.string(), "-" + to);
}

std::string export_json(const Exportable& what, const Exported& written, const std::string& to) {
    std::vector<std::string> files;
    for (const std::filesystem::path& file : written.files) {
        files.push_back(file.string());
    }
    const Data json = {{"target", to},
                       {"files", files},
                       {"atoms", what.state.count()},
                       {"step", what.state.step},
                       {"stage", exported_stage(what.deck).name},
                       {"time_step", exported_stage(what.deck).time_step},
                       {"warnings", written.warnings}};
    return to_json(json) + "\n";
}

std::string export_report(const Exportable& what, const Exported& written) {
    const Stage& stage = exported_stage(what.deck);
    std::string text = fmt::format("{} atoms after {} steps; time step {} tau, of stage '{}'\n", what.state.count(),
                                   what.state.step, stage.time_step, stage.name);
    for (const std::filesystem::path& file : written.files) {
        text += fmt::format("  {}\n", file.string());
    }
    return text + written.usage + "\n";
}

class ExportCommand : public Command {
  public:
    ExportCommand()
        : Command("export", Part::peers,
                  "write the start of a deck, or the end of a run, for another program; nothing is run") {}

    void add_options(CLI::App& command) override {
        options_.add_to(command);
        command.get_option("deck")->description("deck (TOML), or directory of a run")->type_name("DECK|RUNDIR");
        command
            .add_option("--to", to_,
                        fmt::format("{}: the last two are configurations alone", fmt::join(export_targets(), ", ")))
            ->required()
            ->type_name("TARGET");
        command.add_option("--out", out_, "directory for the files; by default NAME-TARGET in the working directory")
            ->type_name("DIR");
        command.add_flag("--forces", forces_, "extxyz, h5md: with the forces on the atoms, by the deck's potential");
    }

    void run() override {
        const bool is_run = input_is_directory(options_.deck);
        const std::filesystem::path directory =
            out_.empty() ? export_directory(options_.deck, is_run, to_) : std::filesystem::path(out_);
        check_export(to_, directory, options_.force);
        Diagnostics diagnostics;
        const Exportable what = is_run ? end_of_run(options_, diagnostics) : start_of_deck(options_, diagnostics);
        require_no_input(what.deck, export_files(to_, directory), "Nothing was written");
        const Exported written = export_configuration(what.deck, what.state, to_, directory, forces_, options_.force);
        if (!options_.quiet) {
            for (const std::string& warning : written.warnings) {
                warn(warning);
            }
        }
        print_result(options_.json ? export_json(what, written, to_) : export_report(what, written));
    }

  private:
    DeckOptions options_;
    std::string to_;
    std::string out_;
    bool forces_ = false;
};

}  // namespace

std::shared_ptr<Command> export_command() {
    return std::make_shared<ExportCommand>();
}

}  // namespace ljmd
