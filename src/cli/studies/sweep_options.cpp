#include "ljmd/cli/studies/sweep_options.hpp"

#include "ljmd/cli/studies/study_mode_options.hpp"
#include "ljmd/execution/threads.hpp"

namespace ljmd {

SweepCommand::SweepCommand(CLI::App& app)
    : command_(*app.add_subcommand("sweep",
                                   "run a deck at many settings, several at a time; an interrupted sweep is resumed")) {
    command_
        .add_option("deck", options_.deck, "deck (TOML); with --work and --status the directory of a prepared sweep")
        ->required()
        ->type_name("DECK|DIR");
    command_
        .add_option(
            "--grid", options_.grids,
            "keys to vary, between commas: numbers at equal distances, KEY=FROM:TO:COUNT, or a list, KEY=A|B|C; "
            "all combinations are run, at most 10000")
        ->type_name("KEY=VALUES,...")
        ->allow_extra_args(false);
    command_.add_option("--list", options_.list, "points to run instead: CSV with a header of keys, each row a point")
        ->type_name("FILE");
    command_.add_option("--set", options_.settings, "replace a value of the deck at all points")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command_
        .add_option("--jobs", options_.jobs,
                    "points at a time; one for each processor by default, with --slurm one in each task")
        ->type_name("N")
        ->check(CLI::Range(1, max_threads));
    command_.add_option("--out", options_.out, "directory, runs/DECK-sweep by default")->type_name("DIR");
    command_.add_flag("--force", options_.force, "accept unlikely values; replace another sweep");
    command_.add_flag("--quiet", options_.quiet, "no progress, no warnings about the deck");
    command_.add_flag("--json", options_.json, "print the table, or the status, as JSON");
    add_study_mode(command_, options_.mode);
}

}  // namespace ljmd
