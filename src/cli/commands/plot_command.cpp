#include <fmt/format.h>

#include "cli/command.hpp"
#include "cli/deck_options.hpp"
#include "cli/plot_scripts.hpp"
#include "io/files/process.hpp"
#include "io/files/program_module.hpp"

namespace ljmd {

namespace {

namespace fs = std::filesystem;

/// Options of `ljmd plot`.
struct PlotOptions {
    std::string path;                  ///< a directory, or a table, of ljmd
    std::vector<std::string> names{};  ///< of pictures; empty: all that suit it
    std::string out{};                 ///< file or directory; empty: beside what is drawn
    std::string against{};             ///< key of a sweep on the axis; empty: the last
    int relative_to = 0;               ///< body from which few bodies are seen, counted from 1; 0: the first
    bool force = false;                ///< replace files that are no pictures of ljmd
};

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

class PlotCommand : public Command {
  public:
    PlotCommand() : Command("plot", Part::results, "draw the pictures of a run, a sweep, a comparison or a table") {}

    void add_options(CLI::App& command) override {
        command
            .add_option("path", options_.path,
                        "directory of a run, an analysis, a sweep, a reproduced table or a comparison; or one of "
                        "their tables")
            ->required()
            ->type_name("DIR|FILE");
        command
            .add_option("names", options_.names,
                        "pictures to draw, e.g. thermo rdf; of a sweep its columns, e.g. pressure; all that suit "
                        "by default")
            ->type_name("NAME");
        command
            .add_option("--out", options_.out,
                        "file that ends in .png, .svg or .pdf (several pictures add their names), or a directory; "
                        "DIR by default")
            ->type_name("FILE");
        command
            .add_option("--against", options_.against, "of a sweep: the varied key on the axis, the last by default")
            ->type_name("KEY");
        command
            .add_option("--relative-to", options_.relative_to,
                        "of few bodies: the body from which the others are seen, counted from 1")
            ->type_name("K")
            ->check(CLI::PositiveNumber);
        command.add_flag("--force", options_.force, "replace files that are no pictures of ljmd");
    }

    void run() override {
        const fs::path program = this_program();
        const fs::path script = plot_script(program.parent_path());
        // The script asks this program for equations of state.
        become_program(python_for_plots(), arguments_of(script, options_), {{"LJMD_PROGRAM", program.string()}});
    }

  private:
    PlotOptions options_;
};

}  // namespace

std::shared_ptr<Command> plot_command() {
    return std::make_shared<PlotCommand>();
}

}  // namespace ljmd
