#include <fmt/format.h>

#include "ljmd/cli/commands.hpp"
#include "ljmd/cli/plot_scripts.hpp"
#include "ljmd/io/files/process.hpp"
#include "ljmd/io/files/program_module.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

/// The command line of plot.py. Names and paths stand behind "--", because they may begin with a dash.
std::vector<std::string> arguments_of(const fs::path& script, const PlotOptions& options) {
    std::vector<std::string> arguments{script.string()};
    if (!options.out.empty()) {
        arguments.push_back("--out=" + options.out);
    }
    if (!options.against.empty()) {
        arguments.push_back("--against=" + options.against);
    }
    if (options.relative_to > 0) {
        arguments.push_back(fmt::format("--relative-to={}", options.relative_to));
    }
    if (options.force) {
        arguments.emplace_back("--force");
    }
    arguments.emplace_back("--");
    arguments.push_back(options.path);
    arguments.insert(arguments.end(), options.names.begin(), options.names.end());
    return arguments;
}

}  // namespace

void plot_command(const PlotOptions& options) {
    const fs::path program = this_program();
    const fs::path script = plot_script(program.parent_path());
    // The script asks this program for equations of state.
    become_program(python_for_plots(), arguments_of(script, options), {{"LJMD_PROGRAM", program.string()}});
}

}  // namespace ljmd
