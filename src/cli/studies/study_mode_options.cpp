#include "cli/studies/study_mode_options.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace ljmd {

namespace {

/// Refuse an option beside all others of the command that are not named.
template <std::size_t n>
void allow_only(CLI::App& command, CLI::Option& option, const std::array<const char*, n>& named) {
    for (CLI::Option* other : command.get_options([](const CLI::Option* one) { return !one->get_positional(); })) {
        const std::string name = other->get_name();
        if (other != &option && name != "--help" && name != "-h,--help" &&
            std::ranges::find(named, name) == named.end()) {
            option.excludes(other);
        }
    }
}

}  // namespace

void add_study_mode(CLI::App& command, StudyMode& mode) {
    CLI::Option* prepare =
        command.add_flag("--prepare", mode.prepare, "check everything and write the directory; run nothing");
    CLI::Option* work =
        command
            .add_option("--work", mode.work,
                        "be worker K of T in a prepared directory: bring its runs K, K+T, ... to their ends")
            ->type_name("K/T");
    command
        .add_option("--walltime", mode.walltime, "of a worker: stop after that long with checkpoints: 90s, 30min, 2h")
        ->type_name("TIME")
        ->needs(work);
    CLI::Option* slurm = command
                             .add_option("--slurm", mode.slurm,
                                         "submit the runs as a job array with these options of sbatch, and return; "
                                         "given again, gather what is finished and submit what is missing")
                             ->type_name("'OPTIONS'");
    CLI::Option* status = command.add_flag("--status", mode.status, "tell how far the runs in a directory are");
    allow_only(command, *work, std::array{"--jobs", "--quiet", "--walltime"});
    allow_only(command, *status, std::array{"--json"});
    prepare->excludes(slurm)->excludes(command.get_option("--jobs"));
}

}  // namespace ljmd
