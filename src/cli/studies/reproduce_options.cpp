#include "ljmd/cli/studies/reproduce_options.hpp"

#include "ljmd/execution/threads.hpp"

namespace ljmd {

ReproduceCommand::ReproduceCommand(CLI::App& app)
    : command_(*app.add_subcommand("reproduce",
                                   "compute a published table anew, with error bars; an interrupted one is resumed")) {
    command_.add_option("table", options_.what, "verlet1967: Phys. Rev. 159, 98")->required()->type_name("TABLE");
    command_.add_option("--rows", options_.rows, "some of the rows: a density, or density:temperature")
        ->type_name("RHO[:T],...")
        ->delimiter(',');
    command_.add_option("--jobs", options_.jobs, "rows at a time; one for each processor by default")
        ->type_name("N")
        ->check(CLI::Range(1, max_threads));
    command_.add_option("--out", options_.out, "directory, runs/verlet1967 by default")->type_name("DIR");
    command_.add_flag("--quick", options_.quick, "runs as short as Verlet's own, 1200 steps");
    command_.add_flag("--force", options_.force, "begin rows anew whose directory holds another run");
    command_.add_flag("--quiet", options_.quiet, "no progress");
    command_.add_flag("--json", options_.json, "print the table as JSON");
}

}  // namespace ljmd
