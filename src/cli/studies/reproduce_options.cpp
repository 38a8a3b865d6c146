#include "ljmd/cli/studies/reproduce_options.hpp"

#include "ljmd/cli/studies/study_mode_options.hpp"
#include "ljmd/execution/threads.hpp"

namespace ljmd {

ReproduceCommand::ReproduceCommand(CLI::App& app)
    : command_(*app.add_subcommand("reproduce",
                                   "compute a published table anew, with error bars; an interrupted one is resumed")) {
    command_
        .add_option("table", options_.what,
                    "verlet1967: Phys. Rev. 159, 98; with --work and --status the directory of a prepared table")
        ->required()
        ->type_name("TABLE|DIR");
    command_.add_option("--rows", options_.rows, "some of the rows: a density, or density:temperature")
        ->type_name("RHO[:T],...")
        ->delimiter(',');
    command_
        .add_option("--jobs", options_.jobs,
                    "rows at a time; one for each processor by default, with --slurm one in each task")
        ->type_name("N")
        ->check(CLI::Range(1, max_threads));
    command_.add_option("--out", options_.out, "directory, runs/verlet1967 by default")->type_name("DIR");
    command_.add_flag("--quick", options_.quick, "runs as short as Verlet's own, 1200 steps");
    command_.add_flag("--force", options_.force, "begin rows anew whose directory holds another run");
    command_.add_flag("--quiet", options_.quiet, "no progress");
    command_.add_flag("--json", options_.json, "print the table, or the status, as JSON");
    add_study_mode(command_, options_.mode);
}

}  // namespace ljmd
